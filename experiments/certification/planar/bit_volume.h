// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace b4p::planar {

/// One bit for each cell of a grid of layers x rows x columns, 64 columns a word.
class BitVolume {
 public:
  using Word = std::uint64_t;
  static constexpr int kBits = 64;

  BitVolume(int layers, int rows, int columns);

  int layers() const { return layers_; }
  int rows() const { return rows_; }
  int columns() const { return columns_; }
  int wordsPerRow() const { return words_; }

  Word* row(int layer, int row) { return &bits_[offset(layer, row)]; }
  const Word* row(int layer, int row) const { return &bits_[offset(layer, row)]; }

  /// The bits of a row's word that are columns: all, but for the last word.
  Word columnsOf(int word) const;

  /// Sets columns first ... last; nothing when first > last.
  void setRun(int layer, int row, int first, int last);

  bool test(int layer, int row, int column) const;
  bool anyInRun(int layer, int row, int first, int last) const;
  std::uint64_t count() const;

 private:
  std::size_t offset(int layer, int row) const {
    return (static_cast<std::size_t>(layer) * static_cast<std::size_t>(rows_) +
            static_cast<std::size_t>(row)) *
           static_cast<std::size_t>(words_);
  }

  int layers_, rows_, columns_, words_;
  std::vector<Word> bits_;
};

}  // namespace b4p::planar
