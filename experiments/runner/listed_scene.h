// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "experiments/runner/experiment.h"

namespace b4p {

/// A scene as an experiment lists it and as it was loaded.
struct ListedScene {
  std::string given;  ///< name or path
  Scene scene;        ///< its name is its own but for objectives, which are appended: NAME-OBJECTIVE
};

/// The scenes of an experiment, each once per objective where the experiment lists some.
/// @throws InputError as loadScene() does, for two scenes of one name, and for objectives where a scene has
///   none
std::vector<ListedScene> listedScenes(const Experiment& experiment);

}  // namespace b4p
