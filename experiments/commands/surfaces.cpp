// SPDX-License-Identifier: BSD-3-Clause
#include <iostream>
#include <memory>
#include <string>

#include "experiments/commands/commands.h"
#include "experiments/output_file.h"
#include "experiments/placement/placement_file.h"
#include "experiments/placement/surface_file.h"
#include "robots/number_text.h"

namespace b4p {
namespace {

struct Options {
  std::string scene;
  std::string out;
};

int showSurfaces(const Options& options) {
  const Scene scene = loadPlacementScene(options.scene);
  if (!options.out.empty()) requireWritableFile(options.out);
  const PlacementGeometry geometry(scene);
  std::cout << scene.name << ": " << geometry.faces().size() << " placement faces of "
            << scene.placing().object_name << ", " << geometry.surfaces().regions().size()
            << " contact regions\n";
  for (const ContactRegion& region : geometry.surfaces().regions())
    std::cout << "  z " << numberText(region.height_m) << " m: " << region.cells.size() << " cells, "
              << numberText(region.cells.size() * region.cell_m * region.cell_m) << " m2\n";
  if (options.out.empty()) return kSolved;
  writeSurfaces(options.out, scene, geometry);
  std::cout << "written to " << options.out << "\n";
  return kSolved;
}

}  // namespace

void addSurfacesCommand(CLI::App& app, Run& run) {
  CLI::App* command = app.add_subcommand(
      "surfaces", "Where an object can be put down in a placement scene, and on which of its faces");
  auto options = std::make_shared<Options>();
  command->add_option("SCENE", options->scene, "Placement scene: a name, or a path to a YAML file")
      ->required();
  command->add_option("--out", options->out, "Regions and faces (JSON), for scripts/placement_regions.py");
  command->callback([&run, options] { run = [options] { return showSurfaces(*options); }; });
}

}  // namespace b4p
