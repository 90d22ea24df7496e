// SPDX-License-Identifier: BSD-3-Clause
// Promises: all placement scenes that ship are sound; what their goals sample stands on something, collides
// with nothing and beats the threshold, by other code than what drew it; RRTConnect brings the object there.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <ompl/base/ScopedState.h>
#include <ompl/geometric/planners/rrt/RRTConnect.h>
#include <algorithm>

#include "experiments/placement/placement_file.h"
#include "experiments/placement/placement_problem.h"
#include "experiments/placement/solid.h"
#include "experiments/problem.h"
#include "experiments/verification/kinematics.h"
#include "experiments/verification/separation.h"
#include "robots/input_error.h"

namespace b4p::test {
namespace {

namespace ob = ompl::base;
using Scoped = ob::ScopedState<ManipulationStateSpace>;

/// What the verifier's kinematics and distances say about a state.
class Judge {
 public:
  explicit Judge(const Scene& scene) : scene_(scene) {}

  Eigen::Isometry3d objectPose(const ManipulationStateSpace::StateType& s) const {
    const PlacementArm& arm = scene_.placing().arms.at(static_cast<std::size_t>(s.grasp));
    const verification::Kinematics kinematics(arm.urdf_file, arm.description, arm.X_WB);
    const Eigen::VectorXd q = Eigen::Map<const Eigen::VectorXd>(s.q, kinematics.dof());
    return kinematics.linkPoses(q, arm.grasp.opening_m)[static_cast<std::size_t>(kinematics.tcpLink())] *
           arm.grasp.X_OT.inverse();
  }

  bool objectFree(const Eigen::Isometry3d& X_WO) const {
    for (const Obstacle& obstacle : scene_.obstacles)
      for (const PlacedShape& part : scene_.placing().object)
        if (!apart(part, X_WO, obstacle)) return false;
    return true;
  }

  /// Whether under every corner of the object's lowest face there is an obstacle's top, a little below.
  bool stands(const Eigen::Isometry3d& X_WO) const {
    std::vector<Eigen::Vector3d> points;
    double lowest = 1e9;
    for (const Eigen::Vector3d& p : hullPoints(scene_.placing().object)) {
      points.push_back(X_WO * p);
      lowest = std::min(lowest, points.back().z());
    }
    Eigen::AlignedBox2d feet;
    for (const Eigen::Vector3d& p : points) {
      if (p.z() > lowest + 5e-4) continue;
      feet.extend(p.head<2>());
      if (!supported(p)) return false;
    }
    return feet.contains((X_WO * scene_.placing().p_OCom).head<2>());
  }

 private:
  /// No gap of a ball at p, but one when the ball is lifted off: something ends 1.9 to 8 mm below.
  bool supported(const Eigen::Vector3d& p) const {
    const auto touches = [&](double below) {
      const PlacedShape probe{Sphere{1e-4},
                              Eigen::Isometry3d(Eigen::Translation3d(p - below * Eigen::Vector3d::UnitZ()))};
      return std::any_of(scene_.obstacles.begin(), scene_.obstacles.end(), [&](const Obstacle& obstacle) {
        return !apart(probe, Eigen::Isometry3d::Identity(), obstacle);
      });
    };
    return touches(0.008) && !touches(0.0019);
  }

  static bool apart(const PlacedShape& part, const Eigen::Isometry3d& X_WO, const Obstacle& obstacle) {
    return verification::separation(verification::ConvexBody::of(part.shape), X_WO * part.X_BS,
                                    verification::ConvexBody::of(obstacle.shape.shape), obstacle.shape.X_BS,
                                    Eigen::Vector3d::UnitZ())
        .apart();
  }

  const Scene& scene_;
};

TEST(PlacementScenes, AllThatShipAreSound) {
  const auto names = placementSceneNames();
  EXPECT_EQ(names.size() % 12, 0u);
  for (std::string name : names) {
    const Scene scene = loadPlacementScene(name);
    std::replace(name.begin(), name.end(), '/', '_');
    EXPECT_EQ(scene.name, name);
    const PlacementProblem problem = makePlacementProblem(scene);
    EXPECT_EQ(problem.goal->problem(), "");
    EXPECT_GE(problem.world->regions().size(), 3u);
    EXPECT_EQ(problem.pdef->getStartStateCount(), scene.placing().arms.size());
    for (unsigned i = 0; i < problem.pdef->getStartStateCount(); ++i)
      EXPECT_TRUE(problem.si->isValid(problem.pdef->getStartState(i))) << name << " arm " << i;
  }
}

class PandaScenes : public ::testing::TestWithParam<const char*> {};

TEST_P(PandaScenes, SamplesStandAreFreeAndBeatTheThreshold) {
  const Scene scene = loadPlacementScene(GetParam());
  const PlacementProblem problem = makePlacementProblem(scene);
  const Judge judge(scene);
  Scoped state(problem.space);
  double threshold = -1.0;
  for (int i = 0; i < 8; ++i) {
    problem.goal->setObjectiveThreshold(threshold);
    ASSERT_TRUE(problem.goal->sample(state.get(), 20000)) << problem.goal->statistics().summary();
    const Eigen::Isometry3d X_WO = judge.objectPose(*state.get());
    EXPECT_TRUE(judge.stands(X_WO)) << X_WO.matrix();
    EXPECT_TRUE(judge.objectFree(X_WO)) << X_WO.matrix();
    EXPECT_TRUE(problem.si->isValid(state.get()));
    EXPECT_TRUE(problem.goal->isSatisfied(state.get()));
    EXPECT_GT(problem.objective->value(X_WO), threshold - 1e-4);
    threshold = std::max(threshold, problem.goal->objective(state.get()) - 0.01);
  }
}

INSTANTIATE_TEST_SUITE_P(Scenes, PandaScenes,
                         ::testing::Values("placement/panda_cabinet_cluttered_small_crayons",
                                           "placement/panda_table_cluttered_wine_glass",
                                           "placement/panda_cabinet_sparse_toy_table",
                                           "placement/panda_table_cluttered_large_crayons"));

TEST(PlacementWorld, LocatesWhatItPlaces) {
  const PlacementProblem problem =
      makePlacementProblem(loadPlacementScene("placement/panda_table_cluttered_toy_table"));
  const auto& world = *problem.world;
  std::mt19937 random(1);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  for (int i = 0; i < 300; ++i) {
    Placement placement;
    placement.face = static_cast<int>(random() % static_cast<unsigned>(world.faceCount()));
    placement.region = static_cast<int>(random() % world.regions().size());
    const auto& region = world.regions()[static_cast<std::size_t>(placement.region)];
    placement.p_WV = region.cells[random() % region.cells.size()];
    placement.angle_rad = 6.28 * unit(random);
    Placement found;
    ASSERT_TRUE(world.locate(world.objectPose(placement), found));
    EXPECT_EQ(found.face, placement.face);
    EXPECT_EQ(found.region, placement.region);
    EXPECT_LT((found.p_WV - placement.p_WV).norm(), 1e-9);
    EXPECT_NEAR(std::remainder(found.angle_rad - placement.angle_rad, 2 * 3.14159265358979), 0.0, 1e-9);
  }
  Placement none;
  Eigen::Isometry3d aloft = Eigen::Isometry3d::Identity();
  aloft.translation().z() = 3.0;
  EXPECT_FALSE(world.locate(aloft, none));
  EXPECT_FALSE(world.stable(aloft));
}

TEST(PlacementWorld, HalfOverAnEdgeOrTiltedIsNotStable) {
  const PlacementProblem problem =
      makePlacementProblem(loadPlacementScene("placement/panda_table_cluttered_small_crayons"));
  const auto& world = *problem.world;
  // Upright on the table's front part: its box stands on z = 0.10, the contact is 2.5 mm above.
  const auto at = [](double y, double tilt) {
    Eigen::Isometry3d X = Eigen::Isometry3d::Identity();
    X.translation() << -0.1, y, 0.1025 + 0.0355;
    X.linear() = Eigen::AngleAxisd(tilt, Eigen::Vector3d::UnitX()).toRotationMatrix();
    return X;
  };
  EXPECT_TRUE(world.stable(at(0.33, 0.0)));
  EXPECT_TRUE(world.stable(at(0.33, 0.005)));
  EXPECT_FALSE(world.stable(at(0.33, 0.03)));
  EXPECT_FALSE(world.stable(at(0.29, 0.0))) << "half of it outside the volume";
  Eigen::Isometry3d raised = at(0.33, 0.0);
  raised.translation().z() += 0.006;
  EXPECT_FALSE(world.stable(raised));
}

TEST(PlacementPlanning, RrtConnectPutsTheObjectDown) {
  const Scene scene = loadPlacementScene("placement/panda_table_cluttered_small_crayons");
  const PlacementProblem problem = makePlacementProblem(scene);
  ompl::geometric::RRTConnect planner(problem.si);
  planner.setProblemDefinition(problem.pdef);
  ASSERT_EQ(planner.ob::Planner::solve(60.0), ob::PlannerStatus::EXACT_SOLUTION)
      << problem.goal->statistics().summary();
  const auto& path = *problem.pdef->getSolutionPath()->as<ompl::geometric::PathGeometric>();
  const auto* last = path.getState(path.getStateCount() - 1)->as<ManipulationStateSpace::StateType>();
  const Judge judge(scene);
  EXPECT_TRUE(judge.stands(judge.objectPose(*last)));
  EXPECT_TRUE(judge.objectFree(judge.objectPose(*last)));
  EXPECT_TRUE(problem.goal->isSatisfied(last));
}

TEST(PlacementScenes, APickAndPlaceCommandRefusesThem) {
  EXPECT_THROW(makeProblem(loadPlacementScene("placement/panda_table_cluttered_small_crayons")), InputError);
}

TEST(PlacementScenes, AStartThatCollidesIsRefusedWithThePair) {
  Scene scene = loadPlacementScene("placement/panda_table_cluttered_small_crayons");
  scene.placing().arms[0].start = {0.0, 1.2, 0.0, -1.0, 0.0, 1.571, 0.785};
  try {
    makePlacementProblem(scene);
    FAIL() << "accepted";
  } catch (const InputError& e) {
    EXPECT_THAT(e.what(), ::testing::HasSubstr("place.arms.panda.start: is not free: "));
  }
}

}  // namespace
}  // namespace b4p::test
