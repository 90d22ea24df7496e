// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace b4p {

/// What figures depend on besides the experiment, one "key: value" a line: commit, compiler, flags, OMPL,
/// CPU, cores.
std::string buildInfo();

}  // namespace b4p
