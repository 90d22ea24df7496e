// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/verification/verifier.h"

#include <algorithm>
#include <iostream>
#include <memory>

#include "experiments/commands/commands.h"
#include "experiments/result.h"
#include "experiments/scene.h"

namespace b4p {
namespace {

/// @return the exit code that this file alone would give
ExitCode verifyFile(const std::string& file) {
  const PlanResult result = readResult(file);
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

}  // namespace

void addVerifyCommand(CLI::App& app, Run& run) {
  CLI::App* command = app.add_subcommand("verify",
                                         "Re-check result files by code that shares nothing with the "
                                         "planning checker, at a 10 times finer step");
  auto files = std::make_shared<std::vector<std::string>>();
  command->add_option("RESULT", *files, "Result files (JSON) that `b4p plan` or `b4p bench` wrote")
      ->required();
  command->callback([&run, files] {
    run = [files] {
      int worst = kSolved;
      for (const std::string& file : *files) worst = std::max<int>(worst, verifyFile(file));
      return worst;
    };
  });
}

}  // namespace b4p
