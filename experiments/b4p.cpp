// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <exception>
#include <iostream>
#include <string>

#include <ompl/util/Console.h>

#include "experiments/commands/commands.h"
#include "robots/input_error.h"

namespace b4p {
namespace {

/// One line on stderr, whatever the message.
int fail(const std::string& message, ExitCode code) {
  std::string line = message.substr(0, message.find_last_not_of(" \n") + 1);
  std::replace(line.begin(), line.end(), '\n', ' ');
  std::cerr << "b4p: " << line << std::endl;
  return code;
}

int runCommandLine(int argc, char** argv) {
  CLI::App app("Plans how to pick, carry and place an object: grasp, placement and motion at once.", "b4p");
  app.footer(
      "Units: seconds, metres, radians; the names of options and keys end in _s (-s), _m, _rad.\n"
      "Exit codes: 0 solved, 1 ran but unsolved, 2 bad input, 3 a result failed verification, 4 internal "
      "error, "
      "130 interrupted.");
  app.require_subcommand(1);
  Run run;
  addListCommand(app, run);
  addPlanCommand(app, run);
  addBenchCommand(app, run);
  addSimulateCommand(app, run);
  addVerifyCommand(app, run);
  addGenerateCommand(app, run);
  addImportCommand(app, run);
  addExportCommand(app, run);
  addCertifyCommand(app, run);
  addPlaceCommand(app, run);
  addSurfacesCommand(app, run);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& e) {
    if (e.get_exit_code() == static_cast<int>(CLI::ExitCodes::Success)) return app.exit(e);
    return fail(std::string(e.what()) + " (see b4p --help)", kBadInput);
  }
  try {
    ompl::msg::noOutputHandler();
    return run();
  } catch (const InputError& e) {
    return fail(e.what(), kBadInput);
  } catch (const std::exception& e) {
    return fail(std::string("internal error: ") + e.what(), kInternalError);
  }
}

}  // namespace
}  // namespace b4p

int main(int argc, char** argv) { return b4p::runCommandLine(argc, argv); }
