// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "experiments/scene_families/family.h"

namespace b4p {

SceneFamily mazeFamily();      ///< a planar robot carries a polygon through passages of several kinds
SceneFamily stickFamily();     ///< a stick into a rack that is open for the hand in the middle only
SceneFamily groceryFamily();   ///< a can into the gap between its neighbours in a low compartment
SceneFamily confinedFamily();  ///< the empty hand of a mobile Panda to an object in a confined place

}  // namespace b4p
