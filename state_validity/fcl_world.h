// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include <Eigen/Core>

#include "state_validity/collision_pairs.h"

namespace b4p {

/// What all contexts of one checker share: the problem made ready for checking. Immutable.
class FclWorld {
 public:
  /// @throws std::invalid_argument as makeFclChecker does.
  explicit FclWorld(CollisionProblem problem);

  const CollisionProblem& problem() const { return problem_; }  ///< padding_m resolved
  const Manipulator& robot() const { return *problem_.robot; }
  const CollisionPieces& pieces() const { return pieces_; }
  const CollisionPairs& pairs(bool with_object) const { return with_object ? pairs_held_ : pairs_empty_; }

  /// Columns of travelPerUnit, one for each piece of a moving link.
  const Eigen::MatrixXd& linkTravel() const { return link_travel_; }

 private:
  CollisionProblem problem_;
  CollisionPieces pieces_;
  CollisionPairs pairs_empty_;
  CollisionPairs pairs_held_;
  Eigen::MatrixXd link_travel_;
};

}  // namespace b4p
