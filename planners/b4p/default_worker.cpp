// SPDX-License-Identifier: BSD-3-Clause
#include "planners/b4p/default_worker.h"

#include <algorithm>

#include "planners/b4p/retreat.h"

namespace b4p {

namespace ob = ompl::base;
namespace og = ompl::geometric;

void DefaultWorker::advance() {
  if (!turn_) takeTurn();
  if (turn_->forests == nullptr)
    drawRoots();
  else if (turn_->forests->treeCount(Side::kPick) == 0 || turn_->forests->treeCount(Side::kPlace) == 0)
    seekPlaceRoot();
  else
    grow(*turn_->forests);
  if (turn_ && --left_ == 0) endTurn(false);
}

void DefaultWorker::takeTurn() {
  turn_ = search().schedule().take();
  left_ = turn_->forests == nullptr ? search().parameters().root_attempts : search().parameters().slice;
}

void DefaultWorker::rest() {
  if (turn_) endTurn(false);
}

void DefaultWorker::endTurn(bool fruitful) {
  share(search().log(),
        [&schedule = search().schedule(), turn = *turn_, fruitful] { schedule.giveBack(turn, fruitful); });
  turn_.reset();
}

// New forests are worth a turn of their own once both their sides have a root.
void DefaultWorker::drawRoots() {
  if (search().region() == nullptr) {
    if (search().plantGoal()) endTurn(true);
    return;
  }
  const Pick pick = drawPick();
  if (pick.grasp == kNoGrasp) return;
  const bool placed = placeTreeFor(region().samplePlacement(), pick.grasp) != nullptr;
  if (pick.is_new && placed) endTurn(true);
}

void DefaultWorker::seekPlaceRoot() {
  if (search().region() != nullptr && turn_->forests->treeCount(Side::kPlace) == 0)
    placeTreeFor(region().samplePlacement(), turn_->forests->grasp());
  endTurn(false);
}

void DefaultWorker::grow(ForestPair& forests) {
  // Each turn begins with the straight way to a root.
  const bool first = left_ == search().parameters().slice;
  if (first && search().region() != nullptr) retreatFromRoots(forests);
  const ob::State* target = first ? anyRoot(forests, opposite(next_side_)) : motion().sample();
  const Growth growth = growAndConnect(forests, next_side_, target, motion());
  next_side_ = opposite(next_side_);
  search().statistics().nodes += growth.nodes;
  if (growth.grown == nullptr) return;
  countOne(search().statistics().connections_tried);
  if (growth.junction && search().rootsMatch(*growth.junction)) return search().publish(*growth.junction);
  if (search().region() != nullptr && search().parameters().relaxed) joinAcrossGrasps(growth.grown);
}

void DefaultWorker::retreatFromRoots(const ForestPair& forests) {
  for (const Side side : {Side::kPick, Side::kPlace})
    for (Tree* tree : forests.trees(side))
      search().statistics().nodes +=
          retreat(*tree, search().parameters().retreat_steps, region(), motion(), root());
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

// Eq. 3 is asked once per placement and grasp; its roots stay as trees.
const Tree* DefaultWorker::placeTreeFor(PlacementId placement, GraspId grasp) {
  if (const auto known = search().memory().placeTree(placement, grasp)) return *known;
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
