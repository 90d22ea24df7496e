// SPDX-License-Identifier: BSD-3-Clause
// Promises: what is written reads back bit for bit; every defect of a file is an InputError that names the
// file and the element; nothing half-written is left behind.
#include "experiments/result.h"

#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <functional>
#include <limits>
#include <sstream>
#include <stdexcept>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "robots/input_error.h"
#include "verification/gantry.h"

namespace b4p {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::StartsWith;

std::string readText(const std::string& file) {
  std::stringstream text;
  text << std::ifstream(file, std::ios::binary).rdbuf();
  return text.str();
}

bool sameBits(double a, double b) { return std::memcmp(&a, &b, sizeof a) == 0; }

bool sameBits(const Eigen::Isometry3d& a, const Eigen::Isometry3d& b) {
  return std::memcmp(a.data(), b.data(), sizeof(double) * 16) == 0;
}

PlanResult awkwardResult() {
  PlanResult result = test::gantryResult();
  result.scene = "h\xC3\xB6lle \"quoted\" \\ \n line";
  result.threads = 8;
  result.planning_time_s = 0.1 + 0.2;
  result.path[1] = {1.0 / 3.0, -0.0, std::numeric_limits<double>::denorm_min(), 1e300,
                    -2.2250738585072014e-308};
  result.grasp.X_OT = Eigen::Translation3d(1.0 / 7, -1e-17, 3) *
                      Eigen::AngleAxisd(1.1, Eigen::Vector3d(1, 2, 3).normalized());
  result.verification = {true, "", 1e-3, 123456789012, 0.0051};
  return result;
}

class ResultTest : public testing::Test {
 protected:
  ~ResultTest() override { fs::remove(file_); }

  void expectRefused(const std::string& text, const std::string& part_of_message) {
    std::ofstream(file_, std::ios::binary) << text;
    try {
      readResult(file_);
      FAIL() << "accepted, expected: " << part_of_message;
    } catch (const InputError& e) {
      EXPECT_THAT(e.what(), StartsWith(file_ + ": "));
      EXPECT_THAT(e.what(), HasSubstr(part_of_message));
      EXPECT_EQ(std::string(e.what()).find('\n'), std::string::npos) << e.what();
    }
  }
  /// The good file with the first `from` replaced.
  std::string with(const std::string& from, const std::string& to) {
    std::string text = good_;
    const std::size_t at = text.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    return text.replace(at, from.size(), to);
  }

  std::string file_ = test::temporaryFile("result.json");
  std::string good_ = (writeResult(file_, test::gantryResult()), readText(file_));
};

TEST_F(ResultTest, AReachedGraspStandsInPlaceOfAHeldOne) {
  PlanResult result = awkwardResult();
  result.X_WT_reached = result.grasp.X_OT;
  writeResult(file_, result);
  const PlanResult read = readResult(file_);
  ASSERT_TRUE(read.X_WT_reached);
  EXPECT_TRUE(sameBits(*read.X_WT_reached, *result.X_WT_reached));
  EXPECT_EQ(read.path, result.path);
  const std::string text = readText(file_);
  EXPECT_EQ(text.find("X_WO_pick"), std::string::npos);
  const auto key = text.find("\"joint_names\"");
  expectRefused(std::string(text).insert(key, "\"X_WO_pick\": null, "), "X_WO_pick");
}

TEST_F(ResultTest, ReadsBackBitForBit) {
  const PlanResult written = awkwardResult();
  writeResult(file_, written);
  const PlanResult read = readResult(file_);
  EXPECT_EQ(read.scene, written.scene);
  EXPECT_EQ(read.planner, written.planner);
  EXPECT_EQ(read.parameters, written.parameters);
  EXPECT_EQ(read.seed, written.seed);
  EXPECT_EQ(read.threads, written.threads);
  EXPECT_TRUE(sameBits(read.time_limit_s, written.time_limit_s));
  EXPECT_TRUE(sameBits(read.planning_time_s, written.planning_time_s));
  EXPECT_EQ(read.status, written.status);
  EXPECT_EQ(read.solved, written.solved);
  EXPECT_EQ(read.grasp_id, written.grasp_id);
  EXPECT_TRUE(sameBits(read.grasp.X_OT, written.grasp.X_OT));
  EXPECT_TRUE(sameBits(read.grasp.opening_m, written.grasp.opening_m));
  EXPECT_TRUE(sameBits(read.X_WO_pick, written.X_WO_pick));
  EXPECT_TRUE(sameBits(read.X_WO_place, written.X_WO_place));
  EXPECT_EQ(read.joint_names, written.joint_names);
  ASSERT_EQ(read.path.size(), written.path.size());
  for (std::size_t i = 0; i < read.path.size(); ++i)
    for (std::size_t j = 0; j < read.path[i].size(); ++j)
      EXPECT_TRUE(sameBits(read.path[i][j], written.path[i][j])) << written.path[i][j];
  EXPECT_EQ(read.verification.passed, written.verification.passed);
  EXPECT_EQ(read.verification.failure, written.verification.failure);
  EXPECT_TRUE(sameBits(read.verification.step_m, written.verification.step_m));
  EXPECT_EQ(read.verification.configurations, written.verification.configurations);
  EXPECT_TRUE(sameBits(read.verification.clearance_m, written.verification.clearance_m));
}

TEST_F(ResultTest, TheSameResultIsWrittenAsTheSameBytes) {
  writeResult(file_, readResult(file_));
  EXPECT_EQ(readText(file_), good_);
}

TEST_F(ResultTest, AnUnsolvedResultWithoutPathReadsBack) {
  writeResult(file_, PlanResult());
  const PlanResult read = readResult(file_);
  EXPECT_FALSE(read.solved);
  EXPECT_TRUE(read.path.empty());
  EXPECT_TRUE(read.parameters.empty());
}

TEST_F(ResultTest, CutOffAnywhereIsRefused) {
  const std::size_t end = good_.rfind('}');
  for (std::size_t length = 0; length <= end; length += 1 + (length % 7))
    expectRefused(good_.substr(0, length), "byte");
  expectRefused(good_.substr(0, end), "cut off or malformed JSON");
}

TEST_F(ResultTest, MalformedOrForeignTextIsRefused) {
  expectRefused("", "malformed");
  expectRefused("schema: 1\nscene: maze\n", "malformed");
  expectRefused(good_ + good_, "malformed");
  expectRefused("[1, 2]", "not a JSON object");
  expectRefused("{}", "schema");
  expectRefused(with("\"b4p\"", "\"b4\xFFp\""), "malformed");
}

TEST_F(ResultTest, WrongSchemaIsRefused) {
  expectRefused(with("\"schema\": 1", "\"schema\": 2"), "schema: 2 is not schema 1");
  expectRefused(with("\"schema\": 1", "\"schema\": \"1\""), "schema: \"1\" is not an integer");
}

TEST_F(ResultTest, EveryKeyIsNeeded) {
  for (const char* key : {"scene",
                          "planner",
                          "parameters",
                          "seed",
                          "threads",
                          "time_limit_s",
                          "planning_time_s",
                          "status",
                          "solved",
                          "grasp_id",
                          "grasp",
                          "X_OT",
                          "opening_m",
                          "X_WO_pick",
                          "X_WO_place",
                          "position_m",
                          "rotation",
                          "joint_names",
                          "path",
                          "verification",
                          "passed",
                          "failure",
                          "step_m",
                          "configurations",
                          "clearance_m"}) {
    const std::string quoted = "\"" + std::string(key) + "\":";
    expectRefused(with(quoted, "\"x" + std::string(key) + "\":"), "unknown key 'x" + std::string(key) + "'");
  }
  expectRefused(with("\"seed\": 18446744073709551557,", ""), "has no key 'seed'");
  expectRefused(with("\"opening_m\": 0.064", "\"opening_m\": 0.064, \"opening_m\": 0.064"),
                "opening_m: is there twice");
}

TEST_F(ResultTest, WrongTypesAreRefusedByName) {
  expectRefused(with("\"solved\": true", "\"solved\": 1"), "solved: 1 is neither true nor false");
  expectRefused(with("\"planner\": \"b4p\"", "\"planner\": 4"), "planner: 4 is not a text");
  expectRefused(with("\"threads\": 1", "\"threads\": -1"), "threads: -1 is out of range");
  expectRefused(with("\"threads\": 1", "\"threads\": 4294967296"), "threads: 4294967296 is out of range");
  expectRefused(with("\"threads\": 1", "\"threads\": 1.5"), "threads: 1.5 is not an integer");
  expectRefused(with("\"grasp_id\": 3", "\"grasp_id\": 2147483648"), "grasp_id: 2147483648 is out of range");
  expectRefused(with("\"opening_m\": 0.064", "\"opening_m\": \"0.064\""),
                "grasp.opening_m: \"0.064\" is not a finite");
  expectRefused(with("\"range\": \"0.1\"", "\"range\": 0.1"), "parameters.range: 0.1 is not a text");
  expectRefused(with("\"path\": [", "\"path\": 3, \"y\": ["), "unknown key 'y'");
}

TEST_F(ResultTest, NonFiniteNumbersAreRefusedByName) {
  expectRefused(with("0.105", "null"), "path[0][2]: null is not a finite number");
  expectRefused(with("0.105", "1e999"), "out_of_range");
  expectRefused(with("0.105", "NaN"), "malformed");
}

TEST_F(ResultTest, RaggedRowsAreRefusedByName) {
  PlanResult ragged = test::gantryResult();
  ragged.path[2].pop_back();
  writeResult(file_, ragged);
  expectRefused(readText(file_), "path[2]: has 4 values, not 5");
}

TEST_F(ResultTest, UnreadableFilesAreRefused) {
  EXPECT_THROW(readResult(test::temporaryFile("missing.json")), InputError);
  EXPECT_THROW(readResult(testing::TempDir()), InputError);
}

TEST_F(ResultTest, NonFiniteNumbersAreNotWritten) {
  PlanResult result = test::gantryResult();
  result.path[0][0] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(writeResult(file_, result), std::invalid_argument);
  EXPECT_EQ(readText(file_), good_) << "the file that was there is untouched";
}

TEST_F(ResultTest, AFailedWriteLeavesNothingBehind) {
  EXPECT_THROW(writeResult("/nowhere/at/all/result.json", test::gantryResult()), InputError);
  const fs::path folder = test::temporaryFile("folder");
  fs::create_directories(folder / "result.json" / "in_the_way");
  EXPECT_THROW(writeResult((folder / "result.json").string(), test::gantryResult()), InputError);
  EXPECT_EQ(std::distance(fs::directory_iterator(folder), fs::directory_iterator()), 1);
  fs::remove_all(folder);
}

}  // namespace
}  // namespace b4p
