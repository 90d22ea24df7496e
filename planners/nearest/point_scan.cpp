// SPDX-License-Identifier: BSD-3-Clause
#include "planners/nearest/point_scan.h"

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
  Scan(const PointBlocks& points, const float* q, float limit)
      : points_(points), q_(q), limit_(hn::Set(d_, limit)) {
    for (int i = 0; i < kDimension; ++i) at_[i] = hn::Set(d_, q[i]);
  }

  std::size_t run(std::size_t block, float* squares) const {
    const std::size_t full = points_.count / kBlockPoints, rest = points_.count % kBlockPoints;
    const std::size_t floats = static_cast<std::size_t>(dimension()) * kBlockPoints;
    const float* values = points_.values + block * floats;
    for (; block < full; ++block, values += floats) {
      V least = whole(values, 0);
      for (std::size_t lane = width_; lane < kBlockPoints; lane += width_)
        least = hn::Min(least, whole(values, lane));
      if (hn::AllTrue(d_, hn::Gt(least, limit_))) continue;
      for (std::size_t lane = 0; lane < kBlockPoints; lane += width_)
        hn::StoreU(whole(values, lane), d_, squares + lane);
      return block;
    }
    if (block > full || rest == 0) return block;
    V least = hn::Set(d_, std::numeric_limits<float>::infinity());
    for (std::size_t lane = 0; lane < rest; lane += width_) {
      const V square = part(values, lane, rest - lane);
      hn::StoreU(square, d_, squares + lane);
      least = hn::Min(least, square);
    }
    return hn::AllTrue(d_, hn::Gt(least, limit_)) ? block + 1 : block;
  }

 private:
  int dimension() const { return kDimension > 0 ? kDimension : points_.dimension; }
  V at(int i) const { return kDimension > 0 ? at_[i] : hn::Set(d_, q_[i]); }

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
  const V limit_;
  V at_[kDimension > 0 ? kDimension : 1];
};

std::size_t firstBlockWithin(const PointBlocks& points, const float* q, float limit, std::size_t block,
                             float* squares) {
  switch (points.dimension) {
    case 2:
      return Scan<2>(points, q, limit).run(block, squares);
    case 3:
      return Scan<3>(points, q, limit).run(block, squares);
    case 6:
      return Scan<6>(points, q, limit).run(block, squares);
    case 7:
      return Scan<7>(points, q, limit).run(block, squares);
    default:
      return Scan<0>(points, q, limit).run(block, squares);
  }
}

const char* scanInstructionSet() { return hwy::TargetName(HWY_TARGET); }

}  // namespace b4p::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace b4p {

HWY_EXPORT(firstBlockWithin);
HWY_EXPORT(scanInstructionSet);

std::size_t firstBlockWithin(const PointBlocks& points, const float* q, float limit, std::size_t block,
                             float* squares) {
  return HWY_DYNAMIC_DISPATCH(firstBlockWithin)(points, q, limit, block, squares);
}

const char* scanInstructionSet() { return HWY_DYNAMIC_DISPATCH(scanInstructionSet)(); }

}  // namespace b4p
#endif  // HWY_ONCE
