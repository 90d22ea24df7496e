// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "experiments/speedup/speed_run.h"

namespace b4p {

/// The runs of one study, in a file of JSON lines: the study first, then a run a line (docs/files.md). A file
/// that is there already is continued.
class SpeedFile {
 public:
  /// A last line that was cut off in the middle is left out.
  /// @throws InputError naming file, line and value: malformed, an unknown schema, or of another study
  SpeedFile(std::string file, const SpeedStudy& study);

  bool has(const SpeedCase& which) const;

  /// @throws InputError when the file cannot be written
  void add(const SpeedRun& run);

  const std::vector<SpeedRun>& runs() const { return runs_; }

 private:
  void read(const SpeedStudy& study);

  std::string file_;
  std::string text_;
  std::vector<SpeedRun> runs_;
};

}  // namespace b4p
