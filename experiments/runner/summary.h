// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "experiments/runner/experiment.h"
#include "experiments/runner/run_record.h"

namespace b4p {

/// A table per scene in Markdown: solved of runs, verified of solved, median and quartiles of the time to a
/// verified path, or to the first placement, where a run without one counts as longer than the limit; of
/// tasks of placement also how good the best one was. Below it, why runs crashed.
std::string summaryTables(const std::vector<Contender>& contenders, const std::vector<RunRecord>& records);

}  // namespace b4p
