// SPDX-License-Identifier: BSD-3-Clause
#include "robots/urdf_text.h"

#include <cmath>
#include <locale>
#include <sstream>

#include "robots/input_error.h"

namespace b4p {
namespace {

/// A finite number and nothing else, whatever the locale.
std::optional<double> finiteNumber(const std::string& word) {
  std::istringstream stream(word);
  stream.imbue(std::locale::classic());
  double value = 0.0;
  stream >> value;
  if (stream.fail() || !std::isfinite(value) || stream.peek() != std::istringstream::traits_type::eof())
    return std::nullopt;
  return value;
}

}  // namespace

std::optional<UrdfText> UrdfText::child(const char* name) const {
  const tinyxml2::XMLElement* found = element_.FirstChildElement(name);
  if (found == nullptr) return std::nullopt;
  return UrdfText(file_, owner_, *found);
}

std::string UrdfText::text(const char* attribute) const {
  const char* value = element_.Attribute(attribute);
  if (value == nullptr || *value == '\0')
    fail("<" + std::string(element_.Name()) + "> has no " + std::string(attribute));
  return value;
}

std::vector<double> UrdfText::numbers(const char* attribute, std::size_t count) const {
  std::istringstream words(text(attribute));
  std::vector<double> values;
  for (std::string word; words >> word;) {
    const std::optional<double> value = finiteNumber(word);
    if (!value) failAt(attribute, "has to be finite numbers");
    values.push_back(*value);
  }
  if (values.size() != count) failAt(attribute, "has to be " + std::to_string(count) + " number(s)");
  return values;
}

void UrdfText::fail(const std::string& problem) const { throw InputError(file_, owner_, problem); }

void UrdfText::failAt(const char* attribute, const std::string& problem) const {
  const char* value = element_.Attribute(attribute);
  fail(std::string(element_.Name()) + " " + attribute + " '" + (value == nullptr ? "" : value) + "' " +
       problem);
}

}  // namespace b4p
