// SPDX-License-Identifier: BSD-3-Clause
#include "robots/sliding_panda_inverse_kinematics.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "robots/aligned_chain.h"
#include "robots/panda_arm.h"

namespace b4p {
namespace {

constexpr double kShareOfTolerance = 0.1;
/// No posture brings frame 7 farther from the shoulder.
constexpr double kReach_m = 0.808;
/// A base that is moved to where the arm reaches comes no nearer than this share of the way: in confined
/// places it is the outstretched arm that fits.
constexpr double kNearestShare = 0.9;
/// An attempt goes on to other values of joint 7 until an arm has an answer.
constexpr int kTries = 8;
/// Steps of this share of a range never come near to where they have been (the golden section).
constexpr double kEvenStep = 0.6180339887498949;

/// A Panda and what carries it.
struct SlidingPanda {
  PandaArm arm;                              ///< with the base at 0; q_index is that of the whole robot
  std::array<int, 2> base_index;             ///< places of the base's values in q
  Eigen::Matrix<double, 3, 2> directions_W;  ///< in which they move the base
};

/// The robot with its base fixed at 0. `arm_index` tells where its joints stand in the whole robot's q.
Manipulator withoutBase(const Manipulator& robot, const std::array<int, 2>& base_index,
                        std::vector<int>& arm_index) {
  RobotModel model = robot.model();
  ManipulatorDescription description = robot.description();
  description.joints.clear();
  for (int i = 0; i < robot.dof(); ++i) {
    Joint& joint = model.joints[static_cast<std::size_t>(robot.plannedJoints()[static_cast<std::size_t>(i)])];
    if (std::find(base_index.begin(), base_index.end(), i) != base_index.end()) {
      joint.type = JointType::kFixed;
    } else {
      description.joints.push_back(joint.name);
      arm_index.push_back(i);
    }
  }
  return {std::move(model), std::move(description), robot.X_WB(), "arm of a sliding Panda"};
}

std::optional<SlidingPanda> recognise(const Manipulator& robot, double tolerance_m) {
  constexpr double kRightAngle_rad = 1e-9;
  const AlignedChain chain(robot);
  const auto& joints = chain.joints();
  if (joints.size() != 9 || joints[0].revolute || joints[1].revolute) return {};
  SlidingPanda panda;
  const Eigen::VectorXd zero = Eigen::VectorXd::Zero(robot.dof());
  const std::vector<Eigen::Isometry3d> X_W = chain.frames(zero.data());
  for (std::size_t i = 0; i < 2; ++i) {
    panda.base_index[i] = joints[i].q_index;
    panda.directions_W.col(static_cast<Eigen::Index>(i)) = X_W[i].linear().col(2);
  }
  if (std::abs(panda.directions_W.col(0).dot(panda.directions_W.col(1))) > kRightAngle_rad) return {};
  std::vector<int> arm_index;
  const auto arm = PandaArm::recognise(withoutBase(robot, panda.base_index, arm_index), tolerance_m);
  if (!arm) return {};
  panda.arm = *arm;
  for (int& index : panda.arm.q_index) index = arm_index[static_cast<std::size_t>(index)];
  return panda;
}

class SlidingPandaInverseKinematics : public InverseKinematics {
 public:
  SlidingPandaInverseKinematics(std::shared_ptr<const Manipulator> robot_in, IkTolerance tolerance,
                                const SlidingPanda& panda)
      : InverseKinematics(std::move(robot_in), tolerance),
        panda_(panda),
        p_WShoulder_(panda.arm.X_SW.inverse().translation()) {}

 protected:
  bool attempt(const Eigen::Isometry3d& X_WT, const Eigen::VectorXd& seed, Eigen::VectorXd& q) override {
    const Eigen::Isometry3d X_W7 = X_WT * panda_.arm.X_T7;
    const Eigen::Vector3d p_Shoulder7 = X_W7.translation() - p_WShoulder_;
    const Eigen::Vector2d under = panda_.directions_W.transpose() * p_Shoulder7;
    const double squared_room =
        kReach_m * kReach_m - (p_Shoulder7 - panda_.directions_W * under).squaredNorm();
    if (!(squared_room > 0.0)) return false;
    const int last = panda_.arm.q_index[6];
    const double range = panda_.arm.upper[6] - panda_.arm.lower[6];
    placeBase(under + moveWithinReach(baseOf(seed) - under, std::sqrt(squared_room)), q);
    double q7 = limits().bringInside(last, seed[last]);
    for (int i = 0; i < kTries; ++i) {
      if (chooseNearest(posturesAt(X_W7, q, q7), seed, q)) return true;
      q7 += kEvenStep * range;
      if (q7 > panda_.arm.upper[6]) q7 -= range;
    }
    return false;
  }

 private:
  Eigen::Vector2d baseOf(const Eigen::VectorXd& q) const {
    return {q[panda_.base_index[0]], q[panda_.base_index[1]]};
  }

  void placeBase(const Eigen::Vector2d& place, Eigen::VectorXd& q) const {
    for (std::size_t i = 0; i < 2; ++i) {
      const int j = panda_.base_index[i];
      q[j] = limits().bringInside(j, place[static_cast<Eigen::Index>(i)]);
    }
  }

  /// Moves a base that is farther from the place under the target than `room` to where the arm reaches.
  static Eigen::Vector2d moveWithinReach(const Eigen::Vector2d& aside, double room) {
    const double distance = aside.norm();
    if (distance <= room) return aside;
    const double share = std::fmod(distance, room) / room;
    return aside * (room * (kNearestShare + (1.0 - kNearestShare) * share) / distance);
  }

  PandaArm::Postures posturesAt(Eigen::Isometry3d X_W7, const Eigen::VectorXd& q, double q7) const {
    X_W7.translation() -= panda_.directions_W * baseOf(q);
    return panda_.arm.postures(panda_.arm.X_SW * X_W7, q7);
  }

  bool chooseNearest(const PandaArm::Postures& postures, const Eigen::VectorXd& seed,
                     Eigen::VectorXd& q) const {
    double nearest = std::numeric_limits<double>::infinity();
    for (int i = 0; i < postures.count; ++i) {
      const PandaArm::Joints& posture = postures.at[static_cast<std::size_t>(i)];
      double squared_distance = 0.0;
      for (std::size_t j = 0; j < posture.size(); ++j) {
        const double apart = posture[j] - seed[panda_.arm.q_index[j]];
        squared_distance += apart * apart;
      }
      if (squared_distance >= nearest) continue;
      nearest = squared_distance;
      for (std::size_t j = 0; j < posture.size(); ++j) q[panda_.arm.q_index[j]] = posture[j];
    }
    return postures.count > 0;
  }

  SlidingPanda panda_;
  Eigen::Vector3d p_WShoulder_;  ///< with the base at 0
};

}  // namespace

std::unique_ptr<InverseKinematics> makeSlidingPandaInverseKinematics(std::shared_ptr<const Manipulator> robot,
                                                                     IkTolerance tolerance) {
  const auto panda =
      recognise(*robot, kShareOfTolerance * std::min(tolerance.position_m, tolerance.angle_rad));
  if (!panda) return nullptr;
  return std::make_unique<SlidingPandaInverseKinematics>(std::move(robot), tolerance, *panda);
}

}  // namespace b4p
