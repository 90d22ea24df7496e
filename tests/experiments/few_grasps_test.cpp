// SPDX-License-Identifier: BSD-3-Clause
// With a single grasp, inverse kinematics always has another posture to offer; the search grows from the
// roots it has before it takes more.
#include <cmath>
#include <optional>
#include <vector>

#include <gtest/gtest.h>
#include <ompl/base/PlannerData.h>
#include <ompl/util/Console.h>
#include <ompl/util/RandomNumbers.h>

#include "experiments/problem.h"
#include "planners/b4p/b4p_planner.h"

namespace b4p::test {
namespace {

namespace ob = ompl::base;

/// A grasp that can pick the stick up and put it down, but not near the stick's middle, where it is let
/// through.
std::optional<Grasp> hardGrasp(const Problem& problem) {
  constexpr double kOffMiddle_m = 0.1;
  const auto context = problem.region->makeContext(1);
  std::vector<double> q(static_cast<std::size_t>(problem.robot->dof()));
  for (int draw = 0; draw < 20000; ++draw) {
    GraspId id = kNoGrasp;
    if (!context->samplePick(q.data(), id)) continue;
    if (std::abs(problem.region->grasp(id).X_OT.translation().z()) < kOffMiddle_m) continue;
    for (int placement = 0; placement < 20; ++placement)
      if (context->placeRoot(context->samplePlacement(), id, q.data())) return problem.region->grasp(id);
  }
  return std::nullopt;
}

TEST(FewGrasps, HaveNoMoreRootsThanTheirNodesHaveDoubled) {
  ompl::msg::noOutputHandler();
  const Problem stick = makeProblem(loadScene("stick"));
  const auto grasp = hardGrasp(stick);
  ASSERT_TRUE(grasp);
  const Problem problem = withGraspsOnly(stick, {*grasp});
  ompl::RNG::setSeed(1);
  B4P planner(problem.si);
  planner.setProblemDefinition(problem.pdef);
  planner.ob::Planner::solve(0.5);
  ob::PlannerData data(problem.si);
  planner.getPlannerData(data);
  const double most = 1.0 + std::log2(static_cast<double>(data.numVertices()));
  EXPECT_GE(data.numStartVertices(), 1u);
  EXPECT_LE(data.numStartVertices(), most) << data.numVertices() << " nodes";
  EXPECT_LE(data.numGoalVertices(), most) << data.numVertices() << " nodes";
}

}  // namespace
}  // namespace b4p::test
