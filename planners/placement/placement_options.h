// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>

namespace b4p {

enum class PlacementSampling {
  kTreeSearch,       ///< Monte Carlo tree search over the AFR hierarchy (paper, Algorithms 2 and 3)
  kUniformChildren,  ///< a uniformly drawn child at each level, down to a leaf: the paper's baseline
  kUniformArea,      ///< arm and face uniform, all cells of all regions alike
};

enum class PlacementReward {
  kPaper,   ///< Eq. 3: a quarter for each of stable, object free, better and arm free; 0 or 1 at leaves
  kStaged,  ///< 1 for a valid draw; `stage` for one that fails at the arm's collisions only, and half as much
            ///< for each test before that: what fails late says a little about success, and stays small
            ///< beside it
};

/// How placements are drawn.
struct PlacementOptions {
  PlacementSampling sampling = PlacementSampling::kTreeSearch;
  double exploration = 0.5;   ///< c of UCB1; >= 0
  unsigned attempts = 200;    ///< draws per goal sample; > 0
  unsigned ik_attempts = 16;  ///< attempts of inverse kinematics per answer; > 0
  unsigned postures = 3;      ///< answers tried per pose until the arm is free; > 0
  bool pose_first = true;     ///< test the pose before inverse kinematics; false: the authors' order
  bool hand_first = true;     ///< test the hand alone before inverse kinematics
  bool prune = false;         ///< leave out branches whose bound cannot beat the objective's threshold
  PlacementReward reward = PlacementReward::kStaged;
  double stage = 1.0 / 16.0;  ///< see kStaged; in [0, 1]
  bool take_back = false;     ///< take rewards back that the rising threshold has made worthless
  double discount = 1.0;      ///< factor on all visits and rewards when the threshold rises; in (0, 1]

  /// What is out of range, with the value; empty when nothing is.
  std::string problem() const;
};

/// What became of the draws.
struct PlacementStatistics {
  std::uint64_t draws = 0;
  std::uint64_t unstable = 0;
  std::uint64_t object_collides = 0;
  std::uint64_t not_better = 0;  ///< objective, or a bound of it, no better than its threshold
  std::uint64_t hand_collides = 0;
  std::uint64_t unreachable = 0;  ///< no answer of inverse kinematics
  std::uint64_t arm_collides = 0;
  std::uint64_t valid = 0;
  std::uint64_t exhausted = 0;  ///< times that no branch was left to draw from

  /// One line: how many draws failed at what, most frequent first.
  std::string summary() const;
};

}  // namespace b4p
