// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "experiments/runner/listed_scene.h"

namespace b4p {

/// Keeps what the runs of a folder are made with (experiment.json): seed, limits, the content of scene and
/// robot files, planners with their parameters. Where the file is there already, the experiment has to agree
/// with it; scenes, planners, thread counts and runs that are new are added to it.
/// @return the planners of all runs in the folder, earlier ones first
/// @throws InputError naming the first setting that differs; the file is then as it was
std::vector<Contender> reconcileSettings(const std::string& file, const Experiment& experiment,
                                         const std::vector<ListedScene>& scenes);

}  // namespace b4p
