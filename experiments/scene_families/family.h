// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace b4p {

/// A number that shapes the instances of a family.
struct FamilyParameter {
  std::string name;  ///< with its unit
  std::string meaning;
  double low, high;             ///< what may be asked for, inclusive
  double easy, standard, hard;  ///< at difficulty 0, 0.5 and 1; equal where the difficulty does not matter
  double grid;                  ///< values that the difficulty gives are rounded to multiples of it
};

/// Parameters' values by name.
using FamilyValues = std::map<std::string, double>;

/// What is asked of a family. The defaults ask for the scene that ships under the family's name; of
/// `confined`, for confined/013.
struct FamilyRequest {
  std::uint64_t seed = 0;   ///< 0: nothing is drawn, every position is the standard one
  double difficulty = 0.5;  ///< 0 ... 1, sets the parameters that are not in `set`
  FamilyValues set;
  std::string scene_name;  ///< "": made from family, seed and difficulty
  std::string grasp_file;  ///< how the scene names its table of grasps; "": SCENE_NAME.grasps.csv
};

/// A kind of scene of which any number of instances can be made.
struct SceneFamily {
  std::string name;
  std::string description;
  std::vector<FamilyParameter> parameters;
  /// The text below the header: obstacles, object, grasps, placement. Same values and seed, same bytes.
  std::string (*body)(const FamilyValues& values, std::uint64_t seed) = nullptr;
  /// The table of grasps that stands beside the scene (readGraspTable()); nullptr for families without one.
  /// Where there is one, `body` ends inside the block `reach:`.
  std::string (*grasps)(const FamilyValues& values, std::uint64_t seed) = nullptr;
  /// Robot and settings that all instances share, as lines of the scene file.
  std::string settings;
};

/// The families there are: maze, stick, grocery, confined.
const std::vector<SceneFamily>& sceneFamilies();

/// @param where  named in errors
/// @throws InputError listing the names there are
const SceneFamily& findFamily(const std::string& name, const std::string& where);

/// All parameters of the family, those not set at what the difficulty makes of them.
/// @throws InputError naming the parameter and its range for an unknown name or a value out of range, and
///   for a difficulty outside 0 ... 1
FamilyValues familyValues(const SceneFamily& family, const FamilyRequest& request, const std::string& where);

/// The scene file of an instance. Same request, same bytes. A choice inside the ranges may still be an
/// impossible task.
/// @throws InputError as familyValues() does
std::string generateScene(const SceneFamily& family, const FamilyRequest& request, const std::string& where);

/// The table of grasps of an instance, of a family that has them. Same request, same bytes.
/// @throws InputError as familyValues() does, and where so many grasps are not found
std::string generateGrasps(const SceneFamily& family, const FamilyRequest& request, const std::string& where);

}  // namespace b4p
