// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>
#include <memory>
#include <random>
#include <stdexcept>
#include <vector>

#include <ompl/base/ProblemDefinition.h>
#include <ompl/base/SpaceInformation.h>
#include <Eigen/Core>

#include "planners/grasp_motion_checker.h"
#include "planners/manipulation_state_space.h"
#include "planners/manipulation_validity.h"
#include "planners/pick_place_region.h"
#include "planners/place_goal.h"

namespace b4p::test {

/// Axis-aligned wall.
struct Wall {
  Eigen::Vector2d min, max;
};

/// A disc robot that holds a disc object at `offset` from the object's centre.
struct DiscGrasp {
  Eigen::Vector2d offset{0.0, 0.0};  ///< robot centre seen from the object's centre
  double object_radius = 0.2;        ///< larger for grasps under which the object is in the way
};

/// Pick and place in the plane without any URDF: a disc moves a disc among walls in a 10 x 10 field.
struct DiscWorld {
  std::vector<Wall> walls;
  std::vector<DiscGrasp> grasps;
  double robot_radius = 0.1;
  Eigen::Vector2d start{1.0, 5.0};  ///< of the object
  Wall region{{8.5, 4.5}, {9.5, 5.5}};
  double step = 0.02;  ///< between two checks of an edge; discs are padded by half of it

  static constexpr double kSize = 10.0;

  bool discIsFree(const Eigen::Vector2d& centre, double radius) const {
    for (int i = 0; i < 2; ++i)
      if (centre[i] - radius < 0.0 || centre[i] + radius > kSize) return false;
    for (const Wall& wall : walls)
      if ((centre - centre.cwiseMax(wall.min).cwiseMin(wall.max)).norm() <= radius) return false;
    return true;
  }

  bool isFree(const Eigen::Vector2d& q, GraspId grasp, double padding) const {
    if (!q.allFinite()) throw std::invalid_argument("not finite");
    if (!discIsFree(q, robot_radius + padding)) return false;
    if (grasp == kNoGrasp) return true;
    const DiscGrasp& held = grasps.at(static_cast<std::size_t>(grasp));
    return discIsFree(q - held.offset, held.object_radius + padding);
  }
};

class DiscMotionContext : public GraspMotionContext {
 public:
  explicit DiscMotionContext(const DiscWorld& world) : world_(world) {}
  bool isFree(const double* q, GraspId grasp) override {
    return world_.isFree({q[0], q[1]}, grasp, world_.step / 2.0);
  }
  bool isEdgeFree(const double* q1, const double* q2, GraspId grasp) override {
    return freeFraction(q1, q2, grasp) >= 1.0;
  }
  double freeFraction(const double* q1, const double* q2, GraspId grasp) override {
    const Eigen::Vector2d a(q1[0], q1[1]), b(q2[0], q2[1]);
    const int pieces = std::max(1, static_cast<int>(std::ceil((b - a).norm() / world_.step)));
    for (int k = 0; k <= pieces; ++k) {
      const Eigen::Vector2d q = k == pieces ? b : Eigen::Vector2d(a + (b - a) * k / pieces);
      if (!isFree(q.data(), grasp)) return safeFraction(a, b, grasp, static_cast<double>(k - 1) / pieces);
    }
    return 1.0;
  }

 private:
  // The shorter edge is checked at points of its own.
  double safeFraction(const Eigen::Vector2d& a, const Eigen::Vector2d& b, GraspId grasp, double fraction) {
    if (fraction <= 0.0) return fraction < 0.0 ? -1.0 : 0.0;
    const Eigen::Vector2d end = a + fraction * (b - a);
    const double again = freeFraction(a.data(), end.data(), grasp);
    return again >= 1.0 ? fraction : 0.0;
  }

  const DiscWorld& world_;
};

class DiscMotionChecker : public GraspMotionChecker {
 public:
  explicit DiscMotionChecker(std::shared_ptr<const DiscWorld> world) : world_(std::move(world)) {}
  std::unique_ptr<GraspMotionContext> makeContext() const override {
    return std::make_unique<DiscMotionContext>(*world_);
  }

 private:
  std::shared_ptr<const DiscWorld> world_;
};

/// Placements are numbered draws of a fixed stream, the same for all contexts.
class DiscRegion : public PickPlaceRegion {
 public:
  explicit DiscRegion(std::shared_ptr<const DiscWorld> world) : world_(std::move(world)) {}

  std::unique_ptr<PickPlaceContext> makeContext(std::uint64_t seed) const override {
    return std::make_unique<Context>(*world_, seed);
  }
  GraspId graspCount() const override { return static_cast<GraspId>(world_->grasps.size()); }
  double distanceToPlacement(const double* q, GraspId grasp) const override {
    const Eigen::Vector2d p =
        Eigen::Vector2d(q[0], q[1]) - world_->grasps.at(static_cast<std::size_t>(grasp)).offset;
    return (p - p.cwiseMax(world_->region.min).cwiseMin(world_->region.max)).norm();
  }

 private:
  class Context : public PickPlaceContext {
   public:
    Context(const DiscWorld& world, std::uint64_t seed) : world_(world), random_(seed) {}
    bool samplePick(double* q, GraspId& grasp) override {
      grasp =
          std::uniform_int_distribution<GraspId>(0, static_cast<GraspId>(world_.grasps.size()) - 1)(random_);
      return robotAt(world_.start, grasp, q);
    }
    PlacementId samplePlacement() override {
      return std::uniform_int_distribution<PlacementId>(0, 999)(random_);
    }
    bool placeRoot(PlacementId placement, GraspId grasp, double* q) override {
      std::mt19937 at(static_cast<unsigned>(placement));
      Eigen::Vector2d p;
      for (int i = 0; i < 2; ++i)
        p[i] = std::uniform_real_distribution<double>(world_.region.min[i], world_.region.max[i])(at);
      return robotAt(p, grasp, q);
    }

   private:
    bool robotAt(const Eigen::Vector2d& object, GraspId grasp, double* q) const {
      const Eigen::Vector2d robot = object + world_.grasps[static_cast<std::size_t>(grasp)].offset;
      q[0] = robot.x();
      q[1] = robot.y();
      return world_.isFree(robot, grasp, world_.step / 2.0);
    }
    const DiscWorld& world_;
    std::mt19937_64 random_;
  };

  std::shared_ptr<const DiscWorld> world_;
};

/// A wall across the field at x = 5 with an opening of the given width around y = 5; 0: none.
inline std::vector<Wall> wallWithOpening(double width, double thickness = 0.4) {
  const double x = 5.0 - thickness / 2.0;
  const double low = 5.0 - width / 2.0, high = 5.0 + width / 2.0;
  if (width <= 0.0) return {{{x, 0.0}, {x + thickness, DiscWorld::kSize}}};
  return {{{x, 0.0}, {x + thickness, low}}, {{x, high}, {x + thickness, DiscWorld::kSize}}};
}

/// Eight grasps around the object; under all but number 3 it is too large for an opening of 0.6.
inline std::vector<DiscGrasp> eightGrasps() {
  std::vector<DiscGrasp> grasps;
  for (int i = 0; i < 8; ++i) {
    const double angle = i * std::acos(-1.0) / 4.0;
    grasps.push_back({0.3 * Eigen::Vector2d(std::cos(angle), std::sin(angle)), i == 3 ? 0.2 : 0.4});
  }
  return grasps;
}

/// Everything a planner needs for a DiscWorld.
struct DiscProblem {
  explicit DiscProblem(const DiscWorld& described) : world(std::make_shared<DiscWorld>(described)) {
    ompl::base::RealVectorBounds bounds(2);
    bounds.setLow(0.0);
    bounds.setHigh(DiscWorld::kSize);
    space = std::make_shared<ManipulationStateSpace>(bounds);
    space->setGraspCount([count = static_cast<GraspId>(world->grasps.size())] { return count; });
    si = makeManipulationSpaceInformation(space, std::make_shared<DiscMotionChecker>(world));
    region = std::make_shared<DiscRegion>(world);
    goal = std::make_shared<PlaceGoal>(si, region);
    problem = std::make_shared<ompl::base::ProblemDefinition>(si);
    problem->setGoal(goal);
  }

  std::shared_ptr<DiscWorld> world;
  std::shared_ptr<ManipulationStateSpace> space;
  ompl::base::SpaceInformationPtr si;
  std::shared_ptr<DiscRegion> region;
  std::shared_ptr<PlaceGoal> goal;
  ompl::base::ProblemDefinitionPtr problem;
};

}  // namespace b4p::test
