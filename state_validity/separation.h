// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "state_validity/shape_bounds.h"

namespace b4p {

/// Lower bound (m) of the distance of two rounded boxes, at least the bound `known_m` that the caller has
/// already. Found by a few steps towards the closest points. They end as soon as the bound exceeds
/// `enough_m`, or exceeds `clear_m` when the distance turns out to be less than enough_m. The bound holds
/// whatever the steps did, for it is the width of a gap between two parallel planes.
double separation(const RoundedBox& a, const RoundedBox& b, double known_m, double clear_m, double enough_m);

}  // namespace b4p
