// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cctype>

#include "experiments/verification/number_text.h"
#include "experiments/verification/task_checks.h"
#include "experiments/verification/verifier.h"

namespace b4p {
namespace {

using verification::kExactSolution;
using verification::text;

constexpr double kLateness_s = 1.0;

/// A text from a file as it may stand in a message of one line.
std::string quoted(std::string words) {
  std::replace_if(
      words.begin(), words.end(), [](unsigned char c) { return std::iscntrl(c) != 0; }, ' ');
  return "'" + words + "'";
}

std::string outcomeProblem(const PlanResult& result) {
  const std::string solved = std::string("solved: ") + (result.solved ? "true" : "false");
  if (result.solved != (result.status == kExactSolution))
    return solved + " contradicts the status " + quoted(result.status);
  if (result.solved == result.path.empty())
    return solved + " contradicts the path of " + std::to_string(result.path.size()) + " way-points";
  return "";
}

std::string effortProblem(const PlanResult& result) {
  if (result.threads == 0) return "threads: 0 cannot have planned";
  if (!(result.time_limit_s > 0.0))
    return "time_limit_s: " + text(result.time_limit_s) + " is not a positive time";
  if (!(result.planning_time_s >= 0.0))
    return "planning_time_s: " + text(result.planning_time_s) + " is not a time";
  if (result.solved && !(result.planning_time_s <= result.time_limit_s + kLateness_s))
    return "planning_time_s: " + text(result.planning_time_s) + " is beyond the time limit of " +
           text(result.time_limit_s) + " s";
  return "";
}

std::string storedVerificationProblem(const PlanResult& result) {
  const Verification& stored = result.verification;
  if (result.solved && !stored.passed)
    return "verification.passed: the file's own verification says that the path failed" +
           (stored.failure.empty() ? "" : ": " + quoted(stored.failure));
  if (!result.solved && stored.passed) return "verification.passed: true, and there is no path";
  if (stored.passed && !stored.failure.empty())
    return "verification.failure: " + quoted(stored.failure) + " contradicts that the path passed";
  return "";
}

}  // namespace

std::string inconsistency(const PlanResult& result) {
  std::string problem = outcomeProblem(result);
  if (problem.empty()) problem = effortProblem(result);
  if (problem.empty()) problem = storedVerificationProblem(result);
  return problem;
}

}  // namespace b4p
