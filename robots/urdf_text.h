// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <tinyxml2.h>

namespace b4p {

/// The text of one URDF element, read strictly. Errors are InputErrors that name the file, the link or joint
/// the element belongs to (`owner`), the attribute and its value.
class UrdfText {
 public:
  UrdfText(const std::string& file, const std::string& owner, const tinyxml2::XMLElement& element)
      : file_(file), owner_(owner), element_(element) {}

  const tinyxml2::XMLElement& element() const { return element_; }

  /// The first child of this name, of the same owner.
  std::optional<UrdfText> child(const char* name) const;

  bool has(const char* attribute) const { return element_.Attribute(attribute) != nullptr; }

  /// Value of an attribute that has to be there and not be empty.
  std::string text(const char* attribute) const;

  /// Exactly `count` finite numbers in an attribute that has to be there.
  std::vector<double> numbers(const char* attribute, std::size_t count) const;
  double number(const char* attribute) const { return numbers(attribute, 1).front(); }

  [[noreturn]] void fail(const std::string& problem) const;

  /// "ELEMENT ATTRIBUTE 'VALUE' PROBLEM"
  [[noreturn]] void failAt(const char* attribute, const std::string& problem) const;

 private:
  const std::string& file_;
  const std::string& owner_;
  const tinyxml2::XMLElement& element_;
};

}  // namespace b4p
