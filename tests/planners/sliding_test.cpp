// SPDX-License-Identifier: BSD-3-Clause
// Promises of growth for narrow places: where the straight motion is blocked, trees go on along the obstacle,
// by motions that are free; spaces whose values cannot be set one by one have none of it; a node that cannot
// move is tried more and more rarely, but never given up.
#include <memory>

#include <gtest/gtest.h>
#include <ompl/base/spaces/DubinsStateSpace.h>
#include <ompl/base/spaces/SE2StateSpace.h>
#include <ompl/base/spaces/SE3StateSpace.h>

#include "planners/b4p/sliding.h"
#include "planners/field.h"
#include "planners/manipulation_state_space.h"

namespace b4p {
namespace {

namespace ob = ompl::base;

/// A field with a wall at x >= 4 that is open above y = 8.
class Sliding : public ::testing::Test, protected test::Field {
 protected:
  Sliding() {
    is_valid = [](double x, double y) { return x < 4.0 || y > 8.0; };
    forests = std::make_unique<ForestPair>(si, distance(), kNoGrasp);
  }

  std::unique_ptr<ForestPair> forests;
};

TEST_F(Sliding, GoesAlongTheWallAndAroundItsEnd) {
  Motion motion(si, 0.0);
  const Node* root = forests->plant(Side::kPick, at(2, 1).get(), kNoGrasp, kNoPlacement)->root;
  const auto target = at(9, 9);
  ASSERT_FALSE(si->checkMotion(root->state, target.get()));
  const auto growth = slideAndConnect(*forests, Side::kPick, target.get(), motion);
  ASSERT_TRUE(growth && growth->grown != nullptr);
  EXPECT_TRUE(si->equalStates(growth->grown->state, target.get()));
  std::size_t nodes = 0;
  for (const Node* node = growth->grown; node->parent != nullptr; node = node->parent, ++nodes)
    EXPECT_TRUE(si->checkMotion(node->parent->state, node->state));
  EXPECT_EQ(nodes, growth->nodes);
  EXPECT_EQ(forests->nodeCount(), nodes + 1);
}

TEST_F(Sliding, EndsWhereNoValueCanMove) {
  Motion motion(si, 0.0);
  forests->plant(Side::kPick, at(2, 1).get(), kNoGrasp, kNoPlacement);
  const auto growth = slideAndConnect(*forests, Side::kPick, at(9, 5).get(), motion);
  ASSERT_TRUE(growth && growth->grown != nullptr);
  EXPECT_NEAR(x(growth->grown->state), 4.0, 0.02);
  EXPECT_DOUBLE_EQ(y(growth->grown->state), 5.0);
}

TEST_F(Sliding, KeepsToTheRange) {
  Motion motion(si, 0.25);
  forests->plant(Side::kPick, at(3.9, 1).get(), kNoGrasp, kNoPlacement);
  const auto growth = slideAndConnect(*forests, Side::kPick, at(9, 5).get(), motion);
  ASSERT_TRUE(growth && growth->grown != nullptr);
  for (const Node* node = growth->grown; node->parent != nullptr; node = node->parent)
    EXPECT_LE(si->distance(node->parent->state, node->state), 0.25 + 1e-9);
}

TEST_F(Sliding, TriesTrappedNodesMoreRarelyButAgainAndAgain) {
  Motion motion(si, 0.0);
  forests->plant(Side::kPick, at(3.9999, 5).get(), kNoGrasp, kNoPlacement);
  const auto target = at(9, 5);
  int tried = 0, tried_late = 0;
  constexpr int kTimes = 20000;
  for (int i = 0; i < kTimes; ++i) {
    const auto growth = slideAndConnect(*forests, Side::kPick, target.get(), motion);
    if (!growth) continue;
    EXPECT_EQ(growth->grown, nullptr);
    ++tried;
    tried_late += i > kTimes / 2;
  }
  EXPECT_LT(tried, kTimes / 20);
  EXPECT_GT(tried_late, 50);
}

TEST_F(Sliding, GapIsWhatLiesBetweenTheTwoSides) {
  Motion motion(si, 0.0);
  forests->plant(Side::kPick, at(2, 1).get(), kNoGrasp, kNoPlacement);
  forests->plant(Side::kPlace, at(7, 9).get(), kNoGrasp, kNoPlacement);
  const auto growth = slideAndConnect(*forests, Side::kPick, at(2, 3).get(), motion);
  ASSERT_TRUE(growth && growth->grown != nullptr);
  const Node* facing = forests->nearest(Side::kPlace, growth->grown->state);
  EXPECT_DOUBLE_EQ(growth->gap, si->distance(growth->grown->state, facing->state));
}

TEST(Values, AreThoseThatCanBeSetOneByOne) {
  const auto values = [](const ob::StateSpacePtr& space) {
    auto si = std::make_shared<ob::SpaceInformation>(space);
    si->setStateValidityChecker([](const ob::State*) { return true; });
    si->setup();
    return Motion(si, 0.0).values();
  };
  ob::RealVectorBounds bounds(3);
  bounds.setLow(-1.0);
  bounds.setHigh(1.0);
  EXPECT_EQ(values(std::make_shared<ManipulationStateSpace>(bounds)), 3u);
  auto plane = std::make_shared<ob::SE2StateSpace>();
  auto car = std::make_shared<ob::DubinsStateSpace>();
  ob::RealVectorBounds square(2);
  square.setLow(-1.0);
  square.setHigh(1.0);
  plane->setBounds(square);
  car->setBounds(square);
  EXPECT_EQ(values(plane), 3u);
  EXPECT_EQ(values(car), 0u);  // its motions are not straight
  auto body = std::make_shared<ob::SE3StateSpace>();
  body->setBounds(bounds);
  EXPECT_EQ(values(body), 0u);  // one value of a quaternion alone is no rotation
}

}  // namespace
}  // namespace b4p
