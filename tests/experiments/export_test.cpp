// SPDX-License-Identifier: BSD-3-Clause
// What `b4p export` writes is enough to plan with, by itself, and true.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <sstream>

#include "experiments/fixtures.h"
#include "experiments/json_value.h"
#include "experiments/verification/kinematics.h"

namespace b4p::test {
namespace {

using ::testing::HasSubstr;

std::vector<Json> linesOf(const std::string& file) {
  std::vector<Json> lines;
  std::istringstream text(readFile(file));
  for (std::string line; std::getline(text, line);) lines.push_back(Json::parse(line));
  return lines;
}

Eigen::Isometry3d poseIn(const Json& pose) {
  Eigen::Isometry3d X = Eigen::Isometry3d::Identity();
  for (int i = 0; i < 3; ++i) {
    X.translation()[i] = pose["position_m"][i];
    for (int j = 0; j < 3; ++j) X.linear()(i, j) = pose["rotation"][i][j];
  }
  return X;
}

/// The robot of a line, from the line and the URDF that it names alone.
verification::Kinematics robotIn(const Json& line) {
  const Json& robot = line["robot"];
  ManipulatorDescription description;
  for (const Json& joint : robot["joints"]) description.joints.push_back(joint["name"]);
  description.tcp_link = robot["tcp_link"];
  description.finger_joints = robot["finger_joints"].get<std::vector<std::string>>();
  description.rest = robot["rest"].get<std::map<std::string, double>>();
  return verification::Kinematics(robot["urdf_file"], description, poseIn(robot["X_WB"]));
}

void expectRootsHoldTheObject(const Json& line, const std::string& roots) {
  const verification::Kinematics robot = robotIn(line);
  for (const Json& root : line[roots]) {
    const Json& grasp = line["grasps"][root["grasp"].get<std::size_t>()];
    const Json& place = root.contains("placement")
                            ? line["X_WO_placements"][root["placement"].get<std::size_t>()]
                            : line["X_WO_start"];
    const auto q = root["q"].get<std::vector<double>>();
    ASSERT_EQ(static_cast<int>(q.size()), robot.dof());
    const Eigen::VectorXd configuration = Eigen::Map<const Eigen::VectorXd>(q.data(), robot.dof());
    const auto X_WL = robot.linkPoses(configuration, grasp["opening_m"]);
    const Eigen::Isometry3d X_WT = poseIn(place) * poseIn(grasp["X_OT"]);
    EXPECT_LT((X_WL[robot.tcpLink()].matrix() - X_WT.matrix()).cwiseAbs().maxCoeff(), 1e-4) << root;
  }
}

TEST(Export, TheTcpIsAtTheObjectTimesTheGrasp) {
  const TemporaryFolder folder;
  const CommandRun run =
      runB4p("export maze grocery stick --grasps 60 --placements 6 --out " + (folder / "q.jsonl"));
  ASSERT_EQ(run.exit_code, 0) << run.err;
  const auto lines = linesOf(folder / "q.jsonl");
  ASSERT_EQ(lines.size(), 3u);
  for (const Json& line : lines) {
    EXPECT_EQ(line["schema"], 1);
    EXPECT_EQ(line["grasps"].size(), line["scene"] == "maze" ? 21u : 60u)
        << "finite families are taken whole";
    EXPECT_EQ(line["X_WO_placements"].size(), 6u);
    EXPECT_GT(line["pick_roots"].size(), 0u);
    EXPECT_GT(line["place_roots"].size(), 0u);
    expectRootsHoldTheObject(line, "pick_roots");
    expectRootsHoldTheObject(line, "place_roots");
  }
}

TEST(Export, RootsStayWithinTheLimitsThatTheLineStates) {
  const TemporaryFolder folder;
  ASSERT_EQ(runB4p("export maze grocery --grasps 20 --placements 2 --out " + (folder / "q.jsonl")).exit_code,
            0);
  const auto lines = linesOf(folder / "q.jsonl");
  EXPECT_EQ(lines[0]["robot"]["joints"][0]["type"], "prismatic");
  EXPECT_EQ(lines[1]["robot"]["joints"][0]["type"], "revolute");
  for (const Json& line : lines)
    for (const Json& root : line["pick_roots"])
      for (std::size_t j = 0; j < root["q"].size(); ++j) {
        const Json& joint = line["robot"]["joints"][j];
        const bool slides = joint["type"] == "prismatic";
        EXPECT_GE(root["q"][j].get<double>(), joint[slides ? "lower_m" : "lower_rad"].get<double>());
        EXPECT_LE(root["q"][j].get<double>(), joint[slides ? "upper_m" : "upper_rad"].get<double>());
      }
}

TEST(Export, EveryKindOfShapeIsPlainAndInTheWorld) {
  const std::vector<SceneCopy::Change> standing{
      {"obstacles:\n",
       "obstacles:\n"
       "  - {name: ball, sphere: {radius_m: 0.1}, position_m: [0, 0.9, 1]}\n"
       "  - {name: post, cylinder: {radius_m: 0.1, length_m: 0.3}, position_m: [0, 0.9, 2]}\n"
       "  - {name: pill, capsule: {radius_m: 0.1, length_m: 0.4}, position_m: [0, 0.9, 3]}\n"
       "  - {name: wedge, prism: {polygon_m: [[0, 0], [0.1, 0], [0, 0.1]], height_m: 0.2}, "
       "position_m: [0, 0.9, 4], rpy_rad: [0, 0, 1.5707963267948966]}\n"}};
  const SceneCopy copy(standing);
  const std::string file = copy.folder() / "q.jsonl";
  const CommandRun run = runB4p("export " + copy.scene() + " --placements 1 --out " + file);
  ASSERT_EQ(run.exit_code, 0) << run.err;
  const Json line = linesOf(file).at(0);
  const Json& obstacles = line["obstacles"];
  ASSERT_EQ(obstacles.size(), 6u);
  EXPECT_EQ(obstacles[0]["name"], "ball");
  EXPECT_EQ(obstacles[0]["sphere"]["radius_m"], 0.1);
  EXPECT_EQ(obstacles[1]["cylinder"], (Json{{"radius_m", 0.1}, {"length_m", 0.3}}));
  EXPECT_EQ(obstacles[2]["capsule"], (Json{{"radius_m", 0.1}, {"length_m", 0.4}}));
  EXPECT_EQ(obstacles[3]["hull"]["vertices_m"].size(), 6u);
  EXPECT_EQ(obstacles[4]["box"]["size_m"], Json({0.1, 1.2, 0.1}));
  // A corner of the wedge's triangle, turned by a quarter: (0.1, 0) comes to stand at (0, 0.1).
  const Eigen::Isometry3d X_WS = poseIn(obstacles[3]["X_WS"]);
  double nearest_m = 1.0;
  for (const Json& vertex : obstacles[3]["hull"]["vertices_m"])
    nearest_m = std::min(
        nearest_m,
        (X_WS * Eigen::Vector3d(vertex[0], vertex[1], vertex[2]) - Eigen::Vector3d(0.0, 1.0, 4.1)).norm());
  EXPECT_LT(nearest_m, 1e-9);
  EXPECT_EQ(line["object"]["shapes"][0]["box"]["size_m"], Json({0.2, 0.2, 0.1}));
}

TEST(Export, OneSeedGivesTheSameBytes) {
  const SceneCopy copy;
  const auto bytes = [&copy](int seed) {
    const std::string file = copy.folder() / "q.jsonl";
    EXPECT_EQ(
        runB4p("export " + copy.scene() + " --seed " + std::to_string(seed) + " --out " + file).exit_code, 0);
    return readFile(file);
  };
  const std::string first = bytes(3);
  EXPECT_EQ(first, bytes(3));
  EXPECT_NE(first, bytes(4));
}

TEST(Export, PlaceRootsEndAtTheirLimit) {
  const SceneCopy copy;
  const std::string file = copy.folder() / "q.jsonl";
  ASSERT_EQ(runB4p("export " + copy.scene() + " --place-roots 3 --out " + file).exit_code, 0);
  EXPECT_EQ(linesOf(file).at(0)["place_roots"].size(), 3u);
}

TEST(Export, ReachingTasksStateStartAndTargets) {
  const TemporaryFolder folder;
  const std::string file = folder / "q.jsonl";
  ASSERT_EQ(runB4p("export table/above_1 confined/011 --out " + file).exit_code, 0);
  const auto lines = linesOf(file);
  EXPECT_EQ(lines[0]["task"], "reach");
  EXPECT_EQ(lines[0]["start"].size(), 7u);
  EXPECT_EQ(lines[0]["p_WT_targets_m"].size(), 1u);
  EXPECT_EQ(lines[0]["tolerance"], (Json{{"position_m", 0.05}}));
  EXPECT_GT(lines[1]["X_WT_targets"].size(), 1u);
  EXPECT_TRUE(lines[1]["tolerance"].contains("flip"));
}

void expectRefused(const std::string& arguments, const std::string& culprit) {
  const TemporaryFolder folder;
  const std::string file = folder / "q.jsonl";
  writeText(file, "as it was\n");
  const CommandRun run = runB4p("export " + arguments + " --out " + file);
  EXPECT_EQ(run.exit_code, 2) << arguments << run.err;
  EXPECT_EQ(run.errorLines(), 1) << run.err;
  EXPECT_THAT(run.err, HasSubstr(culprit));
  EXPECT_EQ(run.out, "");
  EXPECT_EQ(readFile(file), "as it was\n");
  EXPECT_EQ(folder.files().size(), 1u);
}

TEST(Export, BadInputLeavesTheFileAsItWas) {
  expectRefused("atlantis", "atlantis");
  expectRefused("maze placement/panda_table_cluttered_wine_glass", "place");
  expectRefused("maze --grasps 0", "--grasps");
  expectRefused("maze --placements many", "--placements");
  expectRefused("maze --place-roots -1", "--place-roots");
  EXPECT_EQ(runB4p("export maze").exit_code, 2) << "where to is missing";
  EXPECT_EQ(runB4p("export maze --out /nowhere/q.jsonl").exit_code, 2);
}

}  // namespace
}  // namespace b4p::test
