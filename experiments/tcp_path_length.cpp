// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/tcp_path_length.h"

#include <algorithm>
#include <cmath>

namespace b4p {
namespace {

using Row = Eigen::Map<const Eigen::VectorXd>;

double edgeLength_m(const Manipulator& robot, const Row& from, const Row& to) {
  constexpr double kStep = 0.02;  // rad or m, of the joint that moves farthest
  const Eigen::VectorXd change = to - from;
  const int steps = std::max(1, static_cast<int>(std::ceil(change.cwiseAbs().maxCoeff() / kStep)));
  Eigen::Vector3d before = robot.tcpPose(from.data()).translation();
  double length_m = 0.0;
  for (int step = 1; step <= steps; ++step) {
    const Eigen::VectorXd q = from + change * (static_cast<double>(step) / steps);
    const Eigen::Vector3d here = robot.tcpPose(q.data()).translation();
    length_m += (here - before).norm();
    before = here;
  }
  return length_m;
}

}  // namespace

double tcpPathLength_m(const Manipulator& robot, const std::vector<std::vector<double>>& path) {
  double length_m = 0.0;
  for (std::size_t i = 1; i < path.size(); ++i)
    length_m += edgeLength_m(robot, Row(path[i - 1].data(), robot.dof()), Row(path[i].data(), robot.dof()));
  return length_m;
}

}  // namespace b4p
