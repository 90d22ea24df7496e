// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "experiments/runner/run_record.h"

namespace b4p {

/// The finished runs of a benchmark, one line of JSON each (runs.jsonl). A run is in it, for good, once
/// append() has returned; a line that was cut off, by a crash of the machine or the program, is dropped when
/// the file is opened again. One process at a time holds a file open.
class RunFile {
 public:
  /// Opens the file, makes it where there is none, and reads what it holds.
  /// @throws InputError: cannot be opened or written, held by another process, or a line other than the last
  ///   that is no record or the second of one run
  explicit RunFile(const std::string& file);
  ~RunFile();
  RunFile(const RunFile&) = delete;
  RunFile& operator=(const RunFile&) = delete;

  const std::vector<RunRecord>& records() const { return records_; }

  /// @throws InputError when it cannot be written
  void append(RunRecord record);

  /// The record of a run, nullptr where there is none.
  const RunRecord* find(const std::string& scene, const std::string& label, int run) const;

 private:
  void read();

  std::string file_;
  int descriptor_ = -1;
  std::vector<RunRecord> records_;
};

}  // namespace b4p
