// SPDX-License-Identifier: BSD-3-Clause
// What the nearest neighbour of a configuration costs, and adding one: the point index, with leaves of
// several sizes, and OMPL's GNAT. Arguments: joints, points, and the points of a full leaf (0: GNAT). The
// points are those of a random tree, which grows by steps of 0.3 toward random configurations, or uniform;
// queries are uniform.
#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <random>
#include <utility>
#include <vector>

#include <benchmark/benchmark.h>
#include <ompl/datastructures/NearestNeighborsGNAT.h>

#include "planners/nearest/point_index.h"

namespace b4p {
namespace {

constexpr std::size_t kQueries = 1024;
constexpr double kLimit = 2.8, kStep = 0.3;

struct Points {
  int dof;
  std::vector<double> values;
  const double* at(std::size_t i) const { return values.data() + i * static_cast<std::size_t>(dof); }
  std::size_t size() const { return values.size() / static_cast<std::size_t>(dof); }
};

Points uniform(int dof, std::size_t count, unsigned seed) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<> angle(-kLimit, kLimit);
  Points points{dof, {}};
  points.values.reserve(count * static_cast<std::size_t>(dof));
  for (std::size_t i = 0; i < count * static_cast<std::size_t>(dof); ++i)
    points.values.push_back(angle(random));
  return points;
}

Points randomTree(int dof, std::size_t count) {
  const Points goals = uniform(dof, count, 2);
  Points points{dof, {}};
  points.values.reserve(goals.values.size());
  points.values.insert(points.values.end(), goals.at(0), goals.at(1));
  PointIndex index(dof);
  index.add(points.at(0), points.at(0));
  for (std::size_t i = 1; i < count; ++i) {
    const auto* near = static_cast<const double*>(index.nearest(goals.at(i)));
    double square = 0.0;
    for (int j = 0; j < dof; ++j) square += (goals.at(i)[j] - near[j]) * (goals.at(i)[j] - near[j]);
    const double part = std::min(1.0, kStep / std::sqrt(square));
    for (int j = 0; j < dof; ++j) points.values.push_back(near[j] + part * (goals.at(i)[j] - near[j]));
    index.add(points.at(i), points.at(i));
  }
  return points;
}

const Points& pointsOf(bool tree, int dof, std::size_t count) {
  static std::map<std::pair<bool, int>, Points> known;
  Points& points = known[{tree, dof}];
  if (points.dof == 0 || points.size() < count)
    points = tree ? randomTree(dof, count) : uniform(dof, count, 1);
  return points;
}

class Gnat {
 public:
  explicit Gnat(int dof) {
    nodes_.setDistanceFunction([dof](const double* a, const double* b) {
      double square = 0.0;
      for (int i = 0; i < dof; ++i) square += (a[i] - b[i]) * (a[i] - b[i]);
      return std::sqrt(square);
    });
  }
  void add(const double* q) { nodes_.add(q); }
  const void* nearest(const double* q) const { return nodes_.nearest(q); }
  double bytes() const { return 0.0; }

 private:
  ompl::NearestNeighborsGNAT<const double*> nodes_;
};

class Index {
 public:
  Index(int dof, std::size_t leaf_points) : points_(dof, leaf_points) {}
  void add(const double* q) { points_.add(q, q); }
  const void* nearest(const double* q) const { return points_.nearest(q); }
  double bytes() const { return static_cast<double>(points_.bytes()); }

 private:
  PointIndex points_;
};

template <class Neighbours>
void ask(benchmark::State& state, const Points& points, Neighbours& index, std::size_t count) {
  static const std::map<int, Points> queries{{3, uniform(3, kQueries, 3)}, {7, uniform(7, kQueries, 3)}};
  for (std::size_t i = 0; i < count; ++i) index.add(points.at(i));
  const Points& asked = queries.at(points.dof);
  std::size_t i = 0;
  for (auto _ : state) benchmark::DoNotOptimize(index.nearest(asked.at(i++ % kQueries)));
  state.counters["bytes_per_point"] = index.bytes() / static_cast<double>(count);
}

void query(benchmark::State& state, bool tree) {
  const auto dof = static_cast<int>(state.range(0));
  const auto count = static_cast<std::size_t>(state.range(1)),
             leaf_points = static_cast<std::size_t>(state.range(2));
  const Points& points = pointsOf(tree, dof, count);
  if (leaf_points == 0) {
    Gnat gnat(dof);
    ask(state, points, gnat, count);
  } else {
    Index index(dof, leaf_points);
    ask(state, points, index, count);
  }
}

template <class Make>
void build(benchmark::State& state, const Points& points, std::size_t count, Make make) {
  for (auto _ : state) {
    auto index = make();
    for (std::size_t i = 0; i < count; ++i) index->add(points.at(i));
    benchmark::DoNotOptimize(index);
  }
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(count));
}

void insert(benchmark::State& state, bool tree) {
  const auto dof = static_cast<int>(state.range(0));
  const auto count = static_cast<std::size_t>(state.range(1)),
             leaf_points = static_cast<std::size_t>(state.range(2));
  const Points& points = pointsOf(tree, dof, count);
  if (leaf_points == 0)
    build(state, points, count, [&] { return std::make_unique<Gnat>(dof); });
  else
    build(state, points, count, [&] { return std::make_unique<Index>(dof, leaf_points); });
}

void sizes(benchmark::internal::Benchmark* benchmark) {
  for (const int dof : {7, 3})
    for (const int count : {10, 100, 1000, 10000, 100000, 1000000})
      for (const int leaf_points : {0, 128, 256, 512, 1024, 4096})
        if (leaf_points <= 128 || 2 * count > leaf_points) benchmark->Args({dof, count, leaf_points});
}

BENCHMARK_CAPTURE(query, tree, true)->Apply(sizes);
BENCHMARK_CAPTURE(query, uniform, false)->Apply(sizes);
BENCHMARK_CAPTURE(insert, tree, true)->Apply(sizes);

}  // namespace
}  // namespace b4p

BENCHMARK_MAIN();
