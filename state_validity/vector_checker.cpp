// SPDX-License-Identifier: BSD-3-Clause
#include <utility>

#include "state_validity/lanes/lane_block.h"
#ifndef NDEBUG
#include "state_validity/compared_context.h"
#include "state_validity/fcl_context.h"
#endif
#include "state_validity/vector_context.h"

namespace b4p {
namespace {

class VectorChecker : public CollisionChecker {
 public:
  explicit VectorChecker(CollisionProblem problem)
      : world_(std::make_shared<const FclWorld>(std::move(problem))),
        model_(std::make_shared<const lanes::LaneModel>(*world_)) {}

  std::unique_ptr<CollisionContext> makeContext() const override {
    auto context = std::make_unique<VectorContext>(world_, model_);
#ifdef NDEBUG
    return context;
#else
    return std::make_unique<ComparedContext>(std::move(context), std::make_unique<FclContext>(world_));
#endif
  }
  const CollisionProblem& problem() const override { return world_->problem(); }

  std::shared_ptr<const CollisionChecker> sameKindFor(CollisionProblem problem) const override {
    return makeVectorChecker(std::move(problem));
  }
  std::string description() const override {
    std::string text = std::string("vectorised, ") + lanes::instructionSet();
    if (!model_->coarse().empty())
      text += "; FCL decides wherever the bounding box does not for the meshes of " + model_->coarse();
    return text;
  }

 private:
  std::shared_ptr<const FclWorld> world_;
  std::shared_ptr<const lanes::LaneModel> model_;
};

}  // namespace

std::shared_ptr<const CollisionChecker> makeVectorChecker(CollisionProblem problem) {
  return std::make_shared<const VectorChecker>(std::move(problem));
}

}  // namespace b4p
