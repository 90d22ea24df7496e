// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/scene_families/confined_scenario.h"

#include <cmath>
#include <utility>

#include "experiments/scene_families/confined_furniture.h"

namespace b4p {
namespace {

constexpr double kHalfTurn_rad = 3.14159265358979323846;
constexpr double kMiddle_m = 1.0;  ///< x of the robot, and of all that it has to reach through
constexpr double kTableFront_m = 0.6, kTableTop_m = 0.5;

/// A shape whose axis z lies in the plane, turned by `yaw_rad` from the x axis.
PlacedShape lying(const Shape& shape, const Eigen::Vector3d& centre, double yaw_rad) {
  return {shape, Eigen::Translation3d(centre) * Eigen::AngleAxisd(yaw_rad, Eigen::Vector3d::UnitZ()) *
                     Eigen::AngleAxisd(kHalfTurn_rad / 2.0, Eigen::Vector3d::UnitY())};
}

/// Handle and blade of a screwdriver in line, the handle on the table.
std::vector<PlacedShape> screwdriver(const Eigen::Vector2d& middle) {
  constexpr double kHandle_m = 0.11, kBlade_m = 0.106, kThickness_m = 0.034, kBladeThickness_m = 0.008;
  constexpr double kYaw_rad = kHalfTurn_rad / 6.0, kLift_m = 0.001;
  const Eigen::Vector3d along(std::cos(kYaw_rad), std::sin(kYaw_rad), 0.0);
  const Eigen::Vector3d centre(middle.x(), middle.y(), kTableTop_m + kThickness_m / 2.0 + kLift_m);
  return {lying(Cylinder{kThickness_m / 2.0, kHandle_m}, centre - along * kBlade_m / 2.0, kYaw_rad),
          lying(Cylinder{kBladeThickness_m / 2.0, kBlade_m}, centre + along * kHandle_m / 2.0, kYaw_rad)};
}

/// Four capsules along an arc.
std::vector<PlacedShape> banana(const Eigen::Vector3d& tip_of_arc) {
  constexpr double kRadius_m = 0.02, kHalfLength_m = 0.0795, kSagitta_m = 0.039;
  constexpr int kPieces = 4;
  const auto at = [&](int i) {
    const double share = 2.0 * i / kPieces - 1.0;
    return Eigen::Vector3d(tip_of_arc +
                           Eigen::Vector3d(share * kHalfLength_m, share * share * kSagitta_m, 0.0));
  };
  std::vector<PlacedShape> pieces;
  for (int i = 0; i < kPieces; ++i) {
    const Eigen::Vector3d way = at(i + 1) - at(i);
    pieces.push_back(
        lying(Capsule{kRadius_m, way.norm()}, (at(i) + at(i + 1)) / 2.0, std::atan2(way.y(), way.x())));
  }
  return pieces;
}

void place(std::vector<Obstacle>& obstacles, const std::vector<Obstacle>& furniture, double x, double y,
           double z = 0.0) {
  for (Obstacle part : furniture) {
    part.shape.X_BS = Eigen::Translation3d(x, y, z) * part.shape.X_BS;
    obstacles.push_back(std::move(part));
  }
}

void placeWalls(std::vector<Obstacle>& obstacles, double gap_m) {
  constexpr double kFront_m = 0.5, kWidth_m = 0.8;
  place(obstacles, wallBoxes("wall_left"), kMiddle_m - gap_m / 2.0 - kWidth_m, kFront_m);
  place(obstacles, wallBoxes("wall_right"), kMiddle_m + gap_m / 2.0, kFront_m);
}

}  // namespace

ConfinedScenario confinedScenario(int group, double step) {
  constexpr double kNarrower_m = 0.08, kFarther_m = 0.1;  // a step
  constexpr double kBallRadius_m = 0.0335;
  ConfinedScenario scenario;
  std::vector<Obstacle>& obstacles = scenario.obstacles;
  obstacles.push_back(boxObstacle("floor", {-2, -2, -0.1}, {4, 4, 0}));
  const double past = step - 1.0;
  switch (group) {
    case 1:
      place(obstacles, tableBoxes(), 0.0, kTableFront_m);
      place(obstacles, openShelfBoxes(), 0.77, kTableFront_m, kTableTop_m);
      scenario.support_height_m = kTableTop_m;
      scenario.target = screwdriver({kMiddle_m, kTableFront_m + 0.15 + kFarther_m * past});
      break;
    case 2:
      place(obstacles, tableBoxes(), 0.0, kTableFront_m);
      scenario.target = {{Sphere{kBallRadius_m},
                          Eigen::Isometry3d(Eigen::Translation3d(
                              kMiddle_m, kTableFront_m + 0.2 + kFarther_m * past, kBallRadius_m + 0.001))}};
      break;
    case 3:
      placeWalls(obstacles, 0.64 - kNarrower_m * past);
      scenario.target = {boxObstacle("", {0.823, 0.718, 0.001}, {1.002, 0.769, 0.096}).shape};
      break;
    default:
      place(obstacles, gateBoxes(0.86 - kNarrower_m * past), 0.0, 0.4);
      place(obstacles, pedestalBoxes(), 0.8, 1.1);
      scenario.support_height_m = 0.5;
      scenario.target = banana({1.0015, 1.223, 0.522});
      break;
  }
  return scenario;
}

Eigen::Isometry3d confinedRobotBase() {
  Eigen::Isometry3d X_WB = Eigen::Isometry3d::Identity();
  X_WB.translation() << kMiddle_m, 0.0, 0.05;
  X_WB.linear() = Eigen::AngleAxisd(kHalfTurn_rad / 2.0, Eigen::Vector3d::UnitZ()).toRotationMatrix();
  return X_WB;
}

}  // namespace b4p
