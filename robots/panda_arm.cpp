// SPDX-License-Identifier: BSD-3-Clause
#include "robots/panda_arm.h"

#include <algorithm>
#include <cmath>

#include "robots/aligned_chain.h"

// The idea (Y. He, S. Liu, "Analytical inverse kinematics for Franka Emika Panda", ICCMA 2021): once joint 7
// is chosen, the pose of frame 7 gives the wrist, where axes 5 and 6 meet, and with it the triangle shoulder,
// elbow, wrist, whose sides are fixed but for the distance from shoulder to wrist.
//
// Derivation. Let the wrist frame 6 be known up to the turn of joint 6: its orientation R6 (after that turn)
// follows from X_S7 and q7. Then
//   q4: the triangle's angle at the elbow, from the law of cosines; two mirror images.
//   q5, q6: the shoulder lies in the plane of the triangle. Seen from frame 5 before joint 5 turns it is
//     (u, 0, v), where u and v depend on q4 alone; seen from frame 6 it is known, (a, b, c). Going from the
//     one to the other, c = u sin q5, and (a, b) is (u cos q5, v) turned by -q6.
//   q1, q2, q3: what is left, the orientation of frame 3, is Rz(q1) Ry(q2) Rz(q3).

namespace b4p {
namespace {

constexpr double kUpperArm_m = 0.316;    // along axis 3
constexpr double kForearm_m = 0.384;     // along axis 5
constexpr double kElbowSide_m = 0.0825;  // from axes 3 and 5 sideways to axis 4
constexpr double kWristSide_m = 0.088;   // from axis 6 to axis 7

constexpr double kPi = 3.14159265358979323846;
constexpr double kTurn_rad = 2.0 * kPi;
/// How far above one a sine or cosine may come by rounding.
constexpr double kRounding = 1e-12;
/// How far outside the limits (rad) a posture may come by rounding, which is most where the elbow is
/// stretched.
constexpr double kLimitRounding = 1e-7;
/// A sine of q2 below this leaves only the sum of q1 and q3 to be found.
constexpr double kStraightShoulder = 1e-8;

struct Line {
  Eigen::Vector3d point, direction;
};

/// The axes in S at q = 0.
const std::array<Line, 7>& pandaAxes() {
  const Eigen::Vector3d x = Eigen::Vector3d::UnitX(), y = Eigen::Vector3d::UnitY(),
                        z = Eigen::Vector3d::UnitZ();
  static const std::array<Line, 7> axes{{{0.0 * z, z},
                                         {0.0 * z, y},
                                         {0.0 * z, z},
                                         {kElbowSide_m * x + kUpperArm_m * z, -y},
                                         {0.0 * z, z},
                                         {(kUpperArm_m + kForearm_m) * z, -y},
                                         {kWristSide_m * x, -z}}};
  return axes;
}

/// S in the world, from the first two axes at q = 0.
Eigen::Isometry3d shoulder(const Line& axis1, const Line& axis2) {
  const Eigen::Vector3d z = axis1.direction;
  const Eigen::Vector3d x = axis2.direction.cross(z).normalized();
  Eigen::Isometry3d X_WS = Eigen::Isometry3d::Identity();
  X_WS.linear() << x, z.cross(x), z;
  X_WS.translation() = axis1.point + z * z.dot(axis2.point - axis1.point);
  return X_WS;
}

/// Brings an angle of less than a turn and a half inside the limits, if a whole turn can; false if not.
bool wrap(double lower, double upper, double& angle) {
  const double least = lower - kLimitRounding, most = upper + kLimitRounding;
  if (angle < least) angle += kTurn_rad;
  if (angle > most) angle -= kTurn_rad;
  return angle >= least && angle <= most;
}

/// A posture in the making, joint by joint from the hand to the base.
class PostureSearch {
 public:
  PostureSearch(const PandaArm& arm, double q7, PandaArm::Postures& found) : arm_(arm), found_(found) {
    q_[6] = q7;
  }

  void run(const Eigen::Isometry3d& X_S7) {
    const Eigen::Matrix3d R7 = X_S7.linear();
    R6_ = beforeTurn(R7, std::cos(q_[6]), std::sin(q_[6]));
    tiltBack(R6_);
    const Eigen::Vector3d p_SWrist = X_S7.translation() - kWristSide_m * R6_.col(0);
    p_6Shoulder_ = -(R6_.transpose() * p_SWrist);
    elbow(p_SWrist.squaredNorm());
  }

 private:
  /// Orientation of a frame before it turned about its z.
  static Eigen::Matrix3d beforeTurn(const Eigen::Matrix3d& R, double c, double s) {
    Eigen::Matrix3d before;
    before << c * R.col(0) - s * R.col(1), s * R.col(0) + c * R.col(1), R.col(2);
    return before;
  }
  /// Orientations after a quarter turn about x, backwards and forwards.
  static void tiltBack(Eigen::Matrix3d& R) {
    const Eigen::Vector3d y = R.col(1);
    R.col(1) = -R.col(2);
    R.col(2) = y;
  }
  static void tilt(Eigen::Matrix3d& R) {
    const Eigen::Vector3d y = R.col(1);
    R.col(1) = R.col(2);
    R.col(2) = -y;
  }

  bool place(int joint, double angle) {
    const auto i = static_cast<std::size_t>(joint - 1);
    q_[i] = angle;
    return wrap(arm_.lower[i], arm_.upper[i], q_[i]);
  }

  void elbow(double squared_distance) {
    constexpr double kUpper2 = kUpperArm_m * kUpperArm_m + kElbowSide_m * kElbowSide_m;
    constexpr double kFore2 = kForearm_m * kForearm_m + kElbowSide_m * kElbowSide_m;
    static const double sides = 2.0 * std::sqrt(kUpper2 * kFore2);
    // The angle that is left of a turn at the elbow when q4 is zero and both side offsets fold together.
    static const double folded =
        kTurn_rad - std::atan(kUpperArm_m / kElbowSide_m) - std::atan(kForearm_m / kElbowSide_m);
    const double cosine = (kUpper2 + kFore2 - squared_distance) / sides;
    if (!(std::abs(cosine) <= 1.0 + kRounding)) return;
    const double angle = std::acos(std::clamp(cosine, -1.0, 1.0));
    for (const double side : {angle, -angle})
      if (place(4, side - folded)) wrist();
  }

  void wrist() {
    c4_ = std::cos(q_[3]);
    s4_ = std::sin(q_[3]);
    const double u = kElbowSide_m * (1.0 - c4_) - kUpperArm_m * s4_;
    const double v = kElbowSide_m * s4_ - kUpperArm_m * c4_ - kForearm_m;
    const double s5 = p_6Shoulder_.z() / u;
    if (!(std::abs(s5) <= 1.0 + kRounding)) return;
    const double cosine = std::sqrt(std::max(0.0, 1.0 - s5 * s5));
    for (const double c5 : {cosine, -cosine}) {
      const double a = p_6Shoulder_.x(), b = p_6Shoulder_.y();
      const double s6 = a * v - b * u * c5, c6 = a * u * c5 + b * v, norm = std::sqrt(s6 * s6 + c6 * c6);
      if (norm > 0.0 && place(5, std::atan2(s5, c5)) && place(6, std::atan2(s6, c6)))
        shoulder(c5, s5, c6 / norm, s6 / norm);
    }
  }

  void shoulder(double c5, double s5, double c6, double s6) {
    Eigen::Matrix3d R = beforeTurn(R6_, c6, s6);
    tiltBack(R);
    R = beforeTurn(R, c5, s5);
    tilt(R);
    R = beforeTurn(R, c4_, s4_);
    tiltBack(R);
    const double sine = std::sqrt(R(0, 2) * R(0, 2) + R(1, 2) * R(1, 2));
    if (sine < kStraightShoulder) {
      const double half_sum = 0.5 * std::atan2(R(1, 0), R(0, 0));
      if (place(2, std::atan2(sine, R(2, 2))) && place(1, half_sum) && place(3, half_sum)) keep();
      return;
    }
    for (const double side : {1.0, -1.0})
      if (place(2, std::atan2(side * sine, R(2, 2))) &&
          place(1, std::atan2(side * R(1, 2), side * R(0, 2))) &&
          place(3, std::atan2(side * R(2, 1), -side * R(2, 0))))
        keep();
  }

  void keep() { found_.at[static_cast<std::size_t>(found_.count++)] = q_; }

  const PandaArm& arm_;
  PandaArm::Postures& found_;
  PandaArm::Joints q_{};
  Eigen::Matrix3d R6_;           ///< orientation of frame 6 in S
  Eigen::Vector3d p_6Shoulder_;  ///< the shoulder seen from frame 6
  double c4_ = 1.0, s4_ = 0.0;
};

}  // namespace

std::optional<PandaArm> PandaArm::recognise(const Manipulator& robot, double tolerance_m) {
  const AlignedChain chain(robot);
  if (chain.joints().size() != 7) return std::nullopt;
  const Eigen::VectorXd zero = Eigen::VectorXd::Zero(robot.dof());
  const std::vector<Eigen::Isometry3d> X_W = chain.frames(zero.data());
  std::array<Line, 7> axes;
  for (std::size_t i = 0; i < 7; ++i) axes[i] = {X_W[i].translation(), X_W[i].linear().col(2)};

  const Eigen::Isometry3d X_WS = shoulder(axes[0], axes[1]);
  if (!X_WS.matrix().allFinite()) return std::nullopt;
  PandaArm arm;
  for (std::size_t i = 0; i < 7; ++i) {
    const Line expected{X_WS * pandaAxes()[i].point, X_WS.linear() * pandaAxes()[i].direction};
    if (!chain.joints()[i].revolute || (axes[i].direction - expected.direction).norm() > tolerance_m ||
        (axes[i].point - expected.point).cross(expected.direction).norm() > tolerance_m)
      return std::nullopt;
    const int j = chain.joints()[i].q_index;
    arm.q_index[i] = j;
    arm.lower[i] = robot.lower()[j];
    arm.upper[i] = robot.upper()[j];
  }
  Eigen::Isometry3d X_S7 = Eigen::Isometry3d::Identity();
  X_S7.translation() << kWristSide_m, 0.0, kUpperArm_m + kForearm_m;
  X_S7.linear().diagonal() << 1.0, -1.0, -1.0;
  arm.X_SW = X_WS.inverse();
  arm.X_T7 = X_W.back().inverse() * X_WS * X_S7;
  return arm;
}

PandaArm::Postures PandaArm::postures(const Eigen::Isometry3d& X_S7, double q7) const {
  Postures found;
  PostureSearch(*this, q7, found).run(X_S7);
  return found;
}

}  // namespace b4p
