// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include <Eigen/Geometry>

#include "experiments/result.h"
#include "experiments/scene.h"
#include "experiments/verification/kinematics.h"

namespace b4p::verification {

inline constexpr const char* kExactSolution = "Exact solution";  ///< OMPL's name

// Each function answers with the first thing found wrong, one line naming way-point and value, or with an
// empty string. Way-points count from 0.

/// The result is an exact solution of this scene.
std::string statusProblem(const Scene& scene, const PlanResult& result);

/// Joint names are the robot's in their order; there is a way-point; rows are complete, finite and inside
/// the joint limits (to 1e-9 rad or m).
std::string rowsProblem(const Scene& scene, const PlanResult& result, const Kinematics& robot);

/// The grasp is a pose, its opening one that the gripper has, and it holds the scene's object: pads along two
/// opposite faces with the TCP between them, across the stick within its margins, or the polygon edge or
/// listed grasp that grasp_id names.
std::string graspProblem(const Scene& scene, const PlanResult& result, const Kinematics& robot);

/// The object is picked up where it stands (within 1 mm and 0.2 degrees) and comes to rest inside the
/// placement region, upright and turned as asked, and both poses are the ones that the result states.
/// @param X_WO_first, X_WO_last  pose of the object at the path's ends
std::string endsProblem(const Scene& scene, const PlanResult& result, const Eigen::Isometry3d& X_WO_first,
                        const Eigen::Isometry3d& X_WO_last);

}  // namespace b4p::verification
