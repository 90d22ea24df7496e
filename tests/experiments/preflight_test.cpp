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
  for (const std::string& name : sceneNames()) EXPECT_NO_THROW(preflight(loadScene(name))) << name;
}

TEST(Preflight, SaysWhyNoGraspIsValid) {
  Scene scene = loadScene("grocery");
  // The can moves far away from the robot.
  scene.X_WO_start.translation().x() = 5.0;
  try {
    preflight(scene);
    FAIL() << "accepted";
  } catch (const InputError& e) {
    EXPECT_THAT(e.what(), AllOf(HasSubstr("400 grasps"), HasSubstr("no inverse kinematics")));
  }
}

TEST(Preflight, SaysWhatTheObjectTouches) {
  Scene scene = loadScene("grocery");
  scene.X_WO_start.translation().z() -= 0.002;  // closer to the post than the margin
  try {
    preflight(scene);
    FAIL() << "accepted";
  } catch (const InputError& e) {
    EXPECT_THAT(e.what(), AllOf(HasSubstr("object.start"), HasSubstr("post")));
  }
}

TEST(Preflight, HoldsTheStartPoseToTheStatedClearance) {
  Scene maze = loadScene("maze");
  maze.contact_clearance_m = 0.1;
  EXPECT_NO_THROW(preflight(maze));
  maze.contact_clearance_m = 1.0;  // the room is 1.5 m wide
  try {
    preflight(maze);
    FAIL() << "accepted";
  } catch (const InputError& e) {
    EXPECT_THAT(e.what(), AllOf(HasSubstr("contact_clearance_m"), HasSubstr("held object")));
  }
}

TEST(Preflight, PicksAreAsManyAsTheScenesState) {
  constexpr int kDrawsPerGrasp = 8;
  const Problem maze = makeProblem(loadScene("maze"));
  const auto of_maze = maze.region->makeSceneContext(1);
  int valid = 0;
  double q[3];
  for (GraspId id = 0; id < maze.region->graspCount(); ++id)
    for (int draw = 0; draw < kDrawsPerGrasp; ++draw)
      if (of_maze->pickRoot(id, q)) {
        ++valid;
        break;
      }
  EXPECT_EQ(maze.region->graspCount(), maze.scene.numbers.grasps_sampled);
  EXPECT_EQ(valid, maze.scene.numbers.grasps_valid_at_pick);

  const Problem grocery = makeProblem(loadScene("grocery"));
  const auto of_grocery = grocery.region->makeSceneContext(1);
  const SceneNumbers& numbers = grocery.scene.numbers;
  valid = 0;
  for (int draw = 0; draw < numbers.grasps_sampled; ++draw) {
    Grasp grasp;
    std::string collision;
    if (of_grocery->probePick(grasp, collision) == RootOutcome::kValid) ++valid;
  }
  EXPECT_NEAR(valid, numbers.grasps_valid_at_pick, 0.15 * numbers.grasps_sampled);
}

}  // namespace
}  // namespace b4p::test
