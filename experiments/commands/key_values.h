// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "experiments/planners.h"
#include "robots/input_error.h"

namespace b4p {

/// The values of a repeatable option --param KEY=VALUE.
/// @throws InputError
inline PlannerParameters keyValues(const std::vector<std::string>& words, const std::string& where) {
  PlannerParameters parameters;
  for (const std::string& word : words) {
    const auto equals = word.find('=');
    if (equals == std::string::npos || equals == 0)
      throw InputError(where, "--param", "has to be KEY=VALUE (" + word + ")");
    if (!parameters.emplace(word.substr(0, equals), word.substr(equals + 1)).second)
      throw InputError(where, "--param", "is given twice (" + word.substr(0, equals) + ")");
  }
  return parameters;
}

}  // namespace b4p
