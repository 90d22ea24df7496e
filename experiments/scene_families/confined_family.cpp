// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>

#include "experiments/problem.h"
#include "experiments/samplers/antipodal_grasps.h"
#include "experiments/scene_families/confined_furniture.h"
#include "experiments/scene_families/confined_scenario.h"
#include "experiments/scene_families/families.h"
#include "experiments/scene_families/grasp_text.h"
#include "experiments/scene_families/scene_text.h"

namespace b4p {
namespace {

constexpr const char* kRobot = "mobile_panda";
/// Half of edge_step_m, by which planning grows the hand, and what rounding the scene file takes.
constexpr double kHandClearance_m = 0.0052;

int groupOf(const FamilyValues& values) { return static_cast<int>(values.at("group")); }

std::string confinedBody(const FamilyValues& values, std::uint64_t) {
  const ConfinedScenario scenario = confinedScenario(groupOf(values), values.at("step"));
  std::string text = "obstacles:\n";
  for (const Obstacle& obstacle : scenario.obstacles) text += shapeLine(obstacle.name, obstacle.shape);
  for (std::size_t i = 0; i < scenario.target.size(); ++i)
    text += shapeLine(scenario.target.size() == 1 ? "target" : "target_" + std::to_string(i + 1),
                      scenario.target[i]);
  return text +
         "reach:\n  start:\n    [0, 0, -0.01779206, -0.760123541, 0.019782607, -2.342050141, 0.029840531, "
         "1.541193530, 0.753448659]\n";
}

// Seen from the object, the grasps of a group are the same for all steps, which only move the object or
// narrow the way to it.
std::string confinedGrasps(const FamilyValues& values, std::uint64_t seed) {
  const RobotFile file = loadRobotFile(kRobot);
  const auto robot = std::make_shared<const Manipulator>(loadUrdf(file.urdf_file), file.description,
                                                         Eigen::Isometry3d::Identity(), file.file);
  const int group = groupOf(values);
  AntipodalRules rules;
  rules.friction_cone_rad = values.at("friction_cone_rad");
  rules.hand_clearance_m = kHandClearance_m;
  const ConfinedScenario scenario = confinedScenario(group, values.at("step"));
  const Eigen::Isometry3d X_WO(Eigen::Translation3d(scenario.target.front().X_BS.translation()));
  std::vector<PlacedShape> object = scenario.target;
  for (PlacedShape& piece : object) piece.X_BS = X_WO.inverse() * piece.X_BS;
  std::vector<Eigen::Isometry3d> X_BT;
  const PlacedShape plane =
      boxObstacle("", {-1, -1, scenario.support_height_m - 0.1}, {3, 3, scenario.support_height_m}).shape;
  const PlacedShape support{plane.shape, X_WO.inverse() * plane.X_BS};
  for (const Grasp& grasp :
       antipodalGrasps(robot, object, {support}, rules, static_cast<std::size_t>(values.at("grasps")),
                       derivedSeed(seed, static_cast<std::uint64_t>(group))))
    X_BT.push_back(confinedRobotBase().inverse() * X_WO * grasp.X_OT);
  return graspText(X_BT);
}

}  // namespace

SceneFamily confinedFamily() {
  SceneFamily family;
  family.name = "confined";
  family.description =
      "A Panda on a sliding platform reaches for one of many grasps of an object in a confined place: on a "
      "table inside a shelf, under a table, behind a gap or a gate. After the Jogramop framework (Rudorfer, "
      "Hartvich, Vonasek, RoMoCo 2024), from its dimensions.";
  family.settings = std::string("robot: ") + kRobot +
                    "\nrobot_base: {position_m: [1, 0, 0.05], rpy_rad: [0, 0, 1.5707963267948966]}\n"
                    "edge_step_m: 0.01\nbudget_s: 10\n";
  family.parameters = {
      {"group", "1 shelf on a table, 2 under a table, 3 gap between walls, 4 gate", 1.0, 4.0, 1.0, 1.0, 1.0,
       1.0},
      {"step", "1: near or wide, 5: far inside or narrow; 0.1 m farther or 0.08 m narrower each", 1.0, 5.0,
       1.0, 3.0, 5.0, 0.001},
      {"grasps", "how many (count)", 1.0, 1000.0, 200.0, 200.0, 200.0, 1.0},
      {"friction_cone_rad", "most between closing axis and surface normal", 0.01, 0.6, 0.2618, 0.2618, 0.2618,
       0.0001}};
  family.body = confinedBody;
  family.grasps = confinedGrasps;
  return family;
}

}  // namespace b4p
