// SPDX-License-Identifier: BSD-3-Clause
#include "robots/panda_inverse_kinematics.h"

#include <algorithm>
#include <limits>

#include <gtest/gtest.h>

#include "robots/kinematic_chain.h"
#include "robots/shipped_robot.h"

// Promises beyond those of every inverse kinematics: for a given joint 7 all answers are found and none is
// wrong, singular postures included; KDL finds none that this one lacks; a Panda is recognised by how it
// moves, and nothing else is taken for one.

namespace b4p {
namespace {

constexpr int kPoses = 100000;
constexpr double kPi = 3.14159265358979323846;

class PandaInverseKinematicsTest : public testing::Test {
 protected:
  bool amongAllAnswers(const Eigen::VectorXd& q, double tolerance_rad) {
    ik_->solveAll(panda_->tcpPose(q.data()), q[6], answers_);
    return std::any_of(answers_.begin(), answers_.end(), [&](const Eigen::VectorXd& answer) {
      return (answer - q).lpNorm<Eigen::Infinity>() < tolerance_rad;
    });
  }

  /// Counts, in `outside` and `off`, an answer that is not inside the limits or misses the target.
  void judge(const Eigen::VectorXd& q, const Eigen::Isometry3d& X_WT) {
    if (!panda_->withinLimits(q.data())) ++outside_;
    if (!kdl_.tcpPose(q.data()).matrix().isApprox(X_WT.matrix(), 1e-6)) ++off_;
  }

  std::shared_ptr<const Manipulator> panda_ = shippedRobot("panda", unevenPose());
  std::unique_ptr<PandaInverseKinematics> ik_ = makePandaInverseKinematics(panda_);
  KinematicChain kdl_{panda_};
  std::mt19937_64 random_{51};
  std::vector<Eigen::VectorXd> answers_;
  int outside_ = 0, off_ = 0;
};

TEST_F(PandaInverseKinematicsTest, AllAnswersForJoint7AreFoundAndNoneIsWrong) {
  int missed = 0, several = 0;
  for (int i = 0; i < kPoses; ++i) {
    const Eigen::VectorXd q = randomConfiguration(*panda_, random_);
    if (!amongAllAnswers(q, 1e-5)) ++missed;
    if (answers_.size() > 1) ++several;
    const Eigen::Isometry3d X_WT = panda_->tcpPose(q.data());
    for (const Eigen::VectorXd& answer : answers_) {
      judge(answer, X_WT);
      EXPECT_EQ(answer[6], q[6]);
    }
  }
  EXPECT_EQ(missed, 0);
  EXPECT_EQ(outside_, 0);
  EXPECT_EQ(off_, 0);
  EXPECT_GT(several, kPoses / 10);
}

TEST_F(PandaInverseKinematicsTest, NearlyAllReachablePosesAreSolved) {
  Eigen::VectorXd q;
  int found = 0;
  for (int i = 0; i < kPoses; ++i) {
    const Eigen::Isometry3d X_WT = panda_->tcpPose(randomConfiguration(*panda_, random_).data());
    if (!ik_->solve(X_WT, random_, 32, q)) continue;
    ++found;
    judge(q, X_WT);
  }
  EXPECT_EQ(outside_, 0);
  EXPECT_EQ(off_, 0);
  EXPECT_GT(found, kPoses * 99 / 100);
}

TEST_F(PandaInverseKinematicsTest, KdlFindsNoAnswerThatThisOneLacks) {
  const auto kdl_ik = makeKdlInverseKinematics(panda_);
  Eigen::VectorXd q;
  int compared = 0, lacking = 0;
  for (int i = 0; i < 3000; ++i) {
    const Eigen::Isometry3d X_WT = panda_->tcpPose(randomConfiguration(*panda_, random_).data());
    if (!kdl_ik->solve(X_WT, random_, 2, q)) continue;
    ++compared;
    if (!amongAllAnswers(q, 1e-5)) ++lacking;
  }
  EXPECT_EQ(lacking, 0);
  EXPECT_GT(compared, 1000);
}

TEST_F(PandaInverseKinematicsTest, SingularAndMirroredPosturesAndThoseOnALimitAreFound) {
  const double stretched_elbow = std::atan(0.316 / 0.0825) + std::atan(0.384 / 0.0825) - kPi;
  Eigen::VectorXd q(7);
  for (const double q2 : {0.0, 1e-9, 1e-7, 1e-4, 0.5, panda_->upper()[1]})
    for (const double q4 : {-1.5, stretched_elbow, stretched_elbow + 0.1, panda_->upper()[3]}) {
      q << 0.4, q2, 0.4, q4, 0.7, 1.3, -0.9;
      const bool found = amongAllAnswers(q, 1e-6);
      // An elbow and a shoulder that are both stretched leave q1 and q3 to chance, though not their sum.
      const bool unique = q4 != stretched_elbow || q2 > 1e-3;
      EXPECT_TRUE(unique ? found : !answers_.empty()) << q.transpose();
    }
}

TEST_F(PandaInverseKinematicsTest, ValuesOfJoint7ThatAreNotFiniteOrAllowedHaveNoAnswers) {
  const Eigen::VectorXd q = randomConfiguration(*panda_, random_);
  Eigen::Isometry3d X_WT = panda_->tcpPose(q.data());
  for (const double q7 : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity(),
                          panda_->upper()[6] + 1e-9, panda_->lower()[6] - 1e-9}) {
    answers_.assign(1, q);
    ik_->solveAll(X_WT, q7, answers_);
    EXPECT_TRUE(answers_.empty());
  }
  X_WT.translation().x() = std::numeric_limits<double>::quiet_NaN();
  ik_->solveAll(X_WT, q[6], answers_);
  EXPECT_TRUE(answers_.empty());
}

/// Whether a robot with this model and description is taken for a Panda. If so, it has to be solved.
bool isPanda(const RobotModel& model, const ManipulatorDescription& description) {
  const auto robot = std::make_shared<const Manipulator>(model, description, unevenPose(), "test");
  const auto ik = makePandaInverseKinematics(robot);
  const bool chosen = dynamic_cast<PandaInverseKinematics*>(makeInverseKinematics(robot).get()) != nullptr;
  EXPECT_EQ(chosen, ik != nullptr);
  if (!ik) return false;
  std::mt19937_64 random(52);
  Eigen::VectorXd found;
  for (int i = 0; i < 100; ++i) {
    const Eigen::VectorXd q = randomConfiguration(*robot, random);
    EXPECT_TRUE(ik->solveFrom(robot->tcpPose(q.data()), q, found));
    EXPECT_LT((found - q).norm(), 1e-3);
  }
  return true;
}

class PandaRecognition : public testing::Test {
 protected:
  Joint& joint(const std::string& name) {
    return model_.joints[static_cast<std::size_t>(model_.jointIndex(name))];
  }

  std::shared_ptr<const Manipulator> panda_ = shippedRobot("panda");
  RobotModel model_ = panda_->model();
  ManipulatorDescription description_ = panda_->description();
};

TEST_F(PandaRecognition, AcceptsAnyToolAndOrderOfJoints) {
  EXPECT_TRUE(isPanda(model_, description_));
  description_.tcp_link = "panda_link7";
  EXPECT_TRUE(isPanda(model_, description_));
  joint("panda_flange_joint").X_PJ = unevenPose();
  description_.tcp_link = "panda_hand";
  std::reverse(description_.joints.begin(), description_.joints.end());
  EXPECT_TRUE(isPanda(model_, description_));
}

TEST_F(PandaRecognition, AcceptsFramesThatAreElsewhereOnTheAxes) {
  for (const auto& [name, next] :
       {std::pair("panda_joint3", "panda_joint4"), std::pair("panda_joint6", "panda_joint7")}) {
    const Eigen::Isometry3d X = Eigen::Translation3d(0.0, 0.0, 0.15) *
                                Eigen::AngleAxisd(0.8, Eigen::Vector3d(1, -2, 0.5).normalized());
    Joint& moved = joint(name);
    moved.X_PJ = moved.X_PJ * X;
    moved.axis = X.linear().transpose() * moved.axis;
    joint(next).X_PJ = X.inverse() * joint(next).X_PJ;
  }
  EXPECT_TRUE(isPanda(model_, description_));
}

// A millimetre or a milliradian in any place is too much, but for two: what moves axis 2 along or about axis
// 1 moves the whole arm, and what moves frame 7 along or about axis 7 moves the tool.
TEST_F(PandaRecognition, RefusesSmallChangesOfGeometry) {
  for (int i = 2; i <= 7; ++i)
    for (int coordinate = 0; coordinate < 3; ++coordinate) {
      Joint& changed = joint("panda_joint" + std::to_string(i));
      const Eigen::Isometry3d before = changed.X_PJ;
      const bool allowed = (i == 2 && coordinate == 2) || (i == 7 && coordinate == 1);
      changed.X_PJ.translation()[coordinate] += 1e-3;
      EXPECT_EQ(isPanda(model_, description_), allowed) << changed.name << " moved, " << coordinate;
      changed.X_PJ.linear() = Eigen::AngleAxisd(1e-3, Eigen::Vector3d::Unit(coordinate)) * before.linear();
      changed.X_PJ.translation() = before.translation();
      EXPECT_EQ(isPanda(model_, description_), allowed) << changed.name << " turned, " << coordinate;
      changed.X_PJ = before;
    }
  joint("panda_joint5").axis *= -1.0;
  EXPECT_FALSE(isPanda(model_, description_));
}

TEST_F(PandaRecognition, RefusesOtherRobots) {
  EXPECT_EQ(makePandaInverseKinematics(shippedRobot("planar_gripper")), nullptr);
  EXPECT_EQ(makePandaInverseKinematics(pandaOnCarriage()), nullptr);
  EXPECT_EQ(makePandaInverseKinematics(shippedRobot("mobile_panda")), nullptr);
  joint("panda_joint3").type = JointType::kPrismatic;
  EXPECT_FALSE(isPanda(model_, description_));
}

}  // namespace
}  // namespace b4p
