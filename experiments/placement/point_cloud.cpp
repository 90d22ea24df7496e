// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/placement/point_cloud.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <fstream>
#include <set>
#include <sstream>
#include <tuple>

#include "experiments/scene_files/yaml_value.h"
#include "robots/input_error.h"

namespace b4p {
namespace {

std::vector<std::string> words(const std::string& line) {
  std::istringstream stream(line);
  std::vector<std::string> list;
  for (std::string word; stream >> word;) list.push_back(word);
  return list;
}

/// Lines of a file, with their number for messages.
class Lines {
 public:
  explicit Lines(const std::string& file) : file_(file), stream_(file) {
    if (!stream_) fail("", "cannot be read");
  }

  /// The next line's words. @throws InputError at the end of the file
  std::vector<std::string> next() {
    std::string line;
    if (!std::getline(stream_, line)) fail("", "ends after line " + std::to_string(number_) + ", too early");
    ++number_;
    return words(line);
  }

  [[noreturn]] void failHere(const std::string& problem) const {
    fail("line " + std::to_string(number_), problem);
  }
  [[noreturn]] void fail(const std::string& element, const std::string& problem) const {
    throw InputError(file_, element, problem);
  }

  std::size_t count(const std::string& word) const {
    std::size_t value = 0;
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    if (error != std::errc() || end != word.data() + word.size()) failHere("'" + word + "' is not a count");
    return value;
  }

  double coordinate(const std::string& word) const {
    double value = 0.0;
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    if (error != std::errc() || end != word.data() + word.size()) failHere("'" + word + "' is not a number");
    if (!(std::abs(value) <= kFarthest_m)) failHere("'" + word + "' is not a coordinate within 1000 m");
    return value;
  }

 private:
  std::string file_;
  std::ifstream stream_;
  std::size_t number_ = 0;
};

/// What a header says: how many rows of values there are, and what they mean.
struct Header {
  std::size_t rows = 0;
  std::vector<std::string> columns;
};

Header readPly(Lines& lines) {
  Header header;
  bool ascii = false, vertices = false, after = false;
  for (;;) {
    const auto line = lines.next();
    if (line.empty() || line[0] == "comment" || line[0] == "obj_info") continue;
    if (line[0] == "end_header") break;
    if (line[0] == "format" && line.size() >= 2) {
      if (line[1] != "ascii") lines.failHere("format '" + line[1] + "' is not ascii");
      ascii = true;
    } else if (line[0] == "element" && line.size() == 3) {
      if (!vertices && line[1] != "vertex") lines.failHere("the first element is not 'vertex'");
      after = vertices;
      if (!vertices) header.rows = lines.count(line[2]);
      vertices = true;
    } else if (line[0] == "property" && line.size() >= 3 && vertices) {
      if (after) continue;
      if (line[1] == "list") lines.failHere("vertices with a list property are not supported");
      header.columns.push_back(line[2]);
    } else {
      lines.failHere("'" + line[0] + "' is not understood in a PLY header");
    }
  }
  if (!ascii) lines.fail("", "the PLY header has no format");
  return header;
}

Header readPcd(Lines& lines, std::vector<std::string> line) {
  Header header;
  bool points = false;
  for (;; line = lines.next()) {
    if (line.empty() || line[0][0] == '#') continue;
    const std::string& key = line[0];
    if (key == "DATA") {
      if (line.size() != 2 || line[1] != "ascii") lines.failHere("DATA is not ascii");
      break;
    }
    if (key == "FIELDS") {
      header.columns.assign(line.begin() + 1, line.end());
    } else if (key == "COUNT") {
      for (std::size_t i = 1; i < line.size(); ++i)
        if (line[i] != "1") lines.failHere("fields of several values are not supported");
    } else if (key == "POINTS" && line.size() == 2) {
      header.rows = lines.count(line[1]);
      points = true;
    } else if (key != "VERSION" && key != "SIZE" && key != "TYPE" && key != "WIDTH" && key != "HEIGHT" &&
               key != "VIEWPOINT") {
      lines.failHere("'" + key + "' is not understood in a PCD header");
    }
  }
  if (!points) lines.fail("", "the PCD header has no POINTS");
  return header;
}

}  // namespace

std::vector<Eigen::Vector3d> readPointCloud(const std::string& file) {
  Lines lines(file);
  auto first = lines.next();
  while (!first.empty() && first[0][0] == '#') first = lines.next();
  const bool ply = first == std::vector<std::string>{"ply"};
  if (!ply && (first.empty() || (first[0] != "VERSION" && first[0] != "FIELDS")))
    lines.failHere("the file begins neither as PLY nor as PCD");
  const Header header = ply ? readPly(lines) : readPcd(lines, first);
  std::array<std::size_t, 3> place{};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const std::string name(1, "xyz"[axis]);
    const auto found = std::find(header.columns.begin(), header.columns.end(), name);
    if (found == header.columns.end()) lines.fail("", "points have no " + name);
    place.at(axis) = static_cast<std::size_t>(found - header.columns.begin());
  }
  if (header.rows == 0) lines.fail("", "holds no points");
  std::vector<Eigen::Vector3d> points;
  while (points.size() < header.rows) {
    const auto row = lines.next();
    if (row.size() != header.columns.size())
      lines.failHere("has " + std::to_string(row.size()) + " values, not " +
                     std::to_string(header.columns.size()));
    points.emplace_back(lines.coordinate(row[place[0]]), lines.coordinate(row[place[1]]),
                        lines.coordinate(row[place[2]]));
  }
  return points;
}

std::vector<Obstacle> boxesAround(const std::vector<Eigen::Vector3d>& points, const Eigen::Vector3d& origin_m,
                                  double cell_m, const std::string& name) {
  constexpr std::size_t kMostBoxes = 20000;
  // Cells in order of z, y, x.
  std::set<std::tuple<int, int, int>> cells;
  for (const Eigen::Vector3d& p : points) {
    const Eigen::Vector3i cell = ((p - origin_m) / cell_m).array().floor().cast<int>().matrix();
    cells.emplace(cell.z(), cell.y(), cell.x());
  }
  std::vector<Obstacle> boxes;
  while (!cells.empty()) {
    const auto [z, y, x] = *cells.begin();
    int wide = 1, deep = 1, high = 1;
    while (cells.count({z, y, x + wide}) > 0) ++wide;
    const auto full = [&, z0 = z, y0 = y, x0 = x](int z_at, int y_at) {
      for (int i = 0; i < wide; ++i)
        if (cells.count({z0 + z_at, y0 + y_at, x0 + i}) == 0) return false;
      return true;
    };
    while (full(0, deep)) ++deep;
    const auto fullLayer = [&](int z_at) {
      for (int j = 0; j < deep; ++j)
        if (!full(z_at, j)) return false;
      return true;
    };
    while (fullLayer(high)) ++high;
    const int z0 = z, y0 = y, x0 = x;  // the entry they refer to goes
    for (int k = 0; k < high; ++k)
      for (int j = 0; j < deep; ++j)
        for (int i = 0; i < wide; ++i) cells.erase({z0 + k, y0 + j, x0 + i});
    const Eigen::Vector3d size = cell_m * Eigen::Vector3d(wide, deep, high);
    Obstacle box{name + "_" + std::to_string(boxes.size()), {Box{size}, Eigen::Isometry3d::Identity()}};
    box.shape.X_BS.translation() = origin_m + cell_m * Eigen::Vector3d(x0, y0, z0) + size / 2.0;
    boxes.push_back(std::move(box));
    if (boxes.size() > kMostBoxes)
      throw InputError(name, "", "fills too many cells that make no larger boxes");
  }
  return boxes;
}

}  // namespace b4p
