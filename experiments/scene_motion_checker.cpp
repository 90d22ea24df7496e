// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/scene_motion_checker.h"

#include <utility>

namespace b4p {
namespace {

class SceneMotionContext : public GraspMotionContext {
 public:
  SceneMotionContext(std::unique_ptr<CollisionContext> context, std::shared_ptr<const SceneRegion> region)
      : context_(std::move(context)), region_(std::move(region)) {}

  bool isFree(const double* q, GraspId grasp) override { return context_->isFree(q, held(grasp)); }
  bool isEdgeFree(const double* q1, const double* q2, GraspId grasp) override {
    return context_->isEdgeFree(q1, q2, held(grasp));
  }
  double freeFraction(const double* q1, const double* q2, GraspId grasp) override {
    return context_->freeFraction(q1, q2, held(grasp));
  }

 private:
  const Grasp* held(GraspId grasp) const { return grasp == kNoGrasp ? nullptr : &region_->grasp(grasp); }

  std::unique_ptr<CollisionContext> context_;
  std::shared_ptr<const SceneRegion> region_;
};

}  // namespace

std::unique_ptr<GraspMotionContext> SceneMotionChecker::makeContext() const {
  return std::make_unique<SceneMotionContext>(checker_->makeContext(), region_);
}

}  // namespace b4p
