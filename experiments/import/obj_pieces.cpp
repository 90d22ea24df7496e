// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/import/obj_pieces.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <fstream>
#include <map>
#include <numeric>
#include <sstream>

#include "experiments/scene_families/scene_text.h"
#include "robots/input_error.h"

namespace b4p {
namespace {

/// What an OBJ file says, and where to blame it.
class ObjReader {
 public:
  explicit ObjReader(const std::string& file) : file_(file) {}

  void read() {
    std::ifstream in(file_);
    if (!in) throw InputError(file_, "", "no such file, or it cannot be read");
    for (std::string line; std::getline(in, line);) {
      ++line_;
      std::istringstream words(line);
      std::string keyword;
      words >> keyword;
      if (keyword == "v") readVertex(words);
      if (keyword == "f") readFace(words);
    }
    if (in.bad()) throw InputError(file_, "", "cannot be read");
    if (triangles.empty()) throw InputError(file_, "", "holds no faces");
  }

  std::vector<Eigen::Vector3d> vertices;
  std::vector<std::array<int, 3>> triangles;

 private:
  void readVertex(std::istringstream& words) {
    Eigen::Vector3d vertex;
    for (int i = 0; i < 3; ++i) {
      std::string word;
      words >> word;
      const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), vertex[i]);
      if (error != std::errc() || end != word.data() + word.size() || !std::isfinite(vertex[i]))
        fail("has a vertex that is not three finite numbers (" + word + ")");
    }
    vertices.push_back(vertex);
  }

  /// "7", "7/1", "7//3"; negative numbers count backwards from the latest vertex.
  int vertexIndex(const std::string& word) {
    const int count = static_cast<int>(vertices.size());
    int number = 0;
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), number);
    const bool whole = end == word.data() + word.size() || *end == '/';
    const int index = number < 0 ? count + number : number - 1;
    if (error != std::errc() || !whole || index < 0 || index >= count)
      fail("has a face with a vertex that is not there (" + word + ")");
    return index;
  }

  void readFace(std::istringstream& words) {
    std::vector<int> corners;
    for (std::string word; words >> word;) corners.push_back(vertexIndex(word));
    if (corners.size() < 3) fail("has a face of fewer than three corners");
    for (std::size_t i = 2; i < corners.size(); ++i)
      triangles.push_back({corners[0], corners[i - 1], corners[i]});
  }

  [[noreturn]] void fail(const std::string& problem) const {
    throw InputError(file_, "line " + std::to_string(line_), problem);
  }

  const std::string& file_;
  int line_ = 0;
};

/// Of each vertex one that stands for all that are connected with it.
std::vector<int> representatives(std::size_t vertices, const std::vector<std::array<int, 3>>& triangles) {
  std::vector<int> parent(vertices);
  std::iota(parent.begin(), parent.end(), 0);
  const auto root = [&parent](int i) {
    while (parent[static_cast<std::size_t>(i)] != i) {
      int& up = parent[static_cast<std::size_t>(i)];
      up = parent[static_cast<std::size_t>(up)];
      i = up;
    }
    return i;
  };
  for (const auto& t : triangles) {
    parent[static_cast<std::size_t>(root(t[1]))] = root(t[0]);
    parent[static_cast<std::size_t>(root(t[2]))] = root(t[0]);
  }
  for (std::size_t i = 0; i < vertices; ++i) parent[i] = root(static_cast<int>(i));
  return parent;
}

}  // namespace

double MeshPiece::concavity_m() const {
  double most = 0.0;
  for (const auto& [a, b, c] : triangles) {
    const auto at = [this](int i) { return vertices[static_cast<std::size_t>(i)]; };
    const Eigen::Vector3d across = (at(b) - at(a)).cross(at(c) - at(a));
    if (across.isZero()) continue;
    double below = 0.0, above = 0.0;
    for (const Eigen::Vector3d& vertex : vertices) {
      const double height = across.normalized().dot(vertex - at(a));
      below = std::min(below, height);
      above = std::max(above, height);
    }
    most = std::max(most, std::min(-below, above));
  }
  return most;
}

std::vector<MeshPiece> readObjPieces(const std::string& file) {
  ObjReader mesh(file);
  mesh.read();
  const std::vector<int> representative = representatives(mesh.vertices.size(), mesh.triangles);
  std::vector<MeshPiece> pieces;
  std::map<int, std::size_t> piece_of;  // by representative
  std::map<int, int> number_of;         // of a vertex, within its piece
  for (const auto& triangle : mesh.triangles) {
    const auto [entry, first] =
        piece_of.emplace(representative[static_cast<std::size_t>(triangle[0])], pieces.size());
    if (first) pieces.emplace_back();
    MeshPiece& piece = pieces[entry->second];
    std::array<int, 3> local{};
    for (std::size_t i = 0; i < 3; ++i) {
      const auto [number, unseen] = number_of.emplace(triangle[i], static_cast<int>(piece.vertices.size()));
      if (unseen) piece.vertices.push_back(mesh.vertices[static_cast<std::size_t>(triangle[i])]);
      local[i] = number->second;
    }
    piece.triangles.push_back(local);
  }
  return pieces;
}

std::string objText(const std::vector<Eigen::Vector3d>& vertices,
                    const std::vector<std::array<int, 3>>& triangles) {
  constexpr int kDecimals = 7;
  std::string text;
  for (const Eigen::Vector3d& v : vertices)
    text += "v " + sceneNumber(v.x(), kDecimals) + " " + sceneNumber(v.y(), kDecimals) + " " +
            sceneNumber(v.z(), kDecimals) + "\n";
  for (const auto& t : triangles)
    text += "f " + std::to_string(t[0] + 1) + " " + std::to_string(t[1] + 1) + " " +
            std::to_string(t[2] + 1) + "\n";
  return text;
}

}  // namespace b4p
