// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/scene_families/grasp_text.h"

#include "experiments/scene_families/scene_text.h"

namespace b4p {

std::string graspText(const std::vector<Eigen::Isometry3d>& poses) {
  constexpr int kDecimals = 7;
  std::string text;
  for (const Eigen::Isometry3d& pose : poses) {
    for (int row = 0; row < 4; ++row)
      for (int column = 0; column < 4; ++column)
        text += sceneNumber(pose.matrix()(row, column), kDecimals) + (row == 3 && column == 3 ? "\n" : ",");
  }
  return text;
}

}  // namespace b4p
