// SPDX-License-Identifier: BSD-3-Clause
// Scenes that nobody can solve are found before planning, with the reason; sound ones pass.
#include "experiments/preflight.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "experiments/fixtures.h"
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

TEST(Preflight, CountsThePicksThatASceneStates) {
  const Scene maze = loadScene("maze");
  const PickSurvey survey = surveyPicks(maze, 0, 1);
  EXPECT_EQ(survey.drawn, maze.numbers.grasps_sampled);
  EXPECT_EQ(survey.valid, maze.numbers.grasps_valid_at_pick);
  const Scene grocery = loadScene("grocery");
  const PickSurvey drawn = surveyPicks(grocery, grocery.numbers.grasps_sampled, 1);
  EXPECT_NEAR(drawn.valid, grocery.numbers.grasps_valid_at_pick, 0.15 * grocery.numbers.grasps_sampled);
}

}  // namespace
}  // namespace b4p::test
