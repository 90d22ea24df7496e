// SPDX-License-Identifier: BSD-3-Clause
#include "planners/b4p/default_worker.h"

#include <algorithm>
#include <utility>

#include "planners/b4p/retreat.h"
#include "planners/b4p/sliding.h"

namespace b4p {

namespace ob = ompl::base;
namespace og = ompl::geometric;

using Outcome = Schedule::Outcome;

namespace {

/// Forests of this age have had many turns and will have few: these are so many slices long.
constexpr std::uint64_t kOld = 64;
constexpr unsigned kOldSlices = 4;

/// A turn ends when so many motions of one side in a row were blocked at once.
constexpr unsigned kPatience = 4;

}  // namespace

void DefaultWorker::advance() {
  if (!turn_) takeTurn();
  if (turn_->forests == nullptr)
    drawRoots();
  else
    grow(*turn_->forests);
  if (turn_ && --left_ == 0) rest();
}

void DefaultWorker::takeTurn() {
  turn_ = search().schedule().take();
  const B4PParameters& parameters = search().parameters();
  left_ = turn_->forests == nullptr ? parameters.root_attempts
                                    : parameters.slice * (turn_->age < kOld ? 1 : kOldSlices);
  begun_ = false;
  promising_ = false;
  trapped_ = {};
}

void DefaultWorker::rest() {
  if (!turn_) return;
  if (turn_->forests != nullptr) return endTurn(Outcome::kGrown);
  endTurn(promising_ ? Outcome::kFruitful : Outcome::kFruitless);
}

void DefaultWorker::endTurn(Outcome outcome) {
  share(search().log(),
        [&schedule = search().schedule(), turn = *turn_, outcome] { schedule.giveBack(turn, outcome); });
  turn_.reset();
}

// By turns a grasp is drawn, and one that has been picked gets another placement.
void DefaultWorker::drawRoots() {
  if (search().region() == nullptr) {
    if (search().plantGoal()) endTurn(Outcome::kFruitful);
    return;
  }
  const ForestPair* unplaced = left_ % 2 == 0 ? search().nextUnplaced() : nullptr;
  if (unplaced != nullptr) {
    promising_ = true;
    return seekPlaceRoot(unplaced->grasp(), region().samplePlacement());
  }
  const PlacementId placement = region().samplePlacement();
  const Pick pick = drawPickFor(placement);
  if (pick.grasp == kNoGrasp) return;
  promising_ = promising_ || pick.is_new;
  const ForestPair& forests = search().forestsOf(pick.grasp);
  if (!forests.complete())
    seekPlaceRoot(pick.grasp, placement);
  else
    placeTreeFor(placement, pick.grasp);
}

// Forests have as many roots on a side as their nodes have doubled.
bool DefaultWorker::deservesRoot(const ForestPair& forests, Side side) {
  return std::size_t{1} << std::min<std::size_t>(forests.treeCount(side), 63) <= forests.nodeCount();
}

bool DefaultWorker::wantsPick(GraspId grasp) {
  const ForestPair& forests = search().forestsOf(grasp);
  return forests.treeCount(Side::kPick) == 0 || deservesRoot(forests, Side::kPick);
}

// Forests are worth a turn of their own once both their sides have a root.
void DefaultWorker::seekPlaceRoot(GraspId grasp, PlacementId placement) {
  if (placeTreeFor(placement, grasp) != nullptr) endTurn(Outcome::kFruitful);
}

void DefaultWorker::grow(ForestPair& forests) {
  // Each turn begins with the straight way to a root.
  const bool first = !std::exchange(begun_, true);
  if (first && search().region() != nullptr && !leavesRoots(forests) && turn_->age == 0)
    return endTurn(Outcome::kPutOff);
  const ob::State* target = first ? anyRoot(forests, opposite(next_side_)) : motion().sample();
  const Side side = std::exchange(next_side_, opposite(next_side_));
  const bool sliding = search().parameters().slide && !first;
  const std::optional<Growth> attempt = sliding ? slideAndConnect(forests, side, target, motion())
                                                : growAndConnect(forests, side, target, motion());
  if (!attempt) {
    ++left_;
    return;
  }
  const Growth& growth = *attempt;
  turn_->gap = std::min(turn_->gap, growth.gap);
  search().statistics().nodes += growth.nodes;
  unsigned& trapped = trapped_[index(side)];
  trapped = growth.grown == nullptr ? trapped + 1 : 0;
  if (trapped == kPatience && search().region() != nullptr) left_ = 1;
  if (growth.grown == nullptr) return;
  countOne(search().statistics().connections_tried);
  if (growth.junction && search().rootsMatch(*growth.junction)) return search().publish(*growth.junction);
  if (search().region() != nullptr && search().parameters().relaxed) joinAcrossGrasps(growth.grown);
}

// The place side first: there roots are more often boxed in, and then the other need not be tried.
bool DefaultWorker::leavesRoots(const ForestPair& forests) {
  return leavesRoots(forests, Side::kPlace) && leavesRoots(forests, Side::kPick);
}

// Whether some root has a straight way out of at least half the length that is tried; then the others need
// none.
bool DefaultWorker::leavesRoots(const ForestPair& forests, Side side) {
  const unsigned steps = search().parameters().retreat_steps;
  if (region().retreatDirections() == 0) return true;
  for (Tree* tree : forests.trees(side)) {
    search().statistics().nodes += retreat(*tree, steps, region(), motion(), root());
    if (tree->way_out >= steps / 2) return true;
  }
  return false;
}

const ob::State* DefaultWorker::anyRoot(const ForestPair& forests, Side side) {
  const auto trees = forests.trees(side);
  return trees[motion().random().uniformInt(0, static_cast<int>(trees.size()) - 1)]->root->state;
}

void DefaultWorker::joinAcrossGrasps(const Node* grown) {
  const Side side = grown->tree->side;
  const Node* near = search().nearestAnywhere(opposite(side), grown->state);
  if (near == nullptr || near->tree->grasp == grown->tree->grasp || search().repairCount() > 0) return;
  const Junction junction = side == Side::kPick ? Junction{grown, near} : Junction{near, grown};
  const GraspId grasp = junction.pick->tree->grasp;
  if (!search().memory().mayJoin(junction.pick->tree, junction.place->tree)) return;
  const Tree* end = placeTreeFor(junction.place->tree->placement, grasp);
  if (end == nullptr) return;
  countOne(search().statistics().connections_tried);
  if (motion().isFree(junction.pick->state, junction.place->state, grasp)) repair(junction, end->root->state);
}

// Eq. 3 is asked once per placement and grasp; its roots stay as trees. nullptr also when the grasp has place
// roots enough for now.
const Tree* DefaultWorker::placeTreeFor(PlacementId placement, GraspId grasp) {
  if (const auto known = search().memory().placeTree(placement, grasp)) return *known;
  if (!deservesRoot(search().forestsOf(grasp), Side::kPlace)) return nullptr;
  const Tree* tree = nullptr;
  if (derivePlaceRoot(placement, grasp)) tree = search().plant(Side::kPlace, root(), grasp, placement);
  share(search().log(), [&memory = search().memory(), placement, grasp, tree] {
    memory.setPlaceTree(placement, grasp, tree);
  });
  return tree;
}

void DefaultWorker::salvage(const PathRepair& repair) {
  discard(repair.junction());
  transplant(Side::kPick, repair.freePrefix());
  og::PathGeometric suffix = repair.freeSuffix();
  suffix.reverse();
  transplant(Side::kPlace, suffix);
}

void DefaultWorker::discard(const Junction& junction) {
  search().memory().repairFailed(junction.pick->tree, junction.place->tree);
}

// The path starts at a root or leaves a tree at a state that is already in it.
void DefaultWorker::transplant(Side side, const og::PathGeometric& path) {
  ForestPair& forests = search().forestsOf(motion().grasps().get(path.getState(0)));
  const Node* node = nullptr;
  for (std::size_t i = 0; i < path.getStateCount(); ++i) {
    const ob::State* state = path.getState(i);
    const Node* nearest = forests.nearest(side, state);
    if (nearest == nullptr) return;
    if (search().si()->equalStates(nearest->state, state)) {
      node = nearest;
    } else if (node != nullptr) {
      node = forests.grow(node, state);
      countOne(search().statistics().nodes);
    } else {
      return;
    }
  }
}

}  // namespace b4p
