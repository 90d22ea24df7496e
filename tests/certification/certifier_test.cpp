// SPDX-License-Identifier: BSD-3-Clause
// Certification of scenes whose answers are known; what `b4p certify` writes, says and refuses.
#include "experiments/certification/certifier.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <csignal>
#include <filesystem>
#include <thread>

#include "experiments/fixtures.h"
#include "experiments/verification/verifier.h"

namespace b4p::test {
namespace {

using ::testing::HasSubstr;

const std::vector<SceneCopy::Change> kClosed{{"size_m: [0.1, 1.2, 0.1]", "size_m: [0.1, 9.0, 0.1]"}};

CertificateSettings settings(double effort_s) {
  CertificateSettings settings;
  settings.effort_s = effort_s;
  settings.placement_draws = 20;
  settings.grids = {{0.05, 64}, {0.02, 128}};
  return settings;
}

Certificate certified(const Scene& scene, unsigned threads = 1) {
  return Certifier(scene, settings(20.0)).run(threads);
}

TEST(Certifier, FindsAVerifiedPathForEveryGraspOfAnEasyScene) {
  const SceneCopy copy;
  const Scene scene = loadScene(copy.scene());
  const Certificate certificate = certified(scene);
  EXPECT_EQ(inconsistency(certificate), "");
  EXPECT_EQ(certificate.numbers.sampled, 4);
  EXPECT_EQ(certificate.numbers.compatible, 4);
  EXPECT_GT(certificate.numbers.clearance_m, 0.0);
  EXPECT_TRUE(certificate.bins.empty());
  ASSERT_TRUE(certificate.witness.has_value());
  EXPECT_TRUE(verify(scene, *certificate.witness).passed);
}

TEST(Certifier, ProvesEveryGraspBlockedBehindAClosedWall) {
  const SceneCopy copy(kClosed);
  const Certificate certificate = certified(loadScene(copy.scene()));
  EXPECT_EQ(inconsistency(certificate), "");
  EXPECT_EQ(certificate.numbers.valid_at_pick, 4);
  EXPECT_EQ(certificate.numbers.blocked, 4);
  EXPECT_FALSE(certificate.witness.has_value());
}

TEST(Certifier, LeavesUndecidedWhatItNeitherSolvesNorProves) {
  // Cells as large as the wall is thick prove nothing.
  const SceneCopy copy(kClosed);
  CertificateSettings coarse = settings(0.05);
  coarse.grids = {{0.5, 8}};
  const Certificate certificate = Certifier(loadScene(copy.scene()), coarse).run(1);
  EXPECT_EQ(inconsistency(certificate), "");
  EXPECT_EQ(certificate.numbers.undecided, 4);
}

TEST(Certifier, NumberOfThreadsChangesNothingButTimes) {
  const SceneCopy copy;
  const Scene scene = loadScene(copy.scene());
  const TemporaryFolder folder;
  std::vector<std::string> texts;
  for (const unsigned threads : {1u, 3u}) {
    Certificate certificate = certified(scene, threads);
    for (GraspRecord& record : certificate.grasps) record.seconds = 0.0;
    certificate.witness->planning_time_s = 0.0;
    writeCertificate(folder / "c.json", certificate);
    texts.push_back(readFile(folder / "c.json"));
  }
  EXPECT_EQ(texts[0], texts[1]);
}

TEST(Certifier, CountsGraspsOfAContinuumAndSortsThemIntoBins) {
  CertificateSettings few = settings(0.01);
  few.grasps = 12;
  few.placement_draws = 2;
  const Scene scene = loadScene("grocery");
  const Certificate certificate = Certifier(scene, few).run(2);
  EXPECT_EQ(inconsistency(certificate), "");
  EXPECT_EQ(certificate.numbers.sampled, 12);
  EXPECT_EQ(certificate.bins, binsOf(certificate.grasps, scene.pickPlace().object));
  EXPECT_FALSE(certificate.bins.empty());
  EXPECT_TRUE(certificate.settings.grids.empty()) << "an arm has no flood fill";
  few.seed = 2;
  const Certificate other = Certifier(scene, few).run(2);
  EXPECT_FALSE(other.grasps[0].grasp.X_OT.isApprox(certificate.grasps[0].grasp.X_OT));
}

TEST(CertifyCommand, WritesBesideTheSceneAndEndsWithZero) {
  const SceneCopy copy;
  const CommandRun run = runB4p("certify " + copy.scene() + " --threads 2");
  EXPECT_EQ(run.exit_code, 0) << run.err;
  EXPECT_EQ(run.err, "");
  EXPECT_THAT(run.out, HasSubstr("4 compatible"));
  const Scene scene = loadScene(copy.scene());
  EXPECT_EQ(certificateFile(scene), copy.folder() / "easy.certificate.json");
  EXPECT_EQ(inconsistency(readCertificate(certificateFile(scene))), "");
}

TEST(CertifyCommand, ReportsAnImpossibleSceneAndStillWrites) {
  const std::string cage =
      "obstacles:\n"
      "  - {name: north, box: {size_m: [0.4, 0.02, 0.1]}, position_m: [0.3, 0.13, 0]}\n"
      "  - {name: south, box: {size_m: [0.4, 0.02, 0.1]}, position_m: [0.3, -0.13, 0]}\n"
      "  - {name: left, box: {size_m: [0.02, 0.4, 0.1]}, position_m: [0.17, 0, 0]}\n"
      "  - {name: right, box: {size_m: [0.02, 0.4, 0.1]}, position_m: [0.43, 0, 0]}\n";
  const std::string region = "min_m: [1.6, -0.3, 0], max_m: [1.8, 0.3, 0]";
  for (const auto& [change, reason] : std::vector<std::pair<SceneCopy::Change, std::string>>{
           {kClosed[0], "4 with a placement, 4 proved blocked; reason: every way is proved blocked"},
           {{"obstacles:\n", cage}, "0 valid at the pick"},
           {{region, "min_m: [6, 0, 0], max_m: [7, 0, 0]"}, "0 with a placement"}}) {
    const std::vector<SceneCopy::Change> changes{change};
    const SceneCopy copy(changes);
    const std::string file = copy.folder() / "c.json";
    const CommandRun run = runB4p("certify " + copy.scene() + " --effort-s 0.5 --out " + file);
    EXPECT_EQ(run.exit_code, 1) << run.err;
    EXPECT_THAT(run.out, HasSubstr("no compatible grasp within the stated effort: of 4 sampled"));
    EXPECT_THAT(run.out, HasSubstr(reason));
    EXPECT_EQ(readCertificate(file).numbers.compatible, 0);
  }
}

TEST(CertifyCommand, RefusesBadInputWithOneLine) {
  const SceneCopy copy;
  const auto before = copy.folder().files();
  const std::string nowhere = copy.scene() + "/below";
  for (const auto& [arguments, culprit] :
       std::vector<std::pair<std::string, std::string>>{{"atlantis", "atlantis"},
                                                        {"/nowhere/scene.yaml", "/nowhere/scene.yaml"},
                                                        {copy.scene() + " --grasps 0", "--grasps"},
                                                        {copy.scene() + " --grasps -3", "--grasps"},
                                                        {copy.scene() + " --grasps many", "--grasps"},
                                                        {copy.scene() + " --effort-s 0", "--effort-s"},
                                                        {copy.scene() + " --effort-s -1", "--effort-s"},
                                                        {copy.scene() + " --effort-s nan", "--effort-s"},
                                                        {copy.scene() + " --seed 1.5", "--seed"},
                                                        {copy.scene() + " --threads 0", "--threads"},
                                                        {copy.scene() + " --out " + nowhere, nowhere}}) {
    const CommandRun run = runB4p("certify " + arguments);
    EXPECT_EQ(run.exit_code, 2) << arguments;
    EXPECT_EQ(run.errorLines(), 1) << run.err;
    EXPECT_THAT(run.err, HasSubstr(culprit));
    EXPECT_EQ(run.out, "");
  }
  EXPECT_EQ(copy.folder().files(), before);
}

TEST(CertifyCommand, WritesNothingWhenInterrupted) {
  const TemporaryFolder folder;
  const std::string pid_file = folder / "pid";
  CommandRun run;
  std::thread command(
      [&] { run = runB4p("certify grocery --effort-s 600 --out " + folder / "c.json", pid_file); });
  for (int i = 0; i < 600 && !std::filesystem::exists(pid_file); ++i)
    std::this_thread::sleep_for(std::chrono::milliseconds(100));
  std::this_thread::sleep_for(std::chrono::seconds(2));
  ::kill(std::stoi(readFile(pid_file)), SIGINT);
  command.join();
  EXPECT_EQ(run.exit_code, 130) << run.err;
  EXPECT_EQ(run.errorLines(), 1) << run.err;
  EXPECT_EQ(folder.files(), std::vector<std::string>{"pid"});
}

}  // namespace
}  // namespace b4p::test
