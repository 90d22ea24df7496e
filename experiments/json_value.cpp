// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/json_value.h"

#include <filesystem>
#include <fstream>
#include <set>

#include "robots/input_error.h"

namespace b4p {

const JsonValue& JsonValue::requireKeys(std::initializer_list<const char*> keys,
                                        std::initializer_list<const char*> optional) const {
  if (!value_.is_object()) fail("is not an object");
  for (const auto& item : value_.items()) {
    bool known = false;
    for (const auto& list : {keys, optional})
      for (const char* key : list) known = known || item.key() == key;
    if (!known) fail("unknown key '" + item.key() + "'");
  }
  for (const char* key : keys)
    if (!value_.contains(key)) fail("has no key '" + std::string(key) + "'");
  return *this;
}

const JsonValue& JsonValue::requireSchema(int version) const {
  if (!value_.is_object()) fail("is not a JSON object");
  if (!value_.contains("schema")) fail("has no key 'schema'");
  const JsonValue schema = (*this)["schema"];
  if (schema.integer<int>() != version) schema.failWithValue("is not schema " + std::to_string(version));
  return *this;
}

JsonValue JsonValue::operator[](const char* key) const {
  return JsonValue(file_, name_.empty() ? key : name_ + "." + key, value_.at(key));
}

std::vector<JsonValue> JsonValue::items() const {
  if (!value_.is_array()) fail("is not a list");
  std::vector<JsonValue> list;
  for (std::size_t i = 0; i < value_.size(); ++i)
    list.emplace_back(file_, name_ + "[" + std::to_string(i) + "]", value_[i]);
  return list;
}

std::vector<JsonValue> JsonValue::items(std::size_t count) const {
  std::vector<JsonValue> list = items();
  if (list.size() != count)
    fail("has " + std::to_string(list.size()) + " values, not " + std::to_string(count));
  return list;
}

double JsonValue::number() const {
  if (!value_.is_number()) failWithValue("is not a finite number");
  return value_.get<double>();
}

std::vector<double> JsonValue::numbers(std::size_t count) const {
  std::vector<double> list;
  for (const JsonValue& item : items(count)) list.push_back(item.number());
  return list;
}

bool JsonValue::boolean() const {
  if (!value_.is_boolean()) failWithValue("is neither true nor false");
  return value_.get<bool>();
}

std::string JsonValue::text() const {
  if (!value_.is_string()) failWithValue("is not a text");
  return value_.get<std::string>();
}

std::map<std::string, std::string> JsonValue::texts() const {
  std::map<std::string, std::string> map;
  for (const auto& [key, value] : entries()) map[key] = value.text();
  return map;
}

std::map<std::string, int> JsonValue::counts() const {
  std::map<std::string, int> map;
  for (const auto& [key, value] : entries()) map[key] = value.integer<int>();
  return map;
}

std::vector<std::pair<std::string, JsonValue>> JsonValue::entries() const {
  if (!value_.is_object()) fail("is not an object");
  std::vector<std::pair<std::string, JsonValue>> list;
  for (const auto& item : value_.items()) list.emplace_back(item.key(), (*this)[item.key().c_str()]);
  return list;
}

void JsonValue::fail(const std::string& problem) const { throw InputError(file_, name_, problem); }

void JsonValue::failWithValue(const std::string& problem) const {
  constexpr std::size_t kLongest = 60;
  fail(value_.dump(-1, ' ', true, Json::error_handler_t::replace).substr(0, kLongest) + " " + problem);
}

Json parseJson(std::istream& stream, const std::string& file) {
  std::vector<std::set<std::string>> keys;
  const auto watch = [&](int, Json::parse_event_t event, Json& value) {
    if (event == Json::parse_event_t::object_start) keys.emplace_back();
    if (event == Json::parse_event_t::object_end) keys.pop_back();
    if (event == Json::parse_event_t::key && !keys.back().insert(value.get<std::string>()).second)
      throw InputError(file, value.get<std::string>(), "is there twice");
    return true;
  };
  try {
    return Json::parse(stream, watch);
  } catch (const Json::parse_error& e) {
    throw InputError(file, "byte " + std::to_string(e.byte), "cut off or malformed JSON");
  } catch (const Json::exception& e) {
    throw InputError(file, "", e.what());
  }
}

Json readJson(const std::string& file) {
  std::error_code error;
  std::ifstream stream(file, std::ios::binary);
  if (std::filesystem::is_directory(file, error) || !stream) throw InputError(file, "", "cannot be read");
  return parseJson(stream, file);
}

}  // namespace b4p
