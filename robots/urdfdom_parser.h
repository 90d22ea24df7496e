// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include <urdf_model/model.h>
#include <urdf_world/types.h>

namespace b4p {

/// Parses the text of a URDF with urdfdom, which prints nothing: what it complains of ends up in the error.
/// Calls from several threads take turns, because urdfdom's log is one for the process.
/// @throws InputError when urdfdom gives no robot.
urdf::ModelInterfaceSharedPtr parseWithUrdfdom(const std::string& file, const std::string& text);

}  // namespace b4p
