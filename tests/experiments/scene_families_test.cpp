// SPDX-License-Identifier: BSD-3-Clause
// The scenes that ship are instances of their families; instances are made again with the same bytes, differ
// by seed, load, and have valid picks and reachable placements; parameters outside their ranges are refused.
#include "experiments/scene_families/family.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "experiments/fixtures.h"
#include "experiments/preflight.h"
#include "experiments/scene_families/maze_outline.h"
#include "experiments/scene_files/data_files.h"
#include "robots/input_error.h"

namespace b4p::test {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::StartsWith;

FamilyRequest seeded(std::uint64_t seed) {
  FamilyRequest request;
  request.seed = seed;
  return request;
}

std::string generated(const std::string& family, const FamilyRequest& request) {
  return generateScene(findFamily(family, "test"), request, "test");
}

std::string refusal(const std::string& family, const FamilyRequest& request) {
  try {
    generated(family, request);
  } catch (const InputError& e) {
    return e.what();
  }
  return "accepted";
}

FamilyRequest with(const std::string& parameter, double value) {
  FamilyRequest request;
  request.set[parameter] = value;
  return request;
}

TEST(SceneFamilies, ShippedScenesAreTheStandardInstances) {
  for (const SceneFamily& family : sceneFamilies()) {
    const std::string shipped = readFile(shippedFile("experiments/scenes", "scene", family.name));
    const std::string standard = generated(family.name, {});
    // What has been measured about the scene may stand below.
    EXPECT_THAT(shipped, StartsWith(standard)) << family.name;
    const std::string rest = shipped.substr(std::min(standard.size(), shipped.size()));
    EXPECT_TRUE(rest.empty() || rest[0] == '#' || rest.rfind("numbers:", 0) == 0) << rest;
  }
}

TEST(SceneFamilies, OneRequestGivesTheSameBytesAndAnotherSeedOthers) {
  for (const SceneFamily& family : sceneFamilies()) {
    EXPECT_EQ(generated(family.name, seeded(7)), generated(family.name, seeded(7)));
    EXPECT_NE(generated(family.name, seeded(7)), generated(family.name, seeded(8)));
    EXPECT_NE(generated(family.name, seeded(7)), generated(family.name, seeded(0)));
  }
}

TEST(SceneFamilies, FiveSeedsOfEachHavePicksAndReachablePlacements) {
  const TemporaryFolder folder;
  for (const SceneFamily& family : sceneFamilies())
    for (std::uint64_t seed = 1; seed <= 5; ++seed) {
      const std::string file = folder / (family.name + std::to_string(seed) + ".yaml");
      writeText(file, generated(family.name, seeded(seed)));
      const Scene scene = loadScene(file);
      EXPECT_EQ(scene.name, family.name + "_" + std::to_string(seed));
      EXPECT_NO_THROW(preflight(scene)) << file;
    }
}

TEST(SceneFamilies, DifficultyMovesParametersFromEasyToHard) {
  for (const SceneFamily& family : sceneFamilies())
    for (const double difficulty : {0.0, 0.5, 1.0}) {
      FamilyRequest request;
      request.difficulty = difficulty;
      const FamilyValues values = familyValues(family, request, "test");
      for (const FamilyParameter& p : family.parameters) {
        const double wanted = difficulty < 0.5 ? p.easy : difficulty > 0.5 ? p.hard : p.standard;
        EXPECT_NEAR(values.at(p.name), wanted, 1e-9) << p.name;
        EXPECT_LE(p.low, std::min({p.easy, p.standard, p.hard})) << p.name;
        EXPECT_GE(p.high, std::max({p.easy, p.standard, p.hard})) << p.name;
      }
    }
}

TEST(SceneFamilies, EndsOfEveryRangeLoad) {
  const TemporaryFolder folder;
  for (const SceneFamily& family : sceneFamilies())
    for (const FamilyParameter& p : family.parameters)
      for (const double value : {p.low, p.high}) {
        const std::string file = folder / "scene.yaml";
        writeText(file, generated(family.name, with(p.name, value)));
        EXPECT_NO_THROW(loadScene(file)) << family.name << " " << p.name << " " << value;
      }
}

TEST(SceneFamilies, RefuseWhatIsUnknownOrOutOfRange) {
  EXPECT_THAT(refusal("stick", with("gap_width_m", 0.5)),
              AllOf(HasSubstr("gap_width_m"), HasSubstr("from 0.075 to 0.3")));
  EXPECT_THAT(refusal("stick", with("gap_width_m", std::nan(""))), HasSubstr("gap_width_m"));
  EXPECT_THAT(refusal("maze", with("gap_width_m", 0.1)),
              AllOf(HasSubstr("gap_width_m"), HasSubstr("slot_length_m")));
  EXPECT_THAT(refusal("grocery", with("clutter", 2.5)),
              AllOf(HasSubstr("clutter"), HasSubstr("whole number")));
  FamilyRequest request;
  request.difficulty = 1.5;
  EXPECT_THAT(refusal("maze", request), HasSubstr("--difficulty"));
  EXPECT_THROW(findFamily("labyrinth", "test"), InputError);
}

double area(const Outline& outline) {
  double doubled = 0.0;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const Eigen::Vector2d& next = outline[(i + 1) % outline.size()];
    doubled += outline[i].x() * next.y() - outline[i].y() * next.x();
  }
  return doubled / 2.0;
}

TEST(MazeOutline, SectorsFillIt) {
  for (std::uint64_t seed = 0; seed < 4; ++seed) {
    Jitter jitter(seed);
    const Outline outline = seed == 0 ? standardOutline() : drawnOutline(jitter);
    EXPECT_EQ(outline.size(), 21u);
    double sum = 0.0;
    for (const Outline& sector : convexSectors(outline)) sum += area(sector);
    EXPECT_NEAR(sum, area(outline), 1e-12);
  }
}

TEST(MazeOutline, WidthIsTheOneOfRobotAndObjectInLine) {
  // A bar 0.4 m x 0.1 m: held at an end the robot's 0.2 m are the width; held at a side, across, robot and
  // bar are 0.1 + 0.01 + 0.33 m deep and 0.4 m wide.
  const Outline bar{{-0.2, -0.05}, {0.2, -0.05}, {0.2, 0.05}, {-0.2, 0.05}};
  const std::vector<double> widths = graspWidths(bar, 0.01);
  EXPECT_NEAR(widths[1], 0.2, 1e-5);
  EXPECT_NEAR(widths[3], 0.2, 1e-5);
  EXPECT_GT(widths[0], 0.35);
  EXPECT_LE(widths[0], 0.4);
}

}  // namespace
}  // namespace b4p::test
