// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "experiments/runner/experiment.h"

namespace b4p::test {

/// A folder of its own under the system's temporary folder, removed at the end.
class TemporaryFolder {
 public:
  TemporaryFolder();
  ~TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  std::string operator/(const std::string& name) const { return path_ + "/" + name; }
  const std::string& path() const { return path_; }

  /// Names of all files below, sorted.
  std::vector<std::string> files() const;

 private:
  std::string path_;
};

std::string readFile(const std::string& file);
void writeText(const std::string& file, const std::string& text);

/// Replaces what stands exactly once in a text; fails the test otherwise.
std::string replaced(std::string text, const std::string& from, const std::string& to);

/// A copy of the planar test scene with its robot, with changes to one of the files.
class SceneCopy {
 public:
  using Change = std::pair<std::string, std::string>;

  explicit SceneCopy(const std::vector<Change>& changes = {}, const std::string& changed_file = "easy.yaml");
  std::string scene() const { return folder_ / "easy.yaml"; }
  const TemporaryFolder& folder() const { return folder_; }

 private:
  TemporaryFolder folder_;
};

/// A benchmark of a scene, without planners yet.
Experiment benchmarkOf(const SceneCopy& copy, int runs);

/// What a run of the b4p command left.
struct CommandRun {
  int exit_code = -1;
  std::string out;
  std::string err;

  int errorLines() const;
};

/// @param pid_file  when given, gets the number of the command's process
CommandRun runB4p(const std::string& arguments, const std::string& pid_file = "");

}  // namespace b4p::test
