// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/scene_motion_checker.h"

#include <utility>

namespace b4p {
namespace {

/// Says after a question how much a context has counted in all.
class CountedQuestion {
 public:
  CountedQuestion(const CollisionContext& context, ConfigurationCounts::Count& count)
      : context_(context), count_(count) {}
  ~CountedQuestion() { count_.value.store(context_.configurationsChecked(), std::memory_order_relaxed); }
  CountedQuestion(const CountedQuestion&) = delete;
  CountedQuestion& operator=(const CountedQuestion&) = delete;

 private:
  const CollisionContext& context_;
  ConfigurationCounts::Count& count_;
};

class SceneMotionContext : public GraspMotionContext {
 public:
  SceneMotionContext(std::unique_ptr<CollisionContext> context, std::shared_ptr<const SceneRegion> region,
                     std::shared_ptr<ConfigurationCounts> configurations)
      : context_(std::move(context)),
        region_(std::move(region)),
        configurations_(std::move(configurations)),
        count_(configurations_->add()) {}

  bool isFree(const double* q, GraspId grasp) override {
    const CountedQuestion counted(*context_, count_);
    return context_->isFree(q, held(grasp));
  }
  bool isEdgeFree(const double* q1, const double* q2, GraspId grasp) override {
    const CountedQuestion counted(*context_, count_);
    return context_->isEdgeFree(q1, q2, held(grasp));
  }
  double freeFraction(const double* q1, const double* q2, GraspId grasp) override {
    const CountedQuestion counted(*context_, count_);
    return context_->freeFraction(q1, q2, held(grasp));
  }

 private:
  const Grasp* held(GraspId grasp) const { return grasp == kNoGrasp ? nullptr : &region_->grasp(grasp); }

  std::unique_ptr<CollisionContext> context_;
  std::shared_ptr<const SceneRegion> region_;
  std::shared_ptr<ConfigurationCounts> configurations_;
  ConfigurationCounts::Count& count_;
};

}  // namespace

std::unique_ptr<GraspMotionContext> SceneMotionChecker::makeContext() const {
  return std::make_unique<SceneMotionContext>(checker_->makeContext(), region_, configurations_);
}

}  // namespace b4p
