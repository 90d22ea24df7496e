// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>

#include "planners/b4p/forest.h"
#include "planners/b4p/motion.h"

namespace b4p {

/// Leads a tree out of the narrow place that its root may stand in: in each direction that the region knows
/// (PickPlaceContext::retreat), up to `steps` nodes in a row, as far as the motions are free. Once per tree,
/// which remembers how far the longest way went (Tree::way_out).
/// @param scratch  a state of the space, overwritten
/// @return how many nodes were added
std::size_t retreat(Tree& tree, unsigned steps, PickPlaceContext& region, Motion& motion,
                    ompl::base::State* scratch);

}  // namespace b4p
