// SPDX-License-Identifier: BSD-3-Clause
#include "robots/capsule_fusion.h"

#include <cmath>
#include <utility>

namespace b4p {
namespace {

constexpr double kSameSize_m = 1e-6;

/// The first shape that is not used up and is a sphere with this centre and radius; shapes.size() if there is
/// none.
std::size_t findSphere(const std::vector<PlacedShape>& shapes, const std::vector<bool>& used,
                       const Eigen::Vector3d& centre, double radius) {
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    const auto* sphere = std::get_if<Sphere>(&shapes[i].shape);
    if (sphere != nullptr && !used[i] && std::abs(sphere->radius - radius) <= kSameSize_m &&
        (shapes[i].X_BS.translation() - centre).norm() <= kSameSize_m)
      return i;
  }
  return shapes.size();
}

}  // namespace

void fuseCapsules(std::vector<PlacedShape>& shapes) {
  std::vector<bool> used(shapes.size(), false);
  for (PlacedShape& placed : shapes) {
    const auto* cylinder = std::get_if<Cylinder>(&placed.shape);
    if (cylinder == nullptr) continue;
    const Capsule capsule{cylinder->radius, cylinder->length};
    const Eigen::Vector3d end(0.0, 0.0, capsule.length / 2.0);
    const std::size_t upper = findSphere(shapes, used, placed.X_BS * end, capsule.radius);
    const std::size_t lower = findSphere(shapes, used, placed.X_BS * -end, capsule.radius);
    if (upper == shapes.size() || lower == shapes.size() || upper == lower) continue;
    used[upper] = used[lower] = true;
    placed.shape = capsule;
  }
  std::vector<PlacedShape> kept;
  for (std::size_t i = 0; i < shapes.size(); ++i)
    if (!used[i]) kept.push_back(shapes[i]);
  shapes = std::move(kept);
}

}  // namespace b4p
