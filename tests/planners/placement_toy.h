// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <functional>
#include <memory>
#include <stdexcept>
#include <utility>
#include <vector>

#include <ompl/base/spaces/RealVectorBounds.h>

#include "planners/manipulation_state_space.h"
#include "planners/manipulation_validity.h"
#include "planners/placement/placement_goal.h"
#include "planners/placement/placement_world.h"

namespace b4p::test {

constexpr double kTurn = 2.0 * 3.14159265358979323846;

/// Rows of cells side by side, from one corner on.
inline ContactRegion gridRegion(double x, double y, int columns, int rows, double height = 0.0,
                                double cell = 0.01) {
  ContactRegion region;
  region.height_m = height;
  region.cell_m = cell;
  for (int j = 0; j < rows; ++j)
    for (int i = 0; i < columns; ++i) region.cells.emplace_back(x + (i + 0.5) * cell, y + (j + 0.5) * cell);
  return region;
}

/// Gantries with joints (x, y, yaw) that put things down without any URDF: the object's origin is its
/// reference vertex, and inverse kinematics is exact. What is free is for the test to say.
struct ToyPlacement : PlacementWorld {
  std::vector<ContactRegion> surfaces{gridRegion(0.0, 0.0, 64, 64)};
  GraspId arms = 1;
  int faces = 1;
  std::function<bool(double x, double y, double yaw)> object_free = [](double, double, double) {
    return true;
  };
  std::function<bool(GraspId arm, double x, double y)> arm_free = [](GraspId, double, double) {
    return true;
  };

  unsigned dof() const override { return 3; }
  GraspId armCount() const override { return arms; }
  int faceCount() const override { return faces; }
  const std::vector<ContactRegion>& regions() const override { return surfaces; }

  static Eigen::Isometry3d pose(double x, double y, double z, double yaw) {
    Eigen::Isometry3d X = Eigen::Isometry3d::Identity();
    X.linear() = Eigen::AngleAxisd(yaw, Eigen::Vector3d::UnitZ()).toRotationMatrix();
    X.translation() << x, y, z;
    return X;
  }
  static double yawOf(const Eigen::Isometry3d& X_WO) {
    const double yaw = std::atan2(X_WO.linear()(1, 0), X_WO.linear()(0, 0));
    return yaw < 0.0 ? yaw + kTurn : yaw;
  }

  Eigen::Isometry3d objectPose(const Placement& p) const override {
    return pose(p.p_WV.x(), p.p_WV.y(), surfaces.at(static_cast<std::size_t>(p.region)).height_m,
                p.angle_rad);
  }
  bool locate(const Eigen::Isometry3d& X_WO, Placement& p) const override {
    for (std::size_t r = 0; r < surfaces.size(); ++r)
      for (const Eigen::Vector2d& cell : surfaces[r].cells)
        if ((X_WO.translation().head<2>() - cell).cwiseAbs().maxCoeff() <= surfaces[r].cell_m / 2.0) {
          p = {kNoGrasp, 0, static_cast<int>(r), X_WO.translation().head<2>(), yawOf(X_WO)};
          return true;
        }
    return false;
  }
  bool stable(const Eigen::Isometry3d& X_WO) const override {
    Placement p;
    return locate(X_WO, p);
  }
  std::unique_ptr<PlacementContext> makeContext() const override;
};

struct ToyPlacementContext : PlacementContext {
  explicit ToyPlacementContext(const ToyPlacement& world_in) : world(world_in) {}
  const ToyPlacement& world;

  bool objectFree(const Eigen::Isometry3d& X_WO) override {
    return world.object_free(X_WO.translation().x(), X_WO.translation().y(), ToyPlacement::yawOf(X_WO));
  }
  bool handFree(GraspId, const Eigen::Isometry3d&) override { return true; }
  bool inverse(GraspId, const Eigen::Isometry3d& X_WO, std::mt19937_64&, double* q) override {
    q[0] = X_WO.translation().x();
    q[1] = X_WO.translation().y();
    q[2] = ToyPlacement::yawOf(X_WO);
    return true;
  }
  bool armFree(GraspId arm, const double* q) override { return world.arm_free(arm, q[0], q[1]); }
  Eigen::Isometry3d tcpPose(GraspId, const double* q) override {
    return ToyPlacement::pose(q[0], q[1], 0.0, q[2]);
  }
  Eigen::Isometry3d objectPose(GraspId arm, const double* q) override { return tcpPose(arm, q); }
  Jacobian jacobian(GraspId, const double*) override {
    Jacobian j = Jacobian::Zero(6, 3);
    j(0, 0) = j(1, 1) = j(5, 2) = 1.0;
    return j;
  }
};

inline std::unique_ptr<PlacementContext> ToyPlacement::makeContext() const {
  return std::make_unique<ToyPlacementContext>(*this);
}

/// Every motion between free configurations is free.
struct ToyMotions : GraspMotionChecker {
  explicit ToyMotions(std::shared_ptr<const ToyPlacement> world_in) : world(std::move(world_in)) {}
  std::shared_ptr<const ToyPlacement> world;

  struct Context : GraspMotionContext {
    explicit Context(const ToyPlacement& world_in) : world(world_in) {}
    const ToyPlacement& world;
    bool isFree(const double* q, GraspId grasp) override { return world.arm_free(grasp, q[0], q[1]); }
    bool isEdgeFree(const double* a, const double* b, GraspId grasp) override {
      return isFree(a, grasp) && isFree(b, grasp);
    }
    double freeFraction(const double* a, const double* b, GraspId grasp) override {
      return isEdgeFree(a, b, grasp) ? 1.0 : (isFree(a, grasp) ? 0.0 : -1.0);
    }
  };
  std::unique_ptr<GraspMotionContext> makeContext() const override {
    return std::make_unique<Context>(*world);
  }
};

/// A toy world as an OMPL problem.
struct ToyProblem {
  std::shared_ptr<ToyPlacement> world;
  std::shared_ptr<ManipulationStateSpace> space;
  ompl::base::SpaceInformationPtr si;

  explicit ToyProblem(std::shared_ptr<ToyPlacement> world_in) : world(std::move(world_in)) {
    ompl::base::RealVectorBounds bounds(3);
    bounds.setLow(-1.0);
    bounds.setHigh(7.0);
    space = std::make_shared<ManipulationStateSpace>(bounds);
    space->setGraspCount([w = world] { return w->armCount(); });
    si = makeManipulationSpaceInformation(space, std::make_shared<ToyMotions>(world));
  }

  std::shared_ptr<PlacementGoal> goal(std::shared_ptr<const PlacementObjective> objective,
                                      const PlacementOptions& options = {}) const {
    return std::make_shared<PlacementGoal>(si, world, std::move(objective), options);
  }
};

inline std::shared_ptr<PlacementObjective> objectiveOf(std::function<double(double x, double y)> function) {
  return std::make_shared<CallableObjective>([function = std::move(function)](const Eigen::Isometry3d& X_WO) {
    return function(X_WO.translation().x(), X_WO.translation().y());
  });
}

}  // namespace b4p::test
