// SPDX-License-Identifier: BSD-3-Clause
#include "planners/b4p/worker.h"

#include <utility>

#include "planners/b4p/default_worker.h"
#include "planners/b4p/paper_worker.h"

namespace b4p {

namespace ob = ompl::base;
namespace og = ompl::geometric;

Worker::Worker(Search& search, std::uint64_t seed)
    : search_(search),
      motion_(search.si(), search.parameters().range),
      drawer_(search.si(), search.region(), seed) {}

void Worker::step() {
  if (search_.finished()) return;
  countOne(search_.statistics().iterations);
  if (const auto repair = search_.repair())
    helpRepair(repair);
  else
    advance();
}

void Worker::helpRepair(const std::shared_ptr<PathRepair>& repair) {
  const auto attempt = repair->replan(motion_);
  if (!attempt) return endRepair(repair);
  share(search_.log(), [this, repair, attempt = *attempt] {
    if (repair->accept(attempt) != PathRepair::Status::kRunning) endRepair(repair);
  });
}

void Worker::endRepair(const std::shared_ptr<PathRepair>& repair) {
  if (!search_.retire(repair)) return;
  if (repair->status() == PathRepair::Status::kFailed) return salvage(*repair);
  countOne(search_.statistics().repairs_succeeded);
  search_.publish(repair->repaired());
}

Worker::Pick Worker::plantPick(GraspId grasp) {
  if (grasp == kNoGrasp) return {};
  if (!wantsPick(grasp)) return {grasp, false};
  return {grasp, search_.plant(Side::kPick, root(), grasp) != nullptr};
}

void Worker::repair(const Junction& junction, const ob::State* place_root) {
  JoinedPath joined = pathThrough(junction, search_.si());
  ob::State* end = joined.path.getStates().back();
  search_.si()->copyState(end, place_root);
  motion_.grasps().set(end, junction.pick->tree->grasp);
  auto repair = std::make_shared<PathRepair>(search_.si(), std::move(joined.path), junction, joined.junction,
                                             search_.parameters().repair_iterations, motion_, search_.log());
  if (search_.parameters().repair) return search_.submit(std::move(repair));
  if (repair->status() != PathRepair::Status::kSucceeded) return discard(junction);
  search_.publish(repair->repaired());
}

std::unique_ptr<Worker> makeWorker(Search& search, std::uint64_t seed) {
  if (search.parameters().paper) return std::make_unique<PaperWorker>(search, seed);
  return std::make_unique<DefaultWorker>(search, seed);
}

std::unique_ptr<ParallelWorker> Search::newWorker(std::uint64_t seed) { return makeWorker(*this, seed); }

}  // namespace b4p
