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
#include "robots/input_error.h"

namespace b4p::test {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

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

Scene loaded(const TemporaryFolder& folder, const std::string& text) {
  const std::string file = folder / "scene.yaml";
  writeText(file, text);
  return loadScene(file);
}

/// Those that make tasks of pick and place. confined_test.cpp is about the other one.
std::vector<SceneFamily> pickPlaceFamilies() {
  std::vector<SceneFamily> families;
  for (const SceneFamily& family : sceneFamilies())
    if (family.grasps == nullptr) families.push_back(family);
  return families;
}

constexpr double kSame = 1e-9;  // m, and entries of rotation matrices

/// Numbers that say all about a shape of the kinds that families use.
std::vector<double> dimensions(const Shape& shape) {
  if (const auto* box = std::get_if<Box>(&shape)) return {box->size.x(), box->size.y(), box->size.z()};
  if (const auto* cylinder = std::get_if<Cylinder>(&shape)) return {cylinder->radius, cylinder->length};
  std::vector<double> coordinates;
  for (const Eigen::Vector3d& p : std::get<std::shared_ptr<const ConvexMesh>>(shape)->vertices)
    coordinates.insert(coordinates.end(), {p.x(), p.y(), p.z()});
  return coordinates;
}

void expectSame(const PlacedShape& a, const PlacedShape& b, const std::string& what) {
  EXPECT_LT((a.X_BS.matrix() - b.X_BS.matrix()).cwiseAbs().maxCoeff(), kSame) << what;
  ASSERT_EQ(a.shape.index(), b.shape.index()) << what;
  EXPECT_THAT(dimensions(a.shape), ::testing::Pointwise(::testing::DoubleNear(kSame), dimensions(b.shape)))
      << what;
}

void expectSame(const GraspSource& a, const GraspSource& b) {
  EXPECT_EQ(a.family, b.family);
  ASSERT_EQ(a.polygon_m.size(), b.polygon_m.size());
  for (std::size_t i = 0; i < a.polygon_m.size(); ++i)
    EXPECT_LT((a.polygon_m[i] - b.polygon_m[i]).norm(), kSame);
  EXPECT_LT((a.box_size_m - b.box_size_m).norm(), kSame);
  EXPECT_NEAR(a.stick_length_m, b.stick_length_m, kSame);
  EXPECT_NEAR(a.stick_radius_m, b.stick_radius_m, kSame);
  EXPECT_NEAR(a.margin_m, b.margin_m, kSame);
  EXPECT_NEAR(a.finger_depth_m, b.finger_depth_m, kSame);
  EXPECT_NEAR(a.pad_clearance_m, b.pad_clearance_m, kSame);
}

void expectSame(const PlacementSource& a, const PlacementSource& b) {
  EXPECT_LT((a.min_m - b.min_m).norm(), kSame);
  EXPECT_LT((a.max_m - b.max_m).norm(), kSame);
  EXPECT_EQ(a.upright, b.upright);
  EXPECT_NEAR(a.yaw_min_rad, b.yaw_min_rad, kSame);
  EXPECT_NEAR(a.yaw_max_rad, b.yaw_max_rad, kSame);
}

TEST(SceneFamilies, ShippedScenesAreTheStandardInstances) {
  const TemporaryFolder folder;
  for (const SceneFamily& family : pickPlaceFamilies()) {
    SCOPED_TRACE(family.name);
    const Scene shipped = loadScene(family.name);
    const Scene standard = loaded(folder, generated(family.name, {}));
    EXPECT_EQ(standard.name, shipped.name);
    EXPECT_EQ(standard.robot.file, shipped.robot.file);
    EXPECT_EQ(standard.pickPlace().object_name, shipped.pickPlace().object_name);
    EXPECT_EQ(standard.edge_step_m, shipped.edge_step_m);
    EXPECT_EQ(standard.pickPlace().contact_clearance_m, shipped.pickPlace().contact_clearance_m);
    EXPECT_EQ(standard.budget_s, shipped.budget_s);
    ASSERT_EQ(standard.obstacles.size(), shipped.obstacles.size());
    for (std::size_t i = 0; i < shipped.obstacles.size(); ++i)
      expectSame(standard.obstacles[i].shape, shipped.obstacles[i].shape, shipped.obstacles[i].name);
    ASSERT_EQ(standard.pickPlace().object.size(), shipped.pickPlace().object.size());
    for (std::size_t i = 0; i < shipped.pickPlace().object.size(); ++i)
      expectSame(standard.pickPlace().object[i], shipped.pickPlace().object[i],
                 "piece " + std::to_string(i) + " of the object");
    EXPECT_LT((standard.pickPlace().X_WO_start.matrix() - shipped.pickPlace().X_WO_start.matrix())
                  .cwiseAbs()
                  .maxCoeff(),
              kSame);
    expectSame(standard.pickPlace().grasps, shipped.pickPlace().grasps);
    expectSame(standard.pickPlace().placement, shipped.pickPlace().placement);
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
  for (const SceneFamily& family : pickPlaceFamilies())
    for (std::uint64_t seed = 1; seed <= 5; ++seed) {
      const Scene scene = loaded(folder, generated(family.name, seeded(seed)));
      EXPECT_EQ(scene.name, family.name + "_" + std::to_string(seed));
      EXPECT_NO_THROW(preflight(scene)) << scene.name;
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
  for (const SceneFamily& family : pickPlaceFamilies())
    for (const FamilyParameter& p : family.parameters)
      for (const double value : {p.low, p.high}) {
        const std::string text = generated(family.name, with(p.name, value));
        EXPECT_NO_THROW(loaded(folder, text)) << family.name << " " << p.name << " " << value;
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
