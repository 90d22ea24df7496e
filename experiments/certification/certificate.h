// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "experiments/certification/grasp_bins.h"
#include "experiments/certification/grasp_record.h"
#include "experiments/certification/planar/blocked_proof.h"
#include "experiments/result.h"
#include "experiments/scene.h"

namespace b4p {

/// What decides the outcome of a certification, but for the speed of the machine.
struct CertificateSettings {
  std::uint64_t seed = 1;
  int grasps = 200;           ///< drawn where they form a continuum; finite families are taken whole
  int placement_draws = 100;  ///< tries to place the object with each grasp; > 0
  double effort_s = 10.0;     ///< processor time to plan with each grasp; > 0
  std::vector<planar::GridSize> grids;  ///< for flood fills, coarse to fine; those of a planar robot alone
};

struct CertificateNumbers {
  int sampled = 0;
  int valid_at_pick = 0;
  int with_placement = 0;    ///< of those, with a configuration for one of the placements drawn
  int compatible = 0;        ///< with a verified path
  int blocked = 0;           ///< proved to have none
  int undecided = 0;         ///< planned for without success
  double clearance_m = 0.0;  ///< smallest distance along any of the verified paths; 0 without any
};

/// How hard a scene is, as measured and, where it can be, proved. docs/certificates.md says what the
/// numbers mean.
struct Certificate {
  std::string scene;
  std::string digest;  ///< of the files it speaks about: sceneDigest()
  CertificateSettings settings;
  CertificateNumbers numbers;
  std::map<std::string, int> pick_failures;       ///< why grasps are not valid at the pick
  std::map<std::string, int> placement_failures;  ///< why placements drawn gave no configuration
  std::vector<GraspRecord> grasps;                ///< in the order of their ids, 0, 1, ...
  std::vector<GraspBin> bins;                     ///< empty for a finite family
  std::optional<PlanResult> witness;              ///< a verified path of one compatible grasp
};

CertificateNumbers numbersOf(const std::vector<GraspRecord>& grasps);

/// The first contradiction in what a certificate says of itself, one line, or "".
std::string inconsistency(const Certificate& certificate);

/// Where a scene's certificate is kept: beside its file, NAME.certificate.json.
std::string certificateFile(const Scene& scene);

/// @throws InputError if the place cannot be written; std::invalid_argument if a number is not finite.
void writeCertificate(const std::string& file, const Certificate& certificate);

/// @throws InputError naming file and element, as readResult() does
Certificate readCertificate(const std::string& file);

}  // namespace b4p
