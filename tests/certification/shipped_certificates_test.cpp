// SPDX-License-Identifier: BSD-3-Clause
// The certificates kept with the scenes speak about the scenes as they are, and hold where it is cheap to
// look.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

#include "experiments/certification/certificate.h"
#include "experiments/certification/digest.h"
#include "experiments/certification/grasp_examiner.h"
#include "experiments/certification/planar/planar_scene.h"
#include "experiments/fixtures.h"
#include "experiments/problem.h"
#include "experiments/verification/verifier.h"

namespace b4p::test {
namespace {

bool never() { return false; }

class ShippedCertificate : public ::testing::TestWithParam<std::string> {
 protected:
  Scene scene_ = loadScene(GetParam());
  Certificate certificate_ = readCertificate(certificateFile(scene_));
};

std::string sceneLabel(const ::testing::TestParamInfo<std::string>& info) { return info.param; }

/// Those that can have a certificate.
std::vector<std::string> pickAndPlaceScenes() {
  std::vector<std::string> names = sceneNames();
  names.erase(std::remove_if(names.begin(), names.end(),
                             [](const auto& name) { return loadScene(name).kind() != TaskKind::kPickPlace; }),
              names.end());
  return names;
}

INSTANTIATE_TEST_SUITE_P(Scenes, ShippedCertificate, ::testing::ValuesIn(pickAndPlaceScenes()), sceneLabel);

TEST_P(ShippedCertificate, SpeaksAboutTheSceneAsItIs) {
  EXPECT_EQ(certificate_.scene, scene_.name);
  EXPECT_EQ(certificate_.digest, sceneDigest(scene_))
      << "out of date: run b4p certify " << GetParam() << " again";
  EXPECT_EQ(inconsistency(certificate_), "");
  if (scene_.pickPlace().grasps.family == GraspFamily::kPolygonEdges)
    EXPECT_TRUE(certificate_.bins.empty());
  else
    EXPECT_EQ(certificate_.bins, binsOf(certificate_.grasps, scene_.pickPlace().object));
  EXPECT_LT(std::filesystem::file_size(certificateFile(scene_)), 300000u);
}

TEST_P(ShippedCertificate, SceneCanBeSolvedAndNoPathWasRefused) {
  EXPECT_GT(certificate_.numbers.compatible, 0);
  for (const GraspRecord& record : certificate_.grasps) EXPECT_EQ(record.failure, "") << record.id;
}

TEST_P(ShippedCertificate, WitnessPassesTheVerifier) {
  ASSERT_TRUE(certificate_.witness.has_value());
  const PlanResult& witness = *certificate_.witness;
  const GraspRecord& record = certificate_.grasps[static_cast<std::size_t>(witness.grasp_id)];
  EXPECT_TRUE(witness.grasp.X_OT.isApprox(record.grasp.X_OT));
  EXPECT_EQ(inconsistency(witness), "");
  const Verification verification = verify(scene_, witness);
  EXPECT_TRUE(verification.passed) << verification.failure;
  EXPECT_NEAR(verification.clearance_m, record.clearance_m, 1e-6);
}

TEST_P(ShippedCertificate, FirstPicksComeOutAgain) {
  const GraspExaminer examiner(scene_, certificate_.settings);
  ASSERT_EQ(examiner.grasps().size(), certificate_.grasps.size());
  const int count = std::min<int>(20, certificate_.numbers.sampled);
  int different = 0;
  for (int id = 0; id < count; ++id) {
    const GraspRecord& record = certificate_.grasps[static_cast<std::size_t>(id)];
    EXPECT_TRUE(examiner.grasps()[static_cast<std::size_t>(id)].X_OT.isApprox(record.grasp.X_OT, 1e-9));
    std::string failure;
    const bool valid = !examiner.picks(id, failure).empty();
    if (valid != (record.status != GraspStatus::kInvalidAtPick)) ++different;
  }
  // Another version of the mathematics library may lead one iteration of inverse kinematics elsewhere.
  EXPECT_LE(different, 1);
}

TEST(ShippedMaze, ExactlyOneGraspIsCompatibleAndAllOthersAreProvedBlocked) {
  const CertificateNumbers numbers = readCertificate(certificateFile(loadScene("maze"))).numbers;
  EXPECT_EQ(numbers.sampled, 21);
  EXPECT_EQ(numbers.valid_at_pick, 21);
  EXPECT_EQ(numbers.compatible, 1);
  EXPECT_EQ(numbers.blocked, 20);
}

TEST(ShippedMaze, CheapestProofsHoldAgain) {
  constexpr int kMost = 6;
  const Scene maze = loadScene("maze");
  const Certificate certificate = readCertificate(certificateFile(maze));
  const Problem problem = makeProblem(maze);
  const planar::GridSize coarsest = certificate.settings.grids.front();
  int checked = 0;
  for (auto record = certificate.grasps.rbegin(); record != certificate.grasps.rend(); ++record) {
    if (record->grid.angles != coarsest.angles || checked == kMost) continue;
    ++checked;
    const auto task = planar::planarTask(maze, *problem.robot, record->grasp);
    EXPECT_TRUE(planar::floodFromStart(task, coarsest, never)->blocked) << record->id;
  }
  EXPECT_EQ(checked, kMost);
}

}  // namespace
}  // namespace b4p::test
