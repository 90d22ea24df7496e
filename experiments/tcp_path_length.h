// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "robots/manipulator.h"

namespace b4p {

/// How far the TCP travels (m) along a path of straight edges in joint space, to a few parts in 10^5.
/// @param path  way-points of dof() values, inside the joint limits
double tcpPathLength_m(const Manipulator& robot, const std::vector<std::vector<double>>& path);

}  // namespace b4p
