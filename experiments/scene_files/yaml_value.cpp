// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/scene_files/yaml_value.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <filesystem>
#include <set>
#include <sstream>
#include <utility>

#include "robots/input_error.h"

namespace b4p {
namespace {

constexpr double kUnitNormTolerance = 1e-3;

/// The value as it stands in the file, on one line and not longer than fits a message.
std::string shown(const YAML::Node& node) {
  constexpr std::size_t kLongest = 60;
  YAML::Emitter emitter;
  emitter.SetSeqFormat(YAML::Flow);
  emitter.SetMapFormat(YAML::Flow);
  emitter << node;
  std::string text = emitter.good() ? emitter.c_str() : "?";
  std::replace(text.begin(), text.end(), '\n', ' ');
  if (text.size() > kLongest) text = text.substr(0, kLongest) + "...";
  return text;
}

std::string format(double value) {
  std::ostringstream out;
  out << value;
  return out.str();
}

}  // namespace

YamlValue::YamlValue(std::string file, std::string path, YAML::Node node)
    : file_(std::move(file)), path_(std::move(path)), node_(std::move(node)) {}

YamlValue YamlValue::load(const std::string& file) {
  std::error_code error;
  if (!std::filesystem::is_regular_file(file, error)) throw InputError(file, "", "no such file");
  try {
    const YamlValue document(file, "", YAML::LoadFile(file));
    document.requireMapping();
    return document;
  } catch (const YAML::BadFile&) {
    throw InputError(file, "", "cannot be read");
  } catch (const YAML::Exception& e) {
    throw InputError(file, "line " + std::to_string(e.mark.line + 1), "malformed YAML (" + e.msg + ")");
  }
}

void YamlValue::fail(const std::string& problem) const {
  const YAML::Mark mark = node_.Mark();
  const std::string line = mark.is_null() ? "" : "line " + std::to_string(mark.line + 1);
  if (path_.empty()) throw InputError(file_, "", problem);
  throw InputError(file_, line.empty() ? path_ : path_ + " (" + line + ")", problem);
}

void YamlValue::failWithValue(const std::string& problem) const { fail(problem + " (" + shown(node_) + ")"); }

YamlValue YamlValue::child(const std::string& path, const YAML::Node& node) const {
  return YamlValue(file_, path, node);
}

void YamlValue::requireMapping() const {
  if (!node_.IsMap()) fail(path_.empty() ? "is not a mapping of keys to values" : "is not a mapping");
}

void YamlValue::allowKeys(const std::vector<const char*>& keys) const {
  std::set<std::string> seen;
  for (const auto& [key, value] : entries()) {
    if (!seen.insert(key).second) value.fail("duplicate key");
    if (std::none_of(keys.begin(), keys.end(), [&key = key](const char* k) { return key == k; }))
      value.fail("unknown key");
  }
}

bool YamlValue::has(const std::string& key) const { return find(key).has_value(); }

std::optional<YamlValue> YamlValue::find(const std::string& key) const {
  requireMapping();
  const YAML::Node value = node_[key];
  if (!value.IsDefined()) return std::nullopt;
  return child(path_.empty() ? key : path_ + "." + key, value);
}

YamlValue YamlValue::operator[](const std::string& key) const {
  if (auto value = find(key)) return *value;
  fail("key '" + key + "' is missing");
}

std::vector<YamlValue> YamlValue::items() const {
  if (!node_.IsSequence()) failWithValue("is not a list");
  std::vector<YamlValue> result;
  for (std::size_t i = 0; i < node_.size(); ++i)
    result.push_back(child(path_ + "[" + std::to_string(i) + "]", node_[i]));
  return result;
}

std::vector<std::pair<std::string, YamlValue>> YamlValue::entries() const {
  requireMapping();
  std::vector<std::pair<std::string, YamlValue>> result;
  for (const auto& entry : node_) {
    if (!entry.first.IsScalar()) fail("has a key that is not a word");
    const std::string key = entry.first.Scalar();
    result.emplace_back(key, child(path_.empty() ? key : path_ + "." + key, entry.second));
  }
  return result;
}

std::string YamlValue::scalar(const char* expected) const {
  if (!node_.IsScalar()) failWithValue(std::string("is not ") + expected);
  return node_.Scalar();
}

std::string YamlValue::text() const {
  const std::string value = scalar("a text");
  if (value.empty()) fail("is empty");
  return value;
}

std::string YamlValue::word() const {
  const std::string value = text();
  const bool plain =
      std::all_of(value.begin(), value.end(), [](unsigned char c) { return std::isalnum(c) || c == '_'; });
  if (!plain || !std::isalpha(static_cast<unsigned char>(value.front())))
    failWithValue("is not a word of letters, digits and underscores");
  return value;
}

bool YamlValue::boolean() const {
  const std::string value = scalar("true or false");
  if (value == "true") return true;
  if (value == "false") return false;
  failWithValue("is not true or false");
}

int YamlValue::integer(int low, int high) const {
  scalar("a whole number");
  int value = 0;
  if (!YAML::convert<int>::decode(node_, value)) failWithValue("is not a whole number");
  if (value < low || value > high)
    failWithValue("is not between " + std::to_string(low) + " and " + std::to_string(high));
  return value;
}

double YamlValue::number(double low, double high) const {
  scalar("a number");
  double value = 0.0;
  if (!YAML::convert<double>::decode(node_, value)) failWithValue("is not a number");
  if (!std::isfinite(value)) failWithValue("is not finite");
  if (value < low || value > high) {
    if (low == std::numeric_limits<double>::lowest()) failWithValue("is greater than " + format(high));
    if (high == std::numeric_limits<double>::max()) failWithValue("is less than " + format(low));
    failWithValue("is not between " + format(low) + " and " + format(high));
  }
  return value;
}

double YamlValue::positive(double high) const {
  const double value = number(std::numeric_limits<double>::lowest(), high);
  if (value <= 0.0) failWithValue("is not greater than 0");
  return value;
}

std::vector<double> YamlValue::numbers(std::size_t count, double largest) const {
  const auto values = items();
  if (values.size() != count) failWithValue("does not have " + std::to_string(count) + " numbers");
  std::vector<double> result;
  for (const YamlValue& value : values) result.push_back(value.number(-largest, largest));
  return result;
}

Eigen::Vector3d YamlValue::vector3(double largest) const {
  const auto values = numbers(3, largest);
  return {values[0], values[1], values[2]};
}

Eigen::Vector3d YamlValue::positiveVector3(double largest) const {
  const Eigen::Vector3d value = vector3(largest);
  if (value.minCoeff() <= 0.0) failWithValue("has a number that is not greater than 0");
  return value;
}

void YamlValue::requireSchema(int version) const {
  const YamlValue schema = (*this)["schema"];
  int found = 0;
  if (!schema.node_.IsScalar() || !YAML::convert<int>::decode(schema.node_, found) || found != version)
    schema.failWithValue("this version of b4p reads schema " + std::to_string(version));
}

Eigen::Isometry3d poseFrom(const YamlValue& mapping) {
  Eigen::Isometry3d X = Eigen::Isometry3d::Identity();
  if (const auto position = mapping.find("position_m")) X.translation() = position->vector3(kFarthest_m);
  const auto rpy = mapping.find("rpy_rad");
  const auto quaternion = mapping.find("quaternion_wxyz");
  if (rpy && quaternion) mapping.fail("has both rpy_rad and quaternion_wxyz");
  if (rpy) {
    const Eigen::Vector3d angles = rpy->vector3();
    X.linear() = (Eigen::AngleAxisd(angles.z(), Eigen::Vector3d::UnitZ()) *
                  Eigen::AngleAxisd(angles.y(), Eigen::Vector3d::UnitY()) *
                  Eigen::AngleAxisd(angles.x(), Eigen::Vector3d::UnitX()))
                     .toRotationMatrix();
  }
  if (quaternion) {
    const auto wxyz = quaternion->numbers(4);
    const Eigen::Quaterniond rotation(wxyz[0], wxyz[1], wxyz[2], wxyz[3]);
    if (std::abs(rotation.norm() - 1.0) > kUnitNormTolerance)
      quaternion->failWithValue("is not of unit length");
    X.linear() = rotation.normalized().toRotationMatrix();
  }
  return X;
}

}  // namespace b4p
