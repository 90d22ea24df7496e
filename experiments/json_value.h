// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <limits>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

namespace b4p {

using Json = nlohmann::ordered_json;

/// A value in a JSON file, read strictly. Every function throws InputError naming the file, the element and
/// the value found. Refers to the document and the file's name, which have to live as long.
class JsonValue {
 public:
  JsonValue(const std::string& file, std::string name, const Json& value)
      : file_(file), name_(std::move(name)), value_(value) {}

  /// An object with exactly these keys, and of the optional ones any.
  const JsonValue& requireKeys(std::initializer_list<const char*> keys,
                               std::initializer_list<const char*> optional = {}) const;

  /// An object whose key `schema` is `version`.
  const JsonValue& requireSchema(int version) const;

  JsonValue operator[](const char* key) const;  ///< a key that is there
  bool has(const char* key) const { return value_.is_object() && value_.contains(key); }
  const std::string& file() const { return file_; }
  bool isNull() const { return value_.is_null(); }

  std::vector<JsonValue> items() const;  ///< of a list
  std::vector<JsonValue> items(std::size_t count) const;

  double number() const;  ///< finite: the parser refuses what overflows
  std::vector<double> numbers(std::size_t count) const;
  bool boolean() const;
  std::string text() const;
  std::map<std::string, std::string> texts() const;                ///< an object of texts
  std::map<std::string, int> counts() const;                       ///< an object of integers
  std::vector<std::pair<std::string, JsonValue>> entries() const;  ///< of an object, in the file's order

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

  [[noreturn]] void fail(const std::string& problem) const;
  [[noreturn]] void failWithValue(const std::string& problem) const;

 private:
  const std::string& file_;
  std::string name_;
  const Json& value_;
};

/// Parses a document and refuses what the parser would accept silently: the same key twice in an object.
/// @param file  named in errors
/// @throws InputError
Json parseJson(std::istream& stream, const std::string& file);

/// The document in a file.
/// @throws InputError
Json readJson(const std::string& file);

}  // namespace b4p
