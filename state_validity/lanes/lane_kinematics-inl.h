// SPDX-License-Identifier: BSD-3-Clause
// Where the joints and bodies of a robot are, one configuration per lane. Compiled once per instruction set.
#if defined(B4P_LANE_KINEMATICS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef B4P_LANE_KINEMATICS_INL_H
#undef B4P_LANE_KINEMATICS_INL_H
#else
#define B4P_LANE_KINEMATICS_INL_H
#endif

#include <hwy/highway.h>

#include "state_validity/lanes/lane_world.h"

HWY_BEFORE_NAMESPACE();
namespace b4p::lanes::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

using Lanes = hn::CappedTag<float, kLanes>;
using V = hn::Vec<Lanes>;

/// Sine and cosine, off by a few units in the last place for angles up to some ten turns.
HWY_INLINE void sineAndCosine(V angle, V& sine, V& cosine) {
  const Lanes d;
  const hn::RebindToSigned<Lanes> di;
  const V turns = hn::Round(hn::Mul(angle, hn::Set(d, 0.636619772367581343f)));
  // pi / 2 in three parts, of which the first two have few enough bits for exact products.
  V x = hn::NegMulAdd(turns, hn::Set(d, 1.5703125f), angle);
  x = hn::NegMulAdd(turns, hn::Set(d, 4.837512969970703e-4f), x);
  x = hn::NegMulAdd(turns, hn::Set(d, 7.549789948768648e-8f), x);
  const V x2 = hn::Mul(x, x);
  V s = hn::MulAdd(x2, hn::Set(d, -1.9515295891e-4f), hn::Set(d, 8.3321608736e-3f));
  s = hn::MulAdd(s, x2, hn::Set(d, -1.6666654611e-1f));
  s = hn::MulAdd(hn::Mul(s, x2), x, x);
  V c = hn::MulAdd(x2, hn::Set(d, 2.443315711809948e-5f), hn::Set(d, -1.388731625493765e-3f));
  c = hn::MulAdd(c, x2, hn::Set(d, 4.166664568298827e-2f));
  c = hn::MulAdd(hn::Mul(c, x2), x2, hn::NegMulAdd(hn::Set(d, 0.5f), x2, hn::Set(d, 1.0f)));
  const auto quarter = hn::ConvertTo(di, turns);
  const auto swap = hn::RebindMask(d, hn::Ne(hn::And(quarter, hn::Set(di, 1)), hn::Zero(di)));
  const V sign_s = hn::BitCast(d, hn::ShiftLeft<30>(hn::And(quarter, hn::Set(di, 2))));
  const V sign_c =
      hn::BitCast(d, hn::ShiftLeft<30>(hn::And(hn::Add(quarter, hn::Set(di, 1)), hn::Set(di, 2))));
  sine = hn::Xor(hn::IfThenElse(swap, c, s), sign_s);
  cosine = hn::Xor(hn::IfThenElse(swap, s, c), sign_c);
}

/// A pose in every lane: rotation row by row, then the translation.
struct Pose {
  V r[9];
  V p[3];
};

HWY_INLINE Pose loadPose(const float* from, int lane) {
  const Lanes d;
  Pose pose;
  for (int i = 0; i < 9; ++i) pose.r[i] = hn::Load(d, from + i * kLanes + lane);
  for (int i = 0; i < 3; ++i) pose.p[i] = hn::Load(d, from + (9 + i) * kLanes + lane);
  return pose;
}

HWY_INLINE void storePose(const Pose& pose, float* to, int lane) {
  const Lanes d;
  for (int i = 0; i < 9; ++i) hn::Store(pose.r[i], d, to + i * kLanes + lane);
  for (int i = 0; i < 3; ++i) hn::Store(pose.p[i], d, to + (9 + i) * kLanes + lane);
}

HWY_INLINE V rotatedRow(const V* row, const float* column, int stride) {
  const Lanes d;
  V sum = hn::Mul(row[0], hn::Set(d, column[0]));
  sum = hn::MulAdd(row[1], hn::Set(d, column[stride]), sum);
  return hn::MulAdd(row[2], hn::Set(d, column[2 * stride]), sum);
}

HWY_INLINE void translated(const Pose& pose, const float* p, V* out) {
  for (int i = 0; i < 3; ++i) out[i] = hn::Add(pose.p[i], rotatedRow(pose.r + 3 * i, p, 1));
}

HWY_INLINE Pose constantPose(const LanePose& pose) {
  const Lanes d;
  Pose out;
  for (int i = 0; i < 9; ++i) out.r[i] = hn::Set(d, pose.r[i]);
  for (int i = 0; i < 3; ++i) out.p[i] = hn::Set(d, pose.p[i]);
  return out;
}

HWY_INLINE void turn(V angle, Pose& pose) {
  V s, c;
  sineAndCosine(angle, s, c);
  for (int row = 0; row < 3; ++row) {
    const V x = pose.r[3 * row], y = pose.r[3 * row + 1];
    pose.r[3 * row] = hn::MulAdd(c, x, hn::Mul(s, y));
    pose.r[3 * row + 1] = hn::MulSub(c, y, hn::Mul(s, x));
  }
}

/// Poses of the moved joint frames for lanes lane .. lane + Lanes - 1 into `joints` ([joint][12][kLanes]).
HWY_INLINE void poseJoints(const LaneWorld& world, const float* q, int lane, float* joints) {
  const Lanes d;
  Pose last;
  int last_index = -2;
  for (std::size_t j = 0; j < world.joints.size(); ++j) {
    const LaneJoint& joint = world.joints[j];
    Pose pose;
    if (joint.parent < 0) {
      pose = constantPose(joint.in_parent);
    } else {
      if (joint.parent != last_index) last = loadPose(joints + joint.parent * 12 * kLanes, lane);
      for (int row = 0; row < 3; ++row)
        for (int column = 0; column < 3; ++column)
          pose.r[3 * row + column] = rotatedRow(last.r + 3 * row, joint.in_parent.r + column, 3);
      translated(last, joint.in_parent.p, pose.p);
    }
    const V value = hn::LoadU(d, q + joint.q_index * kLanes + lane);
    if (joint.revolute)
      turn(value, pose);
    else
      for (int i = 0; i < 3; ++i) pose.p[i] = hn::MulAdd(value, pose.r[3 * i + 2], pose.p[i]);
    storePose(pose, joints + j * 12 * kLanes, lane);
    last = pose;
    last_index = static_cast<int>(j);
  }
}

/// A body in every lane: its axes as unit vectors, its middle, half of the axis-aligned box around it.
struct Placed {
  V axis[3][3];
  V middle[3];
  V extent[3];
};

HWY_INLINE void boxAround(const LaneBody& body, Placed& placed) {
  const Lanes d;
  const int first = body.kind == LaneKind::kSegment ? 2 : 0;
  for (int i = 0; i < 3; ++i) {
    placed.extent[i] = hn::Set(d, body.radius);
    for (int k = first; k < 3; ++k)
      placed.extent[i] = hn::MulAdd(hn::Abs(placed.axis[k][i]), hn::Set(d, body.half[k]), placed.extent[i]);
  }
}

/// Of a segment only the last axis is worked out.
HWY_INLINE void placeBody(const LaneBody& body, const float* joints, int lane, Placed& placed) {
  const Lanes d;
  const int first = body.kind == LaneKind::kSegment ? 2 : 0;
  const Pose pose =
      body.joint < 0 ? constantPose(LanePose{}) : loadPose(joints + body.joint * 12 * kLanes, lane);
  for (int k = 0; k < 3; ++k)
    for (int i = 0; i < 3; ++i)
      placed.axis[k][i] = k < first ? hn::Zero(d) : rotatedRow(pose.r + 3 * i, body.in_joint.r + k, 3);
  translated(pose, body.in_joint.p, placed.middle);
  boxAround(body, placed);
}

/// A body that stands still.
HWY_INLINE void placeStill(const LaneBody& body, Placed& placed) {
  const Lanes d;
  for (int k = 0; k < 3; ++k)
    for (int i = 0; i < 3; ++i) placed.axis[k][i] = hn::Set(d, body.in_joint.r[3 * i + k]);
  for (int i = 0; i < 3; ++i) placed.middle[i] = hn::Set(d, body.in_joint.p[i]);
}

HWY_INLINE void storePlaced(const Placed& placed, float* to, int lane) {
  const Lanes d;
  for (int k = 0; k < 3; ++k)
    for (int i = 0; i < 3; ++i) hn::Store(placed.axis[k][i], d, to + (3 * k + i) * kLanes + lane);
  for (int i = 0; i < 3; ++i) hn::Store(placed.middle[i], d, to + (9 + i) * kLanes + lane);
  for (int i = 0; i < 3; ++i) hn::Store(placed.extent[i], d, to + (12 + i) * kLanes + lane);
}

HWY_INLINE void loadPlaced(const float* from, int lane, Placed& placed) {
  const Lanes d;
  for (int k = 0; k < 3; ++k)
    for (int i = 0; i < 3; ++i) placed.axis[k][i] = hn::Load(d, from + (3 * k + i) * kLanes + lane);
  for (int i = 0; i < 3; ++i) placed.middle[i] = hn::Load(d, from + (9 + i) * kLanes + lane);
}

}  // namespace b4p::lanes::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
