// SPDX-License-Identifier: BSD-3-Clause
// A plane whose motions have a direction: along x first, then along y, so the way back is another one.
#pragma once

#include <algorithm>
#include <cmath>
#include <utility>

#include <ompl/base/spaces/RealVectorStateSpace.h>

namespace b4p::test {

/// OMPL's own space with directed motions is Dubins', whose code (1.5.2) asserts an accuracy that it misses
/// once in some million motions.
class ManhattanSpace : public ompl::base::RealVectorStateSpace {
 public:
  ManhattanSpace() : RealVectorStateSpace(2) {}

  double distance(const ompl::base::State* a, const ompl::base::State* b) const override {
    return along(a, b, 0) + along(a, b, 1);
  }

  double getMaximumExtent() const override {
    const ompl::base::RealVectorBounds& bounds = getBounds();
    return bounds.high[0] - bounds.low[0] + bounds.high[1] - bounds.low[1];
  }

  void interpolate(const ompl::base::State* from, const ompl::base::State* to, double t,
                   ompl::base::State* state) const override {
    const double along_x = along(from, to, 0), way = t * distance(from, to);
    const double x = along_x == 0.0 ? 1.0 : std::min(1.0, way / along_x);
    const double along_y = along(from, to, 1);
    const double y = along_y == 0.0 ? 1.0 : std::clamp((way - along_x) / along_y, 0.0, 1.0);
    for (const auto& [axis, share] : {std::pair{0u, x}, std::pair{1u, y}})
      at(state, axis) =
          share == 1.0 ? at(to, axis) : at(from, axis) + share * (at(to, axis) - at(from, axis));
  }

  bool hasSymmetricInterpolate() const override { return false; }

 private:
  static double at(const ompl::base::State* s, unsigned axis) { return s->as<StateType>()->values[axis]; }
  static double& at(ompl::base::State* s, unsigned axis) { return s->as<StateType>()->values[axis]; }

  static double along(const ompl::base::State* a, const ompl::base::State* b, unsigned axis) {
    return std::abs(at(a, axis) - at(b, axis));
  }
};

}  // namespace b4p::test
