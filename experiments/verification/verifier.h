// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "experiments/result.h"
#include "experiments/scene.h"

namespace b4p {

/// Re-checks a planned path with code of its own, from the URDF to the distances: nothing here comes from
/// state_validity, KDL, urdfdom or FCL. Checked, until the first thing is found wrong:
/// - the result is an exact solution of this scene;
/// - its joints are the robot's, in order, and inside their limits;
/// - pick and place: the grasp is one that holds the object; the object is at its start pose at the first
///   way-point (within 1 mm and 0.2 degrees) and inside the placement region at the last one, and the poses
///   stated in the result agree;
/// - reaching: the path begins at the scene's start, and at its end the TCP is within the scene's tolerance
/// of
///   the grasp stated, and where the result says; the fingers are fully open all the way;
/// - along every edge nothing touches: links that the path can move against obstacles, links against
///   each other, held object against obstacles and links except fingers. Shapes are bare, without padding.
///   Links are not compared when no planned joint moves them against each other, when they (or what is
///   fixed to them) are joined by one joint, or when the robot file lists the pair.
///
/// Every edge is divided so finely that no point of robot or object moves more than `edge_step_m` / 10
/// between two samples. At every sample each pair of bodies is either measured, or known to be apart since
/// the distance measured at an earlier sample exceeds what the motion since then can have used up. The
/// clearance reported is the smallest distance at any sample; 0 when there is nothing to measure, or the path
/// fails.
///
/// Thread-safe. The outcome depends on the arguments alone.
/// @throws InputError when the scene's URDF cannot be read or lacks what the robot file names.
Verification verify(const Scene& scene, const PlanResult& result);

/// The first contradiction in what a result file says of itself, one line naming the element and its value,
/// or an empty string. Needs no scene, and complements verify(), which does not look at these:
/// - solved, the status "Exact solution" and a path go together: all three, or none;
/// - there was a thread and time to plan, the planning time is not negative, and where it ended with a path
///   it kept to the limit (within 1 s, since a busy machine ends late);
/// - a path has passed the verification stored with it, without a failure, and nothing else has.
std::string inconsistency(const PlanResult& result);

}  // namespace b4p
