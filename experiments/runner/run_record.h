// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "experiments/query.h"
#include "experiments/run_limits.h"

namespace b4p {

/// What OMPL's Benchmark recorded of one run, in the form its logs need.
struct OmplRun {
  std::map<std::string, std::string> common;   ///< the planner's settings
  std::map<std::string, std::string> columns;  ///< "NAME TYPE" -> value, the project's own included
  std::vector<std::string> progress_names;     ///< "NAME TYPE"; empty: the planner reports none
  std::vector<std::map<std::string, std::string>> progress;  ///< a row per sample
};

/// The placements of a run, each better than those before, and what they were worth when.
struct PlacementSeries {
  struct Improvement {
    double time_s = 0.0;  ///< since planning began
    double cpu_s = 0.0;   ///< processor time of the process since then
    double objective_m = 0.0;
    double recomputed_m = 0.0;  ///< the objective as the verifier has it
    std::string arm;
    bool verified = false;
  };

  std::string objective;  ///< as scene files name it
  std::string object;
  std::vector<Improvement> improvements;
};

/// One planned run of a benchmark, whatever came of it: all that tables, logs and a later resumption need.
struct RunRecord {
  std::string scene;  ///< the scene's own name
  std::string label;
  int run = 0;  ///< counted from 1
  std::string planner;
  std::string checker = "fcl";  ///< see checkerNamed(); of lines that do not say, FCL
  std::uint64_t seed = 0;
  unsigned threads = 1;
  RunLimits limits;

  std::string status;  ///< OMPL's name of the planner status
  bool solved = false;
  bool verification_passed = false;
  std::string verification_failure;  ///< first thing found wrong; "" where nothing is
  bool crashed = false;
  std::string crash;  ///< why
  int grasp_id = -1;  ///< of tasks of placement the arm

  /// From the start of planning to its end, which is the path where solved, or the first placement; by the
  /// limits' clock.
  double time_s = 0.0;
  double cpu_s = 0.0;        ///< processor time of all threads meanwhile
  double wall_s = 0.0;       ///< what the run took in all, loading and verification included
  std::uint64_t checks = 0;  ///< configurations checked until then
  std::uint64_t edge_checks = 0;
  std::map<std::string, std::string> build;  ///< see buildInfo()
  OmplRun ompl;
  std::optional<PlacementSeries> placement;  ///< of tasks of placement

  bool verified() const { return solved && verification_passed; }
};

/// One line of JSON, without its end.
std::string recordLine(const RunRecord& record);

/// @param where  named in errors: file and line
/// @throws InputError
RunRecord recordFrom(const std::string& line, const std::string& where);

}  // namespace b4p
