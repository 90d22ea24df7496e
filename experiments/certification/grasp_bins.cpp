// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/certification/grasp_bins.h"

#include <algorithm>
#include <map>
#include <tuple>
#include <utility>

#include <Eigen/Geometry>

#include "experiments/certification/planar/shape_slice.h"

namespace b4p {
namespace {

constexpr int kPositions = 10;

Eigen::AlignedBox3d boundingBox(const std::vector<PlacedShape>& object) {
  Eigen::AlignedBox3d box;
  for (const PlacedShape& shape : object)
    for (const Eigen::Vector3d& point : planar::innerPoints(shape.shape)) box.extend(shape.X_BS * point);
  return box;
}

int positionOf(const Grasp& grasp, const Eigen::AlignedBox3d& box) {
  int axis = 0;
  const double length_m = box.sizes().maxCoeff(&axis);
  const double share = (grasp.X_OT.translation()[axis] - box.min()[axis]) / length_m;
  return std::clamp(static_cast<int>(share * kPositions), 0, kPositions - 1);
}

std::string approachOf(const Grasp& grasp) {
  const Eigen::Vector3d approach = grasp.X_OT.linear().col(2);
  int axis = 0;
  approach.cwiseAbs().maxCoeff(&axis);
  return {approach[axis] < 0.0 ? '-' : '+', "xyz"[axis]};
}

}  // namespace

bool GraspBin::operator==(const GraspBin& other) const {
  const auto all = [](const GraspBin& bin) {
    return std::tie(bin.position, bin.approach, bin.sampled, bin.valid_at_pick, bin.with_placement,
                    bin.compatible);
  };
  return all(*this) == all(other);
}

std::vector<GraspBin> binsOf(const std::vector<GraspRecord>& grasps, const std::vector<PlacedShape>& object) {
  const Eigen::AlignedBox3d box = boundingBox(object);
  std::map<std::pair<int, std::string>, GraspBin> bins;
  for (const GraspRecord& record : grasps) {
    const auto key = std::make_pair(positionOf(record.grasp, box), approachOf(record.grasp));
    GraspBin& bin = bins[key];
    std::tie(bin.position, bin.approach) = key;
    ++bin.sampled;
    if (record.status != GraspStatus::kInvalidAtPick) ++bin.valid_at_pick;
    if (record.placements_found > 0) ++bin.with_placement;
    if (record.status == GraspStatus::kCompatible) ++bin.compatible;
  }
  std::vector<GraspBin> list;
  for (auto& [key, bin] : bins) list.push_back(std::move(bin));
  return list;
}

}  // namespace b4p
