// SPDX-License-Identifier: BSD-3-Clause
// Promises of the point index: the nearest point is that of an exhaustive search in double precision, of
// several the one added first, whatever the dimension, the scale, duplicates and the instruction set; under
// concurrent use each point is found as soon as it has been added, and no answer is off by a half-written
// point.
#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <limits>
#include <random>
#include <set>
#include <string>
#include <thread>
#include <tuple>
#include <vector>

#include <gtest/gtest.h>
#include <hwy/targets.h>

#include "planners/nearest/point_index.h"
#include "planners/nearest/point_scan.h"

namespace b4p {
namespace {

using Point = std::vector<double>;
using Points = std::vector<Point>;

class Draw {
 public:
  Draw(int dimension, unsigned seed) : dimension_(dimension), random_(seed) {}

  Point uniform(double scale = 3.0) {
    return filled([&](int) { return std::uniform_real_distribution<double>(-scale, scale)(random_); });
  }
  Point around(const Point& centre, double deviation) {
    return filled([&](int i) {
      return centre[static_cast<std::size_t>(i)] + std::normal_distribution<double>(0.0, deviation)(random_);
    });
  }
  Point onGrid() {
    return filled([&](int) { return std::uniform_int_distribution<int>(-2, 2)(random_); });
  }
  const Point& oneOf(const Points& points) {
    return points[std::uniform_int_distribution<std::size_t>(0, points.size() - 1)(random_)];
  }

 private:
  template <class Value>
  Point filled(Value value) {
    Point point;
    for (int i = 0; i < dimension_; ++i) point.push_back(value(i));
    return point;
  }

  int dimension_;
  std::mt19937_64 random_;
};

double squareBetween(const Point& a, const Point& b) {
  double square = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) square += (a[i] - b[i]) * (a[i] - b[i]);
  return square;
}

const Point* firstNearest(const Points& points, std::size_t count, const Point& q) {
  const Point* near = nullptr;
  for (std::size_t i = 0; i < count; ++i)
    if (near == nullptr || squareBetween(points[i], q) < squareBetween(*near, q)) near = &points[i];
  return near;
}

enum class Kind { kUniform, kTree, kClusters, kGrid, kSame, kTiny, kHuge, kFarOff };

Points drawPoints(Kind kind, std::size_t count, Draw& draw) {
  Points points;
  Point centre = draw.uniform();
  const Point offset = draw.uniform(1e6);
  while (points.size() < count) {
    switch (kind) {
      case Kind::kUniform:
        points.push_back(draw.uniform());
        break;
      case Kind::kTree:
        points.push_back(draw.around(points.empty() ? centre : draw.oneOf(points), 0.1));
        break;
      case Kind::kClusters:
        if (points.size() % 400 == 0) centre = draw.uniform();
        points.push_back(draw.around(centre, 1e-7));
        break;
      case Kind::kGrid:
        points.push_back(draw.onGrid());
        break;
      case Kind::kSame:
        points.push_back(centre);
        break;
      case Kind::kTiny:
        points.push_back(draw.uniform(1e-30));
        break;
      case Kind::kHuge:
        points.push_back(draw.uniform(1e60));
        break;
      case Kind::kFarOff:
        points.push_back(draw.around(offset, 0.01));
        break;
    }
  }
  return points;
}

class PointIndexEqualsExhaustiveSearch : public ::testing::TestWithParam<std::tuple<int, Kind, std::size_t>> {
};

TEST_P(PointIndexEqualsExhaustiveSearch, WhileItGrows) {
  const auto [dimension, kind, leaf_points] = GetParam();
  Draw draw(dimension, 7);
  const Points points = drawPoints(kind, 3000, draw);
  PointIndex index(dimension, leaf_points);
  EXPECT_EQ(index.nearest(points[0].data()), nullptr);
  for (std::size_t i = 0; i < points.size(); ++i) {
    index.add(points[i].data(), &points[i]);
    ASSERT_EQ(index.size(), i + 1);
    if (i > 100 && i % 20 != 0) continue;
    for (const Point& q : {draw.uniform(), draw.oneOf(points), draw.around(draw.oneOf(points), 1e-8),
                           draw.around(draw.oneOf(points), 0.3)}) {
      ASSERT_EQ(index.nearest(q.data()), firstNearest(points, i + 1, q)) << "of " << i + 1;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Sets, PointIndexEqualsExhaustiveSearch,
                         ::testing::Combine(::testing::Values(1, 2, 3, 7, 9, PointIndex::kMostDimensions),
                                            ::testing::Values(Kind::kUniform, Kind::kTree, Kind::kClusters,
                                                              Kind::kGrid, Kind::kSame, Kind::kTiny,
                                                              Kind::kHuge, Kind::kFarOff),
                                            ::testing::Values(16, PointIndex::kLeafPoints)));

TEST(PointIndex, AnswersTheSameWithEveryInstructionSet) {
  Draw draw(7, 11);
  const Points points = drawPoints(Kind::kTree, 5000, draw);
  Points queries;
  while (queries.size() < 500) queries.push_back(draw.around(draw.oneOf(points), 0.3));
  std::set<std::string> sets;
  const std::int64_t supported = hwy::SupportedTargets();
  for (std::int64_t left = supported; left != 0; left &= left - 1) {
    hwy::SetSupportedTargetsForTest(left & -left);
    hwy::GetChosenTarget().Update(left & -left);
    if (!sets.insert(scanInstructionSet()).second) continue;
    PointIndex index(7);
    for (const Point& point : points) index.add(point.data(), &point);
    for (const Point& q : queries)
      ASSERT_EQ(index.nearest(q.data()), firstNearest(points, points.size(), q)) << scanInstructionSet();
  }
  hwy::SetSupportedTargetsForTest(0);
  hwy::GetChosenTarget().Update(supported);
  EXPECT_GE(sets.size(), 2u);
}

TEST(PointIndex, AnswersAQueryThatIsNotFinite) {
  Draw draw(3, 5);
  const Points points = drawPoints(Kind::kUniform, 2000, draw);
  PointIndex index(3);
  for (const Point& point : points) index.add(point.data(), &point);
  for (const double value : {std::numeric_limits<double>::infinity(), std::nan("")})
    EXPECT_NE(index.nearest(Point{0.0, value, 0.0}.data()), nullptr);
}

// Readers know what has been added before they ask, and what may have been when they have their answer.
TEST(PointIndex, AnswersWithWhatHasBeenAddedWhileOthersAdd) {
  constexpr std::size_t kWriters = 3, kReaders = 2, kEach = 4000;
  Draw draw(7, 13);
  const Points points = drawPoints(Kind::kTree, kWriters * kEach, draw);
  PointIndex index(7, 64);
  std::array<std::atomic<std::size_t>, kWriters> added{};
  std::atomic<std::size_t> lost{0}, farther{0}, early{0}, asked{0};
  std::vector<std::thread> threads;
  for (std::size_t w = 0; w < kWriters; ++w)
    threads.emplace_back([&, w] {
      for (std::size_t i = 0; i < kEach; ++i) {
        while (asked < i / 100) std::this_thread::yield();
        const Point& mine = points[w * kEach + i];
        index.add(mine.data(), &mine);
        added[w].store(i + 1);
        if (index.nearest(mine.data()) != &mine) ++lost;
      }
    });
  for (std::size_t r = 0; r < kReaders; ++r)
    threads.emplace_back([&, r] {
      Draw mine(7, static_cast<unsigned>(100 + r));
      const auto unfinished = [](const std::atomic<std::size_t>& count) { return count < kEach; };
      while (std::any_of(added.begin(), added.end(), unfinished)) {
        // Memory that nobody has written to tends to be the origin, which is far from all points.
        const Point q = mine.around(asked % 2 == 0 ? Point(7, 0.0) : mine.oneOf(points), 0.2);
        std::array<std::size_t, kWriters> before{};
        for (std::size_t w = 0; w < kWriters; ++w) before[w] = added[w];
        const auto* near = static_cast<const Point*>(index.nearest(q.data()));
        ++asked;
        if (near == nullptr) {
          lost += before[0] + before[1] + before[2];
          continue;
        }
        const double square = squareBetween(*near, q);
        for (std::size_t w = 0; w < kWriters; ++w)
          for (std::size_t i = 0; i < before[w]; ++i)
            if (squareBetween(points[w * kEach + i], q) < square) ++farther;
        const auto number = static_cast<std::size_t>(near - points.data());
        if (number % kEach > added[number / kEach]) ++early;
      }
    });
  for (std::thread& thread : threads) thread.join();
  EXPECT_EQ(lost, 0u);
  EXPECT_EQ(farther, 0u);
  EXPECT_EQ(early, 0u);
  EXPECT_EQ(index.size(), points.size());
  for (const Point& point : points) ASSERT_EQ(index.nearest(point.data()), &point);
}

}  // namespace
}  // namespace b4p
