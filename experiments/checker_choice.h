// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <string>

#include "state_validity/collision_checker.h"

namespace b4p {

/// Which checker answers a planner. All of them say the same.
enum class CheckerKind {
  kFast,  ///< vectorised
  kFcl,   ///< FCL alone
};

/// "fast" or "fcl".
std::string checkerName(CheckerKind kind);

/// @throws InputError for a name that is neither, naming where and element
CheckerKind checkerNamed(const std::string& name, const std::string& where, const std::string& element);

/// @throws std::invalid_argument as makeFclChecker() does
std::shared_ptr<const CollisionChecker> makeChecker(CheckerKind kind, CollisionProblem problem);

}  // namespace b4p
