// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/certification/certificate.h"

#include <algorithm>
#include <filesystem>

namespace b4p {
namespace {

bool operator==(const CertificateNumbers& a, const CertificateNumbers& b) {
  return a.sampled == b.sampled && a.valid_at_pick == b.valid_at_pick &&
         a.with_placement == b.with_placement && a.compatible == b.compatible && a.blocked == b.blocked &&
         a.undecided == b.undecided && a.clearance_m == b.clearance_m;
}

std::string recordProblem(const GraspRecord& record, const CertificateSettings& settings) {
  if (record.placements_found < 0 || record.placements_found > settings.placement_draws)
    return "finds more placements than were drawn";
  if (record.status == GraspStatus::kInvalidAtPick && record.placements_found > 0)
    return "has placements, but no pick";
  if (record.status == GraspStatus::kNoPlacement && record.placements_found > 0)
    return "has placements, and none";
  const bool planned = record.status == GraspStatus::kCompatible || record.status == GraspStatus::kUndecided;
  if (planned && record.placements_found == 0) return "was planned for without a placement";
  if ((record.status == GraspStatus::kBlocked) != (record.grid.angles > 0))
    return "is blocked without a grid, or has one without being blocked";
  return "";
}

}  // namespace

CertificateNumbers numbersOf(const std::vector<GraspRecord>& grasps) {
  CertificateNumbers numbers;
  for (const GraspRecord& record : grasps) {
    ++numbers.sampled;
    if (record.status != GraspStatus::kInvalidAtPick) ++numbers.valid_at_pick;
    if (record.placements_found > 0) ++numbers.with_placement;
    if (record.status == GraspStatus::kBlocked) ++numbers.blocked;
    if (record.status == GraspStatus::kUndecided) ++numbers.undecided;
    if (record.status != GraspStatus::kCompatible) continue;
    numbers.clearance_m =
        numbers.compatible == 0 ? record.clearance_m : std::min(numbers.clearance_m, record.clearance_m);
    ++numbers.compatible;
  }
  return numbers;
}

std::string inconsistency(const Certificate& certificate) {
  if (!(certificate.numbers == numbersOf(certificate.grasps)))
    return "numbers: are not those of the grasps listed";
  for (std::size_t i = 0; i < certificate.grasps.size(); ++i) {
    const GraspRecord& record = certificate.grasps[i];
    const std::string where = "grasps[" + std::to_string(i) + "]: ";
    if (record.id != static_cast<int>(i)) return where + "has the id " + std::to_string(record.id);
    if (const std::string problem = recordProblem(record, certificate.settings); !problem.empty())
      return where + problem;
  }
  if (certificate.witness.has_value() != (certificate.numbers.compatible > 0))
    return "witness: a path and compatible grasps go together";
  if (!certificate.witness) return "";
  const int id = certificate.witness->grasp_id;
  const auto count = static_cast<int>(certificate.grasps.size());
  if (id < 0 || id >= count ||
      certificate.grasps[static_cast<std::size_t>(id)].status != GraspStatus::kCompatible)
    return "witness: grasp " + std::to_string(id) + " is not a compatible one";
  return "";
}

std::string certificateFile(const Scene& scene) {
  return std::filesystem::path(scene.file).replace_extension(".certificate.json").string();
}

std::string statusText(GraspStatus status) {
  switch (status) {
    case GraspStatus::kInvalidAtPick:
      return "invalid at pick";
    case GraspStatus::kNoPlacement:
      return "no placement";
    case GraspStatus::kCompatible:
      return "compatible";
    case GraspStatus::kBlocked:
      return "blocked";
    case GraspStatus::kUndecided:
      break;
  }
  return "undecided";
}

}  // namespace b4p
