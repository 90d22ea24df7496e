// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

namespace b4p {

/// The folder that holds `robots/` and `experiments/` with the files that ship with b4p: the environment
/// variable B4P_DATA_DIR, else the source tree b4p was built from, else the place it is installed to.
std::string dataFolder();

/// A path has a YAML extension or begins with `/`, `.` or `..`; all else is a name.
bool isPath(const std::string& name_or_path);

/// The name, or the path made absolute, so that it means the same file from any folder.
std::string nameFromAnywhere(const std::string& name_or_path);

/// `path`, taken relative to the folder of `file`.
std::string relativeTo(const std::string& file, const std::string& path);

/// Names of the YAML files in a folder of dataFolder(), sorted; those in a subfolder as SUBFOLDER/NAME. Empty
/// when there is no such folder.
std::vector<std::string> shippedNames(const std::string& folder);

/// The file a name or path means. @throws InputError listing the names there are when a name is unknown.
std::string shippedFile(const std::string& folder, const std::string& kind, const std::string& name_or_path);

}  // namespace b4p
