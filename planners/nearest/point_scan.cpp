// SPDX-License-Identifier: BSD-3-Clause
#include "planners/nearest/point_scan.h"

#include <algorithm>
#include <limits>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "planners/nearest/point_scan.cpp"
#include <hwy/foreach_target.h>  // compiles this file once per instruction set
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace b4p::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

using Lanes = hn::CappedTag<float, kBlockPoints>;
using V = hn::Vec<Lanes>;

/// A dimension of 0 stands for any.
template <int kDimension>
class Scan {
 public:
  Scan(const PointBlocks& points, const float* q) : points_(points), q_(q) {
    for (int i = 0; i < kDimension; ++i) at_[i] = hn::Set(d_, q[i]);
  }

  float run(float* squares) const {
    const std::size_t whole_blocks = points_.count / kBlockPoints, rest = points_.count % kBlockPoints;
    const std::size_t floats = static_cast<std::size_t>(dimension()) * kBlockPoints;
    const float* values = points_.values;
    V least = hn::Set(d_, std::numeric_limits<float>::infinity());
    for (std::size_t block = 0; block < whole_blocks; ++block, values += floats, squares += kBlockPoints)
      for (std::size_t lane = 0; lane < kBlockPoints; lane += width_)
        least = keep(whole(values, lane), squares + lane, least);
    for (std::size_t lane = 0; rest > 0 && lane < kBlockPoints; lane += width_)
      least = keep(part(values, lane, rest - std::min(rest, lane)), squares + lane, least);
    return hn::GetLane(hn::MinOfLanes(d_, least));
  }

 private:
  int dimension() const { return kDimension > 0 ? kDimension : points_.dimension; }
  V at(int i) const { return kDimension > 0 ? at_[i] : hn::Set(d_, q_[i]); }

  V keep(V square, float* to, V least) const {
    hn::Store(square, d_, to);
    return hn::Min(least, square);
  }

  V whole(const float* values, std::size_t lane) const {
    V square = hn::Zero(d_);
    for (int i = 0; i < dimension(); ++i) {
      const V apart =
          hn::Sub(hn::Load(d_, values + static_cast<std::size_t>(i) * kBlockPoints + lane), at(i));
      square = hn::MulAdd(apart, apart, square);
    }
    return square;
  }

  // The first `count` lanes; the others are not loaded, and infinitely far.
  V part(const float* values, std::size_t lane, std::size_t count) const {
    const auto there = hn::FirstN(d_, count);
    V square = hn::Zero(d_);
    for (int i = 0; i < dimension(); ++i) {
      const float* from = values + static_cast<std::size_t>(i) * kBlockPoints + lane;
      const V apart = hn::Sub(hn::MaskedLoad(there, d_, from), at(i));
      square = hn::MulAdd(apart, apart, square);
    }
    return hn::IfThenElse(there, square, hn::Set(d_, std::numeric_limits<float>::infinity()));
  }

  const Lanes d_{};
  const std::size_t width_ = hn::Lanes(d_);
  const PointBlocks& points_;
  const float* q_;
  V at_[kDimension > 0 ? kDimension : 1];
};

float squaredDistances(const PointBlocks& points, const float* q, float* squares) {
  switch (points.dimension) {
    case 2:
      return Scan<2>(points, q).run(squares);
    case 3:
      return Scan<3>(points, q).run(squares);
    case 6:
      return Scan<6>(points, q).run(squares);
    case 7:
      return Scan<7>(points, q).run(squares);
    default:
      return Scan<0>(points, q).run(squares);
  }
}

std::size_t firstWithin(const float* squares, std::size_t count, float limit, std::size_t index) {
  const Lanes d;
  const V most = hn::Set(d, limit);
  const std::size_t width = hn::Lanes(d);
  for (; index < count && index % width != 0; ++index)
    if (!(squares[index] > limit)) return index;
  for (; index < count; index += width) {
    const auto found = hn::FindFirstTrue(d, hn::Le(hn::Load(d, squares + index), most));
    if (found >= 0) return index + static_cast<std::size_t>(found);
  }
  return index;
}

const char* scanInstructionSet() { return hwy::TargetName(HWY_TARGET); }

}  // namespace b4p::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace b4p {

HWY_EXPORT(squaredDistances);
HWY_EXPORT(firstWithin);
HWY_EXPORT(scanInstructionSet);

float squaredDistances(const PointBlocks& points, const float* q, float* squares) {
  return HWY_DYNAMIC_DISPATCH(squaredDistances)(points, q, squares);
}

std::size_t firstWithin(const float* squares, std::size_t count, float limit, std::size_t index) {
  return HWY_DYNAMIC_DISPATCH(firstWithin)(squares, count, limit, index);
}

const char* scanInstructionSet() { return HWY_DYNAMIC_DISPATCH(scanInstructionSet)(); }

}  // namespace b4p
#endif  // HWY_ONCE
