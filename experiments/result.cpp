// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/result.h"

#include <cmath>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <initializer_list>
#include <limits>
#include <set>
#include <stdexcept>

#include <nlohmann/json.hpp>

#include "experiments/output_file.h"
#include "robots/input_error.h"

namespace b4p {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr int kSchema = 1;
constexpr int kIndent = 1;

/// A value in a result file, with what its errors have to name.
class Element {
 public:
  Element(const std::string& file, std::string name, const Json& value)
      : file_(file), name_(std::move(name)), value_(value) {}

  /// An object with exactly these keys.
  const Element& requireKeys(std::initializer_list<const char*> keys) const {
    if (!value_.is_object()) fail("is not an object");
    for (const auto& item : value_.items()) {
      bool known = false;
      for (const char* key : keys) known = known || item.key() == key;
      if (!known) fail("unknown key '" + item.key() + "'");
    }
    for (const char* key : keys)
      if (!value_.contains(key)) fail("has no key '" + std::string(key) + "'");
    return *this;
  }

  Element operator[](const char* key) const {
    return Element(file_, name_.empty() ? key : name_ + "." + key, value_.at(key));
  }

  std::vector<Element> items() const {
    if (!value_.is_array()) fail("is not a list");
    std::vector<Element> list;
    for (std::size_t i = 0; i < value_.size(); ++i)
      list.emplace_back(file_, name_ + "[" + std::to_string(i) + "]", value_[i]);
    return list;
  }

  std::vector<Element> items(std::size_t count) const {
    const std::vector<Element> list = items();
    if (list.size() != count)
      fail("has " + std::to_string(list.size()) + " values, not " + std::to_string(count));
    return list;
  }

  double number() const {
    if (!value_.is_number()) failWithValue("is not a finite number");
    return value_.get<double>();  // finite: the parser refuses what overflows
  }

  std::vector<double> numbers(std::size_t count) const {
    std::vector<double> list;
    for (const Element& item : items(count)) list.push_back(item.number());
    return list;
  }

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

  bool boolean() const {
    if (!value_.is_boolean()) failWithValue("is neither true nor false");
    return value_.get<bool>();
  }

  std::string text() const {
    if (!value_.is_string()) failWithValue("is not a text");
    return value_.get<std::string>();
  }

  std::map<std::string, std::string> texts() const {
    if (!value_.is_object()) fail("is not an object");
    std::map<std::string, std::string> map;
    for (const auto& item : value_.items()) map[item.key()] = (*this)[item.key().c_str()].text();
    return map;
  }

  [[noreturn]] void fail(const std::string& problem) const { throw InputError(file_, name_, problem); }

  [[noreturn]] void failWithValue(const std::string& problem) const {
    constexpr std::size_t kLongest = 60;
    fail(value_.dump(-1, ' ', true, Json::error_handler_t::replace).substr(0, kLongest) + " " + problem);
  }

 private:
  const std::string& file_;
  std::string name_;
  const Json& value_;
};

void requireFinite(double number, const char* name) {
  if (!std::isfinite(number)) throw std::invalid_argument(std::string("result: ") + name + " is not finite");
}

Json listOf(const Eigen::Vector3d& v) { return Json::array({v.x(), v.y(), v.z()}); }

Json toJson(const Eigen::Isometry3d& X, const char* name) {
  requireFinite(X.matrix().sum(), name);
  Json rows = Json::array();
  for (int i = 0; i < 3; ++i) rows.push_back(listOf(X.linear().row(i)));
  return {{"position_m", listOf(X.translation())}, {"rotation", rows}};
}

Json toJson(const Verification& verification) {
  requireFinite(verification.step_m, "verification.step_m");
  requireFinite(verification.clearance_m, "verification.clearance_m");
  return {{"passed", verification.passed},
          {"failure", verification.failure},
          {"step_m", verification.step_m},
          {"configurations", verification.configurations},
          {"clearance_m", verification.clearance_m}};
}

Json toJson(const PlanResult& result) {
  requireFinite(result.time_limit_s, "time_limit_s");
  requireFinite(result.planning_time_s, "planning_time_s");
  requireFinite(result.grasp.opening_m, "grasp.opening_m");
  for (const auto& row : result.path)
    for (const double value : row) requireFinite(value, "path");
  return {
      {"schema", kSchema},
      {"scene", result.scene},
      {"planner", result.planner},
      {"parameters", Json(result.parameters)},
      {"seed", result.seed},
      {"threads", result.threads},
      {"time_limit_s", result.time_limit_s},
      {"planning_time_s", result.planning_time_s},
      {"status", result.status},
      {"solved", result.solved},
      {"grasp_id", result.grasp_id},
      {"grasp", {{"X_OT", toJson(result.grasp.X_OT, "grasp.X_OT")}, {"opening_m", result.grasp.opening_m}}},
      {"X_WO_pick", toJson(result.X_WO_pick, "X_WO_pick")},
      {"X_WO_place", toJson(result.X_WO_place, "X_WO_place")},
      {"joint_names", result.joint_names},
      {"path", result.path},
      {"verification", toJson(result.verification)}};
}

Eigen::Isometry3d readPose(const Element& pose) {
  pose.requireKeys({"position_m", "rotation"});
  Eigen::Isometry3d X = Eigen::Isometry3d::Identity();
  const std::vector<double> position = pose["position_m"].numbers(3);
  const std::vector<Element> rows = pose["rotation"].items(3);
  for (int i = 0; i < 3; ++i) {
    X.translation()[i] = position[static_cast<std::size_t>(i)];
    const std::vector<double> row = rows[static_cast<std::size_t>(i)].numbers(3);
    for (int j = 0; j < 3; ++j) X.linear()(i, j) = row[static_cast<std::size_t>(j)];
  }
  return X;
}

Verification readVerification(const Element& element) {
  element.requireKeys({"passed", "failure", "step_m", "configurations", "clearance_m"});
  Verification verification;
  verification.passed = element["passed"].boolean();
  verification.failure = element["failure"].text();
  verification.step_m = element["step_m"].number();
  verification.configurations = element["configurations"].integer<long>();
  verification.clearance_m = element["clearance_m"].number();
  return verification;
}

void readMotion(const Element& root, PlanResult& result) {
  const Element grasp = root["grasp"].requireKeys({"X_OT", "opening_m"});
  result.grasp.X_OT = readPose(grasp["X_OT"]);
  result.grasp.opening_m = grasp["opening_m"].number();
  result.X_WO_pick = readPose(root["X_WO_pick"]);
  result.X_WO_place = readPose(root["X_WO_place"]);
  for (const Element& name : root["joint_names"].items()) result.joint_names.push_back(name.text());
  for (const Element& row : root["path"].items())
    result.path.push_back(row.numbers(result.joint_names.size()));
}

/// Refuses what the parser would accept silently: the same key twice in an object.
Json parse(std::istream& stream, const std::string& file) {
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

}  // namespace

void writeResult(const std::string& file, const PlanResult& result) {
  const std::string text = toJson(result).dump(kIndent, ' ', false, Json::error_handler_t::replace);
  writeFile(file, text + "\n");
}

PlanResult readResult(const std::string& file) {
  std::error_code error;
  std::ifstream stream(file, std::ios::binary);
  if (fs::is_directory(file, error) || !stream) throw InputError(file, "", "cannot be read");
  const Json document = parse(stream, file);
  const Element root(file, "", document);
  if (!document.is_object()) root.fail("is not a JSON object");
  if (!document.contains("schema")) root.fail("has no key 'schema'");
  if (root["schema"].integer<int>() != kSchema)
    root["schema"].failWithValue("is not schema " + std::to_string(kSchema));
  root.requireKeys({"schema", "scene", "planner", "parameters", "seed", "threads", "time_limit_s",
                    "planning_time_s", "status", "solved", "grasp_id", "grasp", "X_WO_pick", "X_WO_place",
                    "joint_names", "path", "verification"});
  PlanResult result;
  result.scene = root["scene"].text();
  result.planner = root["planner"].text();
  result.parameters = root["parameters"].texts();
  result.seed = root["seed"].integer<std::uint64_t>();
  result.threads = root["threads"].integer<unsigned>();
  result.time_limit_s = root["time_limit_s"].number();
  result.planning_time_s = root["planning_time_s"].number();
  result.status = root["status"].text();
  result.solved = root["solved"].boolean();
  result.grasp_id = root["grasp_id"].integer<int>();
  readMotion(root, result);
  result.verification = readVerification(root["verification"]);
  return result;
}

}  // namespace b4p
