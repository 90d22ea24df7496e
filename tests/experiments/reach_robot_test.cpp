// SPDX-License-Identifier: BSD-3-Clause
// A robot from a file as reach planners see it: kinematics that agree with the model's own, inverse
// kinematics inside the limits, and the Panda brought to a grasp by every planner.
#include "experiments/reach/reach_robot.h"

#include <algorithm>
#include <functional>
#include <iterator>
#include <limits>
#include <random>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <ompl/base/objectives/PathLengthOptimizationObjective.h>
#include <ompl/geometric/PathGeometric.h>
#include <ompl/geometric/planners/rrt/RRT.h>
#include <ompl/geometric/planners/rrt/RRTConnect.h>
#include <ompl/geometric/planners/rrt/RRTstar.h>
#include <ompl/util/Console.h>

#include "experiments/floating_body.h"
#include "experiments/scene.h"
#include "experiments/scene_motion_checker.h"
#include "planners/b4p/b4p_planner.h"
#include "planners/manipulation_validity.h"
#include "planners/reach/bik_rrt.h"
#include "planners/reach/ik_rrt.h"
#include "planners/reach/jplus_rrt.h"

namespace b4p::test {
namespace {

namespace ob = ompl::base;
namespace og = ompl::geometric;

std::shared_ptr<const Manipulator> panda() {
  const RobotFile file = loadRobotFile("panda");
  Eigen::Isometry3d X_WB = Eigen::Isometry3d::Identity();
  X_WB.translate(Eigen::Vector3d(0.2, -0.1, 0.3)).rotate(Eigen::AngleAxisd(0.5, Eigen::Vector3d::UnitZ()));
  return std::make_shared<const Manipulator>(loadUrdf(file.urdf_file), file.description, X_WB, file.file);
}

Eigen::VectorXd configuration(const Manipulator& robot, std::mt19937_64& random) {
  Eigen::VectorXd q(robot.dof());
  for (Eigen::Index i = 0; i < q.size(); ++i)
    q[i] = std::uniform_real_distribution<double>(robot.lower()[i], robot.upper()[i])(random);
  return q;
}

TEST(ManipulatorReachRobot, KinematicsAreThoseOfTheModel) {
  const auto robot = panda();
  const auto context = ManipulatorReachRobot(robot).makeContext();
  std::mt19937_64 random(1);
  for (int i = 0; i < 20; ++i) {
    const Eigen::VectorXd q = configuration(*robot, random);
    EXPECT_TRUE(context->tcpPose(q.data()).isApprox(robot->tcpPose(q.data()), 1e-9));
    const Eigen::VectorXd dq = 1e-6 * Eigen::VectorXd::Random(q.size());
    const Eigen::VectorXd to = q + dq;
    const Eigen::Vector3d moved =
        robot->tcpPose(to.data()).translation() - robot->tcpPose(q.data()).translation();
    EXPECT_LT((context->jacobian(q.data()).topRows<3>() * dq - moved).norm(), 1e-10);
  }
}

TEST(ManipulatorReachRobot, AnswersNothingWhereTheOpenHandCollidesAndTheSameElsewhere) {
  const auto robot = panda();
  std::mt19937_64 random(4);
  const Eigen::VectorXd at = (Eigen::VectorXd(7) << 0, -0.785, 0, -2.356, 0, 1.571, 0.785).finished();
  const Eigen::Isometry3d X_WT = robot->tcpPose(at.data());
  CollisionProblem problem;
  problem.robot = robot;
  // Between the pads, as wide as the open gripper.
  problem.obstacles = {{"post", {Box{{0.01, 0.09, 0.01}}, X_WT}}};
  const ManipulatorReachRobot plain(robot);
  const ManipulatorReachRobot looking(robot,
                                      FloatingBody::makeChecker(problem, FloatingBody::Parts::kGripper));
  const auto answers = [&](const ManipulatorReachRobot& of, const Eigen::Isometry3d& target) {
    const auto context = of.makeContext();
    std::mt19937_64 stream(5);
    std::vector<std::vector<double>> all;
    std::vector<double> q(7);
    for (int i = 0; i < 50; ++i)
      if (context->inverse({target, false}, stream, q.data())) all.push_back(q);
    return all;
  };
  EXPECT_FALSE(answers(plain, X_WT).empty());
  EXPECT_TRUE(answers(looking, X_WT).empty());
  const Eigen::Isometry3d aside = X_WT * Eigen::Translation3d(0.1, 0, 0);
  EXPECT_FALSE(answers(looking, aside).empty());
  EXPECT_EQ(answers(looking, aside), answers(plain, aside));
}

TEST(ManipulatorReachRobot, AnswersOfInverseKinematicsReachTheTargetInsideTheLimits) {
  const auto robot = panda();
  const auto context = ManipulatorReachRobot(robot).makeContext();
  std::mt19937_64 random(2);
  int found[2] = {0, 0};
  for (int i = 0; i < 200; ++i) {
    const bool position_only = i % 2 == 1;
    const Eigen::Isometry3d target = robot->tcpPose(configuration(*robot, random).data());
    Eigen::VectorXd q(robot->dof());
    if (!context->inverse({target, position_only}, random, q.data())) continue;
    ++found[position_only];
    EXPECT_TRUE(robot->withinLimits(q.data()));
    const Eigen::Isometry3d reached = robot->tcpPose(q.data());
    EXPECT_LE((reached.translation() - target.translation()).norm(), 1.1e-4);
    EXPECT_TRUE(position_only || reached.isApprox(target, 2e-3));
  }
  EXPECT_GT(found[false], 20);
  EXPECT_GT(found[true], 60);
}

/// The Panda in free space, self-collision checked.
struct PandaProblem {
  explicit PandaProblem(const std::function<ReachTargets(const std::vector<Eigen::Isometry3d>&)>& targets) {
    const auto robot = panda();
    ob::RealVectorBounds bounds(static_cast<unsigned>(robot->dof()));
    for (unsigned i = 0; i < bounds.low.size(); ++i) {
      bounds.setLow(i, robot->lower()[i]);
      bounds.setHigh(i, robot->upper()[i]);
    }
    CollisionProblem collision;
    collision.robot = robot;
    const auto checker = makeFclChecker(collision);
    space = std::make_shared<ManipulationStateSpace>(bounds);
    si = makeManipulationSpaceInformation(space, std::make_shared<SceneMotionChecker>(checker, nullptr));

    std::mt19937_64 random(3);
    const auto context = checker->makeContext();
    std::vector<Eigen::Isometry3d> poses;
    while (poses.size() < 8) {
      const Eigen::VectorXd q = configuration(*robot, random);
      if (context->isFree(q.data(), nullptr)) poses.push_back(robot->tcpPose(q.data()));
    }
    goal = std::make_shared<ReachGoal>(si, std::make_shared<ManipulatorReachRobot>(robot), targets(poses));
    problem = std::make_shared<ob::ProblemDefinition>(si);
    ob::ScopedState<ManipulationStateSpace> start(space);
    const double home[] = {-0.0178, -0.7601, 0.0198, -2.3421, 0.0298, 1.5412, 0.7534};
    std::copy(std::begin(home), std::end(home), start->q);
    start->grasp = kNoGrasp;
    problem->addStartState(start);
    problem->setGoal(goal);
    const auto any_path = std::make_shared<ob::PathLengthOptimizationObjective>(si);
    any_path->setCostThreshold(ob::Cost(std::numeric_limits<double>::max()));  // RRTstar ends with its first
    problem->setOptimizationObjective(any_path);
  }

  std::shared_ptr<ManipulationStateSpace> space;
  ob::SpaceInformationPtr si;
  std::shared_ptr<ReachGoal> goal;
  ob::ProblemDefinitionPtr problem;
};

template <class Planner>
ob::PlannerPtr make(const ob::SpaceInformationPtr& si) {
  return std::make_shared<Planner>(si);
}

class PandaReaches : public ::testing::TestWithParam<ob::PlannerPtr (*)(const ob::SpaceInformationPtr&)> {
 protected:
  void expectReached(const PandaProblem& panda_problem) {
    const ob::PlannerPtr planner = GetParam()(panda_problem.si);
    planner->setProblemDefinition(panda_problem.problem);
    planner->setup();
    ASSERT_EQ(planner->ob::Planner::solve(30.0), ob::PlannerStatus::EXACT_SOLUTION) << planner->getName();
    auto& path = *panda_problem.problem->getSolutionPath()->as<og::PathGeometric>();
    EXPECT_NE(panda_problem.goal->graspOf(path.getStates().back()), kNoGrasp) << planner->getName();
    EXPECT_TRUE(path.check()) << planner->getName();
  }
};

TEST_P(PandaReaches, AGrasp) {
  ompl::msg::noOutputHandler();
  const auto as_poses = [](const std::vector<Eigen::Isometry3d>& poses) {
    return ReachTargets::poses(poses);
  };
  expectReached(PandaProblem(as_poses));
}

TEST_P(PandaReaches, APosition) {
  ompl::msg::noOutputHandler();
  const auto as_positions = [](const std::vector<Eigen::Isometry3d>& poses) {
    return ReachTargets::positions({poses[0].translation(), poses[1].translation()});
  };
  expectReached(PandaProblem(as_positions));
}

INSTANTIATE_TEST_SUITE_P(Planners, PandaReaches,
                         ::testing::Values(&make<JPlusRRT>, &make<IKRRT>, &make<BIKRRT>, &make<og::RRT>,
                                           &make<og::RRTstar>, &make<og::RRTConnect>, &make<B4P>));

}  // namespace
}  // namespace b4p::test
