// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "state_validity/lanes/lane_world.h"

namespace b4p::lanes {

/// Lanes (bit i: configuration i) in which two bodies are not known to be apart.
struct PairLanes {
  std::int32_t a = 0;
  std::int32_t b = 0;
  float motion_m = 0;        ///< bound of how much closer they come from one sample to the next
  std::uint16_t near = 0;    ///< may meet within the lane's reach
  std::uint16_t unsure = 0;  ///< may meet at the configuration itself
};

/// kLanes configurations and what to look at.
struct BlockQuery {
  const float* q = nullptr;              ///< [dof][kLanes]
  float reach[kLanes] = {};              ///< how many samples to either side each configuration answers for
  int used = kLanes;                     ///< lanes from here on repeat an earlier one
  const float* body_motion_m = nullptr;  ///< by moving body: bound of its motion from one sample to the next
  const float* pair_motion_m = nullptr;  ///< by LanePair::index: bound of how much closer the two come
  const PairLanes* among = nullptr;      ///< the pairs to look at, in their lanes `near`; nullptr: all
  int among_count = 0;
  bool each = false;  ///< a collision in one lane says nothing about the others
  bool any = false;   ///< one collision is enough: end at the first that is found
};

/// What comes of it, and memory for working it out. One object per thread.
struct BlockScratch {
  /// Makes room for blocks of a robot of the world. The world stays the same over the object's life.
  void makeRoom(const LaneWorld& world, const LaneRobot& robot);

  std::vector<PairLanes> pairs;  ///< those that are not apart in all lanes
  int count = 0;                 ///< of them
  std::uint32_t colliding =
      0;  ///< lanes in which some pair certainly collides; after the first, lanes are left out

  int hit_a = -1, hit_b = -1;  ///< the pair that collided last
  std::uint64_t stamp = 0;
  std::vector<std::uint64_t> placed_at;  ///< by moving body: stamp of the block it is placed for
  std::vector<float> storage;
  float* joints = nullptr;  ///< [joint][12][kLanes]: rotation row by row, translation
  float* bodies = nullptr;  ///< [moving body][15][kLanes]: axes one by one, middle, half of the box around it
  float* swept = nullptr;   ///< [moving body][6]: low, high corner of all that it reaches
};

/// Looks at a block of configurations.
void checkBlock(const LaneWorld& world, const LaneRobot& robot, const BlockQuery& query,
                BlockScratch& scratch);

/// Name of the instruction set in use, "AVX2" for example.
const char* instructionSet();

}  // namespace b4p::lanes
