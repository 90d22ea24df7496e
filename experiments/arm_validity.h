// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <optional>

#include <ompl/base/SpaceInformation.h>

#include "robots/grasp.h"
#include "state_validity/collision_checker.h"

namespace b4p {

/// The joint space of the checker's robot as an ordinary RealVectorStateSpace, in which any OMPL planner
/// plans motions of the arm through the checker; set up. A motion is valid when its straight edge is free,
/// **first state included**. Any thread may ask.
/// @param held  the grasp with which the arm carries the checker's object all the time; none: it carries
/// nothing
ompl::base::SpaceInformationPtr makeArmSpaceInformation(std::shared_ptr<const CollisionChecker> checker,
                                                        const std::optional<Grasp>& held = {});

}  // namespace b4p
