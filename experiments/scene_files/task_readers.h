// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "experiments/scene.h"
#include "experiments/scene_files/yaml_value.h"

namespace b4p {

/// @param document  a scene file
/// @param scene     what of it is read already: all but the task
PickPlaceTask readPickPlaceTask(const YamlValue& document, const Scene& scene);

/// @param reach  the section of that name in a scene file
/// @param scene  what of the file is read already: all but the task
ReachTask readReachTask(const YamlValue& reach, const Scene& scene);

}  // namespace b4p
