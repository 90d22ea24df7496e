// SPDX-License-Identifier: BSD-3-Clause
#include "planners/nearest/point_index.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <new>

#include "planners/nearest/point_scan.h"

namespace b4p {
namespace {

constexpr float kLargest = std::numeric_limits<float>::max();
constexpr float kInfinity = std::numeric_limits<float>::infinity();
constexpr std::size_t kAlign = 64;

// Finite for all values.
float single(double value) {
  if (!(value > -kLargest)) return -kLargest;
  return value < kLargest ? static_cast<float>(value) : kLargest;
}

struct FreeAligned {
  void operator()(float* floats) const { ::operator delete(floats, std::align_val_t(kAlign)); }
};
using AlignedFloats = std::unique_ptr<float[], FreeAligned>;

AlignedFloats alignedFloats(std::size_t count) {
  return AlignedFloats(new (::operator new(count * sizeof(float), std::align_val_t(kAlign))) float[count]);
}

// Chunk k holds numbers from chunkBegin(k) on.
unsigned chunkOf(std::uint32_t number) {
  return number < kBlockPoints ? 0u : 28u - static_cast<unsigned>(__builtin_clz(number));
}
std::uint32_t chunkBegin(unsigned chunk) { return chunk == 0 ? 0u : 8u << chunk; }
std::size_t chunkSize(unsigned chunk) { return chunk == 0 ? 16u : std::size_t{8} << chunk; }

}  // namespace

struct PointIndex::Cell {
  explicit Cell(bool leaf) : is_leaf(leaf) {}
  const bool is_leaf;
};

struct PointIndex::Leaf : Cell {
  Leaf(int dimension, std::size_t points)
      : Cell(true),
        capacity(points),
        floats_per_block(static_cast<std::size_t>(dimension) * kBlockPoints),
        values(alignedFloats(points / kBlockPoints * floats_per_block)),
        numbers(new std::uint32_t[points]) {}

  float& at(std::size_t point, int axis) const {
    return values[point / kBlockPoints * floats_per_block + static_cast<std::size_t>(axis) * kBlockPoints +
                  point % kBlockPoints];
  }

  void append(std::uint32_t number, const float* q, int dimension) {
    const std::size_t point = count.load(std::memory_order_relaxed);
    for (int i = 0; i < dimension; ++i) at(point, i) = q[i];
    numbers[point] = number;
    count.store(point + 1, std::memory_order_release);
  }

  const std::size_t capacity;
  const std::size_t floats_per_block;
  const AlignedFloats values;
  const std::unique_ptr<std::uint32_t[]> numbers;  ///< in the order of joining
  std::atomic<std::size_t> count{0};
};

struct PointIndex::Split : Cell {
  Split(int on_axis, float at_value, Cell* below, Cell* above)
      : Cell(false), axis(on_axis), value(at_value), side{{below}, {above}} {}
  Slot& sideOf(const float* q) { return side[q[axis] < value ? 0 : 1]; }

  const int axis;
  const float value;
  Slot side[2];
};

/// One search, depth first, nearer sides before farther ones.
class PointIndex::Query {
 public:
  Query(const PointIndex& index, const double* q, std::size_t seen) : index_(index), exact_(q), seen_(seen) {
    double reach = index.reach_.load(std::memory_order_relaxed);
    for (int i = 0; i < index.dimension_; ++i) {
      q_[i] = single(q[i]);
      offset_[i] = 0.0;
      if (!(std::abs(q[i]) <= reach)) reach = std::abs(q[i]);
    }
    // Bounds of what single precision adds to a distance or takes away: coordinates are rounded, and so are
    // the steps of the sum.
    constexpr double kRounding = std::numeric_limits<float>::epsilon();
    share_ = 1.0 + (index.dimension_ + 4) * kRounding;
    slack_ = 2.0 * std::sqrt(index.dimension_) * kRounding * reach;
    tiny_ = 4.0 * index.dimension_ * std::numeric_limits<float>::min();
  }

  const void* run() {
    visit(*index_.root_.load(std::memory_order_acquire), 0.0);
    keepWithinLimit();
    if (candidates_ > 1 || best_ != kNone) settle();
    return index_.entry(best_ != kNone ? best_ : candidate_[0].number).item;
  }

 private:
  static constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();
  static constexpr std::size_t kCandidates = 16;
  static constexpr std::size_t kScanned = 512;  ///< at once
  struct Candidate {
    float square;
    std::uint32_t number;
  };

  // `outside`: squared distance from q to the cell.
  void visit(const Cell& cell, double outside) {
    if (cell.is_leaf) return scan(static_cast<const Leaf&>(cell));
    const auto& split = static_cast<const Split&>(cell);
    const double way = static_cast<double>(q_[split.axis]) - split.value;
    const int near = way < 0.0 ? 0 : 1;
    visit(*split.side[near].load(std::memory_order_acquire), outside);
    double& offset = offset_[split.axis];
    const double before = offset;
    const double beyond = outside - before * before + way * way;
    if (beyond > limit_) return;
    offset = way;
    visit(*split.side[1 - near].load(std::memory_order_acquire), beyond);
    offset = before;
  }

  void scan(const Leaf& leaf) {
    std::size_t count = leaf.count.load(std::memory_order_acquire);
    while (count > 0 && leaf.numbers[count - 1] >= seen_) --count;
    alignas(kAlign) float squares[kScanned];
    for (std::size_t first = 0; first < count; first += kScanned) {
      const std::size_t part = std::min(kScanned, count - first);
      const float least = squaredDistances({&leaf.at(first, 0), part, index_.dimension_}, q_, squares);
      if (least > limit_) continue;
      if (least < least_) lower(least);
      for (std::size_t i = 0; (i = firstWithin(squares, part, limit_, i)) < part; ++i)
        consider({squares[i], leaf.numbers[first + i]});
    }
  }

  void consider(const Candidate& candidate) {
    if (candidates_ == kCandidates) keepWithinLimit();
    if (candidates_ == kCandidates) settle();
    candidate_[candidates_++] = candidate;
  }

  // The largest squared distance that a point can have here, or a cell, if in truth it is no farther than one
  // that has `square` here.
  void lower(float square) {
    least_ = square;
    const double distance = (std::sqrt(square + tiny_) * share_ + slack_) * share_ + slack_;
    const double widened = (distance * distance + tiny_) * share_;
    const float limit = widened < kLargest ? static_cast<float>(widened) : kInfinity;
    limit_ = std::min(limit_, limit);
  }

  void keepWithinLimit() {
    std::size_t kept = 0;
    for (std::size_t i = 0; i < candidates_; ++i)
      if (!(candidate_[i].square > limit_)) candidate_[kept++] = candidate_[i];
    candidates_ = kept;
  }

  void settle() {
    for (std::size_t i = 0; i < candidates_; ++i) {
      const std::uint32_t number = candidate_[i].number;
      const double square = exactSquare(index_.entry(number).q);
      const bool nearer = square < best_square_ || (square == best_square_ && number < best_);
      if (best_ != kNone && !nearer) continue;
      best_ = number;
      best_square_ = square;
    }
    candidates_ = 0;
  }

  double exactSquare(const double* q) const {
    double square = 0.0;
    for (int i = 0; i < index_.dimension_; ++i) square += (q[i] - exact_[i]) * (q[i] - exact_[i]);
    return square < std::numeric_limits<double>::infinity() ? square
                                                            : std::numeric_limits<double>::infinity();
  }

  const PointIndex& index_;
  const double* exact_;
  const std::size_t seen_;
  float q_[kMostDimensions];
  double offset_[kMostDimensions];  ///< from q to the cell, by coordinate
  double share_, slack_, tiny_;
  float least_ = kInfinity;
  float limit_ = kInfinity;
  std::size_t candidates_ = 0;
  Candidate candidate_[kCandidates];
  std::uint32_t best_ = kNone;
  double best_square_ = std::numeric_limits<double>::infinity();
};

PointIndex::PointIndex(int dimension, std::size_t leaf_points)
    : dimension_(dimension), leaf_points_(leaf_points) {}

PointIndex::~PointIndex() = default;

const void* PointIndex::nearest(const double* q) const {
  const std::size_t seen = size();
  return seen == 0 ? nullptr : Query(*this, q, seen).run();
}

void PointIndex::add(const double* q, const void* item) {
  float rounded[kMostDimensions];
  for (int i = 0; i < dimension_; ++i) rounded[i] = single(q[i]);
  const std::lock_guard<std::mutex> lock(mutex_);
  const std::size_t count = count_.load(std::memory_order_relaxed);
  const auto number = static_cast<std::uint32_t>(count);
  keep(number, {q, item});
  noteReach(q);
  if (count == 0) root_.store(makeLeaf(kBlockPoints), std::memory_order_release);
  Slot* slot = &slotOf(rounded);
  const auto leafAt = [](const Slot& at) { return static_cast<Leaf*>(at.load(std::memory_order_relaxed)); };
  if (leafAt(*slot)->count.load(std::memory_order_relaxed) == leafAt(*slot)->capacity) {
    makeRoom(*slot);
    slot = &slotOf(rounded);
  }
  leafAt(*slot)->append(number, rounded, dimension_);
  count_.store(count + 1, std::memory_order_release);
}

const PointIndex::Entry& PointIndex::entry(std::uint32_t number) const {
  const unsigned chunk = chunkOf(number);
  return entries_[chunk][number - chunkBegin(chunk)];
}

void PointIndex::keep(std::uint32_t number, const Entry& entry) {
  const unsigned chunk = chunkOf(number);
  if (!entries_[chunk]) entries_[chunk].reset(new Entry[chunkSize(chunk)]);
  entries_[chunk][number - chunkBegin(chunk)] = entry;
}

void PointIndex::noteReach(const double* q) {
  double reach = reach_.load(std::memory_order_relaxed);
  for (int i = 0; i < dimension_; ++i)
    if (!(std::abs(q[i]) <= reach)) reach = std::abs(q[i]);
  reach_.store(reach, std::memory_order_relaxed);
}

PointIndex::Slot& PointIndex::slotOf(const float* q) {
  Slot* slot = &root_;
  while (!slot->load(std::memory_order_relaxed)->is_leaf)
    slot = &static_cast<Split*>(slot->load(std::memory_order_relaxed))->sideOf(q);
  return *slot;
}

PointIndex::Leaf* PointIndex::makeLeaf(std::size_t capacity) {
  return leaves_.emplace_back(std::make_unique<Leaf>(dimension_, capacity)).get();
}

// Puts a larger leaf, or two, in the place of one that is full.
void PointIndex::makeRoom(Slot& slot) {
  const auto& full = *static_cast<const Leaf*>(slot.load(std::memory_order_relaxed));
  Cell* instead = full.capacity >= leaf_points_ ? split(full) : nullptr;
  if (instead == nullptr) {
    Leaf* larger = makeLeaf(2 * full.capacity);
    std::copy_n(full.values.get(), full.capacity / kBlockPoints * full.floats_per_block,
                larger->values.get());
    std::copy_n(full.numbers.get(), full.capacity, larger->numbers.get());
    larger->count.store(full.capacity, std::memory_order_relaxed);
    instead = larger;
  }
  slot.store(instead, std::memory_order_release);
}

// Across the axis on which the points of a full leaf spread widest, near their median there. nullptr when all
// are one point.
PointIndex::Split* PointIndex::split(const Leaf& leaf) {
  const std::size_t count = leaf.capacity;
  int axis = 0;
  float widest = 0.0f, lowest = 0.0f;
  std::vector<float> along(count);
  for (int i = 0; i < dimension_; ++i) {
    for (std::size_t point = 0; point < count; ++point) along[point] = leaf.at(point, i);
    const auto [low, high] = std::minmax_element(along.begin(), along.end());
    if (*high - *low <= widest) continue;
    axis = i;
    widest = *high - *low;
    lowest = *low;
  }
  if (widest == 0.0f) return nullptr;
  for (std::size_t point = 0; point < count; ++point) along[point] = leaf.at(point, axis);
  const auto middle = along.begin() + static_cast<std::ptrdiff_t>(count / 2);
  std::nth_element(along.begin(), middle, along.end());
  float value = *middle;
  if (value == lowest) {
    value = kInfinity;
    for (const float other : along)
      if (other > lowest) value = std::min(value, other);
  }
  std::size_t below = 0;
  for (const float other : along) below += other < value ? 1 : 0;
  // At least half of each side stays free.
  const auto roomFor = [&](std::size_t points) {
    std::size_t capacity = leaf_points_;
    while (capacity < 2 * points) capacity *= 2;
    return capacity;
  };
  Leaf* sides[2] = {makeLeaf(roomFor(below)), makeLeaf(roomFor(count - below))};
  float q[kMostDimensions];
  for (std::size_t point = 0; point < count; ++point) {
    for (int i = 0; i < dimension_; ++i) q[i] = leaf.at(point, i);
    sides[q[axis] < value ? 0 : 1]->append(leaf.numbers[point], q, dimension_);
  }
  return splits_.emplace_back(std::make_unique<Split>(axis, value, sides[0], sides[1])).get();
}

std::size_t PointIndex::bytes() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  std::size_t sum = sizeof(*this) + splits_.capacity() * (sizeof(Split) + sizeof(splits_[0])) +
                    leaves_.capacity() * sizeof(leaves_[0]);
  for (const auto& leaf : leaves_)
    sum += sizeof(Leaf) +
           leaf->capacity * (sizeof(std::uint32_t) + static_cast<std::size_t>(dimension_) * sizeof(float));
  for (unsigned chunk = 0; chunk < entries_.size(); ++chunk)
    if (entries_[chunk]) sum += chunkSize(chunk) * sizeof(Entry);
  return sum;
}

}  // namespace b4p
