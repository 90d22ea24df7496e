// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "state_validity/edge_samples.h"
#include "state_validity/posed_pieces.h"

namespace b4p {

/// What all checkers that look at the samples of an edge have in common: joint limits, grasps, bad input and
/// the promises of freeFraction(). Derived classes say which samples collide.
class SampledContext : public CollisionContext {
 public:
  explicit SampledContext(std::shared_ptr<const FclWorld> world);
  SampledContext(const SampledContext&) = delete;
  SampledContext& operator=(const SampledContext&) = delete;

  bool isFree(const double* q, const Grasp* held) override;
  void areFree(const double* q, int count, const Grasp* held, bool* free) override;
  bool isEdgeFree(const double* q1, const double* q2, const Grasp* held) override;
  double freeFraction(const double* q1, const double* q2, const Grasp* held) override;
  std::string describeCollision(const double* q, const Grasp* held) override;

 protected:
  /// Whether nothing collides at q, which keeps the limits. The grasp is held and has no rigid collision.
  virtual bool stateFree(const double* q) = 0;

  /// Whether no sample collides.
  virtual bool allFree(const EdgeSamples& samples) = 0;

  /// Smallest k <= last at which a sample collides; last + 1 if there is none.
  virtual std::int64_t firstBlocked(const EdgeSamples& samples, std::int64_t last) = 0;

  /// Whether the last answer of firstBlocked() holds by so much that rounding of the samples cannot turn it.
  virtual bool beyondRounding() const { return false; }

  /// How often isFree() has been asked.
  std::uint64_t statesAsked() const { return states_asked_; }

  /// Makes pieces() hold the grasp.
  void hold(const Grasp* held) { pieces_.hold(held); }
  void requireFinite(const double* q) const;
  bool legal(const double* q) const { return !pieces_.rigidCollision() && robot().withinLimits(q); }

  const Manipulator& robot() const { return pieces_.world().robot(); }
  PosedPieces& pieces() { return pieces_; }

 private:
  EdgeSamples samplesOf(const double* q1, const double* q2);
  bool isLegalEdgeFree(const double* q1, const double* q2);
  std::int64_t lastWithinLimits(const EdgeSamples& samples);

  PosedPieces pieces_;
  std::vector<double> q_;
  std::uint64_t states_asked_ = 0;
};

}  // namespace b4p
