// SPDX-License-Identifier: BSD-3-Clause
#include "robots/robot_model.h"

#include <algorithm>

namespace b4p {
namespace {

template <typename Named>
int indexOf(const std::vector<Named>& items, const std::string& name) {
  const auto found =
      std::find_if(items.begin(), items.end(), [&](const Named& item) { return item.name == name; });
  return found == items.end() ? -1 : static_cast<int>(found - items.begin());
}

}  // namespace

int RobotModel::linkIndex(const std::string& link_name) const { return indexOf(links, link_name); }

int RobotModel::jointIndex(const std::string& joint_name) const { return indexOf(joints, joint_name); }

}  // namespace b4p
