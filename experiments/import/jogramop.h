// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace b4p {

/// A scenario of the Jogramop framework as files of ours.
struct ImportedScenario {
  std::string id;  ///< name of its folder
  /// Name and content: the scene, its grasps, and the meshes that it names.
  std::vector<std::pair<std::string, std::string>> files;
  std::vector<std::string> remarks;  ///< what differs from the original, in words
};

/// Reads `folder`/scenarios/*/ of a clone of the Jogramop framework (Rudorfer, Hartvich, Vonasek, RoMoCo
/// 2024), all those with a folder `export`, sorted: export/grasps.csv, export/obstacles.obj,
/// export/robot_start_conf.csv, scene.yaml. Furniture whose dimensions are known (table, open shelf, gates,
/// pedestal, wall segment of 0.8 m) becomes exact boxes in place of its pieces of the mesh; every other
/// connected piece of the mesh becomes its convex hull. A floor is added. The robot is the mobile Panda,
/// where the framework has its robot.
/// @throws InputError naming file and row or line: a file that is missing or malformed, a pose that is not
///   orthonormal or not finite, no grasp at all, a start outside the joint limits, a piece of the mesh that
///   spans no volume, known furniture of which the mesh has nothing
std::vector<ImportedScenario> importJogramop(const std::string& folder);

}  // namespace b4p
