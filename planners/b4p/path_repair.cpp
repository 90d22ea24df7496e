// SPDX-License-Identifier: BSD-3-Clause
#include "planners/b4p/path_repair.h"

#include <utility>

namespace b4p {

namespace ob = ompl::base;
namespace og = ompl::geometric;

PathRepair::PathRepair(const ob::SpaceInformationPtr& si, og::PathGeometric path, const Junction& junction,
                       std::size_t first_unchecked, unsigned iterations, Motion& motion, PublicationLog* log)
    : si_(si),
      path_(std::move(path)),
      junction_(junction),
      grasp_(junction.pick->tree->grasp),
      iterations_(iterations),
      log_(log) {
  bool colliding = false;
  for (std::size_t i = first_unchecked; i + 1 < path_.getStateCount(); ++i) {
    const bool free = motion.isFree(path_.getState(i), path_.getState(i + 1), grasp_);
    if (!free && !colliding) runs_.push_back({i, i + 1});
    if (!free) runs_.back().end = i + 1;
    colliding = !free;
  }
  if (runs_.empty())
    status_ = Status::kSucceeded;
  else
    beginRun();
}

PathRepair::Status PathRepair::status() const {
  std::lock_guard<std::mutex> lock(mutex_);
  return status_;
}

void PathRepair::beginRun() {
  const Run& run = runs_[detours_.size()];
  local_ = std::make_shared<ForestPair>(si_, GraspAccess(si_).distance(), grasp_, nullptr, log_);
  local_->plant(Side::kPick, path_.getState(run.begin), grasp_, kNoPlacement);
  local_->plant(Side::kPlace, path_.getState(run.end), grasp_, kNoPlacement);
  spent_ = 0;
}

std::optional<PathRepair::Attempt> PathRepair::replan(Motion& motion) {
  Attempt attempt;
  Run run;
  bool from_begin;
  {
    std::lock_guard<std::mutex> lock(mutex_);
    if (status_ == Status::kRunning && spent_ >= iterations_) status_ = Status::kFailed;
    if (status_ != Status::kRunning) return std::nullopt;
    attempt.local = local_;
    run = runs_[detours_.size()];
    from_begin = spent_ % 2 == 0;
    ++spent_;
  }
  const ob::State* target = motion.sampleAround(path_.getState(run.begin), path_.getState(run.end));
  attempt.junction =
      growAndConnect(*attempt.local, from_begin ? Side::kPick : Side::kPlace, target, motion).junction;
  return attempt;
}

PathRepair::Status PathRepair::accept(const Attempt& attempt) {
  std::lock_guard<std::mutex> lock(mutex_);
  if (!attempt.junction || attempt.local != local_ || status_ != Status::kRunning) return status_;
  detours_.push_back(pathThrough(*attempt.junction, si_).path);
  if (detours_.size() == runs_.size())
    status_ = Status::kSucceeded;
  else
    beginRun();
  return status_;
}

og::PathGeometric PathRepair::assemble(std::size_t first, std::size_t last) const {
  og::PathGeometric assembled(si_);
  assembled.append(path_.getState(first));
  std::size_t run = 0;
  while (run < detours_.size() && runs_[run].begin < first) ++run;
  for (std::size_t i = first; i < last;) {
    if (run < detours_.size() && runs_[run].begin == i) {
      for (std::size_t k = 1; k < detours_[run].getStateCount(); ++k)
        assembled.append(detours_[run].getState(k));
      i = runs_[run++].end;
    } else {
      assembled.append(path_.getState(++i));
    }
  }
  return assembled;
}

og::PathGeometric PathRepair::freePrefix() const {
  std::lock_guard<std::mutex> lock(mutex_);
  return assemble(0, runs_[detours_.size()].begin);
}

og::PathGeometric PathRepair::freeSuffix() const {
  std::lock_guard<std::mutex> lock(mutex_);
  og::PathGeometric suffix(si_);
  for (std::size_t i = runs_.back().end; i < path_.getStateCount(); ++i) suffix.append(path_.getState(i));
  return suffix;
}

}  // namespace b4p
