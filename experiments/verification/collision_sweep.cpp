// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/verification/collision_sweep.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <set>
#include <stdexcept>
#include <utility>

#include "experiments/verification/separation.h"
#include "robots/input_error.h"

namespace b4p::verification {
namespace {

int requireLink(const Scene& scene, const UrdfTree& tree, const std::string& name) {
  const int link = tree.linkIndex(name);
  if (link < 0)
    throw InputError(scene.robot.file, "link '" + name + "'", "is not in " + scene.robot.urdf_file);
  return link;
}

/// For each link the first link, from the root, of those that it is fixed to.
std::vector<int> rigidGroups(const UrdfTree& tree) {
  std::vector<int> group(tree.links.size());
  for (const int link : tree.root_first) {
    const int index = tree.links[link].parent_joint;
    group[link] = link;
    if (index < 0) continue;
    const UrdfJoint& joint = tree.joints[index];
    if (joint.type == UrdfJointType::kFixed) group[link] = group[joint.parent_link];
  }
  return group;
}

/// Whether exactly the same planned joints carry two links: no path moves one against the other.
bool movedAlike(const Kinematics& robot, int a, int b) {
  constexpr double kAnyRadius_m = 1.0;
  return ((robot.motionPerUnit(a, kAnyRadius_m).array() > 0.0) ==
          (robot.motionPerUnit(b, kAnyRadius_m).array() > 0.0))
      .all();
}

/// Pairs of links whose contact is none: moved alike, joined by one joint with whatever is fixed to either,
/// or listed in the robot file.
std::set<std::pair<int, int>> skippedPairs(const Scene& scene, const Kinematics& robot) {
  const UrdfTree& tree = robot.tree();
  const std::vector<int> group = rigidGroups(tree);
  std::set<std::pair<int, int>> joined, skipped;
  for (const UrdfJoint& joint : tree.joints)
    joined.emplace(group[joint.parent_link], group[joint.child_link]);
  for (int a = 0; a < static_cast<int>(group.size()); ++a)
    for (int b = 0; b < static_cast<int>(group.size()); ++b)
      if (movedAlike(robot, a, b) || joined.count({group[a], group[b]}) > 0)
        skipped.insert({std::min(a, b), std::max(a, b)});
  for (const auto& [name_a, name_b] : scene.robot.description.skip_self_collision) {
    const int a = requireLink(scene, tree, name_a), b = requireLink(scene, tree, name_b);
    skipped.insert({std::min(a, b), std::max(a, b)});
  }
  return skipped;
}

}  // namespace

CollisionSweep::CollisionSweep(const Scene& scene, const Kinematics& robot, const Grasp& grasp, double step_m,
                               const std::vector<StandingBody>& standing)
    : robot_(robot), opening_m_(grasp.opening_m), step_m_(step_m) {
  addBodies(scene, grasp);
  for (const StandingBody& body : standing) addBody(body.name, kWorld, false, body.placed);
  addPairs(scene);
}

void CollisionSweep::addBody(std::string name, int link, bool held, const PlacedBody& placed) {
  const double radius_m = (placed.X_LS * placed.body.centre()).norm() + placed.body.radius();
  Eigen::VectorXd motion = Eigen::VectorXd::Zero(robot_.dof());
  if (link != kWorld) motion = robot_.motionPerUnit(link, radius_m);
  bodies_.push_back(
      {std::move(name), link, held, placed, motion, placed.X_LS, placed.X_LS * placed.body.centre()});
}

void CollisionSweep::addObject(const std::string& name, const std::vector<PlacedShape>& pieces,
                               const Grasp& grasp) {
  const Eigen::Isometry3d X_TO = grasp.X_OT.inverse(Eigen::Isometry);
  for (const PlacedShape& piece : pieces)
    addBody("object '" + name + "'", robot_.tcpLink(), true,
            {ConvexBody::of(piece.shape), X_TO * piece.X_BS});
}

void CollisionSweep::addBodies(const Scene& scene, const Grasp& grasp) {
  const UrdfTree& tree = robot_.tree();
  for (int link = 0; link < static_cast<int>(tree.links.size()); ++link) {
    const UrdfLink& urdf_link = tree.links[link];
    for (const PlacedBody& placed : urdf_link.bodies)
      addBody("link '" + urdf_link.name + "'", link, false, placed);
  }
  if (const auto* task = std::get_if<PickPlaceTask>(&scene.task))
    addObject(task->object_name, task->object, grasp);
  if (const auto* task = std::get_if<PlacementTask>(&scene.task))
    addObject(task->object_name, task->object, grasp);
  for (const Obstacle& obstacle : scene.obstacles)
    addBody("obstacle '" + obstacle.name + "'", kWorld, false,
            {ConvexBody::of(obstacle.shape.shape), obstacle.shape.X_BS});
}

void CollisionSweep::addPairs(const Scene& scene) {
  const std::set<std::pair<int, int>> skipped = skippedPairs(scene, robot_);
  std::set<int> fingers;
  for (const std::string& name : scene.robot.description.finger_links)
    fingers.insert(requireLink(scene, robot_.tree(), name));
  const auto mayTouch = [&](const Body& a, const Body& b) {
    if (a.held && b.held) return true;
    if (a.link == kWorld || b.link == kWorld) return a.motion_per_unit.isZero() && b.motion_per_unit.isZero();
    if (a.held || b.held) return fingers.count(a.held ? b.link : a.link) > 0;
    return skipped.count({std::min(a.link, b.link), std::max(a.link, b.link)}) > 0;
  };
  for (int a = 0; a < static_cast<int>(bodies_.size()); ++a)
    for (int b = a + 1; b < static_cast<int>(bodies_.size()); ++b)
      if (!mayTouch(bodies_[a], bodies_[b])) pairs_.push_back({a, b, 0.0, 0.0, Eigen::Vector3d::UnitX()});
}

double CollisionSweep::steps(const Eigen::VectorXd& q1, const Eigen::VectorXd& q2) const {
  const Eigen::VectorXd amount = (q2 - q1).cwiseAbs();
  if (!amount.allFinite()) return std::numeric_limits<double>::infinity();
  double farthest_m = 0.0;
  for (const Body& body : bodies_) farthest_m = std::max(farthest_m, body.motion_per_unit.dot(amount));
  return farthest_m > 0.0 ? std::max(1.0, std::ceil(farthest_m / step_m_)) : 1.0;
}

/// Bounds all motions over an edge that changes the joints by `change`.
void CollisionSweep::prepareEdge(const Eigen::VectorXd& change) {
  const Eigen::VectorXd amount = change.cwiseAbs();
  for (Pair& pair : pairs_) {
    const Eigen::VectorXd& a = bodies_[pair.a].motion_per_unit;
    const Eigen::VectorXd& b = bodies_[pair.b].motion_per_unit;
    pair.due = 0.0;
    pair.motion_m = 0.0;
    // Seen from the last joint that moves both bodies, only the joints after it move either of them.
    for (Eigen::Index j = 0; j < amount.size(); ++j)
      if (a[j] == 0.0 || b[j] == 0.0) pair.motion_m += amount[j] * (a[j] + b[j]);
  }
}

void CollisionSweep::moveTo(const Eigen::VectorXd& q) {
  const std::vector<Eigen::Isometry3d> X_WL = robot_.linkPoses(q, opening_m_);
  for (Body& body : bodies_) {
    if (body.link == kWorld) continue;
    body.X_WS = X_WL[body.link] * body.placed.X_LS;
    body.p_WC = body.X_WS * body.placed.body.centre();
  }
}

/// Measures a pair at one of `count` + 1 samples and sets when it is due again. False: the two touch.
bool CollisionSweep::measure(Pair& pair, double sample, double count) {
  const Body& a = bodies_[pair.a];
  const Body& b = bodies_[pair.b];
  // The balls around the bodies suffice while they are farther apart than the smaller one is thick.
  double distance_m = (a.p_WC - b.p_WC).norm() - a.placed.body.radius() - b.placed.body.radius();
  const double thickness_m = 2.0 * std::min(a.placed.body.radius(), b.placed.body.radius());
  if (distance_m < closest_m_ + thickness_m) {
    const Separation found = separation(a.placed.body, a.X_WS, b.placed.body, b.X_WS, pair.direction);
    if (!found.apart()) return false;
    pair.direction = found.direction;
    distance_m = found.distance_m;
    closest_m_ = std::min(closest_m_, distance_m);
  }
  const double spare_m = distance_m - closest_m_;
  pair.due = pair.motion_m > 0.0 ? sample + std::floor(spare_m / pair.motion_m * count) + 1.0
                                 : std::numeric_limits<double>::infinity();
  return true;
}

std::optional<Contact> CollisionSweep::firstContact(const Eigen::VectorXd& q1, const Eigen::VectorXd& q2) {
  const double count = steps(q1, q2);
  if (!(count <= kMostSteps)) throw std::length_error("an edge has more steps than can be swept");
  prepareEdge(q2 - q1);
  samples_ += static_cast<long>(count) + (samples_ == 0 ? 1 : 0);  // edges share their way-points
  for (double sample = 0.0; sample <= count;) {
    const double fraction = sample / count;
    moveTo(sample < count ? Eigen::VectorXd(q1 + fraction * (q2 - q1)) : q2);
    double next = count + 1.0;
    for (Pair& pair : pairs_) {
      if (pair.due <= sample && !measure(pair, sample, count))
        return Contact{bodies_[pair.a].name, bodies_[pair.b].name, fraction};
      next = std::min(next, pair.due);
    }
    sample = next;
  }
  return std::nullopt;
}

double CollisionSweep::clearance_m() const { return std::isinf(closest_m_) ? 0.0 : closest_m_; }

}  // namespace b4p::verification
