// SPDX-License-Identifier: BSD-3-Clause
// A drawn hand is free where the object is put down, and has a straight way out where there is one; many
// poses at once get the answers of each.
#include "experiments/hand_sieve.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <optional>
#include <random>
#include <vector>

#include "experiments/fixtures.h"
#include "experiments/problem.h"

namespace b4p::test {
namespace {

constexpr int kWayOutSteps = 4;

/// The parts of a sieve, for a scene's robot among some obstacles.
struct Hands {
  explicit Hands(CollisionProblem problem)
      : robot(problem.robot),
        like(makeVectorChecker(problem)),
        bare(HandSieve::makeChecker(problem, *like)),
        gripper_checker(FloatingBody::makeChecker(problem, FloatingBody::Parts::kGripper, *like)),
        reference_checker(
            FloatingBody::makeChecker(problem, FloatingBody::Parts::kGripper, *makeFclChecker(problem))) {}

  bool leaves(const Eigen::Isometry3d& X_WT, const Grasp& grasp) {
    int reach[Retreat::kDirections];
    retreat.handReach(X_WT, grasp, kWayOutSteps, reach);
    return *std::max_element(reach, reach + Retreat::kDirections) == kWayOutSteps;
  }

  std::shared_ptr<const Manipulator> robot;
  std::shared_ptr<const CollisionChecker> like, bare, gripper_checker, reference_checker;
  FloatingBody gripper{*gripper_checker}, reference{*reference_checker};
  Retreat retreat{robot, gripper};
};

/// A scene's grasps around its object.
struct SceneHands {
  explicit SceneHands(const char* name)
      : scene(loadScene(name)),
        problem(makeProblem(scene)),
        hands(problem.checker->problem()),
        sampler(makeGraspSampler(scene.pickPlace().grasps, hands.robot->description().max_opening_m)),
        context(problem.region->makeContext(1)) {}

  Eigen::Isometry3d placement() { return problem.region->placement(context->samplePlacement()); }

  Scene scene;
  Problem problem;
  Hands hands;
  std::unique_ptr<const GraspSampler> sampler;
  std::unique_ptr<PickPlaceContext> context;
  std::mt19937_64 random{1};
};

TEST(HandSieve, DrawsHandsThatAreFree) {
  for (const char* name : {"grocery", "stick"}) {
    SceneHands at(name);
    HandSieve sieve(*at.sampler, *at.hands.bare, at.hands.gripper, at.hands.retreat);
    int drawn = 0;
    for (int i = 0; i < 60; ++i) {
      const Eigen::Isometry3d X_WO = at.placement();
      const auto grasp = sieve.draw(X_WO, at.random);
      if (!grasp) continue;
      ++drawn;
      EXPECT_TRUE(at.hands.reference.isFree(X_WO * grasp->X_OT, *grasp)) << name;
    }
    EXPECT_GE(drawn, 20) << name;
  }
}

TEST(HandSieve, PrefersAHandThatLeavesToOneThatIsBoxedIn) {
  SceneHands at("stick");
  int compared = 0;
  for (int i = 0; i < 400 && compared < 5; ++i) {
    const Eigen::Isometry3d X_WO = at.placement();
    std::optional<Grasp> boxed_in, leaving;
    for (int draw = 0; draw < 200 && !(boxed_in && leaving); ++draw) {
      const Grasp grasp = at.sampler->sample(at.random);
      const Eigen::Isometry3d X_WT = X_WO * grasp.X_OT;
      if (at.hands.gripper.isFree(X_WT, grasp)) (at.hands.leaves(X_WT, grasp) ? leaving : boxed_in) = grasp;
    }
    if (!boxed_in || !leaving) continue;
    ++compared;
    const ListedGraspSampler both({*boxed_in, *leaving}), only({*boxed_in});
    HandSieve choosing(both, *at.hands.bare, at.hands.gripper, at.hands.retreat);
    HandSieve left(only, *at.hands.bare, at.hands.gripper, at.hands.retreat);
    int leave = 0, other = 0;
    for (int draw = 0; draw < 200; ++draw) {
      const auto chosen = choosing.draw(X_WO, at.random);
      ASSERT_TRUE(chosen);
      ++(chosen->X_OT.matrix() == leaving->X_OT.matrix() ? leave : other);
      ASSERT_TRUE(left.draw(X_WO, at.random));
    }
    EXPECT_GE(leave, 140);
    EXPECT_GE(other, 5);
  }
  EXPECT_EQ(compared, 5);
}

TEST(HandSieve, DrawsNothingWhereNoHandFits) {
  const SceneHands at("grocery");
  CollisionProblem problem = at.problem.checker->problem();
  const Eigen::Isometry3d X_WO(Eigen::Translation3d(0.6, 0.0, 0.6));
  problem.obstacles.clear();
  Hands alone(problem);
  std::mt19937_64 random(1);
  EXPECT_TRUE(HandSieve(*at.sampler, *alone.bare, alone.gripper, alone.retreat).draw(X_WO, random));
  problem.obstacles = {{"block", {Box{{0.4, 0.4, 0.4}}, X_WO}}};
  Hands buried(problem);
  EXPECT_FALSE(HandSieve(*at.sampler, *buried.bare, buried.gripper, buried.retreat).draw(X_WO, random));
}

TEST(FloatingBody, AnswersAboutManyPosesAsAboutEach) {
  SceneHands at("grocery");
  std::uniform_real_distribution<double> shift_m(-0.2, 0.2);
  const Eigen::Isometry3d& X_WO = at.scene.pickPlace().X_WO_start;
  Grasp grasp;
  do grasp = at.sampler->sample(at.random);
  while (!at.hands.gripper.isFree(X_WO * grasp.X_OT, grasp));
  const Eigen::Isometry3d X_WT = X_WO * grasp.X_OT;
  std::vector<Eigen::Vector3d> shifts_m;
  std::vector<Eigen::Isometry3d> poses;
  for (int i = 0; i < 200; ++i) {
    shifts_m.emplace_back(shift_m(at.random), shift_m(at.random), shift_m(at.random));
    poses.push_back(Eigen::Translation3d(shifts_m.back()) * X_WT);
  }
  std::vector<bool> shifted, posed;
  at.hands.gripper.areFreeShifted(X_WT, shifts_m, grasp, shifted);
  at.hands.gripper.areFree(poses, grasp, posed);
  int free = 0;
  ASSERT_EQ(shifted.size(), poses.size());
  ASSERT_EQ(posed.size(), poses.size());
  for (std::size_t i = 0; i < poses.size(); ++i) {
    const bool expected = at.hands.reference.isFree(poses[i], grasp);
    EXPECT_EQ(shifted[i], expected) << i;
    EXPECT_EQ(posed[i], expected) << i;
    free += expected;
  }
  EXPECT_GT(free, 10);
  EXPECT_LT(free, 190);
}

}  // namespace
}  // namespace b4p::test
