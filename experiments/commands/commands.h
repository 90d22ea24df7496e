// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>

#include <CLI/CLI.hpp>

namespace b4p {

/// What the command's exit status says.
enum ExitCode {
  kSolved = 0,
  kUnsolved = 1,  ///< ran, but without a solution
  kBadInput = 2,
  kNotVerified = 3,  ///< a result failed verification
  kInternalError = 4,
  kInterrupted = 130,  ///< ended by SIGINT or SIGTERM
};

/// Each adds one sub-command to the parser; when the user asks for it, `run` is set to what it does.
/// What runs returns an exit code and throws InputError.
using Run = std::function<int()>;
void addListCommand(CLI::App& app, Run& run);
void addPlanCommand(CLI::App& app, Run& run);
void addBenchCommand(CLI::App& app, Run& run);
void addSimulateCommand(CLI::App& app, Run& run);
void addVerifyCommand(CLI::App& app, Run& run);
void addGenerateCommand(CLI::App& app, Run& run);
void addImportCommand(CLI::App& app, Run& run);
void addExportCommand(CLI::App& app, Run& run);
void addCertifyCommand(CLI::App& app, Run& run);
void addPlaceCommand(CLI::App& app, Run& run);
void addSurfacesCommand(CLI::App& app, Run& run);

}  // namespace b4p
