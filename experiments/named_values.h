// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "robots/input_error.h"

namespace b4p {

/// A value by the name that commands and files have for it; lists of them are std::arrays.
template <class Value>
struct Named {
  Value value;
  const char* name;
};

/// "a,b,c"
template <class Names>
std::string namesIn(const Names& names, const std::string& between = ",") {
  std::string all;
  for (const auto& named : names) all += (all.empty() ? "" : between) + std::string(named.name);
  return all;
}

/// @throws InputError listing the names there are
template <class Names>
auto valueOf(const Names& names, const std::string& name, const std::string& where,
             const std::string& element) {
  for (const auto& named : names)
    if (name == named.name) return named.value;
  throw InputError(where, element, "'" + name + "' is unknown; there are: " + namesIn(names, ", "));
}

template <class Names, class Value>
std::string nameIn(const Names& names, Value value) {
  for (const auto& named : names)
    if (named.value == value) return named.name;
  return {};
}

}  // namespace b4p
