// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>

#include "experiments/scene_families/families.h"
#include "experiments/scene_families/jitter.h"
#include "experiments/scene_families/maze_outline.h"
#include "experiments/scene_families/scene_text.h"

namespace b4p {
namespace {

constexpr double kFloor_m = 5.0, kWall_m = 0.1, kHeight_m = 0.3;  ///< side of the floor; of walls
constexpr double kLane_m = 1.5;                                   ///< width of the three lanes
constexpr double kGraspClearance_m = 0.01;
constexpr double kMove_m = 0.1;  ///< how far passages move along their lanes

/// A lane from west to east; walls that close it reach kWall_m beyond.
struct Lane {
  std::string name;
  double middle;  ///< its y
  double low() const { return middle - kLane_m / 2.0 - kWall_m; }
  double high() const { return middle + kLane_m / 2.0 + kWall_m; }
};

const Lane kStart{"_1", 0.85}, kReturn{"_2", 2.5}, kGoal{"_3", 4.15};

std::string wall(const std::string& name, double x_low, double x_high, double y_low, double y_high) {
  return boxBetween(name, {x_low, y_low, -kHeight_m / 2.0}, {x_high, y_high, kHeight_m / 2.0});
}

/// The same wall with its lane turned upside down when `mirrored`.
std::string laneWall(const Lane& lane, bool mirrored, const std::string& name, double x_low, double x_high,
                     double y_low, double y_high) {
  const double twice = 2.0 * lane.middle;
  return mirrored ? wall(name + lane.name, x_low, x_high, twice - y_high, twice - y_low)
                  : wall(name + lane.name, x_low, x_high, y_low, y_high);
}

/// Two openings `width` wide, the second 0.3 m aside of the first.
std::string jog(const Lane& lane, bool mirrored, double x, double width) {
  constexpr double kAside_m = 0.3, kBlock_m = 0.5, kHalf_m = 0.662;
  const double low = lane.middle - (width + kAside_m) / 2.0, high = lane.middle + (width + kAside_m) / 2.0;
  const double from = x - kHalf_m, to = x + kHalf_m;
  return laneWall(lane, mirrored, "jog_floor", from, to, lane.low(), low) +
         laneWall(lane, mirrored, "jog_roof", from, to, high, lane.high()) +
         laneWall(lane, mirrored, "jog_left", from, from + kBlock_m, low + width, lane.high()) +
         laneWall(lane, mirrored, "jog_right", to - kBlock_m, to, lane.low(), high - width);
}

/// Two staggered walls, each of which leaves `opening` of its lane.
std::string zed(const Lane& lane, bool mirrored, double x, double opening) {
  constexpr double kApart_m = 1.14;
  const double left = x - kApart_m / 2.0, right = x + kApart_m / 2.0, reach = kLane_m - opening + kWall_m;
  return laneWall(lane, mirrored, "zed_left", left - kWall_m / 2.0, left + kWall_m / 2.0, lane.high() - reach,
                  lane.high()) +
         laneWall(lane, mirrored, "zed_right", right - kWall_m / 2.0, right + kWall_m / 2.0, lane.low(),
                  lane.low() + reach);
}

std::string slot(const Lane& lane, double x, double middle, double width, double length) {
  const double from = x - length / 2.0, to = x + length / 2.0;
  return laneWall(lane, false, "slot_floor", from, to, lane.low(), middle - width / 2.0) +
         laneWall(lane, false, "slot_roof", from, to, middle + width / 2.0, lane.high());
}

std::string frame() {
  const double far = kFloor_m - kWall_m;
  return wall("outer_south", 0.0, kFloor_m, 0.0, kWall_m) +
         wall("outer_north", 0.0, kFloor_m, far, kFloor_m) + wall("outer_west", 0.0, kWall_m, 0.0, kFloor_m) +
         wall("outer_east", far, kFloor_m, 0.0, kFloor_m) + wall("shelf_low", 0.0, 4.0, 1.6, 1.75) +
         wall("shelf_high", 1.0, kFloor_m, 3.25, 3.4);
}

/// A passage of the lane: a jog or a zed, either way up, as the seed has it.
std::string passage(const Lane& lane, bool jog_by_default, double x, const FamilyValues& values,
                    Jitter& jitter) {
  const bool is_jog = jog_by_default != jitter.coin(), mirrored = jitter.coin();
  const double moved = jitter.around(x, kMove_m);
  return is_jog ? jog(lane, mirrored, moved, values.at("jog_width_m"))
                : zed(lane, mirrored, moved, values.at("zed_opening_m"));
}

std::string obstacles(const FamilyValues& values, double slot_width, Jitter& jitter) {
  const int passages = static_cast<int>(values.at("passages"));
  std::string text = "obstacles:\n" + frame();
  // Each draw is made whether it is needed or not, so that one passage less leaves the others as they are.
  const std::string first = passage(kStart, true, 2.362, values, jitter);
  const std::string second = passage(kReturn, false, 2.62, values, jitter);
  const double slot_x = jitter.around(3.1, kMove_m), slot_y = jitter.around(kGoal.middle, kMove_m);
  const double north_x = jitter.around(1.8, kMove_m), south_x = jitter.around(4.0, kMove_m / 2.0);
  if (passages > 2) text += first;
  if (passages > 1) text += second;
  text += slot(kGoal, slot_x, slot_y, slot_width, values.at("slot_length_m"));
  text += wall("spur_north", north_x - kWall_m / 2.0, north_x + kWall_m / 2.0, 4.3, kFloor_m - kWall_m / 2.0);
  text += wall("spur_south", south_x - kWall_m / 2.0, south_x + kWall_m / 2.0, kWall_m / 2.0, 0.6);
  return text;
}

std::string cornerList(const Outline& outline, const std::string& indent) {
  constexpr std::size_t kPerLine = 5;
  std::string text = "[";
  for (std::size_t i = 0; i < outline.size(); ++i) {
    if (i > 0) text += i % kPerLine == 0 ? ",\n" + indent : ", ";
    text += sceneList(std::vector<double>{outline[i].x(), outline[i].y()});
  }
  return text + "]\n";
}

std::string objectText(const Outline& outline) {
  std::string text =
      "object:\n  name: star_21_gon\n  shapes:  # convex sectors of the outline about the origin\n";
  for (const Outline& sector : convexSectors(outline))
    text +=
        "    - prism:\n        height_m: 0.1\n        polygon_m: " + cornerList(sector, std::string(20, ' '));
  return text + "  start: {position_m: [0.85, 0.85, 0], rpy_rad: [0, 0, 0]}\n";
}

std::string mazeBody(const FamilyValues& values, std::uint64_t seed) {
  constexpr double kPerMetre = 1000.0;
  Jitter jitter(seed);
  const bool drawn = !jitter.standard() && values.at("random_outline") > 0.0;
  const Outline outline = drawn ? drawnOutline(jitter) : standardOutline();
  std::vector<double> widths = graspWidths(outline, kGraspClearance_m);
  std::partial_sort(widths.begin(), widths.begin() + 2, widths.end());
  const double slot_m = widths[0] + values.at("slot_share") * (widths[1] - widths[0]);
  std::string text =
      obstacles(values, std::round(slot_m * kPerMetre) / kPerMetre, jitter) + objectText(outline);
  text +=
      "grasps:  # grasp i lies on the edge from corner i to corner i + 1\n  polygon_edges:\n    "
      "clearance_m: " +
      sceneNumber(kGraspClearance_m) + "\n    polygon_m: " + cornerList(outline, std::string(16, ' '));
  return text +
         "placement:\n  region: {min_m: [4.05, 4.05, 0], max_m: [4.25, 4.25, 0]}\n"
         "  yaw_rad: [-3.14159, 3.14159]\n";
}

}  // namespace

SceneFamily mazeFamily() {
  SceneFamily family;
  family.name = "maze";
  family.description =
      "Planar maze: a rectangular robot carries a 21-gon from the chamber at the bottom left into a region "
      "at "
      "the top right. Held, robot and object move as one rigid body; every edge of the outline is a grasp. "
      "The "
      "last passage is a slot that only the slimmest pair of robot and object passes, in line; the others "
      "are "
      "jogs (two openings, one aside of the other) and zeds (two staggered walls).";
  family.settings =
      "robot: planar_gripper\nedge_step_m: 0.01\n"
      "contact_clearance_m: 0.01  # nothing rests in the plane: how far the object starts from any wall at "
      "least\n"
      "budget_s: 120\n";
  family.parameters = {
      {"slot_share", "slot from the slimmest grasp's width (0) to the second slimmest's (1)", 0.05, 1.5, 0.9,
       0.71, 0.4, 0.01},
      {"slot_length_m", "length of the slot", 0.1, 1.0, 0.4, 0.6, 0.6, 0.001},
      {"jog_width_m", "openings of jogs", 0.4, 0.7, 0.6, 0.54, 0.5, 0.001},
      {"zed_opening_m", "what each wall of a zed leaves of its lane's 1.5 m", 0.5, 1.2, 0.9, 0.8, 0.7, 0.001},
      {"passages", "3: in all lanes, 2: not in the first, 1: the slot alone (count)", 1.0, 3.0, 3.0, 3.0, 3.0,
       1.0},
      {"random_outline", "1: the seed draws the outline, 0: the standard one (seed 0: always)", 0.0, 1.0, 1.0,
       1.0, 1.0, 1.0}};
  family.body = mazeBody;
  return family;
}

}  // namespace b4p
