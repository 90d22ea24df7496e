// SPDX-License-Identifier: BSD-3-Clause
// Certificates come back from their files as they were, are read strictly, and notice what contradicts them.
#include "experiments/certification/certificate.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "experiments/certification/digest.h"
#include "experiments/fixtures.h"
#include "robots/input_error.h"

namespace b4p::test {
namespace {

using ::testing::HasSubstr;

GraspRecord record(int id, GraspStatus status, int placements, double clearance_m = 0.0) {
  GraspRecord record;
  record.id = id;
  record.grasp.X_OT.translation() = Eigen::Vector3d(0.1 * id, 0.0, 1.0 / 3.0);
  record.grasp.opening_m = 0.05;
  record.status = status;
  record.placements_found = placements;
  record.clearance_m = clearance_m;
  if (status == GraspStatus::kBlocked) record.grid = {0.02, 128};
  return record;
}

/// One grasp of each kind, and a second compatible one.
Certificate sound() {
  Certificate certificate;
  certificate.scene = "shelf";
  certificate.digest = "fnv1a64:0";
  certificate.settings.grids = {{0.02, 128}};
  certificate.grasps = {
      record(0, GraspStatus::kInvalidAtPick, 0),     record(1, GraspStatus::kNoPlacement, 0),
      record(2, GraspStatus::kCompatible, 5, 0.004), record(3, GraspStatus::kBlocked, 7),
      record(4, GraspStatus::kUndecided, 100),       record(5, GraspStatus::kCompatible, 1, 0.003)};
  certificate.pick_failures = {{"no inverse kinematics", 1}};
  certificate.numbers = numbersOf(certificate.grasps);
  certificate.bins = binsOf(certificate.grasps, {{Box{{1.0, 0.2, 0.1}}, Eigen::Isometry3d::Identity()}});
  PlanResult witness;
  witness.grasp_id = 5;
  witness.joint_names = {"a"};
  witness.path = {{0.1}, {0.2}};
  certificate.witness = witness;
  return certificate;
}

TEST(Certificate, NumbersCountTheGrasps) {
  const CertificateNumbers numbers = sound().numbers;
  EXPECT_EQ(numbers.sampled, 6);
  EXPECT_EQ(numbers.valid_at_pick, 5);
  EXPECT_EQ(numbers.with_placement, 4);
  EXPECT_EQ(numbers.compatible, 2);
  EXPECT_EQ(numbers.blocked, 1);
  EXPECT_EQ(numbers.undecided, 1);
  EXPECT_EQ(numbers.clearance_m, 0.003);
}

TEST(Certificate, ComesBackAsItWas) {
  const TemporaryFolder folder;
  const std::string file = folder / "c.json", again = folder / "again.json";
  writeCertificate(file, sound());
  const Certificate read = readCertificate(file);
  EXPECT_EQ(inconsistency(read), "");
  EXPECT_EQ(read.bins, sound().bins);
  EXPECT_EQ(read.grasps[3].grasp.X_OT.matrix(), sound().grasps[3].grasp.X_OT.matrix());
  writeCertificate(again, read);
  EXPECT_EQ(readFile(file), readFile(again));
}

TEST(Certificate, WithoutAnyPathComesBackToo) {
  const TemporaryFolder folder;
  Certificate certificate;
  certificate.grasps = {record(0, GraspStatus::kUndecided, 3)};
  certificate.numbers = numbersOf(certificate.grasps);
  writeCertificate(folder / "c.json", certificate);
  const Certificate read = readCertificate(folder / "c.json");
  EXPECT_EQ(inconsistency(read), "");
  EXPECT_FALSE(read.witness.has_value());
}

TEST(Certificate, IsReadStrictly) {
  const TemporaryFolder folder;
  writeCertificate(folder / "c.json", sound());
  const std::string text = readFile(folder / "c.json");
  const auto refusal = [&](const std::string& from, const std::string& to) -> std::string {
    writeText(folder / "bad.json", replaced(text, from, to));
    try {
      readCertificate(folder / "bad.json");
    } catch (const InputError& e) {
      return e.what();
    }
    return "accepted";
  };
  EXPECT_THAT(refusal("{\"schema\": 1,\n\"scene\"", "{\"schema\": 2,\n\"scene\""), HasSubstr("schema"));
  EXPECT_THAT(refusal("\"digest\"", "\"digests\""), HasSubstr("digest"));
  EXPECT_THAT(refusal("\"undecided\",", "\"unknown\","), HasSubstr("grasps[4].status"));
  EXPECT_THAT(refusal("\"sampled\":6", "\"sampled\":6.5"), HasSubstr("numbers.sampled"));
  EXPECT_THAT(refusal("\"witness\": {", "\"witness\": ["), HasSubstr("JSON"));
  EXPECT_THAT(refusal("\"grasp_id\":5", "\"grasp_ids\":5"), HasSubstr("grasp_id"));
}

TEST(Certificate, NoticesContradictions) {
  const auto after = [](const std::function<void(Certificate&)>& change) {
    Certificate certificate = sound();
    change(certificate);
    return inconsistency(certificate);
  };
  EXPECT_EQ(after([](Certificate&) {}), "");
  EXPECT_THAT(after([](Certificate& c) { ++c.numbers.compatible; }), HasSubstr("numbers"));
  EXPECT_THAT(after([](Certificate& c) { c.numbers.clearance_m = 0.01; }), HasSubstr("numbers"));
  EXPECT_THAT(after([](Certificate& c) { c.grasps.pop_back(); }), HasSubstr("numbers"));
  EXPECT_THAT(after([](Certificate& c) { c.grasps[2].id = 7; }), HasSubstr("grasps[2]"));
  EXPECT_THAT(after([](Certificate& c) { c.grasps[4].placements_found = 101; }), HasSubstr("grasps[4]"));
  EXPECT_THAT(after([](Certificate& c) { c.grasps[3].grid = {0.0, 0}; }), HasSubstr("grasps[3]"));
  EXPECT_THAT(after([](Certificate& c) { c.witness.reset(); }), HasSubstr("witness"));
  EXPECT_THAT(after([](Certificate& c) { c.witness->grasp_id = 4; }), HasSubstr("witness"));
  EXPECT_THAT(after([](Certificate& c) { c.witness->grasp_id = 6; }), HasSubstr("witness"));
}

TEST(Digest, ChangesWithEachOfTheFiles) {
  const SceneCopy copy;
  const std::string before = sceneDigest(loadScene(copy.scene()));
  EXPECT_EQ(sceneDigest(loadScene(copy.scene())), before);
  for (const char* name : {"easy.yaml", "planar.yaml", "planar.urdf"}) {
    const std::string text = readFile(copy.folder() / name);
    writeText(copy.folder() / name, text + "\n");
    EXPECT_NE(sceneDigest(loadScene(copy.scene())), before) << name;
    writeText(copy.folder() / name, text);
  }
  EXPECT_EQ(sceneDigest(loadScene(copy.scene())), before);
}

TEST(GraspBins, SortByPositionAlongTheLongestSideAndByApproach) {
  std::vector<GraspRecord> grasps(4);
  grasps[0].grasp.X_OT.translation() << 0, -0.49, 0;
  grasps[1].grasp.X_OT.translation() << 0, -0.41, 0;
  grasps[1].status = GraspStatus::kCompatible;
  grasps[1].placements_found = 1;
  grasps[2].grasp.X_OT.translation() << 0, 0.7, 0;  // beyond the end
  grasps[3].grasp.X_OT.translation() << 0, -0.45, 0;
  grasps[3].grasp.X_OT.linear() = Eigen::AngleAxisd(1.4, Eigen::Vector3d::UnitX()).toRotationMatrix();
  const auto bins = binsOf(grasps, {{Box{{0.1, 1.0, 0.1}}, Eigen::Isometry3d::Identity()}});
  const std::vector<GraspBin> expected{{0, "+z", 2, 1, 1, 1}, {0, "-y", 1, 0, 0, 0}, {9, "+z", 1, 0, 0, 0}};
  EXPECT_EQ(bins, expected);
}

}  // namespace
}  // namespace b4p::test
