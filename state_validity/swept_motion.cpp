// SPDX-License-Identifier: BSD-3-Clause
#include "state_validity/swept_motion.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "robots/joint_motion.h"
#include "state_validity/link_groups.h"
#include "state_validity/shape_bounds.h"

namespace b4p {
namespace {

// Where the shape's points can be, as convex pieces in the frame of the link reached so far.
using Enclosure = std::vector<PlacedShape>;

double farthestFromOrigin(const Enclosure& pieces) {
  double distance = 0.0;
  for (const PlacedShape& piece : pieces)
    distance = std::max(distance, farthestDistance(piece, Eigen::Vector3d::Zero()));
  return distance;
}

double farthestFromAxis(const Enclosure& pieces, const Eigen::Vector3d& axis) {
  double distance = 0.0;
  for (const PlacedShape& piece : pieces)
    distance = std::max(distance, farthestDistanceFromLine(piece, Eigen::Vector3d::Zero(), axis));
  return distance;
}

double highestAlong(const Enclosure& pieces, const Eigen::Vector3d& axis) {
  double height = extentAlong(pieces.front(), axis);
  for (const PlacedShape& piece : pieces) height = std::max(height, extentAlong(piece, axis));
  return height;
}

// A set that contains all reachable points, walked from the link towards the root. It is kept twice, as a
// cylinder about the last axis and as a ball about the last joint's origin, because either can be much the
// tighter one: the cylinder for a hand on its wrist, the ball for an arm on its shoulder.
class ReachableSet {
 public:
  explicit ReachableSet(const PlacedShape& shape) : slim_{shape}, round_{shape} {}

  void place(const Eigen::Isometry3d& X_PC) {
    for (Enclosure* pieces : {&slim_, &round_})
      for (PlacedShape& piece : *pieces) piece.X_BS = X_PC * piece.X_BS;
  }

  // Slides over [lower, upper] along the axis. Both ends suffice: distances and extents are convex along the
  // way.
  void slide(const Eigen::Vector3d& axis, double lower, double upper) {
    for (Enclosure* pieces : {&slim_, &round_}) {
      const std::size_t count = pieces->size();
      for (std::size_t i = 0; i < count; ++i) {
        PlacedShape far_end = (*pieces)[i];
        far_end.X_BS.pretranslate(upper * axis);
        (*pieces)[i].X_BS.pretranslate(lower * axis);
        pieces->push_back(far_end);
      }
    }
  }

  // Turns by any angle about the axis through the origin.
  // @return the largest distance (m) of any point from the axis
  double turn(const Eigen::Vector3d& axis) {
    const double reach = std::min(farthestFromOrigin(slim_), farthestFromOrigin(round_));
    const double radius = std::min({farthestFromAxis(slim_, axis), farthestFromAxis(round_, axis), reach});
    const double top = std::min({highestAlong(slim_, axis), highestAlong(round_, axis), reach});
    const double bottom = std::max({-highestAlong(slim_, -axis), -highestAlong(round_, -axis), -reach});
    PlacedShape cylinder{Cylinder{radius, std::max(0.0, top - bottom)}, Eigen::Isometry3d::Identity()};
    cylinder.X_BS.linear() = Eigen::Quaterniond::FromTwoVectors(Eigen::Vector3d::UnitZ(), axis).matrix();
    cylinder.X_BS.translation() = 0.5 * (top + bottom) * axis;
    slim_ = {cylinder};
    round_ = {{Sphere{reach}, Eigen::Isometry3d::Identity()}};
    return radius;
  }

 private:
  Enclosure slim_;
  Enclosure round_;
};

}  // namespace

Eigen::VectorXd travelPerUnit(const Manipulator& robot, int link, const PlacedShape& shape) {
  const RobotModel& model = robot.model();
  Eigen::VectorXd travel = Eigen::VectorXd::Zero(robot.dof());
  ReachableSet points(shape);
  for (int j = model.links[link].parent_joint; j >= 0;) {
    const Joint& joint = model.joints[j];
    const int planned = plannedIndex(robot, j);
    const bool finger = isFingerJoint(robot, j);
    double value = 0.0;
    if (planned < 0 && !finger) {
      value = robot.restValue(j);
    } else if (joint.type == JointType::kRevolute) {
      const double radius = points.turn(joint.axis);
      if (planned >= 0) travel[planned] = radius;
    } else {
      const double widest = 0.5 * robot.description().max_opening_m;
      points.slide(joint.axis, finger ? 0.0 : joint.lower, finger ? widest : joint.upper);
      if (planned >= 0) travel[planned] = 1.0;
    }
    points.place(childInParent(joint, value));
    j = model.links[joint.parent_link].parent_joint;
  }
  return travel;
}

}  // namespace b4p
