// SPDX-License-Identifier: BSD-3-Clause
#include "robots/kinematic_chain.h"

#include <cmath>
#include <stdexcept>

#include <kdl/chainfksolverpos_recursive.hpp>
#include <kdl/chainjnttojacsolver.hpp>
#include <kdl/jacobian.hpp>

#include "robots/kdl_chain.h"

namespace b4p {

// The solvers keep references to the chain, so it comes first.
struct KinematicChain::Impl {
  explicit Impl(const Manipulator& robot)
      : kdl(robot),
        forward(kdl.chain),
        to_jacobian(kdl.chain),
        chain_q(kdl.chain.getNrOfJoints()),
        chain_jacobian(kdl.chain.getNrOfJoints()) {}

  void set(const double* q) {
    for (std::size_t i = 0; i < kdl.q_index.size(); ++i)
      if (!std::isfinite(q[i]))
        throw std::invalid_argument("joint value " + std::to_string(i) + " is not finite");
    kdl.toChain(q, chain_q);
  }

  KdlChain kdl;
  KDL::ChainFkSolverPos_recursive forward;
  KDL::ChainJntToJacSolver to_jacobian;
  KDL::JntArray chain_q;
  KDL::Jacobian chain_jacobian;
};

KinematicChain::KinematicChain(std::shared_ptr<const Manipulator> robot)
    : impl_(std::make_unique<Impl>(*robot)) {}

KinematicChain::~KinematicChain() = default;

Eigen::Isometry3d KinematicChain::tcpPose(const double* q) {
  impl_->set(q);
  KDL::Frame X_WT;
  impl_->forward.JntToCart(impl_->chain_q, X_WT);
  return fromKdl(X_WT);
}

Eigen::MatrixXd KinematicChain::jacobian(const double* q) {
  impl_->set(q);
  impl_->to_jacobian.JntToJac(impl_->chain_q, impl_->chain_jacobian);
  Eigen::MatrixXd jacobian(6, impl_->chain_jacobian.columns());
  for (std::size_t i = 0; i < impl_->kdl.q_index.size(); ++i)
    jacobian.col(impl_->kdl.q_index[i]) = impl_->chain_jacobian.data.col(static_cast<Eigen::Index>(i));
  return jacobian;
}

}  // namespace b4p
