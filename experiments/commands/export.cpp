// SPDX-License-Identifier: BSD-3-Clause
#include <iostream>
#include <memory>
#include <string>
#include <vector>

#include "experiments/commands/commands.h"
#include "experiments/commands/whole_number.h"
#include "experiments/output_file.h"
#include "experiments/preflight.h"
#include "experiments/query_export/query_export.h"

namespace b4p {
namespace {

constexpr const char* kWhere = "b4p export";
constexpr std::uint64_t kMostDraws = 100000;
constexpr std::uint64_t kMostRoots = 10000000;

struct Options {
  std::vector<std::string> scenes;
  std::string grasps = "100";
  std::string placements = "20";
  std::string place_roots = "1000";
  std::string seed = "1";
  std::string out;
};

QueryExportSettings settingsFrom(const Options& options) {
  QueryExportSettings settings;
  settings.grasps = static_cast<int>(wholeNumber(options.grasps, 1, kMostDraws, kWhere, "--grasps"));
  settings.placements =
      static_cast<int>(wholeNumber(options.placements, 1, kMostDraws, kWhere, "--placements"));
  settings.place_roots =
      static_cast<int>(wholeNumber(options.place_roots, 0, kMostRoots, kWhere, "--place-roots"));
  settings.seed = wholeNumber(options.seed, 0, kLargestSeed, kWhere, "--seed");
  return settings;
}

int exportQueries(const Options& options) {
  const QueryExportSettings settings = settingsFrom(options);
  std::vector<Scene> scenes;
  for (const std::string& scene : options.scenes) scenes.push_back(loadScene(scene));
  for (const Scene& scene : scenes) requireExportable(scene);
  for (const Scene& scene : scenes) preflight(scene);
  requireWritableFile(options.out);
  std::string lines, report;
  for (const Scene& scene : scenes) {
    const ExportedQuery query = exportQuery(scene, settings);
    if (!query.failure.empty()) {
      std::cerr << "b4p: " << scene.file << ": a root failed its verification: " << query.failure
                << std::endl;
      return kNotVerified;
    }
    lines += query.document.dump(-1, ' ', false, Json::error_handler_t::replace) + "\n";
    report += scene.name + ": " + query.summary + "\n";
  }
  writeFile(options.out, lines);
  std::cout << report << "written to " << options.out << "\n";
  return kSolved;
}

}  // namespace

void addExportCommand(CLI::App& app, Run& run) {
  CLI::App* command = app.add_subcommand(
      "export",
      "Write scenes as plain JSON lines that any other planner can read: robot, obstacles, object, grasps, "
      "placements, and verified configurations for them");
  auto options = std::make_shared<Options>();
  command
      ->add_option("SCENE", options->scenes,
                   "Scenes of pick and place, or reaching: names, or paths of scene files")
      ->required();
  command->add_option("--out", options->out, "Queries (JSON, a scene a line)")->required();
  command
      ->add_option("--grasps", options->grasps,
                   "Grasps drawn where they form a continuum; finite families are taken whole")
      ->capture_default_str();
  command->add_option("--placements", options->placements, "Placements drawn")->capture_default_str();
  command->add_option("--place-roots", options->place_roots, "Most configurations at placements")
      ->capture_default_str();
  command->add_option("--seed", options->seed, "Seed of all that is drawn")->capture_default_str();
  command->callback([&run, options] { run = [options] { return exportQueries(*options); }; });
}

}  // namespace b4p
