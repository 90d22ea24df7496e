// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <yaml-cpp/yaml.h>
#include <Eigen/Geometry>

namespace b4p {

/// Farthest coordinate and largest size (m) that files may state.
constexpr double kFarthest_m = 1000.0;

/// A value in a YAML file, read strictly. Every function throws InputError naming the file, the path of the
/// key with its line, and the value found.
class YamlValue {
 public:
  /// The document in `file`, which has to be a mapping.
  static YamlValue load(const std::string& file);

  /// Requires a mapping without duplicate keys and without keys other than these.
  void allowKeys(const std::vector<const char*>& keys) const;

  bool isList() const { return node_.IsSequence(); }
  bool isMapping() const { return node_.IsMap(); }
  bool isWord(const std::string& word) const { return node_.IsScalar() && node_.Scalar() == word; }

  bool has(const std::string& key) const;
  YamlValue operator[](const std::string& key) const;  ///< a key that has to be there
  std::optional<YamlValue> find(const std::string& key) const;

  std::vector<YamlValue> items() const;                            ///< of a sequence
  std::vector<std::pair<std::string, YamlValue>> entries() const;  ///< of a mapping, in the file's order

  std::string text() const;  ///< a scalar that is not empty
  std::string word() const;  ///< text of letters, digits and underscores that begins with a letter
  bool boolean() const;
  int integer(int low, int high) const;
  double number(double low = std::numeric_limits<double>::lowest(),
                double high = std::numeric_limits<double>::max()) const;  ///< finite and in [low, high]
  double positive(double high = std::numeric_limits<double>::max()) const;
  /// Each finite and at most `largest` away from 0.
  std::vector<double> numbers(std::size_t count, double largest = std::numeric_limits<double>::max()) const;
  Eigen::Vector3d vector3(double largest = std::numeric_limits<double>::max()) const;
  Eigen::Vector3d positiveVector3(double largest = std::numeric_limits<double>::max()) const;

  /// Requires `key` to be `version`.
  void requireSchema(int version) const;

  [[noreturn]] void fail(const std::string& problem) const;
  [[noreturn]] void failWithValue(const std::string& problem) const;

  const std::string& file() const { return file_; }

 private:
  YamlValue(std::string file, std::string path, YAML::Node node);
  YamlValue child(const std::string& path, const YAML::Node& node) const;
  void requireMapping() const;
  std::string scalar(const char* expected) const;

  std::string file_;
  std::string path_;
  YAML::Node node_;
};

/// Pose from `position_m` and either `rpy_rad` (roll, pitch, yaw about fixed axes) or `quaternion_wxyz`, each
/// optional.
Eigen::Isometry3d poseFrom(const YamlValue& mapping);

}  // namespace b4p
