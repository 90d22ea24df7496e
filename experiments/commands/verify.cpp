// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/verification/verifier.h"

#include <array>
#include <iostream>
#include <memory>

#include "experiments/commands/commands.h"
#include "experiments/placement/placement_check.h"
#include "experiments/placement/placement_file.h"
#include "experiments/placement/placement_result_json.h"
#include "experiments/result_json.h"
#include "experiments/scene.h"
#include "robots/input_error.h"

namespace b4p {
namespace {

ExitCode verifyPlacements(const std::string& file, PlacementResult result) {
  if (!result.solved()) {
    std::cout << file << ": holds no placement (" << result.status << ")\n";
    return kUnsolved;
  }
  verifyImprovements(loadPlacementScene(result.scene), result);
  const std::string failure = firstFailure(result);
  if (!failure.empty()) {
    std::cout << file << ": FAILED: " << failure << "\n";
    return kNotVerified;
  }
  const PlacementVerification& best = result.improvements.back().verification;
  std::cout << file << ": passed, " << result.improvements.size() << " improvements, the last at "
            << best.configurations << " configurations at most " << best.step_m << " m apart, objective "
            << best.objective_m << " m\n";
  return kSolved;
}

/// @return the exit code that this file alone would give
ExitCode verifyFile(const std::string& file) {
  const Json document = readJson(file);
  if (isPlacementResult(document))
    return verifyPlacements(file, placementResultFrom(JsonValue(file, "", document)));
  const PlanResult result = resultFrom(JsonValue(file, "", document));
  const std::string contradiction = inconsistency(result);
  if (!contradiction.empty()) {
    std::cout << file << ": FAILED: " << contradiction << "\n";
    return kNotVerified;
  }
  if (!result.solved) {
    std::cout << file << ": holds no path (" << result.status << ")\n";
    return kUnsolved;
  }
  const Verification verification = verify(loadScene(result.scene), result);
  if (!verification.passed) {
    std::cout << file << ": FAILED: " << verification.failure << "\n";
    return kNotVerified;
  }
  std::cout << file << ": passed, " << verification.configurations << " configurations at most "
            << verification.step_m << " m apart, smallest distance " << verification.clearance_m << " m\n";
  return kSolved;
}

/// All files, whatever becomes of those before. A failed verification outweighs a file that cannot be read,
/// and that a file without a path.
ExitCode verifyFiles(const std::vector<std::string>& files) {
  std::array<bool, kInternalError> met{};
  for (const std::string& file : files) {
    try {
      met[verifyFile(file)] = true;
    } catch (const InputError& e) {
      std::cerr << "b4p: " << e.what() << std::endl;
      met[kBadInput] = true;
    }
  }
  for (const ExitCode code : {kNotVerified, kBadInput, kUnsolved})
    if (met[code]) return code;
  return kSolved;
}

}  // namespace

void addVerifyCommand(CLI::App& app, Run& run) {
  CLI::App* command = app.add_subcommand("verify",
                                         "Re-check result files by code that shares nothing with the "
                                         "planning checker, at a 10 times finer step. Exit code: 3 if any "
                                         "fails, else 2 if any cannot be read, else 1 if any "
                                         "holds no path, else 0");
  auto files = std::make_shared<std::vector<std::string>>();
  command
      ->add_option("RESULT", *files, "Result files (JSON) that `b4p plan`, `b4p place` or `b4p bench` wrote")
      ->required();
  command->callback([&run, files] { run = [files] { return verifyFiles(*files); }; });
}

}  // namespace b4p
