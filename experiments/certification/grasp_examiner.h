// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "experiments/certification/certificate.h"
#include "experiments/problem.h"

namespace b4p {

/// All that comes of looking at one grasp.
struct Examination {
  GraspRecord record;
  std::string pick_failure;  ///< why the grasp is not valid at the pick; "" where it is
  std::map<std::string, int> placement_failures;
  std::optional<PlanResult> path;  ///< of a compatible grasp, verified
};

/// Finds out about single grasps of a scene. Immutable; any thread may ask.
class GraspExaminer {
 public:
  /// @throws InputError when the robot's files are at fault
  GraspExaminer(const Scene& scene, CertificateSettings settings);

  /// All grasps of a finite family, else as many as the settings say.
  const std::vector<Grasp>& grasps() const { return grasps_; }
  bool finite() const { return problem_.region->finite(); }

  /// "" where blocked grasps can be proved blocked, else why not.
  const std::string& whyNoProof() const { return why_no_proof_; }

  /// Tries picks and placements; tries to prove the grasp blocked; plans for it; tries finer cells. Ends
  /// early, with a record that means nothing, when interrupted(). Depends on the settings and the grasp's
  /// number alone, but for the time that planning takes.
  Examination examine(int id) const;

  /// The part of examine() that says whether the grasp is valid at the pick: configurations that hold the
  /// object there, at most a few. None: `failure` says why.
  std::vector<std::vector<double>> picks(int id, std::string& failure) const;

 private:
  std::uint64_t seedOf(int id) const;
  Problem problemOf(int id) const;
  void countPlacements(Examination& examination) const;
  bool proveBlocked(GraspRecord& record, std::size_t first_grid, std::size_t last_grid) const;
  void plan(const std::vector<std::vector<double>>& starts, Examination& examination) const;

  CertificateSettings settings_;
  Problem problem_;
  std::string why_no_proof_;
  std::vector<Grasp> grasps_;
};

}  // namespace b4p
