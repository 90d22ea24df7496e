// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <mutex>
#include <vector>

namespace b4p {

/// Nearest neighbours in R^n by the Euclidean metric, among points that only ever join. Any thread may add or
/// ask. Adding takes a short lock; asking takes none, and sees all points whose add() has returned, and of
/// those that are joining the first ones.
///
/// A kd-tree whose leaves hold up to some hundred points in single precision and are scanned many points at
/// a time; a small set is one leaf. What single precision cannot tell apart is settled in double. A leaf that
/// is full gives way to a larger one or to two; what readers may still look at is kept.
class PointIndex {
 public:
  static constexpr int kMostDimensions = 32;
  static constexpr std::size_t kLeafPoints = 512;

  /// @param dimension    1 .. kMostDimensions
  /// @param leaf_points  a fuller leaf is split; a power of two, at least 16
  explicit PointIndex(int dimension, std::size_t leaf_points = kLeafPoints);
  ~PointIndex();
  PointIndex(const PointIndex&) = delete;
  PointIndex& operator=(const PointIndex&) = delete;

  /// `q` (dimension values) stays where it is, unchanged, while the index lives.
  void add(const double* q, const void* item);

  /// The item at the point nearest to q, of several the one added first; nullptr while there is none.
  const void* nearest(const double* q) const;

  std::size_t size() const { return count_.load(std::memory_order_acquire); }

  /// Memory in use, without what `q` and `item` point to.
  std::size_t bytes() const;

 private:
  struct Entry {
    const double* q;
    const void* item;
  };
  struct Cell;
  struct Leaf;
  struct Split;
  class Query;
  using Slot = std::atomic<Cell*>;

  // Entries lie in chunks of 16, 16, 32, 64, ...
  const Entry& entry(std::uint32_t number) const;
  void keep(std::uint32_t number, const Entry& entry);
  void noteReach(const double* q);
  Slot& slotOf(const float* q);
  Leaf* makeLeaf(std::size_t capacity);
  void makeRoom(Slot& slot);
  Split* split(const Leaf& leaf);

  const int dimension_;
  const std::size_t leaf_points_;
  std::atomic<std::size_t> count_{0};
  std::atomic<double> reach_{0.0};  ///< no coordinate is larger
  Slot root_{nullptr};
  std::array<std::unique_ptr<Entry[]>, 32> entries_;

  mutable std::mutex mutex_;  // of writers; guards what follows
  std::vector<std::unique_ptr<Leaf>> leaves_;
  std::vector<std::unique_ptr<Split>> splits_;
};

}  // namespace b4p
