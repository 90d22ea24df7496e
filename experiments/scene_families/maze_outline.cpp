// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/scene_families/maze_outline.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace b4p {
namespace {

using Eigen::Vector2d;

constexpr double kPi = 3.14159265358979323846;

/// robots/urdf/planar_gripper.urdf: the body's box, and the bar at its front, which the TCP is in the middle
/// of.
const Vector2d kBody_m(0.30, 0.20), kBar_m(0.03, 0.12);

double cross(const Vector2d& a, const Vector2d& b) { return a.x() * b.y() - a.y() * b.x(); }

/// Corners of a box whose front is `behind` m behind `front`, approaching along `ahead`.
void addBox(Outline& points, const Vector2d& front, const Vector2d& ahead, const Vector2d& size,
            double behind) {
  const Vector2d left(-ahead.y(), ahead.x());
  for (const double back : {behind, behind + size.x()})
    for (const double side : {-0.5, 0.5}) points.push_back(front - back * ahead + side * size.y() * left);
}

/// How far points reach in directions a fifth of a degree apart, which is enough for widths to a part in
/// 10^5.
class Reach {
 public:
  Reach() : low_(kDirections, std::numeric_limits<double>::max()), high_(kDirections, -low_[0]) {}

  void add(const Outline& points) {
    for (std::size_t i = 0; i < kDirections; ++i) {
      const double angle = kPi * static_cast<double>(i) / kDirections;
      const Vector2d direction(std::cos(angle), std::sin(angle));
      for (const Vector2d& point : points) {
        const double along = direction.dot(point);
        low_[i] = std::min(low_[i], along);
        high_[i] = std::max(high_[i], along);
      }
    }
  }

  double leastWidth() const {
    double least = std::numeric_limits<double>::max();
    for (std::size_t i = 0; i < kDirections; ++i) least = std::min(least, high_[i] - low_[i]);
    return least;
  }

 private:
  static constexpr std::size_t kDirections = 900;
  std::vector<double> low_, high_;
};

Outline oneDraw(Jitter& jitter) {
  constexpr int kCorners = 21;
  constexpr double kHalfLength_m = 0.30, kHalfWidth_m = 0.14, kTurn = 0.35, kIn = 0.78, kOut = 1.10;
  constexpr double kPerMetre = 1000.0;
  Outline outline;
  for (int i = 0; i < kCorners; ++i) {
    const double angle = 2.0 * kPi * (i + kTurn * (2.0 * jitter.unit() - 1.0)) / kCorners;
    const Vector2d direction(std::cos(angle), std::sin(angle));
    const double ellipse = 1.0 / std::hypot(direction.x() / kHalfLength_m, direction.y() / kHalfWidth_m);
    const double radius = ellipse * (kIn + (kOut - kIn) * jitter.unit());
    outline.emplace_back((radius * direction * kPerMetre).array().round() / kPerMetre);
  }
  return outline;
}

double lead(const Outline& outline) {
  constexpr double kClearance_m = 0.01;
  std::vector<double> widths = graspWidths(outline, kClearance_m);
  std::partial_sort(widths.begin(), widths.begin() + 2, widths.end());
  return widths[1] - widths[0];
}

}  // namespace

Outline standardOutline() {
  return {{0.104, -0.124},  {0.16, -0.147},   {0.185, -0.13},   {0.304, -0.016},  {0.202, 0.085},
          {0.174, 0.13},    {0.115, 0.123},   {0.041, 0.112},   {-0.015, 0.109},  {-0.066, 0.111},
          {-0.118, 0.118},  {-0.173, 0.128},  {-0.241, 0.136},  {-0.291, 0.056},  {-0.296, -0.053},
          {-0.248, -0.134}, {-0.183, -0.124}, {-0.131, -0.113}, {-0.069, -0.115}, {-0.006, -0.109},
          {0.046, -0.116}};
}

Outline drawnOutline(Jitter& jitter) {
  constexpr int kDraws = 60;
  Outline best;
  double best_lead = -1.0;
  for (int draw = 0; draw < kDraws; ++draw) {
    Outline outline = oneDraw(jitter);
    const double its_lead = lead(outline);
    if (its_lead <= best_lead) continue;
    best_lead = its_lead;
    best = std::move(outline);
  }
  return best;
}

std::vector<double> graspWidths(const Outline& outline, double clearance_m) {
  Reach object;
  object.add(outline);
  std::vector<double> widths;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const Vector2d& a = outline[i];
    const Vector2d& b = outline[(i + 1) % outline.size()];
    const Vector2d along = (b - a).normalized(), inward(-along.y(), along.x());
    const Vector2d tcp = (a + b) / 2.0 - clearance_m * inward;
    Outline robot;
    addBox(robot, tcp, inward, kBar_m, 0.0);
    addBox(robot, tcp, inward, kBody_m, kBar_m.x());
    Reach both = object;
    both.add(robot);
    widths.push_back(both.leastWidth());
  }
  return widths;
}

std::vector<Outline> convexSectors(const Outline& outline) {
  const std::size_t n = outline.size();
  const auto corner = [&](std::size_t i) { return outline[i % n]; };
  std::vector<Outline> sectors;
  for (std::size_t first = 0; first < n;) {
    std::size_t last = first + 1;
    // Another corner is taken in while the sector turns left at the one before and stays below half a turn.
    while (last < n && cross(corner(last) - corner(last - 1), corner(last + 1) - corner(last)) >= 0.0 &&
           cross(corner(first), corner(last + 1)) > 0.0)
      ++last;
    Outline sector{Vector2d::Zero()};
    for (std::size_t i = first; i <= last; ++i) sector.push_back(corner(i));
    sectors.push_back(std::move(sector));
    first = last;
  }
  return sectors;
}

}  // namespace b4p
