// SPDX-License-Identifier: BSD-3-Clause
#include <array>

#include "experiments/scene_families/families.h"
#include "experiments/scene_families/jitter.h"
#include "experiments/scene_families/scene_text.h"

namespace b4p {
namespace {

constexpr double kLength_m = 0.6, kRadius_m = 0.0125;  ///< of the stick
constexpr double kClearance_m = 0.006;                 ///< contact_clearance_m
constexpr double kBoard_m = 0.016, kPanel_m = 0.01, kDivider_m = 0.005, kFront_m = 0.012;  ///< thicknesses
constexpr double kRest_m = 0.02;      ///< height of what the stick lies on
constexpr double kSideRoom_m = 0.03;  ///< between the stick's end and the rack's side
constexpr double kBehind_m = 0.13;    ///< from the farthest placement to the wall: half a hand and a bit
constexpr double kRim_m = 0.03;       ///< height of bar, dividers and brackets above the slot
constexpr double kBracketInside_m = 0.038;  ///< of a bracket from the stick's end
constexpr double kApron_m = 0.1;            ///< of the board in front of the bar
constexpr double kSlack_m = 0.01;           ///< of a placement to each side

/// A rack seen from the robot: its bar's front face at `x`, its middle at `y`, the stick lying at `z`.
struct Rack {
  double x, y, z;
  double slot_m, gap_m, depth_m;
};

Eigen::Vector3d at(const Rack& rack, double x, double y, double z) {
  return {rack.x + x, rack.y + y, rack.z + z};
}

/// What stands on one side (+1 left, -1 right): the rack's side panel, what the stick's end rests on, the
/// bracket and the divider above the slot, which keep the stick down, and half of the bar.
std::string rackSide(const Rack& rack, int side) {
  const std::string name = side > 0 ? "_left" : "_right";
  const double half = kLength_m / 2.0 + kSideRoom_m, bracket = kLength_m / 2.0 - kBracketInside_m;
  const double divider = rack.gap_m / 2.0, top = rack.slot_m + kRim_m, back = rack.depth_m;
  const auto between = [&](const std::string& part, double x, double inner, double outer, double low,
                           double high, double to) {
    const double y_low = side > 0 ? inner : -outer, y_high = side > 0 ? outer : -inner;
    return boxBetween(part + name, at(rack, x, y_low, low), at(rack, to, y_high, high));
  };
  return between("side", 0.0, half, half + kPanel_m, -kRest_m, top, back) +
         between("rest", 0.0, bracket, bracket + kPanel_m, -kRest_m, 0.0, back) +
         between("bracket", kFront_m, bracket, bracket + kPanel_m, rack.slot_m, top, back) +
         between("divider", 0.0, divider, divider + kDivider_m, rack.slot_m, top, back) +
         between("bar", 0.0, divider + kDivider_m, half, rack.slot_m, top, kFront_m);
}

std::string pickTable(double x, double y, double z) {
  const double half_x = 0.35, half_y = 0.15, block = 0.27;
  std::string text = boxBetween("table", {x - half_x, y - half_y, z - kRest_m - 0.03},
                                {x + half_x, y + half_y, z - kRest_m});
  for (const int end : {-1, 1})
    text += boxLine(end < 0 ? "block_near" : "block_far", {kPanel_m, 0.04, kRest_m},
                    {x + end * block, y, z - kRest_m / 2.0});
  return text;
}

/// Things on the board's far corners and above the rack, by number.
std::string clutter(const Rack& rack, int count) {
  const double half = kLength_m / 2.0 + kSideRoom_m + kPanel_m;
  const std::array<std::string, 4> things{
      boxLine("lamp", {0.08, 0.1, 0.05}, at(rack, 0.25, half + 0.1, 0.42)),
      boxLine("switch", {0.03, 0.08, 0.08}, at(rack, rack.depth_m - 0.015, -half - 0.06, 0.2)),
      boxLine("shelf_above", {0.12, 0.5, 0.02}, at(rack, rack.depth_m - 0.06, 0.0, 0.46)),
      cylinderLine("jar", 0.04, 0.1, at(rack, rack.depth_m - 0.06, 0.12, 0.53))};
  std::string text;
  for (int i = 0; i < count; ++i) text += things.at(static_cast<std::size_t>(i));
  return text;
}

std::string stickBody(const FamilyValues& values, std::uint64_t seed) {
  Jitter jitter(seed);
  const double move = values.at("pose_jitter_m"), front = values.at("front_room_m");
  const double depth = values.at("passage_depth_m") + kBehind_m + kFront_m;
  const Rack rack{jitter.around(0.48, move),
                  jitter.around(0.0, move),
                  jitter.around(values.at("shelf_height_m"), move),
                  2.0 * kRadius_m + values.at("slot_clearance_m"),
                  values.at("gap_width_m"),
                  depth};
  const double pick_x = jitter.around(0.3, move), pick_y = jitter.around(-0.45, move), pick_z = 0.1;
  const double half = kLength_m / 2.0 + kSideRoom_m + kPanel_m, lie = kRadius_m + kClearance_m;
  const double wall = rack.x + depth;
  const Eigen::Vector3d low = at(rack, kFront_m + front, -kSlack_m, lie);
  const Eigen::Vector3d high = at(rack, kFront_m + values.at("passage_depth_m"), kSlack_m, lie);
  std::string text = "obstacles:\n";
  text += boxLine("floor", {2.4, 2.4, 0.05}, {0.3, 0.0, -0.125}) + pickTable(pick_x, pick_y, pick_z);
  text +=
      "  # The rack on the wall: a slot along its whole width; above it the bar, which is open in the "
      "middle.\n";
  text +=
      boxBetween("board", at(rack, -kApron_m, -half, -kRest_m - kBoard_m), at(rack, depth, half, -kRest_m));
  text += boxBetween("wall", {wall, -0.7, -0.1}, {wall + 0.02, 0.7, 0.8});
  text += rackSide(rack, -1) + rackSide(rack, 1) + clutter(rack, static_cast<int>(values.at("clutter")));
  text += "object:\n  name: stick\n  shapes: [{cylinder: {radius_m: " + sceneNumber(kRadius_m) +
          ", length_m: " + sceneNumber(kLength_m) +
          "}}]\n  start: {position_m: " + sceneList(Eigen::Vector3d(pick_x, pick_y, pick_z + lie)) +
          ", rpy_rad: [0, 1.5707963267948966, 0]}\n";
  text += "grasps:\n  stick: {length_m: " + sceneNumber(kLength_m) + ", radius_m: " + sceneNumber(kRadius_m) +
          ", margin_m: 0.06, finger_depth_m: " + sceneNumber(kRadius_m) + ", pad_clearance_m: 0.002}\n";
  text += "placement:\n  region: {min_m: " + sceneList(low) + ", max_m: " + sceneList(high) +
          "}\n  yaw_rad: [1.5508, 1.5908]\n";
  return text;
}

}  // namespace

SceneFamily stickFamily() {
  SceneFamily family;
  family.name = "stick";
  family.description =
      "A stick from two blocks into a rack on the wall. The stick passes under the bar along the rack's "
      "front; the hand above it passes only where the bar is open, in the middle. Hands elsewhere along the "
      "stick have placements behind the bar, reached from above, but hardly a way to them.";
  family.settings = "robot: panda\nedge_step_m: 0.01\ncontact_clearance_m: " + sceneNumber(kClearance_m) +
                    "\nbudget_s: 180\n";
  family.parameters = {
      {"slot_clearance_m", "height of the slot less the stick's thickness", 0.012, 0.08, 0.06, 0.04, 0.02,
       0.001},
      {"gap_width_m", "opening of the bar (the hand is 0.064 wide)", 0.075, 0.3, 0.16, 0.085, 0.078, 0.001},
      {"passage_depth_m", "from the bar to the farthest placement", 0.13, 0.2, 0.15, 0.15, 0.15, 0.001},
      {"front_room_m", "from the bar to the nearest placement", 0.015, 0.12, 0.015, 0.015, 0.03, 0.001},
      {"shelf_height_m", "of the rests above the robot's foot", 0.2, 0.45, 0.3, 0.3, 0.3, 0.001},
      {"pose_jitter_m", "rack and stick stand up to this off (seeds other than 0)", 0.0, 0.05, 0.03, 0.03,
       0.03, 0.001},
      {"clutter", "things about the rack (count)", 0.0, 4.0, 0.0, 0.0, 4.0, 1.0}};
  family.body = stickBody;
  return family;
}

}  // namespace b4p
