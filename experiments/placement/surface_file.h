// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "experiments/placement/placement_geometry.h"
#include "experiments/scene.h"

namespace b4p {

/// Writes what pre-processing found in a placement scene as JSON, for pictures: target volume, regions with
/// the centres of their cells, placement faces with their corners in O, obstacles and object as points whose
/// hull they are. Metres.
/// @throws InputError when the file cannot be written
void writeSurfaces(const std::string& file, const Scene& scene, const PlacementGeometry& geometry);

}  // namespace b4p
