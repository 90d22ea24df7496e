// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <charconv>
#include <cstdint>
#include <limits>
#include <string>

#include "robots/input_error.h"

namespace b4p {

constexpr std::uint64_t kLargestSeed = std::numeric_limits<std::int32_t>::max();
constexpr std::uint64_t kMostThreads = 64;
constexpr std::uint64_t kMostRuns = 100000;

/// An option's value, which is taken as it is meant or refused: digits alone, and low <= value <= high.
/// @throws InputError
inline std::uint64_t wholeNumber(const std::string& text, std::uint64_t low, std::uint64_t high,
                                 const std::string& where, const std::string& option) {
  std::uint64_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size() || value < low || value > high)
    throw InputError(where, option,
                     "has to be a whole number from " + std::to_string(low) + " to " + std::to_string(high) +
                         " (" + text + ")");
  return value;
}

}  // namespace b4p
