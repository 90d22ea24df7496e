// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/checker_choice.h"

#include <utility>

#include "robots/input_error.h"

namespace b4p {

std::string checkerName(CheckerKind kind) { return kind == CheckerKind::kFcl ? "fcl" : "fast"; }

CheckerKind checkerNamed(const std::string& name, const std::string& where, const std::string& element) {
  for (const CheckerKind kind : {CheckerKind::kFast, CheckerKind::kFcl})
    if (checkerName(kind) == name) return kind;
  throw InputError(where, element, "is neither fast nor fcl (" + name + ")");
}

std::shared_ptr<const CollisionChecker> makeChecker(CheckerKind kind, CollisionProblem problem) {
  return kind == CheckerKind::kFcl ? makeFclChecker(std::move(problem))
                                   : makeVectorChecker(std::move(problem));
}

}  // namespace b4p
