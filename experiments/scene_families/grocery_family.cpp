// SPDX-License-Identifier: BSD-3-Clause
#include <array>

#include "experiments/scene_families/families.h"
#include "experiments/scene_families/jitter.h"
#include "experiments/scene_families/scene_text.h"

namespace b4p {
namespace {

using Eigen::Vector3d;

constexpr double kClearance_m = 0.006;              ///< contact_clearance_m
constexpr double kWidth_m = 0.54, kPlank_m = 0.02;  ///< of the shelf, outside; of its planks
const Vector3d kCan_m(0.102, 0.060, 0.0835);
const Vector3d kSugar_m(0.176, 0.097, 0.063), kCracker_m(0.16, 0.072, 0.12);

/// The shelf: its front edge at `x`, its middle at `y`, its compartment's floor at `z`.
struct Shelf {
  double x, y, z;
  double depth_m, gap_m;
};

Vector3d at(const Shelf& shelf, double x, double y, double z) {
  return {shelf.x + x, shelf.y + y, shelf.z + z};
}

std::string planks(const Shelf& shelf) {
  const double half = kWidth_m / 2.0, foot = -0.36, top = 0.40;
  const auto plank = [&](const std::string& name, double low) {
    return boxBetween(name, at(shelf, 0.0, -half, low), at(shelf, shelf.depth_m, half, low + kPlank_m));
  };
  const auto side = [&](const std::string& name, double low) {
    return boxBetween(name, at(shelf, 0.0, low, foot), at(shelf, shelf.depth_m, low + kPlank_m, top));
  };
  return plank("shelf_bottom", -kPlank_m) + plank("shelf_top", shelf.gap_m) +
         boxBetween("shelf_back", at(shelf, shelf.depth_m, -half, foot),
                    at(shelf, shelf.depth_m + kPlank_m, half, top)) +
         side("shelf_left", half - kPlank_m) + side("shelf_right", -half) + plank("shelf_lower", -0.26) +
         plank("shelf_upper", 0.38);
}

/// What stands around the gap for the can, its middle `middle_m` behind the shelf's edge, and behind it.
std::string neighbours(const Shelf& shelf, double clearance_m, double middle_m) {
  const double gap_half = kCan_m.y() / 2.0 + clearance_m;
  constexpr double kSugarHalf_m = 0.048, kCrackerHalf_m = 0.038;
  return boxLine("sugar_box", kSugar_m, at(shelf, middle_m, -gap_half - kSugarHalf_m, kSugar_m.z() / 2.0)) +
         boxLine("cracker_box", kCracker_m,
                 at(shelf, middle_m, gap_half + kCrackerHalf_m, kCracker_m.z() / 2.0)) +
         cylinderLine("soup_can", 0.034, 0.102, at(shelf, shelf.depth_m - 0.055, 0.0, 0.051));
}

/// Groceries in the other compartments and beside the gap, by number.
std::string clutter(const Shelf& shelf, int count) {
  const double above = shelf.gap_m + kPlank_m, below = kPlank_m - 0.26, slack = 0.001;
  const std::array<std::string, 6> things{
      boxLine("mustard", {0.058, 0.095, 0.14}, at(shelf, 0.1, -0.16, above + 0.07 + slack)),
      cylinderLine("bottle", 0.037, 0.15, at(shelf, 0.08, 0.1, above + 0.075 + slack)),
      cylinderLine("tuna", 0.043, 0.034, at(shelf, 0.1, 0.1, below + 0.017)),
      cylinderLine("coffee", 0.051, 0.14, at(shelf, 0.09, -0.1, below + 0.07)),
      boxLine("pudding", {0.035, 0.09, 0.089}, at(shelf, 0.03, 0.19, 0.0445)),
      cylinderLine("pitcher", 0.054, 0.1, at(shelf, 0.2, -0.02, above + 0.05))};
  std::string text;
  for (int i = 0; i < count; ++i) text += things.at(static_cast<std::size_t>(i));
  return text;
}

std::string groceryBody(const FamilyValues& values, std::uint64_t seed) {
  constexpr double kGoal_m = 0.03, kGoalHalf_m = 0.015, kPost_m = 0.35;
  Jitter jitter(seed);
  const double move = values.at("pose_jitter_m");
  const Shelf shelf{jitter.around(0.5, move), jitter.around(0.0, move), jitter.around(0.3, move), 0.34,
                    values.at("shelf_gap_m")};
  const double post_x = jitter.around(0.35, move), post_y = jitter.around(-0.45, move);
  const double post_z = jitter.around(0.25, move);
  const double lie = kCan_m.z() / 2.0 + kClearance_m, goal = values.at("goal_depth_m");
  std::string text = "obstacles:\n" + boxLine("floor", {2.4, 2.4, 0.05}, {0.3, 0.0, -0.125});
  text += cylinderLine("post", 0.03, kPost_m, {post_x, post_y, post_z - kPost_m / 2.0});
  text += "  # The shelf; the compartment in its middle is the one to put the can into.\n" + planks(shelf);
  text += neighbours(shelf, values.at("neighbour_clearance_m"), values.at("neighbour_depth_m"));
  text += clutter(shelf, static_cast<int>(values.at("clutter")));
  text += "object:\n  name: spam\n  shapes: [{box: {size_m: " + sceneList(kCan_m) +
          "}}]\n  start: {position_m: " + sceneList(Vector3d(post_x, post_y, post_z + lie)) +
          ", rpy_rad: [0, 0, -1.6]}\n";
  text +=
      "grasps:\n  box: {size_m: " + sceneList(kCan_m) + ", finger_depth_m: 0.026, pad_clearance_m: 0.002}\n";
  text += "placement:\n  region: {min_m: " + sceneList(at(shelf, goal, -kGoalHalf_m, lie)) +
          ", max_m: " + sceneList(at(shelf, goal + kGoal_m, kGoalHalf_m, lie)) + "}\n  upright: true\n";
  const double turn = values.at("yaw_room_rad");
  text += "  yaw_rad: " + sceneList(std::vector<double>{1.6 - turn, 1.6 + turn}) + "\n";
  return text;
}

}  // namespace

SceneFamily groceryFamily() {
  SceneFamily family;
  family.name = "grocery";
  family.description =
      "A spam can from a post into a shelf, between two neighbours. The compartment is so low and the goal "
      "so "
      "deep that only a hand that comes in nearly flat from the front, holding the can at its front, fits, "
      "while the post leaves grasps from nearly all sides open: most picks are dead ends.";
  family.settings = "robot: panda\nedge_step_m: 0.01\ncontact_clearance_m: " + sceneNumber(kClearance_m) +
                    "\nbudget_s: 120\n";
  family.parameters = {
      {"shelf_gap_m", "height of the compartment", 0.11, 0.3, 0.17, 0.115, 0.113, 0.001},
      {"goal_depth_m", "from the shelf's front edge to the nearest placement of the can's middle", 0.06, 0.2,
       0.12, 0.14, 0.15, 0.001},
      {"neighbour_clearance_m", "from a can in the middle of its gap to each neighbour", 0.035, 0.1, 0.07,
       0.057, 0.05, 0.001},
      {"neighbour_depth_m", "from the shelf's front edge to the middles of the neighbours", 0.1, 0.24, 0.2,
       0.2, 0.18, 0.001},
      {"yaw_room_rad", "turn allowed to each side at the place", 0.02, 1.5, 0.2, 0.2, 0.1, 0.01},
      {"pose_jitter_m", "shelf and post stand up to this off (seeds other than 0)", 0.0, 0.05, 0.03, 0.03,
       0.03, 0.001},
      {"clutter", "groceries in the other compartments (count)", 0.0, 6.0, 3.0, 3.0, 6.0, 1.0}};
  family.body = groceryBody;
  return family;
}

}  // namespace b4p
