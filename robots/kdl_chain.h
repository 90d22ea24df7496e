// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include <Eigen/Geometry>
#include <kdl/chain.hpp>
#include <kdl/jntarray.hpp>

#include "robots/manipulator.h"

namespace b4p {

/// A robot from the world to its TCP as a KDL chain. KDL caches poses inside its joints, so a chain belongs
/// to one thread and every object that evaluates one owns it.
struct KdlChain {
  explicit KdlChain(const Manipulator& robot);

  /// Values of the chain's joints, which run from the root to the TCP, from those of the planned joints, and
  /// back.
  void toChain(const double* q, KDL::JntArray& chain_q) const;
  void fromChain(const KDL::JntArray& chain_q, double* q) const;

  KDL::Chain chain;
  std::vector<int> q_index;  ///< per joint of the chain: its place in q
};

KDL::Frame toKdl(const Eigen::Isometry3d& pose);
Eigen::Isometry3d fromKdl(const KDL::Frame& frame);

}  // namespace b4p
