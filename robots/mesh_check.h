// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "robots/shape.h"

namespace b4p {

/// Empty when the mesh is finite, closed, oriented outwards and convex within 1e-6 m; otherwise what is
/// wrong.
std::string meshProblem(const ConvexMesh& mesh);

}  // namespace b4p
