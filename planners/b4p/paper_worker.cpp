// SPDX-License-Identifier: BSD-3-Clause
#include "planners/b4p/paper_worker.h"

namespace b4p {

void PaperWorker::advance() {
  if (spawnForest()) return;
  const ompl::base::State* target = motion().sample();
  ForestPair& forests = search().commonForests();
  const Expansion pick = expand(forests, Side::kPick, target, motion());
  const Expansion place = expand(forests, Side::kPlace, target, motion());
  search().statistics().nodes += std::uint64_t{pick.added} + std::uint64_t{place.added};
  if (pick.node != nullptr && place.node != nullptr) connect({pick.node, place.node});
}

// Algorithm 2, one root at a time so that all workers take part.
bool PaperWorker::spawnForest() {
  const B4PParameters& parameters = search().parameters();
  if (search().region() == nullptr) {
    if (search().rootsOffered(Side::kPlace) >= parameters.place_roots) return false;
    return search().plantGoal() || search().rootCount(Side::kPlace) == 0;
  }
  if (search().rootsOffered(Side::kPick) < parameters.pick_roots) {
    drawPick();
    return true;
  }
  if (search().rootsOffered(Side::kPlace) >= parameters.place_roots) return false;
  const auto picks = search().commonForests().trees(Side::kPick);
  const GraspId grasp = picks[motion().random().uniformInt(0, static_cast<int>(picks.size()) - 1)]->grasp;
  const PlacementId placement = region().samplePlacement();
  if (derivePlaceRoot(placement, grasp)) search().plant(Side::kPlace, root(), grasp, placement);
  return true;
}

void PaperWorker::connect(const Junction& junction) {
  const Tree& pick = *junction.pick->tree;
  const Tree& place = *junction.place->tree;
  if (pick.grasp != place.grasp && !search().parameters().relaxed) return;
  countOne(search().statistics().connections_tried);
  if (!motion().isFree(junction.pick->state, junction.place->state, pick.grasp)) return;
  if (pick.grasp == place.grasp) {
    if (search().rootsMatch(junction)) search().publish(junction);
  } else if (search().region() != nullptr && derivePlaceRoot(place.placement, pick.grasp)) {
    repair(junction, root());
  }
}

}  // namespace b4p
