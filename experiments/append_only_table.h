// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <deque>
#include <mutex>
#include <shared_mutex>
#include <stdexcept>
#include <string>
#include <utility>

namespace b4p {

/// Rows numbered from 0 that are only ever added. Any thread may add or read; references stay good as long as
/// the table lives.
template <class Row>
class AppendOnlyTable {
 public:
  std::int32_t add(Row row) {
    std::unique_lock<std::shared_mutex> lock(mutex_);
    rows_.push_back(std::move(row));
    return static_cast<std::int32_t>(rows_.size()) - 1;
  }

  std::int32_t size() const {
    std::shared_lock<std::shared_mutex> lock(mutex_);
    return static_cast<std::int32_t>(rows_.size());
  }

  /// @throws std::invalid_argument when there is no such row.
  const Row& at(std::int32_t id) const {
    std::shared_lock<std::shared_mutex> lock(mutex_);
    if (id < 0 || static_cast<std::size_t>(id) >= rows_.size())
      throw std::invalid_argument("unknown id " + std::to_string(id));
    return rows_[static_cast<std::size_t>(id)];
  }

 private:
  mutable std::shared_mutex mutex_;
  std::deque<Row> rows_;
};

}  // namespace b4p
