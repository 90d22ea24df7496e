// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <initializer_list>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "experiments/scene_files/yaml_value.h"
#include "robots/shape.h"

namespace b4p {

/// Reads one shape with its pose. `mapping` may also have the keys in `more_keys`.
/// @throws InputError unless there is exactly one of box, sphere, cylinder, capsule, mesh, prism, with good
/// sizes.
PlacedShape readPlacedShape(const YamlValue& mapping, std::initializer_list<const char*> more_keys);

/// A simple polygon, counter-clockwise, with at least three corners (m).
std::vector<Eigen::Vector2d> readPolygon(const YamlValue& value);

}  // namespace b4p
