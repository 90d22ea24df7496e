// SPDX-License-Identifier: BSD-3-Clause
// Builds with assertions end on a verdict that is not FCL's; others do not compare.
#include "state_validity/compared_context.h"

#include <gtest/gtest.h>

#include "state_validity/crane.h"
#include "state_validity/vector_context.h"

namespace b4p::testing {
namespace {

CollisionProblem problem() {
  CollisionProblem crane;
  crane.robot = Crane().with("tool", Sphere{0.1}).build();
  return crane;
}

#ifdef NDEBUG

TEST(ComparedContext, HasNoPartInBuildsWithoutAssertions) {
  EXPECT_NE(dynamic_cast<VectorContext*>(makeVectorChecker(problem())->makeContext().get()), nullptr);
}

#else

/// FCL's answers, one kind of which can be made wrong.
class WrongContext : public CollisionContext {
 public:
  bool isFree(const double* q, const Grasp* held) override { return right_->isFree(q, held) != wrong_state; }
  void areFree(const double* q, int count, const Grasp* held, bool* free) override {
    right_->areFree(q, count, held, free);
    if (wrong_last_of_many) free[count - 1] = !free[count - 1];
  }
  bool isEdgeFree(const double* q1, const double* q2, const Grasp* held) override {
    return right_->isEdgeFree(q1, q2, held) != wrong_edge;
  }
  double freeFraction(const double* q1, const double* q2, const Grasp* held) override {
    return right_->freeFraction(q1, q2, held) - (wrong_fraction ? 1e-9 : 0.0);
  }
  std::string describeCollision(const double* q, const Grasp* held) override {
    return right_->describeCollision(q, held);
  }

  bool wrong_state = false, wrong_last_of_many = false, wrong_edge = false, wrong_fraction = false;

 private:
  std::unique_ptr<CollisionContext> right_ = makeFclChecker(problem())->makeContext();
};

class ComparedContextDeathTest : public ::testing::Test {
 protected:
  ComparedContextDeathTest() {
    auto wrong = std::make_unique<WrongContext>();
    wrong_ = wrong.get();
    compared_ = std::make_unique<ComparedContext>(std::move(wrong), makeFclChecker(problem())->makeContext());
    q_.assign(static_cast<std::size_t>(problem().robot->dof()), 0.0);
    to_ = q_;
    to_[0] = 0.1;
  }

  void askAll() {
    std::vector<double> many = q_;
    many.insert(many.end(), to_.begin(), to_.end());
    bool free[2];
    compared_->isFree(q_.data(), nullptr);
    compared_->areFree(many.data(), 2, nullptr, free);
    compared_->isEdgeFree(q_.data(), to_.data(), nullptr);
    compared_->freeFraction(q_.data(), to_.data(), nullptr);
  }

  WrongContext* wrong_ = nullptr;
  std::unique_ptr<ComparedContext> compared_;
  std::vector<double> q_, to_;
};

TEST_F(ComparedContextDeathTest, AgreementPasses) { askAll(); }

TEST_F(ComparedContextDeathTest, AWrongVerdictEndsTheProgram) {
  wrong_->wrong_state = true;
  EXPECT_DEATH(askAll(), "say the same of a state");
  wrong_->wrong_state = false;
  wrong_->wrong_last_of_many = true;
  EXPECT_DEATH(askAll(), "say the same of many states");
  wrong_->wrong_last_of_many = false;
  wrong_->wrong_edge = true;
  EXPECT_DEATH(askAll(), "say the same of an edge");
  wrong_->wrong_edge = false;
  wrong_->wrong_fraction = true;
  EXPECT_DEATH(askAll(), "free the same part of an edge");
}

TEST(ComparedContext, IsWhatTheVectorisedCheckerHandsOut) {
  EXPECT_NE(dynamic_cast<ComparedContext*>(makeVectorChecker(problem())->makeContext().get()), nullptr);
}

#endif

}  // namespace
}  // namespace b4p::testing
