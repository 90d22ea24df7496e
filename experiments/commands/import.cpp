// SPDX-License-Identifier: BSD-3-Clause
#include <filesystem>
#include <iostream>
#include <memory>
#include <string>

#include "experiments/commands/commands.h"
#include "experiments/import/jogramop.h"
#include "experiments/output_file.h"

namespace b4p {
namespace {

struct Options {
  std::string folder;
  std::string out;
};

/// Everything is read before anything is written.
int import(const Options& options) {
  const std::vector<ImportedScenario> scenarios = importJogramop(options.folder);
  requireWritableFolder(options.out);
  for (const ImportedScenario& scenario : scenarios) {
    std::cout << scenario.id << ":";
    for (const std::string& remark : scenario.remarks)
      std::cout << (&remark == &scenario.remarks.front() ? " " : "; ") << remark;
    std::cout << "\n";
    for (const auto& [name, content] : scenario.files)
      writeFile((std::filesystem::path(options.out) / name).string(), content);
  }
  std::cout << scenarios.size() << " scenarios written to " << options.out << "\n";
  return kSolved;
}

}  // namespace

void addImportCommand(CLI::App& app, Run& run) {
  CLI::App* command = app.add_subcommand("import", "Turn others' benchmarks into scene files");
  command->require_subcommand(1);
  CLI::App* jogramop = command->add_subcommand(
      "jogramop", "A clone of the Jogramop framework: one scene for each of its scenarios");
  auto options = std::make_shared<Options>();
  jogramop->add_option("DIR", options->folder, "The clone, which holds scenarios/")->required();
  jogramop->add_option("--out", options->out, "Folder for scenes, grasps and meshes")->required();
  jogramop->callback([&run, options] { run = [options] { return import(*options); }; });
}

}  // namespace b4p
