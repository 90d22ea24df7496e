// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/scene_families/scene_text.h"

#include <cmath>
#include <iomanip>
#include <locale>
#include <sstream>

namespace b4p {
namespace {

std::string placed(const std::string& name, const std::string& shape, const Eigen::Vector3d& centre_m) {
  return "  - {name: " + name + ", " + shape + ", position_m: " + sceneList(centre_m) + "}\n";
}

}  // namespace

std::string sceneNumber(double value) {
  constexpr int kDecimals = 5;
  std::ostringstream out;
  out.imbue(std::locale::classic());
  out << std::fixed << std::setprecision(kDecimals) << value;
  std::string text = out.str();
  text.erase(text.find_last_not_of('0') + 1);
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

std::string boxBetween(const std::string& name, const Eigen::Vector3d& low_m, const Eigen::Vector3d& high_m) {
  return boxLine(name, high_m - low_m, (low_m + high_m) / 2.0);
}

}  // namespace b4p
