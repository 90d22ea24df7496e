// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/certification/planar/bit_volume.h"

#include <algorithm>
#include <bitset>

namespace b4p::planar {
namespace {

using Word = BitVolume::Word;

/// Bits of word `word` that belong to the columns first ... last.
Word runMask(int word, int first, int last) {
  const int low = std::max(first - word * BitVolume::kBits, 0);
  const int high = std::min(last - word * BitVolume::kBits, BitVolume::kBits - 1);
  return (~Word{0} >> (BitVolume::kBits - 1 - high)) & (~Word{0} << low);
}

}  // namespace

BitVolume::BitVolume(int layers, int rows, int columns)
    : layers_(layers),
      rows_(rows),
      columns_(columns),
      words_((columns + kBits - 1) / kBits),
      bits_(static_cast<std::size_t>(layers) * static_cast<std::size_t>(rows) *
            static_cast<std::size_t>(words_)) {}

Word BitVolume::columnsOf(int word) const { return runMask(word, word * kBits, columns_ - 1); }

void BitVolume::setRun(int layer, int row_index, int first, int last) {
  if (first > last) return;
  Word* words = row(layer, row_index);
  for (int word = first / kBits; word <= last / kBits; ++word) words[word] |= runMask(word, first, last);
}

bool BitVolume::test(int layer, int row_index, int column) const {
  return (row(layer, row_index)[column / kBits] >> (column % kBits) & 1) != 0;
}

bool BitVolume::anyInRun(int layer, int row_index, int first, int last) const {
  if (first > last) return false;
  const Word* words = row(layer, row_index);
  for (int word = first / kBits; word <= last / kBits; ++word)
    if ((words[word] & runMask(word, first, last)) != 0) return true;
  return false;
}

std::uint64_t BitVolume::count() const {
  std::uint64_t count = 0;
  for (const Word word : bits_) count += std::bitset<kBits>(word).count();
  return count;
}

}  // namespace b4p::planar
