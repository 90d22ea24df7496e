// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <limits>
#include <map>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

namespace b4p {

using Json = nlohmann::ordered_json;

/// The document in a file. Refuses what the parser would accept silently: the same key twice in an object.
/// @throws InputError
Json readJson(const std::string& file);

/// A value in a JSON file, read strictly. Every function throws InputError naming the file, the element and
/// the value found. Refers to the file's name and document, which have to outlive it.
class JsonValue {
 public:
  JsonValue(const std::string& file, std::string name, const Json& value)
      : file_(file), name_(std::move(name)), value_(value) {}

  /// An object with exactly these keys.
  const JsonValue& requireKeys(std::initializer_list<const char*> keys) const;

  /// An object whose key `schema` is `version`.
  const JsonValue& requireSchema(int version) const;

  JsonValue operator[](const char* key) const;  ///< a key known to be there
  bool isNull() const { return value_.is_null(); }

  std::vector<JsonValue> items() const;
  std::vector<JsonValue> items(std::size_t count) const;

  double number() const;  ///< finite
  std::vector<double> numbers(std::size_t count) const;

  template <class Integer>
  Integer integer() const {
    if (!value_.is_number_integer()) failWithValue("is not an integer");
    // Unsigned values lie beyond, negative ones below, what the signed comparison can hold.
    const bool negative = !value_.is_number_unsigned();
    const bool fits =
        negative ? std::numeric_limits<Integer>::is_signed &&
                       value_.get<std::int64_t>() >= std::int64_t{std::numeric_limits<Integer>::min()}
                 : value_.get<std::uint64_t>() <= std::uint64_t{std::numeric_limits<Integer>::max()};
    if (!fits) failWithValue("is out of range");
    return value_.get<Integer>();
  }

  bool boolean() const;
  std::string text() const;
  std::map<std::string, std::string> texts() const;  ///< an object of texts
  std::map<std::string, int> counts() const;         ///< an object of integers

  [[noreturn]] void fail(const std::string& problem) const;
  [[noreturn]] void failWithValue(const std::string& problem) const;

 private:
  const std::string& file_;
  std::string name_;
  const Json& value_;
};

}  // namespace b4p
