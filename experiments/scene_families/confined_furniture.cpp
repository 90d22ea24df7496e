// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/scene_families/confined_furniture.h"

namespace b4p {

Obstacle boxObstacle(const std::string& name, const Eigen::Vector3d& low, const Eigen::Vector3d& high) {
  return {name, {Box{high - low}, Eigen::Isometry3d(Eigen::Translation3d((low + high) / 2.0))}};
}

std::vector<Obstacle> tableBoxes() {
  constexpr double kWidth_m = 2.0, kDepth_m = 0.8, kLeg_m = 0.1, kUnderside_m = 0.4, kTop_m = 0.5;
  return {boxObstacle("table_leg_left", {0, 0, 0}, {kLeg_m, kDepth_m, kUnderside_m}),
          boxObstacle("table_leg_right", {kWidth_m - kLeg_m, 0, 0}, {kWidth_m, kDepth_m, kUnderside_m}),
          boxObstacle("table_top", {0, 0, kUnderside_m}, {kWidth_m, kDepth_m, kTop_m})};
}

std::vector<Obstacle> openShelfBoxes() {
  constexpr double kWidth_m = 0.46, kDepth_m = 0.5, kHeight_m = 0.4, kBoard_m = 0.03;
  constexpr double kUnderTop_m = kHeight_m - kBoard_m;
  return {boxObstacle("shelf_left", {0, 0, 0}, {kBoard_m, kDepth_m, kUnderTop_m}),
          boxObstacle("shelf_right", {kWidth_m - kBoard_m, 0, 0}, {kWidth_m, kDepth_m, kUnderTop_m}),
          boxObstacle("shelf_top", {0, 0, kUnderTop_m}, {kWidth_m, kDepth_m, kHeight_m})};
}

std::vector<Obstacle> gateBoxes(double opening_m) {
  constexpr double kWidth_m = 2.0, kThickness_m = 0.1;
  const double beam_m = (kWidth_m - opening_m) / 2.0;
  return {boxObstacle("gate_left", {0, 0, 0}, {beam_m, kThickness_m, opening_m}),
          boxObstacle("gate_right", {kWidth_m - beam_m, 0, 0}, {kWidth_m, kThickness_m, opening_m}),
          boxObstacle("gate_lintel", {0, 0, opening_m}, {kWidth_m, kThickness_m, opening_m + beam_m})};
}

std::vector<Obstacle> wallBoxes(const std::string& name) {
  return {boxObstacle(name, {0, 0, 0}, {0.8, 0.1, 1.0})};
}

std::vector<Obstacle> pedestalBoxes() { return {boxObstacle("pedestal", {0, 0, 0}, {0.4, 0.4, 0.5})}; }

}  // namespace b4p
