// SPDX-License-Identifier: BSD-3-Clause
// Bounds of the distance of two bodies, one configuration per lane. Compiled once per instruction set.
//
// A lower bound is the width of a gap between two parallel planes that separate the bodies; an upper bound is
// the distance of two of their points, less what is around these. Both hold whatever led to them.
#if defined(B4P_LANE_DISTANCES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef B4P_LANE_DISTANCES_INL_H
#undef B4P_LANE_DISTANCES_INL_H
#else
#define B4P_LANE_DISTANCES_INL_H
#endif

#include <algorithm>
#include <cmath>

#include <hwy/highway.h>

#include "state_validity/lanes/lane_kinematics-inl.h"

HWY_BEFORE_NAMESPACE();
namespace b4p::lanes::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// Bounds of a signed distance (m). A negative upper bound is a depth by which the bodies certainly overlap.
struct Bounds {
  V lower;
  V upper;
};

/// What has to be known about a distance: whether it exceeds `apart`, else whether it exceeds `clear` or is
/// less than -clear.
struct Question {
  V apart;
  V clear;
  hn::Mask<Lanes> ignored;  ///< lanes in which nobody asks

  HWY_INLINE hn::Mask<Lanes> decided(const Bounds& bounds) const {
    return hn::Or(ignored, hn::Or(hn::Gt(bounds.lower, apart), hn::Lt(bounds.upper, hn::Neg(clear))));
  }
  HWY_INLINE bool answered(const Bounds& bounds) const { return hn::AllTrue(Lanes(), decided(bounds)); }

  /// Likewise where a positive upper bound is one of the distance, too: no better lower bound may exist.
  HWY_INLINE bool settled(const Bounds& bounds) const {
    const auto between = hn::And(hn::Gt(bounds.lower, clear), hn::Le(bounds.upper, apart));
    return hn::AllTrue(Lanes(), hn::Or(decided(bounds), between));
  }

  /// Whether no lane can collide.
  HWY_INLINE bool free(const Bounds& bounds) const {
    return hn::AllTrue(Lanes(), hn::Or(ignored, hn::Gt(bounds.lower, clear)));
  }
};

constexpr float kFar = 1e9f;
constexpr float kTiny = 1e-20f;

HWY_INLINE V constant(float value) { return hn::Set(Lanes(), value); }

HWY_INLINE V dot(const V* a, const V* b) {
  return hn::MulAdd(a[2], b[2], hn::MulAdd(a[1], b[1], hn::Mul(a[0], b[0])));
}

HWY_INLINE V positive(V x) { return hn::Max(x, hn::Zero(Lanes())); }

HWY_INLINE V unitInterval(V t) { return hn::Min(hn::Max(t, constant(-1.0f)), constant(1.0f)); }

/// Components of u along the axes of a body.
HWY_INLINE void along(const Placed& body, const V* u, V* out) {
  for (int k = 0; k < 3; ++k) out[k] = dot(body.axis[k], u);
}

HWY_INLINE void difference(const V* a, const V* b, V* out) {
  for (int i = 0; i < 3; ++i) out[i] = hn::Sub(a[i], b[i]);
}

/// The way from a box's nearest point to x, and how the square of its length curves along v.
struct FromBox {
  V half[3];

  HWY_INLINE V excess(const V* x, const V* v, V* e) const {
    V curvature = constant(kTiny);
    for (int i = 0; i < 3; ++i) {
      e[i] = hn::Sub(x[i], hn::Min(hn::Max(x[i], hn::Neg(half[i])), half[i]));
      const auto outside = hn::Ne(e[i], hn::Zero(Lanes()));
      curvature = hn::Add(curvature, hn::IfThenElseZero(outside, hn::Mul(v[i], v[i])));
    }
    return curvature;
  }
};

/// Likewise for a cylinder about z.
struct FromCylinder {
  V radius;
  V half;

  HWY_INLINE V excess(const V* x, const V* v, V* e) const {
    const V square = hn::MulAdd(x[0], x[0], hn::Mul(x[1], x[1]));
    const V share = hn::Div(radius, hn::Sqrt(hn::Max(square, constant(kTiny))));
    const V beyond = positive(hn::Sub(constant(1.0f), share));
    e[0] = hn::Mul(x[0], beyond);
    e[1] = hn::Mul(x[1], beyond);
    e[2] = hn::Sub(x[2], hn::Min(hn::Max(x[2], hn::Neg(half)), half));
    const V across = hn::MulAdd(v[0], v[0], hn::Mul(v[1], v[1]));
    const V outwards = hn::MulAdd(x[0], v[0], hn::Mul(x[1], v[1]));
    const V radial =
        hn::MulAdd(beyond, across,
                   hn::Mul(hn::Sub(constant(1.0f), beyond),
                           hn::Div(hn::Mul(outwards, outwards), hn::Max(square, constant(kTiny)))));
    const V curvature =
        hn::Add(constant(kTiny), hn::IfThenElseZero(hn::Ne(e[2], hn::Zero(Lanes())), hn::Mul(v[2], v[2])));
    return hn::Add(curvature, hn::IfThenElseZero(hn::Gt(beyond, hn::Zero(Lanes())), radial));
  }
};

/// Distance of the segment p - v .. p + v, rounded by `radius`, from a solid around the origin. Newton's
/// method on the place of the nearest point along the segment, kept between bounds.
template <typename Solid>
HWY_INLINE Bounds segmentToSolid(const V* p, const V* v, float radius, const Solid& solid,
                                 const Question& question) {
  constexpr int kSteps = 7;
  const V zero = hn::Zero(Lanes());
  V t = unitInterval(hn::Div(hn::Neg(dot(p, v)), hn::Max(dot(v, v), constant(kTiny))));
  V low = constant(-1.0f), high = constant(1.0f);
  Bounds bounds{constant(-kFar), constant(kFar)};
  for (int step = 0; step < kSteps; ++step) {
    V x[3], e[3];
    for (int i = 0; i < 3; ++i) x[i] = hn::MulAdd(t, v[i], p[i]);
    const V curvature = solid.excess(x, v, e);
    const V square = dot(e, e), slope = dot(e, v);
    const V distance = hn::Sqrt(square);
    // The solid lies behind the plane across e through the nearest point; e . (p +- v) says where the ends
    // lie.
    const V slack = hn::MulAdd(t, slope, hn::Abs(slope));
    const V gap = hn::Sub(distance, hn::Div(slack, hn::Max(distance, constant(kTiny))));
    bounds.lower = hn::Max(bounds.lower, hn::Sub(gap, constant(radius)));
    bounds.upper = hn::Min(bounds.upper, hn::Sub(distance, constant(radius)));
    if (question.settled(bounds)) break;
    const auto uphill = hn::Gt(slope, zero);
    high = hn::IfThenElse(uphill, t, high);
    low = hn::IfThenElse(uphill, low, t);
    const V next = hn::Sub(t, hn::Div(slope, curvature));
    const V middle = hn::Mul(constant(0.5f), hn::Add(low, high));
    t = hn::IfThenElse(hn::And(hn::Gt(next, low), hn::Lt(next, high)), next, middle);
    if (step == 0) t = hn::IfThenElse(hn::Ge(next, high), high, hn::IfThenElse(hn::Le(next, low), low, t));
  }
  return bounds;
}

/// Distance of two rounded segments, c1 +- v1 and c2 +- v2, `way` = c1 - c2.
HWY_INLINE Bounds segmentToSegment(const V* way, const V* v1, const V* v2, float radius) {
  const V a = hn::Max(dot(v1, v1), constant(kTiny)), e = hn::Max(dot(v2, v2), constant(kTiny));
  const V b = dot(v1, v2), c = dot(v1, way), f = dot(v2, way);
  const V denominator = hn::NegMulAdd(b, b, hn::Mul(a, e));
  V s = unitInterval(hn::Div(hn::MulSub(b, f, hn::Mul(c, e)), hn::Max(denominator, constant(kTiny))));
  const V t = unitInterval(hn::Div(hn::MulAdd(b, s, f), e));
  s = unitInterval(hn::Div(hn::MulSub(b, t, c), a));
  V between[3];
  for (int i = 0; i < 3; ++i) between[i] = hn::NegMulAdd(t, v2[i], hn::MulAdd(s, v1[i], way[i]));
  const V distance = hn::Sqrt(dot(between, between));
  const V gap = hn::Sub(hn::Sub(dot(between, way), hn::Abs(dot(between, v1))), hn::Abs(dot(between, v2)));
  return {hn::Sub(hn::Div(gap, hn::Max(distance, constant(kTiny))), constant(radius)),
          hn::Sub(distance, constant(radius))};
}

HWY_INLINE V lengthOf(const V* u) { return hn::Sqrt(dot(u, u)); }

/// How far a body reaches from its middle along a unit vector that has these components along its axes.
HWY_INLINE V reachAlong(const LaneBody& body, const V* u) {
  const V z = hn::Abs(u[2]);
  V reach = hn::Mul(z, constant(body.half[2]));
  if (body.kind == LaneKind::kSegment) return hn::Add(reach, constant(body.radius));
  if (body.kind == LaneKind::kCylinder)
    return hn::MulAdd(hn::Sqrt(positive(hn::NegMulAdd(z, z, constant(1.0f)))), constant(body.half[0]), reach);
  reach = hn::MulAdd(hn::Abs(u[0]), constant(body.half[0]), reach);
  return hn::MulAdd(hn::Abs(u[1]), constant(body.half[1]), reach);
}

/// Separating axes of two boxes or cylinders (of a mesh its box), as far as these are known in closed form.
/// @param way   from b's middle to a's
/// @param c     c[i][j]: cosine between axis i of a and axis j of b
HWY_INLINE Bounds boxToBox(const LaneBody& a, const LaneBody& b, const V* way, const Placed& pa,
                           const Placed& pb, const Question& question, float rounding) {
  const bool round_a = a.kind == LaneKind::kCylinder, round_b = b.kind == LaneKind::kCylinder;
  V c[3][3], ta[3], tb[3], column[3];
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) c[i][j] = dot(pa.axis[i], pb.axis[j]);
  along(pa, way, ta);
  along(pb, way, tb);
  V square = hn::Zero(Lanes()), depth = constant(kFar), gap;
  Bounds bounds{constant(-kFar), constant(kFar)};
  for (int i = round_a ? 2 : 0; i < 3; ++i) {
    gap = hn::Sub(hn::Sub(hn::Abs(ta[i]), constant(a.half[i])), reachAlong(b, c[i]));
    depth = hn::Min(depth, hn::Neg(gap));
    square = hn::MulAdd(positive(gap), positive(gap), square);
  }
  bounds.lower = hn::Sqrt(square);
  square = hn::Zero(Lanes());
  for (int j = round_b ? 2 : 0; j < 3; ++j) {
    for (int i = 0; i < 3; ++i) column[i] = c[i][j];
    gap = hn::Sub(hn::Sub(hn::Abs(tb[j]), constant(b.half[j])), reachAlong(a, column));
    depth = hn::Min(depth, hn::Neg(gap));
    square = hn::MulAdd(positive(gap), positive(gap), square);
  }
  bounds.lower = hn::Max(bounds.lower, hn::Sqrt(square));
  // A mesh's own faces and vertices say more than what its box has across its axes.
  if (a.kind == LaneKind::kMesh || b.kind == LaneKind::kMesh || question.answered(bounds)) return bounds;

  // Across one axis of each. Where these are parallel the cross product is mere rounding, and one body turned
  // by so little that they are exactly parallel needs no such axis.
  constexpr float kParallel = 1e-3f;
  const V least = constant(kParallel), spread = constant(rounding);
  V widest_skipped = hn::Zero(Lanes());
  for (int i = round_a ? 2 : 0; i < 3; ++i) {
    const int i1 = (i + 1) % 3, i2 = (i + 2) % 3;
    for (int j = round_b ? 2 : 0; j < 3; ++j) {
      const int j1 = (j + 1) % 3, j2 = (j + 2) % 3;
      const V norm = hn::Sqrt(positive(hn::NegMulAdd(c[i][j], c[i][j], constant(1.0f))));
      const V distance = hn::Abs(hn::MulSub(ta[i2], c[i1][j], hn::Mul(ta[i1], c[i2][j])));
      V reach = round_a ? hn::Mul(constant(a.half[0]), norm)
                        : hn::MulAdd(constant(a.half[i1]), hn::Abs(c[i2][j]),
                                     hn::Mul(constant(a.half[i2]), hn::Abs(c[i1][j])));
      reach = hn::Add(reach, round_b ? hn::Mul(constant(b.half[0]), norm)
                                     : hn::MulAdd(constant(b.half[j1]), hn::Abs(c[i][j2]),
                                                  hn::Mul(constant(b.half[j2]), hn::Abs(c[i][j1]))));
      const auto usable = hn::Gt(norm, least);
      const V per_norm = hn::Div(constant(1.0f), hn::Max(norm, least));
      const V apart = hn::Mul(hn::Sub(hn::Sub(distance, reach), spread), per_norm);
      const V overlap = hn::Mul(hn::Sub(hn::Sub(reach, distance), spread), per_norm);
      bounds.lower = hn::Max(bounds.lower, hn::IfThenElse(usable, apart, constant(-kFar)));
      depth = hn::IfThenElse(usable, hn::Min(depth, overlap), depth);
      widest_skipped = hn::IfThenElse(usable, widest_skipped, hn::Max(widest_skipped, norm));
    }
  }
  const bool complete = a.kind == LaneKind::kBox && b.kind == LaneKind::kBox;
  if (complete) {
    const float turned = 8.0f * std::min(a.size, b.size);
    bounds.upper = hn::MulSub(hn::Add(widest_skipped, constant(1e-6f)), constant(turned), depth);
  }
  return bounds;
}

/// The faces of a mesh as separating planes, and whether the other body's middle lies behind all of them.
HWY_INLINE void meshFaces(const LaneBody& mesh, const Placed& pm, const LaneBody& other, const Placed& po,
                          const V* way_to_other, Bounds& bounds) {
  V t[3], w[3][3];
  along(pm, way_to_other, t);
  const int first = other.kind == LaneKind::kSegment || other.kind == LaneKind::kCylinder ? 2 : 0;
  for (int k = first; k < 3; ++k) along(pm, po.axis[k], w[k]);
  V highest = constant(-kFar);
  for (std::size_t f = 0; f < mesh.mesh->nx.size(); ++f) {
    const V n[3] = {constant(mesh.mesh->nx[f]), constant(mesh.mesh->ny[f]), constant(mesh.mesh->nz[f])};
    const V height = hn::Sub(dot(n, t), constant(mesh.mesh->offset[f]));
    V u[3];
    for (int k = 0; k < 3; ++k) u[k] = k < first ? hn::Zero(Lanes()) : dot(n, w[k]);
    bounds.lower = hn::Max(bounds.lower, hn::Sub(height, reachAlong(other, u)));
    highest = hn::Max(highest, height);
  }
  if (!other.mesh) bounds.upper = hn::Min(bounds.upper, highest);
}

/// The axes of a box as separating directions of a mesh's vertices, and whether one of these lies inside.
HWY_INLINE void meshVertices(const LaneBody& mesh, const Placed& pm, const LaneBody& box, const Placed& pb,
                             const V* way_to_mesh, Bounds& bounds) {
  V t[3], w[3][3], least[3], most[3];
  along(pb, way_to_mesh, t);
  for (int k = 0; k < 3; ++k) along(pb, pm.axis[k], w[k]);
  for (int i = 0; i < 3; ++i) {
    least[i] = constant(kFar);
    most[i] = constant(-kFar);
  }
  V deepest = constant(kFar);
  for (std::size_t v = 0; v < mesh.mesh->x.size(); ++v) {
    const V x = constant(mesh.mesh->x[v]), y = constant(mesh.mesh->y[v]), z = constant(mesh.mesh->z[v]);
    V farthest = constant(-kFar);
    for (int i = 0; i < 3; ++i) {
      const V place = hn::MulAdd(x, w[0][i], hn::MulAdd(y, w[1][i], hn::MulAdd(z, w[2][i], t[i])));
      least[i] = hn::Min(least[i], place);
      most[i] = hn::Max(most[i], place);
      farthest = hn::Max(farthest, hn::Sub(hn::Abs(place), constant(box.half[i])));
    }
    deepest = hn::Min(deepest, farthest);
  }
  V square = hn::Zero(Lanes());
  for (int i = 0; i < 3; ++i) {
    const V gap = positive(hn::Sub(hn::Max(least[i], hn::Neg(most[i])), constant(box.half[i])));
    square = hn::MulAdd(gap, gap, square);
  }
  bounds.lower = hn::Max(bounds.lower, hn::Sqrt(square));
  if (box.kind == LaneKind::kBox) bounds.upper = hn::Min(bounds.upper, deepest);
}

/// A cylinder against a box or cylinder through the capsules around and inside it.
template <typename Solid>
HWY_INLINE void roundCylinder(const LaneBody& cylinder, const V* p, const V* axis, const Solid& solid,
                              const Question& question, Bounds& bounds) {
  V v[3];
  for (int i = 0; i < 3; ++i) v[i] = hn::Mul(axis[i], constant(cylinder.half[2]));
  const Bounds outer = segmentToSolid(p, v, cylinder.half[0], solid, question);
  bounds.lower = hn::Max(bounds.lower, outer.lower);
  const float inner = cylinder.half[2] - cylinder.half[0];
  if (inner <= 0.0f || question.answered(bounds)) return;
  for (int i = 0; i < 3; ++i) v[i] = hn::Mul(axis[i], constant(inner));
  bounds.upper = hn::Min(bounds.upper, segmentToSolid(p, v, cylinder.half[0], solid, question).upper);
}

HWY_INLINE FromBox boxOf(const LaneBody& body) {
  return {{constant(body.half[0]), constant(body.half[1]), constant(body.half[2])}};
}

HWY_INLINE FromCylinder cylinderOf(const LaneBody& body) {
  return {constant(body.half[0]), constant(body.half[2])};
}

/// Bounds of the distance of a and b, where the kind of a is not listed after b's. A segment's Placed has its
/// last axis only.
HWY_INLINE Bounds distanceOf(const LaneBody& a, const Placed& pa, const LaneBody& b, const Placed& pb,
                             const Question& question) {
  V way[3];
  difference(pa.middle, pb.middle, way);
  if (a.kind == LaneKind::kSegment) {
    V v[3], p_b[3], v_b[3];
    for (int i = 0; i < 3; ++i) v[i] = hn::Mul(pa.axis[2][i], constant(a.half[2]));
    if (b.kind == LaneKind::kSegment) {
      V vb[3];
      for (int i = 0; i < 3; ++i) vb[i] = hn::Mul(pb.axis[2][i], constant(b.half[2]));
      return segmentToSegment(way, v, vb, a.radius + b.radius);
    }
    along(pb, way, p_b);
    along(pb, v, v_b);
    if (b.kind == LaneKind::kCylinder) return segmentToSolid(p_b, v_b, a.radius, cylinderOf(b), question);
    Bounds bounds = segmentToSolid(p_b, v_b, a.radius, boxOf(b), question);
    if (b.kind == LaneKind::kBox) return bounds;
    bounds.upper = constant(kFar);
    if (b.mesh && !question.answered(bounds)) meshFaces(b, pb, a, pa, way, bounds);
    return bounds;
  }
  Bounds bounds = boxToBox(a, b, way, pa, pb, question, a.margin + b.margin);
  if (question.answered(bounds)) return bounds;
  const bool meshes = a.mesh || b.mesh;
  if (!meshes && question.free(bounds)) return bounds;
  V back[3];
  for (int i = 0; i < 3; ++i) back[i] = hn::Neg(way[i]);
  if (b.kind == LaneKind::kCylinder) {
    V p[3], axis[3];
    along(pa, back, p);
    along(pa, pb.axis[2], axis);
    if (a.kind == LaneKind::kBox)
      roundCylinder(b, p, axis, boxOf(a), question, bounds);
    else
      roundCylinder(b, p, axis, cylinderOf(a), question, bounds);
  }
  if (b.mesh) {
    if (a.kind != LaneKind::kCylinder) meshVertices(b, pb, a, pa, back, bounds);
    if (!question.answered(bounds)) meshFaces(b, pb, a, pa, way, bounds);
  }
  if (a.mesh && !question.answered(bounds)) meshFaces(a, pa, b, pb, back, bounds);
  return bounds;
}

}  // namespace b4p::lanes::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
