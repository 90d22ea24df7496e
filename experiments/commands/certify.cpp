// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <iostream>
#include <memory>

#include "experiments/certification/certifier.h"
#include "experiments/commands/commands.h"
#include "experiments/commands/progress_line.h"
#include "experiments/commands/whole_number.h"
#include "experiments/interrupt.h"
#include "experiments/output_file.h"
#include "experiments/query.h"

namespace b4p {
namespace {

constexpr const char* kWhere = "b4p certify";
constexpr std::uint64_t kMostGrasps = 100000;

struct Options {
  std::string scene;
  std::string out;  ///< empty: beside the scene
  std::string grasps = "200";
  std::string seed = "1";
  std::string threads = "1";
  double effort_s = 10.0;
};

CertificateSettings settingsFrom(const Options& options) {
  CertificateSettings settings;
  settings.seed = wholeNumber(options.seed, 0, kLargestSeed, kWhere, "--seed");
  settings.grasps = static_cast<int>(wholeNumber(options.grasps, 1, kMostGrasps, kWhere, "--grasps"));
  requireTimeLimit(options.effort_s, kWhere, "--effort-s");
  settings.effort_s = options.effort_s;
  settings.grids = Certifier::standardGrids();
  return settings;
}

std::string commonest(const std::map<std::string, int>& reasons) {
  const auto most = std::max_element(reasons.begin(), reasons.end(),
                                     [](const auto& a, const auto& b) { return a.second < b.second; });
  if (most == reasons.end()) return "";
  return most->first + " (" + std::to_string(most->second) + " times)";
}

/// Where grasps fail, in a scene where all do.
std::string reason(const Certificate& certificate) {
  const CertificateNumbers& n = certificate.numbers;
  if (n.valid_at_pick == 0) return "at the pick, most often " + commonest(certificate.pick_failures);
  if (n.blocked == n.valid_at_pick) return "every way is proved blocked";
  if (n.with_placement == 0)
    return "at the placement, most often " + commonest(certificate.placement_failures);
  return "no path found for " + std::to_string(n.undecided) + " in " +
         std::to_string(std::lround(certificate.settings.effort_s)) + " s each";
}

/// Bins in which a count is not zero.
std::ptrdiff_t binsWith(const Certificate& certificate, int GraspBin::*count) {
  return std::count_if(certificate.bins.begin(), certificate.bins.end(),
                       [count](const GraspBin& bin) { return bin.*count > 0; });
}

void report(const Certificate& certificate) {
  const CertificateNumbers& n = certificate.numbers;
  if (n.compatible == 0) {
    std::cout << certificate.scene << ": no compatible grasp within the stated effort: of " << n.sampled
              << " sampled, " << n.valid_at_pick << " valid at the pick, " << n.with_placement
              << " with a placement, " << n.blocked << " proved blocked; reason: " << reason(certificate)
              << "\n";
    return;
  }
  std::cout << certificate.scene << ": of " << n.sampled << " grasps, " << n.valid_at_pick
            << " are valid at the pick, " << n.with_placement << " with a placement, " << n.compatible
            << " compatible, " << n.blocked << " proved blocked, " << n.undecided
            << " undecided; smallest distance along a path " << n.clearance_m << " m\n";
  if (!certificate.bins.empty())
    std::cout << "bins of position and approach: " << certificate.bins.size() << ", "
              << binsWith(certificate, &GraspBin::valid_at_pick) << " with a grasp valid at the pick, "
              << binsWith(certificate, &GraspBin::compatible) << " with a compatible one\n";
}

/// @return whether the verifier refused a path
bool reportRefusedPaths(const Certificate& certificate) {
  bool any = false;
  for (const GraspRecord& record : certificate.grasps) {
    if (record.failure.empty()) continue;
    std::cerr << "b4p: grasp " << record.id << ": path NOT verified: " << record.failure << std::endl;
    any = true;
  }
  return any;
}

int certify(const Options& options) {
  const CertificateSettings settings = settingsFrom(options);
  const auto threads =
      static_cast<unsigned>(wholeNumber(options.threads, 1, kMostThreads, kWhere, "--threads"));
  const Scene scene = loadScene(options.scene);
  const std::string file = options.out.empty() ? certificateFile(scene) : options.out;
  requireWritableFile(file);
  Certifier certifier(scene, settings);

  catchInterrupts();
  Certificate certificate;
  {
    const ProgressLine progress([&certifier] { return certifier.progress(); });
    certificate = certifier.run(threads);
  }
  if (interrupted()) {
    std::cerr << "b4p: interrupted, nothing written" << std::endl;
    return kInterrupted;
  }
  writeCertificate(file, certificate);
  report(certificate);
  std::cout << "written to " << file << "\n";
  if (reportRefusedPaths(certificate)) return kNotVerified;
  return certificate.numbers.compatible > 0 ? kSolved : kUnsolved;
}

}  // namespace

void addCertifyCommand(CLI::App& app, Run& run) {
  CLI::App* command = app.add_subcommand(
      "certify",
      "Measure how hard a scene is, grasp by grasp: which are valid at the pick, have a placement, have a "
      "verified path, are proved to have none. Exit code: 3 if a path failed its verification, else 1 if no "
      "compatible grasp was found, else 0");
  auto options = std::make_shared<Options>();
  command->add_option("SCENE", options->scene, "Name of a scene that ships with b4p, or path of a scene file")
      ->required();
  command->add_option("--out", options->out,
                      "Certificate (JSON) [beside the scene file: NAME.certificate.json]");
  command
      ->add_option("--grasps", options->grasps,
                   "Grasps drawn where they form a continuum; finite families are taken whole")
      ->capture_default_str();
  command
      ->add_option("--effort-s", options->effort_s, "Processor time to plan with each grasp, in seconds, > 0")
      ->capture_default_str();
  command->add_option("--seed", options->seed, "Seed")->capture_default_str();
  command->add_option("--threads", options->threads, "Grasps looked at in parallel, 1 to 64")
      ->capture_default_str();
  command->callback([&run, options] { run = [options] { return certify(*options); }; });
}

}  // namespace b4p
