// SPDX-License-Identifier: BSD-3-Clause
#include <utility>

#include "state_validity/fcl_context.h"

namespace b4p {
namespace {

class FclChecker : public CollisionChecker {
 public:
  explicit FclChecker(CollisionProblem problem)
      : world_(std::make_shared<const FclWorld>(std::move(problem))) {}

  std::unique_ptr<CollisionContext> makeContext() const override {
    return std::make_unique<FclContext>(world_);
  }
  const CollisionProblem& problem() const override { return world_->problem(); }
  std::shared_ptr<const CollisionChecker> sameKindFor(CollisionProblem problem) const override {
    return makeFclChecker(std::move(problem));
  }
  std::string description() const override { return "FCL"; }

 private:
  std::shared_ptr<const FclWorld> world_;
};

}  // namespace

std::shared_ptr<const CollisionChecker> makeFclChecker(CollisionProblem problem) {
  return std::make_shared<const FclChecker>(std::move(problem));
}

}  // namespace b4p
