// SPDX-License-Identifier: BSD-3-Clause
// Scene files are read strictly, and mean what they say.
#include "experiments/scene.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "experiments/fixtures.h"
#include "robots/input_error.h"

namespace b4p::test {
namespace {

using ::testing::Contains;
using ::testing::HasSubstr;

std::string refusal(const std::vector<SceneCopy::Change>& changes) {
  const SceneCopy copy(changes);
  try {
    loadScene(copy.scene());
  } catch (const InputError& e) {
    EXPECT_THAT(e.what(), HasSubstr(copy.scene()));
    return e.what();
  }
  return "accepted";
}

TEST(Scene, ReadsAllOfTheFile) {
  const std::vector<SceneCopy::Change> turned{
      {"start: {position_m: [0.3, 0, 0]}",
       "start: {position_m: [0.3, 0, 0], rpy_rad: [0, 0, 1.5707963267948966]}"}};
  const SceneCopy copy(turned);
  const Scene scene = loadScene(copy.scene());
  EXPECT_EQ(scene.name, "easy");
  EXPECT_EQ(scene.robot.urdf_file, copy.folder() / "planar.urdf");
  EXPECT_EQ(scene.robot.description.joints.size(), 3u);
  ASSERT_EQ(scene.obstacles.size(), 2u);
  EXPECT_EQ(scene.obstacles[0].name, "wall");
  EXPECT_TRUE(scene.obstacles[0].shape.X_BS.translation().isApprox(Eigen::Vector3d(1.0, -0.6, 0.0)));
  EXPECT_TRUE(std::get<Box>(scene.obstacles[0].shape.shape).size.isApprox(Eigen::Vector3d(0.1, 1.2, 0.1)));
  EXPECT_TRUE(scene.pickPlace().X_WO_start.linear().col(0).isApprox(Eigen::Vector3d::UnitY(), 1e-12));
  EXPECT_EQ(scene.pickPlace().grasps.family, GraspFamily::kPolygonEdges);
  EXPECT_EQ(scene.pickPlace().grasps.polygon_m.size(), 4u);
  EXPECT_EQ(scene.pickPlace().placement.max_m.x(), 1.8);
  EXPECT_EQ(scene.edge_step_m, 0.02);
}

TEST(Scene, ShippedScenesLoad) {
  EXPECT_THAT(sceneNames(), Contains("maze"));
  EXPECT_THAT(sceneNames(), Contains("stick"));
  EXPECT_THAT(sceneNames(), Contains("grocery"));
  EXPECT_THAT(sceneNames(), Contains("table/above_1"));
  for (std::string name : sceneNames()) {
    const Scene scene = loadScene(name);
    std::replace(name.begin(), name.end(), '/', '_');
    EXPECT_EQ(scene.name, name);
  }
}

TEST(Scene, RefusesShapesThatAreNone) {
  EXPECT_THAT(refusal({{"box: {size_m: [0.1, 1.2, 0.1]}", "box: {size_m: [0.1, 1.2]}"}}),
              HasSubstr("obstacles[0].box.size_m"));
  EXPECT_THAT(refusal({{"box: {size_m: [0.1, 1.2, 0.1]}", "box: {size_m: [0.1, -1.2, 0.1]}"}}),
              HasSubstr("size_m"));
  EXPECT_THAT(refusal({{"box: {size_m: [0.1, 1.2, 0.1]}", "cube: {size_m: [0.1, 1.2, 0.1]}"}}),
              HasSubstr("cube"));
  EXPECT_THAT(refusal({{"wall, box: {size_m: [0.1, 1.2, 0.1]}", "wall"}}), HasSubstr("no shape"));
  EXPECT_THAT(refusal({{"name: west", "name: wall"}}), HasSubstr("wall"));
}

TEST(Scene, RefusesPolygonsThatAreNotSimpleAndCounterClockwise) {
  const std::string polygon = "[[-0.1, -0.1], [0.1, -0.1], [0.1, 0.1], [-0.1, 0.1]]";
  EXPECT_THAT(refusal({{polygon, "[[-0.1, -0.1], [-0.1, 0.1], [0.1, 0.1], [0.1, -0.1]]"}}),
              HasSubstr("counter-clockwise"));
  EXPECT_THAT(refusal({{polygon, "[[-0.1, -0.1], [0.1, 0.1], [0.1, -0.1], [-0.1, 0.1]]"}}),
              HasSubstr("cross"));
  EXPECT_THAT(refusal({{polygon, "[[-0.1, -0.1], [0.1, -0.1]]"}}), HasSubstr("corners"));
}

TEST(Scene, ReadsGraspsOfAStickAndRefusesThoseThatCannotBe) {
  const std::string edges =
      "polygon_edges: {polygon_m: [[-0.1, -0.1], [0.1, -0.1], [0.1, 0.1], [-0.1, 0.1]], clearance_m: 0.03}";
  const auto stick = [](const std::string& changed_from, const std::string& changed_to) {
    return replaced(
        "stick: {length_m: 0.6, radius_m: 0.01, margin_m: 0.05, finger_depth_m: 0.012, pad_clearance_m: 0}",
        changed_from, changed_to);
  };
  // The test's robot has no fingers to hold a stick with.
  EXPECT_THAT(refusal({{edges, stick("stick", "stick")}}), HasSubstr("stick.radius_m"));
  EXPECT_THAT(refusal({{edges, stick("margin_m: 0.05", "margin_m: 0.4")}}), HasSubstr("stick.margin_m"));
  EXPECT_THAT(refusal({{edges, stick("0.012", "0.03")}}), HasSubstr("stick.finger_depth_m"));
  EXPECT_THAT(refusal({{edges, stick("length_m: 0.6", "length_m: 0")}}), HasSubstr("stick.length_m"));
  EXPECT_THAT(refusal({{edges, stick("length_m", "long_m")}}), HasSubstr("long_m"));
  EXPECT_THAT(refusal({{edges, edges + "\n  " + stick("stick", "stick")}}), HasSubstr("exactly one"));
  const GraspSource grasps = loadScene("stick").pickPlace().grasps;
  EXPECT_EQ(grasps.family, GraspFamily::kStick);
  EXPECT_EQ(grasps.stick_length_m, 0.6);
  EXPECT_EQ(grasps.stick_radius_m, 0.0125);
  EXPECT_EQ(grasps.margin_m, 0.06);
}

TEST(Scene, RefusesRegionsStepsAndNamesThatAreNone) {
  EXPECT_THAT(refusal({{"max_m: [1.8, 0.3, 0]", "max_m: [1.5, 0.3, 0]"}}), HasSubstr("max_m"));
  EXPECT_THAT(refusal({{"edge_step_m: 0.02", "edge_step_m: 0"}}), HasSubstr("edge_step_m"));
  EXPECT_THAT(refusal({{"name: easy", "name: rather easy"}}), HasSubstr("name"));
}

}  // namespace
}  // namespace b4p::test
