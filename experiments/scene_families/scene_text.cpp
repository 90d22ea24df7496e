// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/scene_families/scene_text.h"

#include <cmath>
#include <iomanip>
#include <locale>
#include <sstream>
#include <stdexcept>

namespace b4p {
namespace {

std::string placed(const std::string& name, const std::string& shape, const Eigen::Vector3d& centre_m) {
  return "  - {name: " + name + ", " + shape + ", position_m: " + sceneList(centre_m) + "}\n";
}

constexpr double kNoTurn = 1e-9;

std::string shapeText(const Box& box) { return "box: {size_m: " + sceneList(box.size) + "}"; }
std::string shapeText(const Sphere& sphere) {
  return "sphere: {radius_m: " + sceneNumber(sphere.radius) + "}";
}
std::string shapeText(const Cylinder& c) {
  return "cylinder: {radius_m: " + sceneNumber(c.radius) + ", length_m: " + sceneNumber(c.length) + "}";
}
std::string shapeText(const Capsule& c) {
  return "capsule: {radius_m: " + sceneNumber(c.radius) + ", length_m: " + sceneNumber(c.length) + "}";
}
std::string shapeText(const std::shared_ptr<const ConvexMesh>&) {
  throw std::invalid_argument("a mesh has no text of its own");
}

/// Roll, pitch and yaw about fixed axes.
std::string rpyText(const Eigen::Matrix3d& R) {
  constexpr int kDecimals = 9;
  const double pitch = std::atan2(-R(2, 0), std::hypot(R(0, 0), R(1, 0)));
  double roll = 0.0, yaw = 0.0;
  if (std::hypot(R(0, 0), R(1, 0)) < kNoTurn) {
    yaw = std::atan2(-R(0, 1), R(1, 1));
  } else {
    roll = std::atan2(R(2, 1), R(2, 2));
    yaw = std::atan2(R(1, 0), R(0, 0));
  }
  return "[" + sceneNumber(roll, kDecimals) + ", " + sceneNumber(pitch, kDecimals) + ", " +
         sceneNumber(yaw, kDecimals) + "]";
}

}  // namespace

std::string sceneNumber(double value, int decimals) {
  std::ostringstream out;
  out.imbue(std::locale::classic());
  out << std::fixed << std::setprecision(decimals) << value;
  std::string text = out.str();
  if (decimals > 0) text.erase(text.find_last_not_of('0') + 1);
  if (text.back() == '.') text.pop_back();
  return text == "-0" ? "0" : text;
}

std::string sceneList(const std::vector<double>& values) {
  std::string text;
  for (const double value : values) text += (text.empty() ? "" : ", ") + sceneNumber(value);
  return "[" + text + "]";
}

std::string sceneList(const Eigen::Vector3d& values) {
  return sceneList(std::vector<double>{values.x(), values.y(), values.z()});
}

std::string commentLines(const std::string& text) {
  constexpr std::size_t kWidth = 110;
  std::istringstream words(text);
  std::string lines, line = "#";
  for (std::string word; words >> word;) {
    if (line.size() + 1 + word.size() > kWidth) {
      lines += line + "\n";
      line = "#";
    }
    line += " " + word;
  }
  return lines + line + "\n";
}

std::string boxLine(const std::string& name, const Eigen::Vector3d& size_m, const Eigen::Vector3d& centre_m) {
  return placed(name, "box: {size_m: " + sceneList(size_m) + "}", centre_m);
}

std::string cylinderLine(const std::string& name, double radius_m, double length_m,
                         const Eigen::Vector3d& centre_m) {
  return placed(
      name, "cylinder: {radius_m: " + sceneNumber(radius_m) + ", length_m: " + sceneNumber(length_m) + "}",
      centre_m);
}

std::string shapeLine(const std::string& name, const PlacedShape& placed) {
  const std::string shape = std::visit([](const auto& kind) { return shapeText(kind); }, placed.shape);
  std::string line = "  - {name: " + name + ", " + shape +
                     ", position_m: " + sceneList(Eigen::Vector3d(placed.X_BS.translation()));
  if (!placed.X_BS.linear().isIdentity(kNoTurn)) line += ", rpy_rad: " + rpyText(placed.X_BS.linear());
  return line + "}\n";
}

std::string meshLine(const std::string& name, const std::string& file, bool convex_hull) {
  return "  - {name: " + name + ", mesh: {file: " + file + (convex_hull ? ", convex_hull: true" : "") +
         "}}\n";
}

std::string boxBetween(const std::string& name, const Eigen::Vector3d& low_m, const Eigen::Vector3d& high_m) {
  return boxLine(name, high_m - low_m, (low_m + high_m) / 2.0);
}

}  // namespace b4p
