// SPDX-License-Identifier: BSD-3-Clause
// Pick and place without a URDF, with a collision checker and a pick-and-place region of one's own: a point
// carries an upright rod through a gap in a wall. A grasp is the height at which it holds the rod. The
// gripper reaches below its point, so it clears the gap's sill only when it holds the upper half of the rod.
#include <algorithm>
#include <cmath>
#include <iostream>
#include <memory>
#include <random>
#include <vector>

#include <ompl/base/ProblemDefinition.h>

#include "planners/b4p/b4p_planner.h"
#include "planners/grasp_motion_checker.h"
#include "planners/manipulation_validity.h"
#include "planners/pick_place_region.h"
#include "planners/place_goal.h"

namespace {

using b4p::GraspId;
using b4p::PlacementId;

constexpr double kRodLength = 0.4;
constexpr int kGrasps = 5;
constexpr double kWall_x = 0.5, kWallHalfWidth = 0.05;
constexpr double kGapLow = 0.3, kGapHigh = 0.75;
constexpr double kStart_x = 0.2, kStart_y = 0.5;  ///< lower end of the upright rod
constexpr double kPlace_x = 0.8, kPlaceLow_y = 0.0, kPlaceHigh_y = 0.6;

constexpr double kGripperReach = 0.2;  ///< below the point

/// Where grasp number `id` is on the rod, from its lower end.
double heightOnRod(GraspId id) { return kRodLength * id / (kGrasps - 1); }

bool isFree(const double* q, GraspId grasp) {
  const double x = q[0], y = q[1];
  if (std::abs(x - kWall_x) > kWallHalfWidth) return true;
  if (y - kGripperReach < kGapLow || y > kGapHigh) return false;
  if (grasp == b4p::kNoGrasp) return true;
  const double rod_low = y - heightOnRod(grasp);
  return rod_low > kGapLow && rod_low + kRodLength < kGapHigh;
}

class RodContext : public b4p::GraspMotionContext {
 public:
  bool isFree(const double* q, GraspId grasp) override { return ::isFree(q, grasp); }
  bool isEdgeFree(const double* q1, const double* q2, GraspId grasp) override {
    return freeFraction(q1, q2, grasp) >= 1.0;
  }
  double freeFraction(const double* q1, const double* q2, GraspId grasp) override {
    constexpr double kStep = 0.002;
    const int steps =
        std::max(1, static_cast<int>(std::ceil(std::hypot(q2[0] - q1[0], q2[1] - q1[1]) / kStep)));
    for (int i = 0; i <= steps; ++i) {
      const double t = static_cast<double>(i) / steps;
      const double q[2] = {q1[0] + t * (q2[0] - q1[0]), q1[1] + t * (q2[1] - q1[1])};
      if (!::isFree(q, grasp)) return i == 0 ? -1.0 : static_cast<double>(i - 1) / steps;
    }
    return 1.0;
  }
};

class RodChecker : public b4p::GraspMotionChecker {
 public:
  std::unique_ptr<b4p::GraspMotionContext> makeContext() const override {
    return std::make_unique<RodContext>();
  }
};

/// Placements are numbered by how far up they lie, so that no table is needed.
class RodRegionContext : public b4p::PickPlaceContext {
 public:
  explicit RodRegionContext(std::uint64_t seed) : random_(seed) {}

  bool samplePick(double* q, GraspId& grasp) override {
    grasp = std::uniform_int_distribution<GraspId>(0, kGrasps - 1)(random_);
    q[0] = kStart_x;
    q[1] = kStart_y + heightOnRod(grasp);
    return isFree(q, grasp);
  }
  PlacementId samplePlacement() override {
    return std::uniform_int_distribution<PlacementId>(0, kPlacements - 1)(random_);
  }
  bool placeRoot(PlacementId placement, GraspId grasp, double* q) override {
    q[0] = kPlace_x;
    q[1] = kPlaceLow_y + (kPlaceHigh_y - kPlaceLow_y) * placement / kPlacements + heightOnRod(grasp);
    return isFree(q, grasp);
  }

 private:
  static constexpr PlacementId kPlacements = 1000;
  std::mt19937_64 random_;
};

class RodRegion : public b4p::PickPlaceRegion {
 public:
  std::unique_ptr<b4p::PickPlaceContext> makeContext(std::uint64_t seed) const override {
    return std::make_unique<RodRegionContext>(seed);
  }
  GraspId graspCount() const override { return kGrasps; }
  double distanceToPlacement(const double* q, GraspId grasp) const override {
    constexpr double kTolerance = 1e-9;
    const double y = q[1] - heightOnRod(grasp);
    const double distance = std::hypot(q[0] - kPlace_x, y - std::clamp(y, kPlaceLow_y, kPlaceHigh_y));
    return distance < kTolerance ? 0.0 : distance;
  }
};

}  // namespace

int main() {
  ompl::base::RealVectorBounds bounds(2);
  bounds.setLow(-0.5);
  bounds.setHigh(1.5);
  const auto space = std::make_shared<b4p::ManipulationStateSpace>(bounds);
  space->setGraspCount([] { return kGrasps; });
  const auto si = b4p::makeManipulationSpaceInformation(space, std::make_shared<RodChecker>());
  const auto pdef = std::make_shared<ompl::base::ProblemDefinition>(si);
  pdef->setGoal(std::make_shared<b4p::PlaceGoal>(si, std::make_shared<RodRegion>()));

  b4p::B4P planner(si);
  planner.setProblemDefinition(pdef);
  constexpr double kTimeLimit_s = 10.0;
  if (planner.solve(kTimeLimit_s) != ompl::base::PlannerStatus::EXACT_SOLUTION) return 1;
  pdef->getSolutionPath()->print(std::cout);
  return 0;
}
