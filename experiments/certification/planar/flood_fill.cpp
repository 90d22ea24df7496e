// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/certification/planar/flood_fill.h"

#include <algorithm>
#include <cstddef>
#include <vector>

namespace b4p::planar {
namespace {

using Word = BitVolume::Word;

/// Kogge-Stone: the seeds, and all bits of `open` that an unbroken run of them joins to a lower seed.
Word fillUpwards(Word seeds, Word open) {
  for (int step = 1; step < BitVolume::kBits; step *= 2) {
    seeds |= open & (seeds << step);
    open &= open << step;
  }
  return seeds;
}

Word fillDownwards(Word seeds, Word open) {
  for (int step = 1; step < BitVolume::kBits; step *= 2) {
    seeds |= open & (seeds >> step);
    open &= open >> step;
  }
  return seeds;
}

/// Rows are taken from a list until none is left whose neighbours have changed.
class Filler {
 public:
  Filler(const BitVolume& blocked, BitVolume& reached)
      : blocked_(blocked),
        reached_(reached),
        words_(static_cast<std::size_t>(reached.wordsPerRow())),
        listed_(static_cast<std::size_t>(reached.layers()) * static_cast<std::size_t>(reached.rows())),
        seeds_(words_) {}

  bool run(const std::function<bool()>& stop) {
    constexpr std::size_t kRowsBetweenStops = 4096;
    for (int layer = 0; layer < reached_.layers(); ++layer)
      for (int row = 0; row < reached_.rows(); ++row)
        if (dropBlocked(layer, row)) listNeighbours(layer, row);
    for (std::size_t rows = 0; !list_.empty(); ++rows) {
      if (rows % kRowsBetweenStops == 0 && stop()) return false;
      const Place place = list_.back();
      list_.pop_back();
      listed_[number(place)] = false;
      if (spreadInto(place)) listNeighbours(place.layer, place.row);
    }
    return true;
  }

 private:
  struct Place {
    int layer, row;
  };

  std::size_t number(Place place) const {
    return static_cast<std::size_t>(place.layer) * static_cast<std::size_t>(reached_.rows()) +
           static_cast<std::size_t>(place.row);
  }

  Word open(Place place, std::size_t word) const {
    return ~blocked_.row(place.layer, place.row)[word] & reached_.columnsOf(static_cast<int>(word));
  }

  /// @return whether anything is left
  bool dropBlocked(int layer, int row) {
    bool any = false;
    for (std::size_t w = 0; w < words_; ++w) {
      Word& word = reached_.row(layer, row)[w];
      word &= open({layer, row}, w);
      any = any || word != 0;
    }
    return any;
  }

  void listNeighbours(int layer, int row) {
    for (int l = -1; l <= 1; ++l)
      for (int r = std::max(row - 1, 0); r <= std::min(row + 1, reached_.rows() - 1); ++r) {
        const Place place{(layer + l + reached_.layers()) % reached_.layers(), r};
        if (listed_[number(place)]) continue;
        listed_[number(place)] = true;
        list_.push_back(place);
      }
  }

  /// What is reached in the nine rows around, one column farther to each side.
  void gatherSeeds(Place place) {
    std::fill(seeds_.begin(), seeds_.end(), 0);
    for (int l = -1; l <= 1; ++l)
      for (int r = std::max(place.row - 1, 0); r <= std::min(place.row + 1, reached_.rows() - 1); ++r) {
        const Word* row = reached_.row((place.layer + l + reached_.layers()) % reached_.layers(), r);
        for (std::size_t w = 0; w < words_; ++w) seeds_[w] |= row[w];
      }
    Word carry = 0;  // the neighbour's bit, as it was before the spread
    for (std::size_t w = 0; w < words_; ++w) {
      const Word own = seeds_[w];
      const Word next = w + 1 < words_ ? seeds_[w + 1] : 0;
      seeds_[w] = own | own << 1 | carry | own >> 1 | next << (BitVolume::kBits - 1);
      carry = own >> (BitVolume::kBits - 1);
    }
  }

  /// @return whether the row has gained cells
  bool spreadInto(Place place) {
    gatherSeeds(place);
    Word* row = reached_.row(place.layer, place.row);
    Word carry = 0;
    for (std::size_t w = 0; w < words_; ++w) {
      const Word free = open(place, w);
      seeds_[w] = fillUpwards((seeds_[w] | carry) & free, free);
      carry = seeds_[w] >> (BitVolume::kBits - 1);
    }
    bool gained = false;
    carry = 0;
    for (std::size_t w = words_; w-- > 0;) {
      const Word free = open(place, w);
      seeds_[w] = fillDownwards((seeds_[w] | carry) & free, free);
      carry = seeds_[w] << (BitVolume::kBits - 1);
      gained = gained || seeds_[w] != row[w];
      row[w] = seeds_[w];
    }
    return gained;
  }

  const BitVolume& blocked_;
  BitVolume& reached_;
  std::size_t words_;
  std::vector<Place> list_;
  std::vector<bool> listed_;
  std::vector<Word> seeds_;
};

}  // namespace

bool floodFill(const BitVolume& blocked, BitVolume& reached, const std::function<bool()>& stop) {
  return Filler(blocked, reached).run(stop);
}

}  // namespace b4p::planar
