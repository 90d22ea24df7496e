// SPDX-License-Identifier: BSD-3-Clause
// Growth for narrow places: trees go on along what blocks them, and nodes that cannot move are left in peace.
#pragma once

#include <algorithm>
#include <cstdint>

#include "planners/b4p/growth.h"

namespace b4p {

/// Moves on from `node` toward `target` one value of the state at a time, by turns, each as far as it stays
/// free, until none can move or four rounds have been made: a way along the obstacle that is in the way of
/// the straight motion. Only in spaces that have such values (Motion::values()). The last node is that of
/// `growth` when it moved.
/// @tparam Forests  a ForestPair, or what has its grow()
template <class Forests>
void slide(Forests& forests, const Node* node, const ompl::base::State* target, Motion& motion,
           Growth& growth) {
  constexpr unsigned kRounds = 4;
  const unsigned values = motion.values();
  if (values == 0) return;
  auto value = static_cast<unsigned>(motion.random().uniformInt(0, static_cast<int>(values) - 1));
  for (unsigned tried = 0, stuck = 0; stuck < values && tried < kRounds * values; ++tried, ++stuck) {
    const ompl::base::State* beside = motion.alongValue(value, node->state, target);
    value = (value + 1) % values;
    if (beside == nullptr) continue;
    const Expansion slid = expandFrom(forests, node, beside, motion);
    if (!slid.added) continue;
    growth.grown = node = slid.node;
    ++growth.nodes;
    stuck = 0;
  }
}

/// Whether a node is tried again, by chance: half as often after each time that it could not move, but never
/// less than once in 64 times.
inline bool isTried(const Node& node, ompl::RNG& random) {
  const unsigned trapped = node.trapped.load(std::memory_order_relaxed);
  return trapped == 0 || random.uniformInt(0, (1 << trapped) - 1) == 0;
}

/// The node could not move.
inline void noteTrapped(const Node& node) {
  constexpr unsigned kRarest = 6;
  const unsigned trapped = node.trapped.load(std::memory_order_relaxed);
  node.trapped.store(static_cast<std::uint8_t>(std::min(trapped + 1, kRarest)), std::memory_order_relaxed);
}

/// growAndConnect() with both: `side` grows toward `target` from its nearest node, slides where it is
/// blocked, and the other side grows straight toward what it has got to. nullopt when the nearest node is
/// not tried.
/// @tparam Forests  a ForestPair, or what has its grow() and nearest()
template <class Forests>
std::optional<Growth> slideAndConnect(Forests& forests, Side side, const ompl::base::State* target,
                                      Motion& motion) {
  Growth growth;
  const Node* near = forests.nearest(side, target);
  if (near == nullptr) return growth;
  if (!isTried(*near, motion.random())) return std::nullopt;
  const Expansion expansion = expandFrom(forests, near, target, motion);
  growth.grown = expansion.node;
  growth.nodes = expansion.added;
  if (expansion.blocked)
    slide(forests, expansion.node == nullptr ? near : expansion.node, target, motion, growth);
  if (growth.grown != nullptr)
    connect(forests, side, growth, motion);
  else
    noteTrapped(*near);
  return growth;
}

}  // namespace b4p
