// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/scene_files/shape_reader.h"

#include <array>
#include <cmath>
#include <filesystem>
#include <optional>
#include <stdexcept>
#include <utility>

#include "robots/input_error.h"
#include "robots/mesh_loader.h"

namespace b4p {
namespace {

double cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b) { return a.x() * b.y() - a.y() * b.x(); }

/// Whether the closed segments ab and cd have a point in common; touching counts.
bool segmentsMeet(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& c,
                  const Eigen::Vector2d& d) {
  const double c_side = cross(b - a, c - a), d_side = cross(b - a, d - a);
  const double a_side = cross(d - c, a - c), b_side = cross(d - c, b - c);
  const bool boxes_meet =
      std::min(a.x(), b.x()) <= std::max(c.x(), d.x()) && std::min(c.x(), d.x()) <= std::max(a.x(), b.x()) &&
      std::min(a.y(), b.y()) <= std::max(c.y(), d.y()) && std::min(c.y(), d.y()) <= std::max(a.y(), b.y());
  return boxes_meet && c_side * d_side <= 0.0 && a_side * b_side <= 0.0;
}

bool isSimple(const std::vector<Eigen::Vector2d>& polygon) {
  const std::size_t n = polygon.size();
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = i + 2; j < n; ++j) {
      if (i == 0 && j == n - 1) continue;  // neighbours share a corner
      if (segmentsMeet(polygon[i], polygon[i + 1], polygon[j], polygon[(j + 1) % n])) return false;
    }
  return true;
}

bool isConvex(const std::vector<Eigen::Vector2d>& polygon) {
  const std::size_t n = polygon.size();
  for (std::size_t i = 0; i < n; ++i)
    if (cross(polygon[(i + 1) % n] - polygon[i], polygon[(i + 2) % n] - polygon[(i + 1) % n]) < 0.0)
      return false;
  return true;
}

Shape readBox(const YamlValue& value) {
  value.allowKeys({"size_m"});
  return Box{value["size_m"].positiveVector3(kFarthest_m)};
}

Shape readSphere(const YamlValue& value) {
  value.allowKeys({"radius_m"});
  return Sphere{value["radius_m"].positive(kFarthest_m)};
}

Shape readCylinder(const YamlValue& value) {
  value.allowKeys({"radius_m", "length_m"});
  return Cylinder{value["radius_m"].positive(kFarthest_m), value["length_m"].positive(kFarthest_m)};
}

Shape readCapsule(const YamlValue& value) {
  value.allowKeys({"radius_m", "length_m"});
  return Capsule{value["radius_m"].positive(kFarthest_m), value["length_m"].number(0.0, kFarthest_m)};
}

Shape readPrism(const YamlValue& value) {
  value.allowKeys({"polygon_m", "height_m"});
  const YamlValue outline = value["polygon_m"];
  const auto polygon = readPolygon(outline);
  if (!isConvex(polygon)) outline.fail("is not convex; cut it into convex pieces");
  const double half_height = value["height_m"].positive(kFarthest_m) / 2.0;
  std::vector<Eigen::Vector3d> points;
  for (const Eigen::Vector2d& p : polygon)
    for (const double z : {-half_height, half_height}) points.emplace_back(p.x(), p.y(), z);
  try {
    return convexHull(points);
  } catch (const std::invalid_argument& e) {
    outline.fail(e.what());
  }
}

bool hasHull(const std::string& file, const Eigen::Vector3d& factors) {
  try {
    loadMeshHull(file, factors);
    return true;
  } catch (const std::runtime_error&) {
    return false;
  }
}

Shape readMesh(const YamlValue& value) {
  value.allowKeys({"file", "scale", "convex_hull"});
  const auto scale = value.find("scale");
  const auto hull = value.find("convex_hull");
  const YamlValue address = value["file"];
  const Eigen::Vector3d factors = scale ? scale->positiveVector3() : Eigen::Vector3d::Ones();
  const bool take_hull = hull && hull->boolean();
  std::string file;
  try {
    file = meshFile(address.text(), std::filesystem::path(value.file()).parent_path().string());
    return take_hull ? loadMeshHull(file, factors) : loadConvexMesh(file, factors);
  } catch (const InputError&) {
    throw;
  } catch (const std::runtime_error& error) {
    const bool hull_helps = !take_hull && hasHull(file, factors);
    address.failWithValue(std::string(error.what()) +
                          (hull_helps ? "; convex_hull: true uses the hull" : ""));
  }
}

using Reader = Shape (*)(const YamlValue&);
constexpr std::array<std::pair<const char*, Reader>, 6> kReaders{{{"box", readBox},
                                                                  {"sphere", readSphere},
                                                                  {"cylinder", readCylinder},
                                                                  {"capsule", readCapsule},
                                                                  {"prism", readPrism},
                                                                  {"mesh", readMesh}}};

}  // namespace

std::vector<Eigen::Vector2d> readPolygon(const YamlValue& value) {
  constexpr std::size_t kFewestCorners = 3;
  std::vector<Eigen::Vector2d> polygon;
  for (const YamlValue& corner : value.items()) {
    const auto xy = corner.numbers(2, kFarthest_m);
    polygon.emplace_back(xy[0], xy[1]);
  }
  if (polygon.size() < kFewestCorners) value.fail("has fewer than 3 corners");
  double doubled_area = 0.0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Eigen::Vector2d& next = polygon[(i + 1) % polygon.size()];
    if (polygon[i] == next) value.fail("has the same corner twice in a row");
    doubled_area += cross(polygon[i], next);
  }
  if (!isSimple(polygon)) value.fail("has edges that cross or touch");
  if (doubled_area <= 0.0) value.fail("does not run counter-clockwise");
  return polygon;
}

PlacedShape readPlacedShape(const YamlValue& mapping, std::initializer_list<const char*> more_keys) {
  std::vector<const char*> keys{"position_m", "rpy_rad", "quaternion_wxyz"};
  keys.insert(keys.end(), more_keys);
  for (const auto& entry : kReaders) keys.push_back(entry.first);
  mapping.allowKeys(keys);
  std::optional<YamlValue> found;
  Reader reader = nullptr;
  for (const auto& [name, read] : kReaders) {
    auto value = mapping.find(name);
    if (!value) continue;
    if (found) mapping.fail("has more than one shape");
    found = value;
    reader = read;
  }
  if (!found) mapping.fail("has no shape: one of box, sphere, cylinder, capsule, prism, mesh");
  PlacedShape placed{reader(*found), poseFrom(mapping)};
  const std::string problem = shapeProblem(placed.shape);
  if (!problem.empty()) found->fail(problem);
  return placed;
}

}  // namespace b4p
