// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <string>

namespace b4p {

/// What figures depend on besides the experiment: commit, compiler, flags, OMPL, CPU, cores.
std::map<std::string, std::string> buildInfo();

/// OMPL's version, "1.5.2". OMPL 1.5 leaves its own text of it empty.
std::string omplVersion();

}  // namespace b4p
