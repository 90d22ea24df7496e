// SPDX-License-Identifier: BSD-3-Clause
#include "planners/reach/jplus_search.h"

#include "planners/reach/jacobian_descent.h"

namespace b4p {

namespace ob = ompl::base;

namespace {

StateDistance metric(const ob::SpaceInformationPtr& si, const ReachGoal& goal, bool scaled) {
  return scaled ? goal.joints().scaledDistance() : GraspAccess(si).distance();
}

}  // namespace

JPlusSearch::JPlusSearch(const ob::SpaceInformationPtr& si, const ReachGoal& goal,
                         const JPlusRRTParameters& parameters, std::uint64_t seed,
                         ReachStatistics& statistics)
    : ReachSearch(si, goal, metric(si, goal, parameters.scaled_metric), parameters.range, statistics),
      parameters_(parameters),
      context_(goal.robot().makeContext()),
      approaches_(goal.targets()),
      random_(seed),
      next_(si) {}

void JPlusSearch::startPlanted(const Node* root) {
  approaches_.offer(root, context_->tcpPose(joints().q(root->state)));
}

std::optional<Junction> JPlusSearch::step() {
  const bool steering = motion().random().uniform01() < parameters_.steer_probability;
  const GraspId grasp = steering ? approaches_.draw(random_, parameters_.weighted_grasps) : kNoGrasp;
  return grasp != kNoGrasp ? steer(grasp) : growRandomly();
}

std::optional<Junction> JPlusSearch::growRandomly() {
  const Expansion grown = expand(forests(), Side::kPick, motion().sample(), motion());
  if (!grown.added) return {};
  countOne(statistics().nodes);
  const GraspId grasp = approaches_.offer(grown.node, context_->tcpPose(joints().q(grown.node->state)));
  return reached(grown.node, grasp);
}

std::optional<Junction> JPlusSearch::reached(const Node* node, GraspId grasp) {
  if (grasp == kNoGrasp) return {};
  return Junction{node, plantGoal(node->state, grasp)};
}

std::optional<Junction> JPlusSearch::steer(GraspId grasp) {
  countOne(statistics().grasps_tried);
  const Node* node = approaches_.take(grasp);
  JacobianDescent descent({parameters_.cartesian_step, parameters_.orientation_distance}, joints().lower(),
                          joints().upper());
  Eigen::VectorXd q = Eigen::Map<const Eigen::VectorXd>(joints().q(node->state), joints().dof());
  Eigen::Isometry3d X_WT = context_->tcpPose(q.data());
  for (unsigned i = 0; i < parameters_.steering_steps; ++i) {
    q = descent.step(*context_, q, goal().targets().twistTo(grasp, X_WT));
    if (q.size() == 0) return {};
    si()->copyState(next_.get(), node->state);
    Eigen::Map<Eigen::VectorXd>(joints().q(next_.get()), q.size()) = q;
    if (!motion().isFree(node->state, next_.get(), kNoGrasp)) return {};
    node = forests().grow(node, next_.get());
    countOne(statistics().nodes);
    X_WT = context_->tcpPose(q.data());
    const GraspId satisfied = approaches_.offer(node, X_WT, grasp);
    if (satisfied != kNoGrasp) return reached(node, satisfied);
  }
  approaches_.offerTo(grasp, node, X_WT);  // the way was not blocked, only long
  return {};
}

}  // namespace b4p
