// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <mutex>
#include <optional>
#include <vector>

#include <ompl/geometric/PathGeometric.h>

#include "planners/b4p/forest.h"
#include "planners/b4p/growth.h"
#include "planners/b4p/motion.h"

namespace b4p {

/// Mends a path whose states carry one grasp but whose edges may collide under it (Algorithm 4): each maximal
/// run of colliding edges is replaced by a motion found by local replanning between the run's two ends; all
/// other edges stay as they are. A run that reaches the end of the path counts. Any number of threads may
/// replan() for the same repair: they mend its runs together, one run after the other.
class PathRepair {
 public:
  enum class Status { kRunning, kSucceeded, kFailed };

  /// What one iteration of local replanning has found.
  struct Attempt {
    std::shared_ptr<ForestPair> local;  ///< grew for the run at that time
    std::optional<Junction> junction;   ///< set when it mends the run
  };

  /// Checks the edges from way-point `first_unchecked` on; those before it are known to be free.
  /// @param junction    the connection that the path came from, kept for who asked
  /// @param iterations  of local replanning per run before the repair fails
  /// @param log         of the search; may be nullptr
  PathRepair(const ompl::base::SpaceInformationPtr& si, ompl::geometric::PathGeometric path,
             const Junction& junction, std::size_t first_unchecked, unsigned iterations, Motion& motion,
             PublicationLog* log = nullptr);

  /// One iteration of local replanning, to be handed to accept(). Nothing when the repair has ended, which it
  /// does here when a run has used up its iterations.
  std::optional<Attempt> replan(Motion& motion);

  /// Takes over what replan() has found, unless that run has been mended meanwhile.
  Status accept(const Attempt& attempt);

  Status status() const;

  const Junction& junction() const { return junction_; }

  /// How many runs of colliding edges there were.
  std::size_t runCount() const { return runs_.size(); }

  /// The whole path, mended. Only after kSucceeded.
  ompl::geometric::PathGeometric repaired() const { return assemble(0, path_.getStateCount() - 1); }

  /// After kFailed: what is free from the start up to the run that failed, mended runs included, and from
  /// that run to the end of the path as far as it is free from there backwards.
  ompl::geometric::PathGeometric freePrefix() const;
  ompl::geometric::PathGeometric freeSuffix() const;

 private:
  /// Way-points [begin, end] whose edges all collide.
  struct Run {
    std::size_t begin, end;
  };

  void beginRun();
  ompl::geometric::PathGeometric assemble(std::size_t first, std::size_t last) const;

  ompl::base::SpaceInformationPtr si_;
  const ompl::geometric::PathGeometric path_;
  Junction junction_;
  GraspId grasp_;
  unsigned iterations_;
  PublicationLog* log_;
  std::vector<Run> runs_;

  mutable std::mutex mutex_;  // guards what follows
  Status status_ = Status::kRunning;
  std::vector<ompl::geometric::PathGeometric> detours_;  ///< one per run mended so far
  std::shared_ptr<ForestPair> local_;                    ///< grows for run detours_.size()
  unsigned spent_ = 0;
};

}  // namespace b4p
