// SPDX-License-Identifier: BSD-3-Clause
// The vectorised checker says what FCL says: at random configurations, at configurations within a hair of
// contact, along edges, with an object and without, on every shipped scene and with every instruction set.
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <random>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <hwy/targets.h>

#include "experiments/problem.h"
#include "experiments/samplers/grasp_sampler.h"
#include "experiments/scene.h"
#include "state_validity/collision_checker.h"

namespace b4p::test {
namespace {

using Configuration = std::vector<double>;

/// B4P_EQUALITY_TIMES=10 looks at ten times as many configurations.
int times(int count) {
  const char* factor = std::getenv("B4P_EQUALITY_TIMES");
  return factor ? count * std::max(1, std::atoi(factor)) : count;
}

/// One scene under both checkers, and configurations worth asking about.
class Twins {
 public:
  explicit Twins(const std::string& scene_name, std::uint64_t seed = 1) : random_(seed) {
    const Scene scene = loadScene(scene_name);
    const Problem problem = makeProblem(scene);
    robot_ = problem.robot;
    const CollisionProblem collisions = problem.checker->problem();
    fcl_ = makeFclChecker(collisions);
    vector_ = makeVectorChecker(collisions);
    fcl = fcl_->makeContext();
    vector = vector_->makeContext();
    const auto region = problem.region->makeSceneContext(seed);
    Configuration q(static_cast<std::size_t>(robot_->dof()));
    GraspId id = kNoGrasp;
    for (int draw = 0; draw < 20000 && grasps.size() < 8; ++draw) {
      if (!region->samplePick(q.data(), id)) continue;
      grasps.push_back(problem.region->grasp(id));
      roots_.push_back(q);
      if (region->placeRoot(region->samplePlacement(), id, q.data())) roots_.push_back(q);
    }
  }

  Configuration uniform() {
    Configuration q;
    for (int i = 0; i < robot_->dof(); ++i)
      q.push_back(std::uniform_real_distribution<>(robot_->lower()[i], robot_->upper()[i])(random_));
    return q;
  }

  /// Uniform, or not far from a pick or placement.
  Configuration draw() {
    const Configuration far = uniform();
    if (random_() % 2 == 0) return far;
    return between(roots_[random_() % roots_.size()], far, std::pow(0.1, 3.0 * share()));
  }

  static Configuration between(const Configuration& q1, const Configuration& q2, double t) {
    Configuration q = q1;
    for (std::size_t i = 0; i < q.size(); ++i) q[i] += t * (q2[i] - q1[i]);
    return q;
  }

  double share() { return std::uniform_real_distribution<>(0.0, 1.0)(random_); }
  const Grasp* drawGrasp() { return random_() % 4 == 0 ? nullptr : &grasps[random_() % grasps.size()]; }

  std::shared_ptr<const CollisionChecker> vectorChecker() const { return vector_; }
  int dof() const { return robot_->dof(); }

  std::vector<Grasp> grasps;
  std::unique_ptr<CollisionContext> fcl, vector;

 private:
  std::mt19937_64 random_;
  std::shared_ptr<const Manipulator> robot_;
  std::shared_ptr<const CollisionChecker> fcl_, vector_;
  std::vector<Configuration> roots_;
};

class VectorChecker : public ::testing::TestWithParam<std::string> {};
INSTANTIATE_TEST_SUITE_P(Scenes, VectorChecker, ::testing::Values("grocery", "stick", "maze"),
                         [](const auto& test) { return test.param; });

TEST_P(VectorChecker, SaysOfStatesWhatFclSays) {
  Twins twins(GetParam());
  int free = 0;
  const int count = times(50000);
  for (int i = 0; i < count; ++i) {
    const Configuration q = twins.draw();
    const Grasp* held = twins.drawGrasp();
    const bool expected = twins.fcl->isFree(q.data(), held);
    ASSERT_EQ(twins.vector->isFree(q.data(), held), expected) << twins.fcl->describeCollision(q.data(), held);
    free += expected;
  }
  EXPECT_GT(free, count / 100);
  EXPECT_LT(free, count - count / 100);
}

// Contact is found by bisection, down to distances at which only FCL itself knows what it says.
TEST_P(VectorChecker, SaysOfStatesNearContactWhatFclSays) {
  Twins twins(GetParam());
  int found = 0;
  for (const int wanted = times(3000); found < wanted;) {
    const Grasp* held = twins.drawGrasp();
    Configuration in = twins.draw(), out = twins.draw();
    const bool first = twins.fcl->isFree(in.data(), held), second = twins.fcl->isFree(out.data(), held);
    if (first == second) continue;
    if (first) std::swap(in, out);
    ++found;
    for (int step = 0; step < 45; ++step) {
      // A share of the way that is not a half now and then, so as to stay at each distance for a while.
      const Configuration q = Twins::between(in, out, step % 3 == 2 ? 0.1 + 0.8 * twins.share() : 0.5);
      const bool free = twins.fcl->isFree(q.data(), held);
      ASSERT_EQ(twins.vector->isFree(q.data(), held), free) << "step " << step;
      (free ? out : in) = q;
    }
  }
}

TEST_P(VectorChecker, SaysOfManyStatesAtOnceWhatItSaysOfEach) {
  Twins twins(GetParam());
  for (int round = 0; round < 300; ++round) {
    const int count = round % 40 + 1;
    const Grasp* held = twins.drawGrasp();
    std::vector<double> all;
    for (int i = 0; i < count; ++i) {
      const Configuration q = twins.draw();
      all.insert(all.end(), q.begin(), q.end());
    }
    bool free[40];
    twins.vector->areFree(all.data(), count, held, free);
    for (int i = 0; i < count; ++i)
      ASSERT_EQ(free[i], twins.fcl->isFree(all.data() + i * twins.dof(), held)) << i << " of " << count;
  }
}

TEST_P(VectorChecker, SaysOfEdgesWhatFclSays) {
  Twins twins(GetParam());
  int free = 0, blocked = 0;
  for (int i = 0; i < times(10000); ++i) {
    const Grasp* held = twins.drawGrasp();
    const Configuration q1 = twins.draw();
    const Configuration q2 = Twins::between(q1, twins.uniform(), std::pow(0.1, 2.5 * twins.share()));
    if (i % 4 != 0 && !twins.fcl->isFree(q1.data(), held)) continue;
    const double expected = twins.fcl->freeFraction(q1.data(), q2.data(), held);
    ASSERT_EQ(twins.vector->freeFraction(q1.data(), q2.data(), held), expected);
    ASSERT_EQ(twins.vector->isEdgeFree(q1.data(), q2.data(), held), expected == 1.0);
    ASSERT_EQ(twins.vector->isEdgeFree(q2.data(), q1.data(), held), expected == 1.0) << "backwards";
    ++(expected == 1.0 ? free : blocked);
  }
  EXPECT_GT(std::min(free, blocked), 300);
}

TEST_P(VectorChecker, SaysTheSameWithEveryInstructionSet) {
  Twins twins(GetParam());
  std::vector<double> expected;
  std::vector<std::string> sets;
  const std::int64_t supported = hwy::SupportedTargets();
  for (std::int64_t left = supported; left != 0; left &= left - 1) {
    hwy::SetSupportedTargetsForTest(left & -left);
    hwy::GetChosenTarget().Update(left & -left);
    if (std::find(sets.begin(), sets.end(), twins.vectorChecker()->description()) != sets.end()) continue;
    sets.push_back(twins.vectorChecker()->description());
    Twins same(GetParam());
    std::vector<double> answers;
    for (int i = 0; i < 2000; ++i) {
      const Grasp* held = same.drawGrasp();
      const Configuration q1 = same.draw();
      const Configuration q2 = Twins::between(q1, same.uniform(), std::pow(0.1, 2.5 * same.share()));
      answers.push_back(same.vector->freeFraction(q1.data(), q2.data(), held));
      answers.push_back(same.vector->isFree(q2.data(), held) ? 1.0 : 0.0);
    }
    if (expected.empty()) expected = answers;
    EXPECT_EQ(answers, expected) << sets.back();
  }
  hwy::SetSupportedTargetsForTest(0);
  hwy::GetChosenTarget().Update(supported);
  EXPECT_GE(sets.size(), 2u);
}

TEST(VectorCheckerDescription, SaysWhatItLeavesToFcl) {
  EXPECT_EQ(Twins("maze").vectorChecker()->description().find("FCL"), std::string::npos);
}

}  // namespace
}  // namespace b4p::test
