// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cassert>
#include <memory>
#include <utility>

#include "state_validity/collision_checker.h"

namespace b4p {

/// Answers as one context does, and asserts that a reference gives the same verdicts: in builds without
/// NDEBUG a disagreement ends the program. makeVectorChecker() hands out such contexts there, with FCL as the
/// reference, and bare ones elsewhere.
class ComparedContext : public CollisionContext {
 public:
  ComparedContext(std::unique_ptr<CollisionContext> answering, std::unique_ptr<CollisionContext> reference)
      : answering_(std::move(answering)), reference_(std::move(reference)) {}

  bool isFree(const double* q, const Grasp* held) override {
    const bool free = answering_->isFree(q, held);
    assert(free == reference_->isFree(q, held) && "both checkers say the same of a state");
    return free;
  }

  void areFree(const double* q, int count, const Grasp* held, bool* free) override {
    answering_->areFree(q, count, held, free);
    assert(sameOfMany(q, count, held, free) && "both checkers say the same of many states");
  }

  bool isEdgeFree(const double* q1, const double* q2, const Grasp* held) override {
    const bool free = answering_->isEdgeFree(q1, q2, held);
    assert(free == reference_->isEdgeFree(q1, q2, held) && "both checkers say the same of an edge");
    return free;
  }

  double freeFraction(const double* q1, const double* q2, const Grasp* held) override {
    const double fraction = answering_->freeFraction(q1, q2, held);
    assert(fraction == reference_->freeFraction(q1, q2, held) &&
           "both checkers free the same part of an edge");
    return fraction;
  }

  std::string describeCollision(const double* q, const Grasp* held) override {
    return answering_->describeCollision(q, held);
  }
  std::uint64_t configurationsChecked() const override { return answering_->configurationsChecked(); }

 private:
  bool sameOfMany(const double* q, int count, const Grasp* held, const bool* free) {
    const std::unique_ptr<bool[]> expected(new bool[static_cast<std::size_t>(count)]);
    reference_->areFree(q, count, held, expected.get());
    return std::equal(free, free + count, expected.get());
  }

  std::unique_ptr<CollisionContext> answering_, reference_;
};

}  // namespace b4p
