// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <fstream>
#include <string>
#include <vector>

namespace b4p {

/// A file of text lines and, after them, text or bytes. What goes wrong names the file, and where in it.
class PointFile {
 public:
  /// @throws InputError
  explicit PointFile(const std::string& file);

  /// The next line's words. @throws InputError at the end of the file
  std::vector<std::string> next();

  /// The next bytes. False: there are not as many.
  bool read(std::vector<unsigned char>& bytes);

  /// @throws InputError naming the line last read
  [[noreturn]] void failHere(const std::string& problem) const;
  [[noreturn]] void fail(const std::string& element, const std::string& problem) const;

  /// A word of the line last read as a number. @throws InputError
  std::size_t count(const std::string& word) const;
  double number(const std::string& word) const;

 private:
  std::string file_;
  std::ifstream stream_;
  std::size_t number_ = 0;
};

}  // namespace b4p
