// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "planners/b4p/schedule.h"
#include "planners/b4p/worker.h"

namespace b4p {

/// The worker of the default search. Each grasp has forests of its own, which grow by RRT-Connect, slide
/// along what blocks them (slideAndConnect()) and are served in turn (Schedule); roots are drawn without
/// limit, and trees leave them by straight ways (retreat()). Forests whose roots have no long way out are put
/// off, and a turn in which a side cannot move ends early. Every new node is also offered to the nearest tree
/// of any other grasp: if Eq. 3 has a root for it, the two are joined and the path repaired. What a failed
/// repair found out is kept: the free ends of its path join the trees.
class DefaultWorker : public Worker {
 public:
  using Worker::Worker;
  void rest() override;

 protected:
  void advance() override;
  void salvage(const PathRepair& repair) override;
  void discard(const Junction& junction) override;

 private:
  void takeTurn();
  void endTurn(Schedule::Outcome outcome);
  void drawRoots();
  void seekPlaceRoot(GraspId grasp, PlacementId placement);
  bool wantsPick(GraspId grasp) override;
  static bool deservesRoot(const ForestPair& forests, Side side);
  void grow(ForestPair& forests);
  bool leavesRoots(const ForestPair& forests);
  bool leavesRoots(const ForestPair& forests, Side side);
  const ompl::base::State* anyRoot(const ForestPair& forests, Side side);
  void joinAcrossGrasps(const Node* grown);
  const Tree* placeTreeFor(PlacementId placement, GraspId grasp);
  void transplant(Side side, const ompl::geometric::PathGeometric& path);

  std::optional<Schedule::Turn> turn_;
  unsigned left_ = 0;       ///< steps of this turn
  bool begun_ = false;      ///< its forests have grown
  bool promising_ = false;  ///< this drawing found a pick, or knows one without a placement
  Side next_side_ = Side::kPick;
  std::array<unsigned, 2> trapped_{};  ///< how often in a row each side could not move in this turn
};

}  // namespace b4p
