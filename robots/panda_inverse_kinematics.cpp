// SPDX-License-Identifier: BSD-3-Clause
#include "robots/panda_inverse_kinematics.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "robots/panda_arm.h"

namespace b4p {
namespace {

constexpr double kShareOfTolerance = 0.1;
/// Steps of this share of a range never come near to where they have been (the golden section).
constexpr double kEvenStep = 0.6180339887498949;

class AnalyticInverseKinematics : public PandaInverseKinematics {
 public:
  AnalyticInverseKinematics(std::shared_ptr<const Manipulator> robot_in, IkTolerance tolerance,
                            const PandaArm& arm)
      : PandaInverseKinematics(std::move(robot_in), tolerance), arm_(arm) {}

  void solveAll(const Eigen::Isometry3d& X_WT, double q7, std::vector<Eigen::VectorXd>& answers) override {
    answers.clear();
    if (!X_WT.matrix().allFinite() || !(q7 >= arm_.lower[6] && q7 <= arm_.upper[6])) return;
    const PandaArm::Postures postures = arm_.postures(arm_.X_SW * X_WT * arm_.X_T7, q7);
    Eigen::VectorXd q(7);
    for (int i = 0; i < postures.count; ++i) {
      write(postures.at[static_cast<std::size_t>(i)], q);
      if (accept(X_WT, q)) answers.push_back(q);
    }
  }

 protected:
  bool attempt(const Eigen::Isometry3d& X_WT, const Eigen::VectorXd& seed, Eigen::VectorXd& q) override {
    const double q7 = limits().bringInside(arm_.q_index[6], seed[arm_.q_index[6]]);
    const PandaArm::Postures postures = arm_.postures(arm_.X_SW * X_WT * arm_.X_T7, q7);
    double nearest = std::numeric_limits<double>::infinity();
    for (int i = 0; i < postures.count; ++i) {
      const PandaArm::Joints& posture = postures.at[static_cast<std::size_t>(i)];
      double squared_distance = 0.0;
      for (std::size_t j = 0; j < 6; ++j) {
        const double apart = posture[j] - seed[arm_.q_index[j]];
        squared_distance += apart * apart;
      }
      if (squared_distance >= nearest) continue;
      nearest = squared_distance;
      write(posture, q);
    }
    return postures.count > 0;
  }

  void drawSeed(std::mt19937_64& random, int attempt, Eigen::VectorXd& seed) override {
    if (attempt == 0) return InverseKinematics::drawSeed(random, attempt, seed);
    double& q7 = seed[arm_.q_index[6]];
    const double range = arm_.upper[6] - arm_.lower[6];
    q7 += kEvenStep * range;
    if (q7 > arm_.upper[6]) q7 -= range;
  }

 private:
  void write(const PandaArm::Joints& posture, Eigen::VectorXd& q) const {
    for (std::size_t j = 0; j < posture.size(); ++j) q[arm_.q_index[j]] = posture[j];
  }

  PandaArm arm_;
};

}  // namespace

std::unique_ptr<PandaInverseKinematics> makePandaInverseKinematics(std::shared_ptr<const Manipulator> robot,
                                                                   IkTolerance tolerance) {
  const auto arm =
      PandaArm::recognise(*robot, kShareOfTolerance * std::min(tolerance.position_m, tolerance.angle_rad));
  if (!arm) return nullptr;
  return std::make_unique<AnalyticInverseKinematics>(std::move(robot), tolerance, *arm);
}

}  // namespace b4p
