// SPDX-License-Identifier: BSD-3-Clause
#include "robots/inverse_kinematics.h"

#include <algorithm>
#include <limits>
#include <optional>
#include <stdexcept>
#include <thread>

#include <gtest/gtest.h>

#include "robots/kinematic_chain.h"
#include "robots/shipped_robot.h"

// Conformance suite: what every inverse kinematics has to hold, for every robot that ships with b4p. A
// further solver is one more line in kSolvers.

namespace b4p {
namespace {

constexpr int kPoses = 300;
constexpr int kRestarts = 20;
constexpr double kRecall = 0.9;
constexpr double kPi = 3.14159265358979323846;
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

struct Solver {
  const char* name;
  std::unique_ptr<InverseKinematics> (*make)(std::shared_ptr<const Manipulator>, IkTolerance);
};

const Solver kSolvers[] = {
    {"Kdl", makeKdlInverseKinematics},
    {"Damped", makeDampedInverseKinematics},
    {"Fastest", makeInverseKinematics},  // analytic for the Panda
};

class InverseKinematicsConformance : public testing::TestWithParam<std::tuple<Solver, const char*>> {
 protected:
  InverseKinematicsConformance() {
    std::mt19937_64 random(17);
    for (int i = 0; i < kPoses; ++i)
      targets_.push_back(robot_->tcpPose(randomConfiguration(*robot_, random).data()));
  }

  std::unique_ptr<InverseKinematics> make(IkTolerance tolerance = {}) const {
    return std::get<Solver>(GetParam()).make(robot_, tolerance);
  }

  Eigen::VectorXd middle() const { return (robot_->lower() + robot_->upper()) / 2.0; }

  /// Answers to all targets, in order; those not found are empty.
  std::vector<std::optional<Eigen::VectorXd>> answers(InverseKinematics& ik, std::uint64_t seed) const {
    std::vector<std::optional<Eigen::VectorXd>> all;
    std::mt19937_64 random(seed);
    Eigen::VectorXd q;
    for (const auto& X_WT : targets_)
      all.push_back(ik.solve(X_WT, random, kRestarts, q) ? std::optional(q) : std::nullopt);
    return all;
  }

  std::shared_ptr<const Manipulator> robot_ = shippedRobot(std::get<1>(GetParam()), unevenPose());
  std::vector<Eigen::Isometry3d> targets_;
};

TEST_P(InverseKinematicsConformance, AnswersLieInsideLimitsAndReachTheTarget) {
  for (const IkTolerance tolerance : {IkTolerance{}, IkTolerance{1e-6, 1e-5}}) {
    const auto ik = make(tolerance);
    KinematicChain chain(robot_);
    const auto all = answers(*ik, 1);
    for (std::size_t i = 0; i < all.size(); ++i) {
      if (!all[i]) continue;
      ASSERT_EQ(all[i]->size(), robot_->dof());
      EXPECT_TRUE(((*all[i]).array() >= robot_->lower().array()).all());
      EXPECT_TRUE(((*all[i]).array() <= robot_->upper().array()).all());
      const Eigen::Isometry3d reached = chain.tcpPose(all[i]->data());
      EXPECT_LE((reached.translation() - targets_[i].translation()).norm(), tolerance.position_m);
      const Eigen::AngleAxisd turn(Eigen::Matrix3d(reached.linear().transpose() * targets_[i].linear()));
      EXPECT_LE(turn.angle(), tolerance.angle_rad + 1e-12);
    }
  }
}

TEST_P(InverseKinematicsConformance, FindsMostReachablePoses) {
  const auto ik = make();
  const auto all = answers(*ik, 2);
  const auto found =
      std::count_if(all.begin(), all.end(), [](const auto& answer) { return answer.has_value(); });
  RecordProperty("found", static_cast<int>(found));
  EXPECT_GE(static_cast<double>(found), kRecall * kPoses);
}

TEST_P(InverseKinematicsConformance, SeedThatIsAnAnswerIsFound) {
  const auto ik = make();
  std::mt19937_64 random(3);
  Eigen::VectorXd q;
  for (int i = 0; i < 50; ++i) {
    const Eigen::VectorXd answer = randomConfiguration(*robot_, random);
    EXPECT_TRUE(ik->solveFrom(robot_->tcpPose(answer.data()), answer, q));
    EXPECT_LT((q - answer).norm(), 1e-6);
  }
}

TEST_P(InverseKinematicsConformance, NonFiniteTargetOrSeedIsNotSolved) {
  const auto ik = make();
  std::mt19937_64 random(4);
  Eigen::VectorXd q;
  for (const double bad : {kNan, std::numeric_limits<double>::infinity()}) {
    for (const auto& [row, column] : {std::pair(0, 3), std::pair(1, 1)}) {
      Eigen::Isometry3d X_WT = targets_.front();
      X_WT.matrix()(row, column) = bad;
      EXPECT_FALSE(ik->solveFrom(X_WT, middle(), q));
      EXPECT_FALSE(ik->solve(X_WT, random, kRestarts, q));
    }
    Eigen::VectorXd seed = middle();
    seed[0] = bad;
    EXPECT_FALSE(ik->solveFrom(targets_.front(), seed, q));
  }
  EXPECT_FALSE(ik->solveFrom(targets_.front(), Eigen::VectorXd::Zero(robot_->dof() + 1), q));
  EXPECT_TRUE(ik->solve(targets_.front(), random, 10 * kRestarts, q)) << "an attempt that failed left traces";
}

TEST_P(InverseKinematicsConformance, UnreachableOrImproperPoseIsNotSolved) {
  const auto ik = make();
  std::mt19937_64 random(5);
  Eigen::VectorXd q;
  Eigen::Isometry3d far = targets_.front();
  far.translation() += Eigen::Vector3d(20.0, 0.0, 0.0);
  EXPECT_FALSE(ik->solve(far, random, kRestarts, q));
  Eigen::Isometry3d no_rotation = targets_.front();
  no_rotation.linear().setZero();
  EXPECT_FALSE(ik->solve(no_rotation, random, kRestarts, q));
  EXPECT_FALSE(ik->solve(targets_.front(), random, 0, q));
}

TEST_P(InverseKinematicsConformance, SameSeedSameBytesAnotherSeedDiffers) {
  const auto first = make(), second = make();
  const auto a = answers(*first, 6), b = answers(*second, 6), again = answers(*first, 6),
             other = answers(*first, 7);
  EXPECT_EQ(a, b);
  EXPECT_EQ(a, again) << "answers depend on what was asked before";
  EXPECT_NE(a, other);
}

TEST_P(InverseKinematicsConformance, ThreadsWithTheirOwnObjectsAnswerAsOneThreadDoes) {
  const auto serial = answers(*make(), 8);
  std::vector<std::vector<std::optional<Eigen::VectorXd>>> parallel(4);
  std::vector<std::thread> threads;
  for (auto& mine : parallel) threads.emplace_back([this, &mine] { mine = answers(*make(), 8); });
  for (auto& thread : threads) thread.join();
  for (const auto& mine : parallel) EXPECT_EQ(mine, serial);
}

TEST_P(InverseKinematicsConformance, ToleranceHasToBePositive) {
  EXPECT_THROW(make({0.0, 1e-3}), std::invalid_argument);
  EXPECT_THROW(make({1e-4, kNan}), std::invalid_argument);
}

INSTANTIATE_TEST_SUITE_P(SolversAndRobots, InverseKinematicsConformance,
                         testing::Combine(testing::ValuesIn(kSolvers),
                                          testing::Values("panda", "planar_gripper", "yumi_left",
                                                          "yumi_right")),
                         [](const auto& instance) {
                           return std::string(std::get<Solver>(instance.param).name) + "_" +
                                  std::get<1>(instance.param);
                         });

// Without KDL's solver, which takes minutes for nine joints.
INSTANTIATE_TEST_SUITE_P(NineJoints, InverseKinematicsConformance,
                         testing::Combine(testing::Values(kSolvers[1], kSolvers[2]),
                                          testing::Values("mobile_panda")),
                         [](const auto& instance) {
                           return std::string(std::get<Solver>(instance.param).name) + "_" +
                                  std::get<1>(instance.param);
                         });

class InverseKinematicsInThePlane : public testing::TestWithParam<Solver> {};

// Where a maze wants the planar robot, the answer is unique but for whole turns: all of them have to be
// found.
TEST_P(InverseKinematicsInThePlane, FindsAllPoses) {
  const auto planar = shippedRobot("planar_gripper");
  const auto ik = GetParam().make(planar, {});
  std::mt19937_64 random(9);
  Eigen::VectorXd found;
  for (int i = 0; i < 500; ++i) {
    const Eigen::VectorXd q = randomConfiguration(*planar, random);
    ASSERT_TRUE(ik->solve(planar->tcpPose(q.data()), random, kRestarts, found)) << q.transpose();
    EXPECT_LT((found.head<2>() - q.head<2>()).norm(), 1e-3);
    EXPECT_NEAR(std::remainder(found[2] - q[2], 2.0 * kPi), 0.0, 1e-3);
  }
  for (const double x : {0.0, 5.0}) {
    const double q[] = {x, x, 0.0};
    EXPECT_TRUE(ik->solve(planar->tcpPose(q), random, kRestarts, found)) << "on the border, x = " << x;
  }
}

INSTANTIATE_TEST_SUITE_P(Solvers, InverseKinematicsInThePlane, testing::ValuesIn(kSolvers),
                         [](const auto& instance) { return std::string(instance.param.name); });

/// Answers what it is told.
class FixedAnswer : public InverseKinematics {
 public:
  FixedAnswer(std::shared_ptr<const Manipulator> robot, Eigen::VectorXd answer)
      : InverseKinematics(std::move(robot), {}), answer_(std::move(answer)) {}

 protected:
  bool attempt(const Eigen::Isometry3d&, const Eigen::VectorXd&, Eigen::VectorXd& q) override {
    q = answer_;
    return true;
  }

 private:
  Eigen::VectorXd answer_;
};

class InverseKinematicsBase : public testing::Test {
 protected:
  bool solves(const Eigen::VectorXd& answer) {
    FixedAnswer ik(panda_, answer);
    return ik.solveFrom(panda_->tcpPose(home_.data()), home_, q_);
  }

  std::shared_ptr<const Manipulator> panda_ = shippedRobot("panda");
  Eigen::VectorXd home_ = (Eigen::VectorXd(7) << 0, -0.785, 0, -2.356, 0, 1.571, 0.785).finished();
  Eigen::VectorXd q_;
};

TEST_F(InverseKinematicsBase, WrapsRevoluteJointsIntoTheirLimits) {
  Eigen::VectorXd turned = home_;
  turned[0] += 4.0 * kPi;
  turned[3] -= 2.0 * kPi;
  ASSERT_TRUE(solves(turned));
  EXPECT_LT((q_ - home_).norm(), 1e-12);
}

TEST_F(InverseKinematicsBase, RefusesWhatIsOutsideTheLimitsWhicheverWayItIsTurned) {
  Eigen::VectorXd beyond = home_;
  beyond[1] = 2.0;
  FixedAnswer ik(panda_, beyond);
  EXPECT_FALSE(ik.solveFrom(panda_->tcpPose(beyond.data()), home_, q_));
}

TEST_F(InverseKinematicsBase, RefusesAnswersThatMissTheTargetOrAreNotFinite) {
  Eigen::VectorXd off = home_;
  off[6] += 2e-3;  // turns the hand by more than the tolerance and hardly moves it
  EXPECT_FALSE(solves(off));
  off[6] = kNan;
  EXPECT_FALSE(solves(off));
  EXPECT_TRUE(solves(home_));
}

}  // namespace
}  // namespace b4p
