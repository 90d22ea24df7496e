// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "state_validity/edge_search.h"

namespace b4p {

/// One thread's access to an FclWorld.
class FclContext : public CollisionContext {
 public:
  explicit FclContext(std::shared_ptr<const FclWorld> world);
  FclContext(const FclContext&) = delete;
  FclContext& operator=(const FclContext&) = delete;

  bool isFree(const double* q, const Grasp* held) override;
  bool isEdgeFree(const double* q1, const double* q2, const Grasp* held) override;
  double freeFraction(const double* q1, const double* q2, const Grasp* held) override;
  std::string describeCollision(const double* q, const Grasp* held) override;
  std::uint64_t configurationsChecked() const override { return states_checked_ + search_.checked(); }

 private:
  const Manipulator& robot() const { return pieces_.world().robot(); }
  EdgeSamples samplesOf(const double* q1, const double* q2) const;
  bool isLegalEdgeFree(const double* q1, const double* q2);
  std::int64_t lastWithinLimits(const EdgeSamples& samples);

  PosedPieces pieces_;
  EdgeSearch search_;
  std::vector<double> q_;
  std::uint64_t states_checked_ = 0;
  std::size_t last_hit_ =
      0;  ///< pair that collided last; looked at first, since neighbours tend to collide alike
};

}  // namespace b4p
