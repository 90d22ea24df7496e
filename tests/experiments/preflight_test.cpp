// SPDX-License-Identifier: BSD-3-Clause
// Scenes that nobody can solve are found before planning, with the reason; sound ones pass.
#include "experiments/preflight.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "experiments/fixtures.h"
#include "experiments/problem.h"
#include "robots/input_error.h"

namespace b4p::test {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

TEST(Preflight, LetsSoundScenesPass) {
  EXPECT_NO_THROW(preflight(loadScene(SceneCopy().scene())));
  for (const std::string& name : sceneNames()) {
    const Scene scene = loadScene(name);
    if (scene.kind() == TaskKind::kPlacement) continue;
    EXPECT_NO_THROW(preflight(scene)) << name;
  }
}

TEST(Preflight, SaysWhyNoGraspIsValid) {
  Scene scene = loadScene("grocery");
  // The can moves far away from the robot.
  scene.pickPlace().X_WO_start.translation().x() = 5.0;
  try {
    preflight(scene);
    FAIL() << "accepted";
  } catch (const InputError& e) {
    EXPECT_THAT(e.what(), AllOf(HasSubstr("400 grasps"), HasSubstr("no inverse kinematics")));
  }
}

TEST(Preflight, SaysWhatTheObjectTouches) {
  Scene scene = loadScene("grocery");
  scene.pickPlace().X_WO_start.translation().z() -= 0.002;  // closer to the post than the margin
  try {
    preflight(scene);
    FAIL() << "accepted";
  } catch (const InputError& e) {
    EXPECT_THAT(e.what(), AllOf(HasSubstr("object.start"), HasSubstr("post")));
  }
}

TEST(Preflight, HoldsTheStartPoseToTheStatedClearance) {
  Scene maze = loadScene("maze");
  maze.pickPlace().contact_clearance_m = 0.1;
  EXPECT_NO_THROW(preflight(maze));
  maze.pickPlace().contact_clearance_m = 1.0;  // the room is 1.5 m wide
  try {
    preflight(maze);
    FAIL() << "accepted";
  } catch (const InputError& e) {
    EXPECT_THAT(e.what(), AllOf(HasSubstr("contact_clearance_m"), HasSubstr("held object")));
  }
}

}  // namespace
}  // namespace b4p::test
