// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "experiments/placement/placement_task.h"
#include "experiments/scene.h"
#include "experiments/scene_files/yaml_value.h"

namespace b4p {

/// Reads the keys `place` and `object` of a scene file. Where a point cloud is named, its cells become
/// obstacles of the scene.
/// @param scene  read so far: robot, obstacles
/// @throws InputError naming file, key and value
PlacementTask readPlacementTask(const YamlValue& place, const YamlValue& object, Scene& scene);

/// Loads a scene with a placement task by path, or by name from those that ship with b4p.
/// @throws InputError as loadScene() does, and when the scene has no placement task
Scene loadPlacementScene(const std::string& name_or_path);

/// Names of the placement scenes that ship with b4p.
std::vector<std::string> placementSceneNames();

}  // namespace b4p
