// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include <tinyxml2.h>

namespace b4p {

/// Checks of a URDF's text that urdfdom leaves out. All throw InputError naming `file`, the element and the
/// value.

/// Links and joints form one tree: names unique, parents and children exist, one root, no link its own
/// ancestor; nothing left to expand with xacro.
void validateUrdfTree(const std::string& file, const tinyxml2::XMLElement& robot);

/// Joint types are supported; origins, axes, limits and shape sizes are complete, finite and in range.
void validateUrdfValues(const std::string& file, const tinyxml2::XMLElement& robot);

/// Number of collision shapes that the text declares for a link.
std::size_t declaredShapes(const tinyxml2::XMLElement& robot, const std::string& link);

}  // namespace b4p
