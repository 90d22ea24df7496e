// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <utility>

#include <kdl/chainiksolverpos_lma.hpp>

#include "robots/inverse_kinematics.h"
#include "robots/kdl_chain.h"

namespace b4p {
namespace {

constexpr int kMaxIterations = 100;
/// One radian counts as much as this many metres in the error that the solver minimises.
constexpr double kRotationWeight_m = 0.01;
/// The solver stops at this share of the tolerance, so that its answers pass the check that follows.
constexpr double kShareOfTolerance = 0.1;

Eigen::Matrix<double, 6, 1> errorWeights() {
  Eigen::Matrix<double, 6, 1> weights;
  weights << 1.0, 1.0, 1.0, kRotationWeight_m, kRotationWeight_m, kRotationWeight_m;
  return weights;
}

class KdlInverseKinematics : public InverseKinematics {
 public:
  KdlInverseKinematics(std::shared_ptr<const Manipulator> robot, IkTolerance tolerance)
      : InverseKinematics(std::move(robot), tolerance),
        kdl_(this->robot()),
        solver_(kdl_.chain, errorWeights(),
                kShareOfTolerance * std::min(tolerance.position_m, kRotationWeight_m * tolerance.angle_rad),
                kMaxIterations),
        seed_(kdl_.chain.getNrOfJoints()),
        answer_(kdl_.chain.getNrOfJoints()) {}

 protected:
  bool attempt(const Eigen::Isometry3d& X_WT, const Eigen::VectorXd& seed, Eigen::VectorXd& q) override {
    kdl_.toChain(seed.data(), seed_);
    if (solver_.CartToJnt(seed_, toKdl(X_WT), answer_) != KDL::SolverI::E_NOERROR) return false;
    kdl_.fromChain(answer_, q.data());
    return true;
  }

 private:
  KdlChain kdl_;
  KDL::ChainIkSolverPos_LMA solver_;  // refers to the chain above
  KDL::JntArray seed_;
  KDL::JntArray answer_;
};

}  // namespace

std::unique_ptr<InverseKinematics> makeKdlInverseKinematics(std::shared_ptr<const Manipulator> robot,
                                                            IkTolerance tolerance) {
  return std::make_unique<KdlInverseKinematics>(std::move(robot), tolerance);
}

}  // namespace b4p
