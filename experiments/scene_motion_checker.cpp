// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/scene_motion_checker.h"

#include <utility>

namespace b4p {
namespace {

/// Adds what a context counts during one question to a count that all threads share.
class CountedQuestion {
 public:
  CountedQuestion(const CollisionContext& context, std::atomic<std::uint64_t>& total)
      : context_(context), total_(total), before_(context.configurationsChecked()) {}
  ~CountedQuestion() {
    total_.fetch_add(context_.configurationsChecked() - before_, std::memory_order_relaxed);
  }
  CountedQuestion(const CountedQuestion&) = delete;
  CountedQuestion& operator=(const CountedQuestion&) = delete;

 private:
  const CollisionContext& context_;
  std::atomic<std::uint64_t>& total_;
  std::uint64_t before_;
};

class SceneMotionContext : public GraspMotionContext {
 public:
  SceneMotionContext(std::unique_ptr<CollisionContext> context, std::shared_ptr<const SceneRegion> region,
                     std::shared_ptr<std::atomic<std::uint64_t>> configurations)
      : context_(std::move(context)),
        region_(std::move(region)),
        configurations_(std::move(configurations)) {}

  bool isFree(const double* q, GraspId grasp) override {
    const CountedQuestion counted(*context_, *configurations_);
    return context_->isFree(q, held(grasp));
  }
  bool isEdgeFree(const double* q1, const double* q2, GraspId grasp) override {
    const CountedQuestion counted(*context_, *configurations_);
    return context_->isEdgeFree(q1, q2, held(grasp));
  }
  double freeFraction(const double* q1, const double* q2, GraspId grasp) override {
    const CountedQuestion counted(*context_, *configurations_);
    return context_->freeFraction(q1, q2, held(grasp));
  }

 private:
  const Grasp* held(GraspId grasp) const { return grasp == kNoGrasp ? nullptr : &region_->grasp(grasp); }

  std::unique_ptr<CollisionContext> context_;
  std::shared_ptr<const SceneRegion> region_;
  std::shared_ptr<std::atomic<std::uint64_t>> configurations_;
};

}  // namespace

std::unique_ptr<GraspMotionContext> SceneMotionChecker::makeContext() const {
  return std::make_unique<SceneMotionContext>(checker_->makeContext(), region_, configurations_);
}

}  // namespace b4p
