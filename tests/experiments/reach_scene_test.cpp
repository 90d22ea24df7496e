// SPDX-License-Identifier: BSD-3-Clause
// Scenes of reaching tasks are read strictly, and mean what they say.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "experiments/fixtures.h"
#include "experiments/scene.h"
#include "robots/input_error.h"

namespace b4p::test {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

constexpr const char* kScene = R"(schema: 1
name: reaching
robot: panda
robot_base: {position_m: [0, 0, 1], rpy_rad: [0, 0, 1.5707963267948966]}
edge_step_m: 0.01
budget_s: 2
obstacles:
  - {name: table, box: {size_m: [1, 1, 0.1]}, position_m: [0.9, 0, 0.2]}
reach:
  start: [0, -0.76, 0, -2.34, 0, 1.54, 0.75]
  grasps: {file: reaching.grasps.csv}
  tolerance: {position_m: 0.002, angle_rad: 0.01, flip: false}
)";
constexpr const char* kPoses =
    "1, 0, 0, 0.5, 0, -1, 0, 0.25, 0, 0, -1, 0.125, 0, 0, 0, 1\n"
    "0,1,0,0.5,1,0,0,-2.5e-1,0,0,-1,0.125,0,0,0,1\r\n";

class ReachScene : public ::testing::Test {
 protected:
  ReachScene() { writeText(folder_ / "reaching.grasps.csv", kPoses); }

  Scene load(const std::string& text) {
    writeText(file_, text);
    return loadScene(file_);
  }
  std::string refusal(const std::string& text, const std::string& file) {
    try {
      load(text);
    } catch (const InputError& e) {
      EXPECT_EQ(std::string(e.what()).rfind(file + ": ", 0), 0u) << e.what();
      EXPECT_EQ(std::string(e.what()).find('\n'), std::string::npos) << e.what();
      return e.what();
    }
    return "accepted";
  }
  std::string refusal(const std::string& from, const std::string& to, const std::string& file) {
    return refusal(replaced(kScene, from, to), file);
  }
  std::string graspRefusal(const std::string& poses) {
    writeText(folder_ / "reaching.grasps.csv", poses);
    return refusal(kScene, folder_ / "reaching.grasps.csv");
  }

  TemporaryFolder folder_;
  std::string file_ = folder_ / "reaching.yaml";
};

TEST_F(ReachScene, PosesAreInTheFrameOfTheRobotsRootAndComeOutInTheWorld) {
  const Scene scene = load(kScene);
  const auto& task = std::get<ReachTask>(scene.task);
  EXPECT_EQ(task.start, (std::vector<double>{0, -0.76, 0, -2.34, 0, 1.54, 0.75}));
  ASSERT_EQ(task.X_WT.size(), 2u);
  // The base is turned by a quarter: its x is the world's y.
  EXPECT_TRUE(task.X_WT[0].translation().isApprox(Eigen::Vector3d(-0.25, 0.5, 1.125), 1e-12));
  EXPECT_TRUE(task.X_WT[0].linear().col(0).isApprox(Eigen::Vector3d::UnitY(), 1e-12));
  EXPECT_TRUE(task.X_WT[1].linear().col(1).isApprox(Eigen::Vector3d::UnitY(), 1e-12));
  EXPECT_TRUE(task.X_WT[1].linear().col(2).isApprox(-Eigen::Vector3d::UnitZ(), 1e-12));
  EXPECT_FALSE(task.orientation_free);
  EXPECT_EQ(task.grasp_file, folder_ / "reaching.grasps.csv");
  EXPECT_EQ(task.position_tolerance_m, 0.002);
  EXPECT_EQ(task.angle_tolerance_rad, 0.01);
  EXPECT_FALSE(task.flip);
}

TEST_F(ReachScene, PositionsAreInTheWorldWithATolerance) {
  const std::string grasps = "grasps: {file: reaching.grasps.csv}";
  const std::string tolerance = "  tolerance: {position_m: 0.002, angle_rad: 0.01, flip: false}\n";
  const std::string positions = replaced(kScene, grasps, "positions_m: [[0.7, 0, 0.6], [0.7, 0.3, 0.6]]");
  const Scene scene = load(replaced(positions, tolerance, ""));
  const auto& task = std::get<ReachTask>(scene.task);
  EXPECT_TRUE(task.orientation_free);
  ASSERT_EQ(task.X_WT.size(), 2u);
  EXPECT_EQ(task.X_WT[1].translation(), Eigen::Vector3d(0.7, 0.3, 0.6));
  EXPECT_EQ(task.position_tolerance_m, 0.05);
  EXPECT_THAT(refusal(positions, file_), HasSubstr("reach.tolerance.angle_rad"));
  EXPECT_THAT(refusal(grasps, "positions_m: []", file_), HasSubstr("reach.positions_m (line 11): is empty"));
  EXPECT_THAT(refusal(grasps, "positions_m: [[0, 0]]", file_), HasSubstr("reach.positions_m[0]"));
  EXPECT_THAT(refusal(grasps, "positions_m: [[0, 0, .nan]]", file_), HasSubstr("not finite"));
}

TEST_F(ReachScene, RefusesWhatIsNoReachingTask) {
  EXPECT_THAT(refusal("start: [0, ", "start: [", file_), HasSubstr("does not have 7 numbers"));
  EXPECT_THAT(refusal("[0, -0.76", "[0, low", file_), AllOf(HasSubstr("reach.start[1]"), HasSubstr("low")));
  EXPECT_THAT(refusal("[0, -0.76", "[0, .inf", file_), HasSubstr("not finite"));
  EXPECT_THAT(refusal("  grasps: {", "  poses: {", file_), HasSubstr("reach.poses"));
  EXPECT_THAT(refusal("file: reaching", "files: reaching", file_), HasSubstr("files"));
  EXPECT_THAT(refusal("  grasps: {file: reaching.grasps.csv}\n", "", file_), HasSubstr("exactly one"));
  EXPECT_THAT(refusal("  grasps", "  positions_m: [[0, 0, 0]]\n  grasps", file_), HasSubstr("exactly one"));
  EXPECT_THAT(refusal("position_m: 0.002", "position_m: 0", file_), HasSubstr("tolerance.position_m"));
  EXPECT_THAT(refusal("angle_rad: 0.01", "angle_rad: -1", file_), HasSubstr("tolerance.angle_rad"));
  EXPECT_THAT(refusal("flip: false", "flip: perhaps", file_), HasSubstr("tolerance.flip"));
  EXPECT_THAT(refusal("flip: false", "flipped: false", file_), HasSubstr("flipped"));
  EXPECT_THAT(refusal("budget_s: 2", "budget_s: 2\nobject: {name: can}", file_), HasSubstr("object"));
  EXPECT_THAT(refusal("reaching.grasps.csv", "none.csv", folder_ / "none.csv"), HasSubstr("no such file"));
}

TEST_F(ReachScene, RefusesGraspsThatAreNoPosesNamingRowAndValue) {
  const auto with = [this](const std::string& from, const std::string& to) {
    return graspRefusal(replaced(kPoses, from, to));
  };
  EXPECT_THAT(with("0,1,0,0.5,1,", "0,1,0,0.5,1.001,"), HasSubstr("row 2: has a rotation that is not ortho"));
  EXPECT_THAT(with("0,1,0,0.5,1,", "0,1,0,0.5,-1,"), HasSubstr("row 2: has a rotation that is a reflection"));
  EXPECT_THAT(with("-2.5e-1", "nan"), HasSubstr("row 2: column 8 is not finite (nan)"));
  EXPECT_THAT(with("-2.5e-1", "left"), HasSubstr("row 2: column 8 is not a number (left)"));
  EXPECT_THAT(with("-2.5e-1", "0.2 5"), HasSubstr("row 2: column 8 is not a number (0.2 5)"));
  EXPECT_THAT(with("-2.5e-1", ""), HasSubstr("row 2: column 8 is not a number ()"));
  EXPECT_THAT(with("-2.5e-1,", ""), HasSubstr("row 2: has 15 columns"));
  EXPECT_THAT(with("0, 0, 0, 1\n", "0, 0, 0, 1,\n"), HasSubstr("row 1: has 17 columns"));
  EXPECT_THAT(with("0, 0, 0, 1\n", "0, 0, 1, 1\n"),
              HasSubstr("row 1: does not end in 0, 0, 0, 1 (0, 0, 1, 1)"));
  EXPECT_THAT(with("0, 0, 0, 1\n", "0, 0, 0, 1\n\n"), HasSubstr("row 2: has 0 columns"));
  EXPECT_THAT(graspRefusal(""), HasSubstr("holds no grasp"));
}

TEST_F(ReachScene, IsNoTaskOfPickAndPlace) {
  const Scene scene = load(kScene);
  EXPECT_THROW(scene.pickPlace(), InputError);
}

}  // namespace
}  // namespace b4p::test
