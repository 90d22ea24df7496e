// SPDX-License-Identifier: BSD-3-Clause
// ik_cross_check [POSES [SEED]]: every inverse kinematics on the poses of POSES (100000) random
// configurations of the Panda. Answers are judged by KDL's forward kinematics and by the limits, and KDL's
// own answers are looked for among those of the analytic one. Exit code 1 when an answer is wrong or one of
// KDL's is lacking.
#include <algorithm>
#include <array>
#include <iomanip>
#include <iostream>
#include <random>
#include <string>
#include <vector>

#include "experiments/scene.h"
#include "robots/kinematic_chain.h"
#include "robots/panda_inverse_kinematics.h"

namespace b4p {
namespace {

constexpr IkTolerance kTolerance{};

struct Solver {
  const char* name;
  int attempts;
  std::unique_ptr<InverseKinematics> ik;
  int found = 0;                              // poses solved
  int kdl_only = 0;                           // poses that KDL solved and this one did not
  int kdl_missed = 0;                         // poses that this one solved and KDL did not
  int outside = 0;                            // answers outside the limits
  int off = 0;                                // answers farther from the target than the tolerance
  double largest_m = 0.0, largest_rad = 0.0;  // largest distance from a target
};

class CrossCheck {
 public:
  CrossCheck(std::shared_ptr<const Manipulator> robot, unsigned seed)
      : robot_(std::move(robot)),
        forward_(robot_),
        analytic_(makePandaInverseKinematics(robot_)),
        random_(seed) {
    solvers_[0] = {"KDL", 20, makeKdlInverseKinematics(robot_)};
    solvers_[1] = {"damped", 20, makeDampedInverseKinematics(robot_)};
    solvers_[2] = {"analytic", 128, makePandaInverseKinematics(robot_)};
  }

  void nextPose() {
    Eigen::VectorXd q(robot_->dof());
    for (int i = 0; i < robot_->dof(); ++i)
      q[i] = std::uniform_real_distribution<>(robot_->lower()[i], robot_->upper()[i])(random_);
    const Eigen::Isometry3d X_WT = forward_.tcpPose(q.data());
    bool by_kdl = false;
    for (Solver& solver : solvers_) {
      const bool solved = solver.ik->solve(X_WT, random_, solver.attempts, q);
      if (&solver == &solvers_.front()) by_kdl = solved;
      solver.kdl_only += by_kdl && !solved;
      solver.kdl_missed += solved && !by_kdl;
      if (!solved) continue;
      judge(solver, X_WT, q);
      if (&solver == &solvers_.front()) lookForAmongAnalytic(q);
    }
  }

  /// True when nothing is wrong.
  bool report(std::ostream& out) const {
    out << "solver    attempts    solved  KDL only  not KDL  outside      off   largest m  largest rad\n";
    bool right = lacking_ == 0;
    for (const Solver& s : solvers_) {
      out << std::left << std::setw(10) << s.name << std::right << std::setw(8) << s.attempts << std::setw(10)
          << s.found << std::setw(10) << s.kdl_only << std::setw(9) << s.kdl_missed << std::setw(9)
          << s.outside << std::setw(9) << s.off << std::scientific << std::setprecision(1) << std::setw(12)
          << s.largest_m << std::setw(13) << s.largest_rad << '\n';
      right = right && s.outside == 0 && s.off == 0;
    }
    out << "KDL's answers not among the analytic ones with the same joint 7: " << lacking_ << " of "
        << solvers_.front().found << '\n';
    return right;
  }

 private:
  void judge(Solver& solver, const Eigen::Isometry3d& X_WT, const Eigen::VectorXd& q) {
    ++solver.found;
    solver.outside += !robot_->withinLimits(q.data());
    const Eigen::Isometry3d reached = forward_.tcpPose(q.data());
    const double apart_m = (reached.translation() - X_WT.translation()).norm();
    const double apart_rad =
        Eigen::AngleAxisd(Eigen::Matrix3d(reached.linear().transpose() * X_WT.linear())).angle();
    solver.off += !(apart_m <= kTolerance.position_m && apart_rad <= kTolerance.angle_rad);
    solver.largest_m = std::max(solver.largest_m, apart_m);
    solver.largest_rad = std::max(solver.largest_rad, apart_rad);
  }

  void lookForAmongAnalytic(const Eigen::VectorXd& q) {
    analytic_->solveAll(forward_.tcpPose(q.data()), q[6], answers_);
    lacking_ += std::none_of(answers_.begin(), answers_.end(), [&](const Eigen::VectorXd& answer) {
      return (answer - q).lpNorm<Eigen::Infinity>() < 1e-5;
    });
  }

  std::shared_ptr<const Manipulator> robot_;
  KinematicChain forward_;
  std::unique_ptr<PandaInverseKinematics> analytic_;
  std::mt19937_64 random_;
  std::array<Solver, 3> solvers_;
  std::vector<Eigen::VectorXd> answers_;
  int lacking_ = 0;
};

int crossCheck(int poses, unsigned seed) {
  const RobotFile file = loadRobotFile("panda");
  CrossCheck check(std::make_shared<const Manipulator>(loadUrdf(file.urdf_file), file.description,
                                                       Eigen::Isometry3d::Identity(), "panda"),
                   seed);
  for (int i = 0; i < poses; ++i) {
    if (i % 10000 == 0) std::cerr << i << " of " << poses << " poses\n";
    check.nextPose();
  }
  return check.report(std::cout) ? 0 : 1;
}

}  // namespace
}  // namespace b4p

int main(int argc, char** argv) {
  try {
    const int poses = argc > 1 ? std::stoi(argv[1]) : 100000;
    const int seed = argc > 2 ? std::stoi(argv[2]) : 1;
    return b4p::crossCheck(poses, static_cast<unsigned>(seed));
  } catch (const std::exception& error) {
    std::cerr << "ik_cross_check: " << error.what() << '\n';
    return 2;
  }
}
