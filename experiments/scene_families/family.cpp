// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/scene_families/family.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "experiments/scene_families/families.h"
#include "experiments/scene_families/scene_text.h"
#include "robots/input_error.h"

namespace b4p {
namespace {

constexpr double kMiddle = 0.5;  ///< the difficulty of the standard values

double atDifficulty(const FamilyParameter& parameter, double difficulty) {
  const double past = 2.0 * (difficulty - kMiddle);
  const double end = past < 0.0 ? parameter.easy : parameter.hard;
  const double value = parameter.standard + std::abs(past) * (end - parameter.standard);
  return std::round(value / parameter.grid) * parameter.grid;
}

void requireInRange(const FamilyParameter& parameter, double value, const std::string& where) {
  if (!(value >= parameter.low && value <= parameter.high))
    throw InputError(where, parameter.name,
                     "has to be from " + sceneNumber(parameter.low) + " to " + sceneNumber(parameter.high) +
                         " (" + std::to_string(value) + ")");
  const double steps = value / parameter.grid;
  if (parameter.grid >= 1.0 && steps != std::round(steps))
    throw InputError(where, parameter.name, "has to be a whole number (" + std::to_string(value) + ")");
}

/// The family's own name for the instance that ships, a name of its own for every other seed and difficulty.
std::string sceneName(const SceneFamily& family, const FamilyRequest& request) {
  constexpr double kPercent = 100.0;
  if (!request.scene_name.empty()) return request.scene_name;
  std::string name = family.name;
  if (request.seed != 0) name += "_" + std::to_string(request.seed);
  if (request.difficulty != kMiddle)
    name += "_d" + std::to_string(std::lround(kPercent * request.difficulty));
  return name;
}

std::string generatedBlock(const SceneFamily& family, const FamilyRequest& request,
                           const FamilyValues& values) {
  std::string text = "generated:  # by b4p generate; to be made again with the same bytes\n";
  text += "  family: " + family.name + "\n  seed: " + std::to_string(request.seed) +
          "\n  difficulty: " + sceneNumber(request.difficulty) + "\n  parameters:\n";
  for (const FamilyParameter& parameter : family.parameters)
    text += "    " + parameter.name + ": " + sceneNumber(values.at(parameter.name)) + "\n";
  return text;
}

}  // namespace

const std::vector<SceneFamily>& sceneFamilies() {
  static const std::vector<SceneFamily> families{mazeFamily(), stickFamily(), groceryFamily(),
                                                 confinedFamily()};
  return families;
}

const SceneFamily& findFamily(const std::string& name, const std::string& where) {
  std::string known;
  for (const SceneFamily& family : sceneFamilies()) {
    if (family.name == name) return family;
    known += (known.empty() ? "" : ", ") + family.name;
  }
  throw InputError(where, "", "no family of scenes is called '" + name + "'; there are: " + known);
}

FamilyValues familyValues(const SceneFamily& family, const FamilyRequest& request, const std::string& where) {
  if (!(request.difficulty >= 0.0 && request.difficulty <= 1.0))
    throw InputError(where, "--difficulty",
                     "has to be from 0 to 1 (" + std::to_string(request.difficulty) + ")");
  FamilyValues values;
  std::string known;
  for (const FamilyParameter& parameter : family.parameters) {
    known += (known.empty() ? "" : ", ") + parameter.name;
    const auto asked = request.set.find(parameter.name);
    const bool is_set = asked != request.set.end();
    if (is_set) requireInRange(parameter, asked->second, where);
    values[parameter.name] = is_set ? asked->second : atDifficulty(parameter, request.difficulty);
  }
  for (const auto& [name, value] : request.set)
    if (values.count(name) == 0)
      throw InputError(where, name, "is no parameter of " + family.name + "; there are: " + known);
  return values;
}

std::string generateScene(const SceneFamily& family, const FamilyRequest& request, const std::string& where) {
  const FamilyValues values = familyValues(family, request, where);
  const std::string name = sceneName(family, request);
  const std::string table = request.grasp_file.empty() ? name + ".grasps.csv" : request.grasp_file;
  return "# SPDX-License-Identifier: BSD-3-Clause\n" + commentLines(family.description) +
         "schema: 1\nname: " + name + "\n" + family.settings + generatedBlock(family, request, values) +
         family.body(values, request.seed) +
         (family.grasps == nullptr ? "" : "  grasps: {file: " + table + "}\n");
}

std::string generateGrasps(const SceneFamily& family, const FamilyRequest& request,
                           const std::string& where) {
  const FamilyValues values = familyValues(family, request, where);
  try {
    return family.grasps(values, request.seed);
  } catch (const std::invalid_argument& error) {
    throw InputError(where, "grasps", error.what());
  }
}

}  // namespace b4p
