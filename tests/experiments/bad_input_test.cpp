// SPDX-License-Identifier: BSD-3-Clause
// Bad input ends the command with exit code 2 and one line on stderr that names the culprit; nothing is left
// behind.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "experiments/fixtures.h"

namespace b4p::test {
namespace {

using ::testing::HasSubstr;

void expectRefused(const std::string& arguments, const std::string& culprit) {
  const CommandRun run = runB4p(arguments);
  EXPECT_EQ(run.exit_code, 2) << arguments << "\n" << run.out << run.err;
  EXPECT_EQ(run.errorLines(), 1) << run.err;
  EXPECT_THAT(run.err, HasSubstr(culprit));
  EXPECT_EQ(run.out, "");
}

/// Planning with a changed copy of the test scene is refused, and leaves no file.
void expectSceneRefused(const std::vector<SceneCopy::Change>& changes, const std::string& file,
                        const std::string& culprit) {
  const SceneCopy copy(changes, file);
  const auto before = copy.folder().files();
  expectRefused("plan " + copy.scene() + " --time-limit-s 5 --out " + copy.folder() / "r.json", culprit);
  EXPECT_EQ(copy.folder().files(), before);
}

TEST(BadInput, UnchangedCopyOfTheSceneIsSolved) {
  const SceneCopy copy;
  const CommandRun run = runB4p("plan " + copy.scene() + " --out " + copy.folder() / "r.json");
  EXPECT_EQ(run.exit_code, 0) << run.err;
}

TEST(BadInput, MissingScene) { expectRefused("plan /nowhere/scene.yaml", "/nowhere/scene.yaml"); }
TEST(BadInput, UnknownSceneName) { expectRefused("plan atlantis", "atlantis"); }

TEST(BadInput, MalformedYaml) { expectSceneRefused({{"schema: 1", "schema: [1"}}, "easy.yaml", "malformed"); }
TEST(BadInput, UnknownKey) {
  expectSceneRefused({{"budget_s: 10", "budget_s: 10\nbudget_m: 1"}}, "easy.yaml", "budget_m");
}
TEST(BadInput, DuplicateKey) {
  expectSceneRefused({{"budget_s: 10", "budget_s: 10\nbudget_s: 11"}}, "easy.yaml", "budget_s");
}
TEST(BadInput, MissingKey) { expectSceneRefused({{"budget_s: 10\n", ""}}, "easy.yaml", "budget_s"); }
TEST(BadInput, WrongSchemaVersion) {
  expectSceneRefused({{"schema: 1", "schema: 2"}}, "easy.yaml", "schema");
}
TEST(BadInput, NonFiniteNumber) {
  expectSceneRefused({{"position_m: [0.3, 0, 0]", "position_m: [.nan, 0, 0]"}}, "easy.yaml", "position_m");
}
TEST(BadInput, ClearanceThatLetsTheObjectTouch) {
  expectSceneRefused({{"contact_clearance_m: 0.01", "contact_clearance_m: 0.009"}}, "easy.yaml",
                     "contact_clearance_m");
}
TEST(BadInput, ClearanceThatTheStartPoseDoesNotHave) {
  expectSceneRefused({{"contact_clearance_m: 0.01", "contact_clearance_m: 0.6"}}, "easy.yaml",
                     "contact_clearance_m");
}
TEST(BadInput, AbsurdSizes) {
  expectSceneRefused({{"edge_step_m: 0.02", "edge_step_m: 1e-300"}}, "easy.yaml", "edge_step_m");
  expectSceneRefused({{"edge_step_m: 0.02", "edge_step_m: 0.51"}}, "easy.yaml", "edge_step_m");
  expectSceneRefused({{"position_m: [1.0, -0.6, 0]", "position_m: [1e9, -0.6, 0]"}}, "easy.yaml",
                     "position_m");
  expectSceneRefused({{"size_m: [0.1, 1.2, 0.1]", "size_m: [0.1, 1200, 0.1]"}}, "easy.yaml", "size_m");
  expectSceneRefused({{"box: {size_m: [0.1, 1.2, 0.1]}", "sphere: {radius_m: 1e4}"}}, "easy.yaml",
                     "radius_m");
  expectSceneRefused({{"max_m: [1.8, 0.3, 0]}", "max_m: [-1e5, 0.3, 0]}"}}, "easy.yaml", "max_m");
  expectSceneRefused({{"max_m: [1.8, 0.3, 0]}", "max_m: [1.8, 0.3, 0]}\n  yaw_rad: [-4, 4]"}}, "easy.yaml",
                     "yaw_rad");
}
TEST(BadInput, UnknownRobot) {
  expectSceneRefused({{"robot: planar.yaml", "robot: r2d2"}}, "easy.yaml", "r2d2");
}
TEST(BadInput, UnknownLinkInRobotFile) {
  expectSceneRefused({{"tcp_link: tcp", "tcp_link: tool"}}, "planar.yaml", "tool");
}
TEST(BadInput, MissingMeshOfAnObstacle) {
  expectSceneRefused({{"box: {size_m: [0.1, 1.2, 0.1]}", "mesh: {file: gone.stl, convex_hull: true}"}},
                     "easy.yaml", "gone.stl");
}

TEST(BadInput, UrdfWithNanSize) {
  expectSceneRefused({{"size=\"0.2 0.2 0.1\"", "size=\"nan 0.2 0.1\""}}, "planar.urdf", "body");
}
TEST(BadInput, UrdfWithMissingMesh) {
  expectSceneRefused({{"<box size=\"0.2 0.2 0.1\"/>", "<mesh filename=\"gone.stl\"/>"}}, "planar.urdf",
                     "gone.stl");
}
TEST(BadInput, UrdfWithReversedLimits) {
  expectSceneRefused({{"lower=\"-3.2\" upper=\"3.2\"", "lower=\"3.2\" upper=\"-3.2\""}}, "planar.urdf",
                     "turn");
}
TEST(BadInput, UrdfWithZeroAxis) {
  expectSceneRefused({{"axis xyz=\"0 0 1\"", "axis xyz=\"0 0 0\""}}, "planar.urdf", "turn");
}
TEST(BadInput, MissingUrdf) {
  expectSceneRefused({{"urdf: planar.urdf", "urdf: gone.urdf"}}, "planar.yaml", "gone.urdf");
}

TEST(BadInput, StartPoseInCollision) {
  expectSceneRefused({{"start: {position_m: [0.3, 0, 0]}", "start: {position_m: [0.9, -0.5, 0]}"}},
                     "easy.yaml", "wall");
}
TEST(BadInput, NoValidGrasp) {
  // The square stands in a cage that no gripper gets into.
  expectSceneRefused({{"obstacles:\n",
                       "obstacles:\n"
                       "  - {name: north, box: {size_m: [0.4, 0.02, 0.1]}, position_m: [0.3, 0.13, 0]}\n"
                       "  - {name: south, box: {size_m: [0.4, 0.02, 0.1]}, position_m: [0.3, -0.13, 0]}\n"
                       "  - {name: left, box: {size_m: [0.02, 0.4, 0.1]}, position_m: [0.17, 0, 0]}\n"
                       "  - {name: right, box: {size_m: [0.02, 0.4, 0.1]}, position_m: [0.43, 0, 0]}\n"}},
                     "easy.yaml", "grasps");
}
TEST(BadInput, UnreachableRegion) {
  expectSceneRefused({{"min_m: [1.6, -0.3, 0], max_m: [1.8, 0.3, 0]", "min_m: [6, 0, 0], max_m: [7, 0, 0]"}},
                     "easy.yaml", "placement.region");
}

TEST(BadInput, InstancesThatNoFamilyHas) {
  const TemporaryFolder folder;
  const std::string out = " --out " + folder / "scene.yaml";
  for (const auto& [arguments, culprit] : std::vector<std::pair<std::string, std::string>>{
           {"generate" + out, "FAMILY"},
           {"generate stick", "--out"},
           {"generate labyrinth" + out, "maze, stick, grocery"},
           {"generate stick --set gap_width_m=9" + out, "gap_width_m: has to be from 0.075 to 0.3"},
           {"generate stick --set gap_width_m=wide" + out, "gap_width_m"},
           {"generate stick --set gap_width_m=0.1 --set gap_width_m=0.2" + out, "gap_width_m"},
           {"generate stick --set gap=1" + out, "gap"},
           {"generate stick --set 0.1" + out, "--set"},
           {"generate stick --difficulty 2" + out, "--difficulty"},
           {"generate stick --name 'a stick'" + out, "--name"},
           {"generate stick --seed -1" + out, "--seed"},
           {"generate stick --out /nowhere/scene.yaml", "/nowhere/scene.yaml"}}) {
    const CommandRun run = runB4p(arguments);
    EXPECT_EQ(run.exit_code, 2) << arguments;
    EXPECT_EQ(run.errorLines(), 1) << run.err;
    EXPECT_THAT(run.err, HasSubstr(culprit));
    EXPECT_TRUE(folder.files().empty()) << arguments;
  }
}

TEST(BadInput, OptionsOutOfRange) {
  const SceneCopy copy;
  const auto before = copy.folder().files();
  const std::string plan = "plan " + copy.scene() + " --out " + copy.folder() / "r.json ";
  for (const auto& [option, culprit] :
       std::vector<std::pair<std::string, std::string>>{{"--threads 0", "threads"},
                                                        {"--threads -2", "threads"},
                                                        {"--threads 1000", "threads"},
                                                        {"--threads two", "two"},
                                                        {"--time-limit-s 0", "time-limit-s"},
                                                        {"--time-limit-s -1", "time-limit-s"},
                                                        {"--time-limit-s nan", "time-limit-s"},
                                                        {"--time-limit-s inf", "time-limit-s"},
                                                        {"--seed -1", "seed"},
                                                        {"--seed 99999999999999999999999", "seed"},
                                                        {"--seed 1x", "seed"},
                                                        {"--seed 1.5", "seed"},
                                                        {"--planner b4p-paper --param paper=0", "paper"},
                                                        {"--planner teleport", "teleport"},
                                                        {"--checker slow", "--checker"},
                                                        {"--param slices=3", "slices"},
                                                        {"--param slice=0", "slice"},
                                                        {"--param slice=-1", "slice"},
                                                        {"--param slice=3x", "slice"},
                                                        {"--param range=nan", "range"},
                                                        {"--param slice", "--param"},
                                                        {"--planner rrtconnect --threads 2", "threads"},
                                                        {"--no-such-option", "--no-such-option"}})
    expectRefused(plan + option, culprit);
  EXPECT_EQ(copy.folder().files(), before);
}

TEST(BadInput, NoCommandAtAll) { expectRefused("", "subcommand"); }

TEST(BadInput, OutputThatCannotBeWrittenIsFoundBeforePlanning) {
  const SceneCopy copy;
  // Not even root can make a folder under a file.
  const std::string nowhere = copy.scene() + "/below";
  expectRefused("plan " + copy.scene() + " --out " + nowhere, nowhere);
  expectRefused("plan " + copy.scene() + " --out " + copy.folder() / "r.json --forests " + nowhere, nowhere);
  EXPECT_FALSE(std::filesystem::exists(copy.folder() / "r.json"));
}

TEST(BadInput, ResultFileCutInHalf) {
  const SceneCopy copy;
  const std::string file = copy.folder() / "r.json";
  ASSERT_EQ(runB4p("plan " + copy.scene() + " --out " + file).exit_code, 0);
  const std::string whole = readFile(file);
  writeText(file, whole.substr(0, whole.size() / 2));
  expectRefused("verify " + file, file);
}

TEST(BadInput, MissingResultFile) { expectRefused("verify /nowhere/r.json", "/nowhere/r.json"); }

class BadExperiment : public ::testing::Test {
 protected:
  /// @param changes  to a sound experiment file
  void expectRefusedWith(const std::vector<SceneCopy::Change>& changes, const std::string& culprit) {
    std::string text =
        "schema: 1\nname: quick\nruns: 2\ntime_limit_s: 5\nthreads: 1\nseed: 1\nscenes: [easy.yaml]\n"
        "planners:\n  - {label: first, planner: b4p, parameters: {slice: 10}}\n";
    for (const auto& [from, to] : changes) text = replaced(text, from, to);
    writeText(copy_.folder() / "experiment.yaml", text);
    const auto before = copy_.folder().files();
    expectRefused("bench " + copy_.folder() / "experiment.yaml --out " + out(), culprit);
    EXPECT_EQ(copy_.folder().files(), before);
    EXPECT_FALSE(std::filesystem::exists(copy_.folder() / "out"));
  }

  std::string out() const { return copy_.folder() / "out"; }

  SceneCopy copy_;
};

TEST_F(BadExperiment, NamesTheKey) {
  expectRefusedWith({{"runs: 2", "runs: 0"}}, "runs");
  expectRefusedWith({{"time_limit_s: 5", "time_limit_s: -5"}}, "time_limit_s");
  expectRefusedWith({{"time_limit_s: 5", "time_limit_s: .nan"}}, "time_limit_s");
  expectRefusedWith({{"threads: 1", "threads: 0"}}, "threads");
  expectRefusedWith({{"seed: 1", "seed: 1\nchecker: slow"}}, "slow");
  expectRefusedWith({{"schema: 1", "schema: 7"}}, "schema");
  expectRefusedWith({{"seed: 1", "seeds: 1"}}, "seed");
  expectRefusedWith({{"planner: b4p", "planner: b5p"}}, "b5p");
  expectRefusedWith({{"slice: 10", "slice: 0"}}, "slice");
  expectRefusedWith({{"label: first", "label: has-dash"}}, "has-dash");
  expectRefusedWith({{"[easy.yaml]", "[gone.yaml]"}}, "gone.yaml");
  expectRefusedWith({{"[easy.yaml]", "[]"}}, "scenes");
}

TEST_F(BadExperiment, NamesTheOption) {
  const std::string file = copy_.folder() / "e.yaml";
  writeText(file,
            "schema: 1\nname: quick\nruns: 2\ntime_limit_s: 5\nthreads: 1\nseed: 1\nscenes: [easy.yaml]\n"
            "planners:\n  - {label: first, planner: b4p}\n");
  for (const char* option : {"--runs 0", "--seed 1e3", "--threads 65", "--threads 1,1", "--threads 1,two",
                             "--scenes mars", "--checker slow", "--time-limit-s -1", "--resume --overwrite"})
    expectRefused("bench " + file + " --out " + out() + " " + option,
                  option == std::string("--scenes mars")
                      ? "mars"
                      : std::string(option).substr(0, std::string(option).find(' ')));
  EXPECT_FALSE(std::filesystem::exists(out()));
}

TEST_F(BadExperiment, ResumedWithOtherSettings) {
  const std::string file = copy_.folder() / "e.yaml";
  writeText(file,
            "schema: 1\nname: quick\nruns: 1\ntime_limit_s: 5\nthreads: 1\nseed: 1\nscenes: [easy.yaml]\n"
            "planners:\n  - {label: first, planner: b4p}\n");
  const std::string bench = "bench " + file + " --out " + out();
  ASSERT_EQ(runB4p(bench + " --resume").exit_code, 0);
  const auto before = copy_.folder().files();
  expectRefused(bench, "--resume");
  expectRefused(bench + " --resume --seed 2", "seed");
  expectRefused(bench + " --resume --time-limit-s 4", "time_limit_s");
  EXPECT_EQ(copy_.folder().files(), before);
  EXPECT_EQ(runB4p(bench + " --resume --runs 2").exit_code, 0);
}

TEST_F(BadExperiment, FolderThatCannotBeMade) {
  writeText(copy_.folder() / "e.yaml",
            "schema: 1\nname: quick\nruns: 2\ntime_limit_s: 5\nthreads: 1\nseed: 1\nscenes: [easy.yaml]\n"
            "planners:\n  - {label: first, planner: b4p}\n");
  const std::string under_a_file = copy_.scene() + "/below";
  expectRefused("bench " + copy_.folder() / "e.yaml --out " + under_a_file, under_a_file);
  expectRefused("bench " + copy_.folder() / "e.yaml --out /proc/b4p", "/proc/b4p");
}

}  // namespace
}  // namespace b4p::test
