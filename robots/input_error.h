// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <stdexcept>
#include <string>

namespace b4p {

/// Something a user wrote is wrong. what() is one line: "FILE: ELEMENT: PROBLEM".
/// Raised where input enters (parsers, problem set-up), never from inside a planner. The `b4p`
/// command turns it into exit code 2.
class InputError : public std::runtime_error {
 public:
  /// @param file     the file read, or the name of the option
  /// @param element  the key, link, joint or row at fault; may be empty
  /// @param problem  what is wrong, with the value found
  InputError(const std::string& file, const std::string& element, const std::string& problem)
      : std::runtime_error(element.empty() ? file + ": " + problem : file + ": " + element + ": " + problem) {
  }
};

}  // namespace b4p
