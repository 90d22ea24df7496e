// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "experiments/scene.h"

namespace b4p {

/// Tells whether the files that make up a scene have changed: 64 bits (FNV-1a) over the bytes of the scene
/// file, the robot file, the URDF and a file of grasps, as text. Mesh files are not read. No protection
/// against forgery.
/// @throws InputError when one of them cannot be read
std::string sceneDigest(const Scene& scene);

}  // namespace b4p
