// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/planners.h"
#include "planners/parallel_planner.h"
#include "planners/placement/placement_planner.h"
#include "planners/placement/redirectable_rrt_connect.h"
#include "planners/reach/reach_planner.h"

namespace b4p {
namespace {

using Meanings = std::map<std::string, std::string>;

const Meanings kOfParallelPlanners{
    {"threads", "parallel workers (count); set by --threads"},
    {"paper", "1: the algorithm as printed; set by the planner's name"},
    {"pick_roots", "b4p-paper: pick trees (count)"},
    {"place_roots", "b4p-paper: place trees (count)"},
    {"relaxed", "1: trees of different grasps are joined; 0: only those of equal grasps"},
    {"repair", "1: a path that collides after its place root was derived anew is repaired; 0: thrown away"},
    {"slide", "b4p: 1: where a motion is blocked, trees go on along one joint at a time; 0: they stop there"},
    {"range", "longest motion added at once (joint distance: rad, m for sliding joints); 0: no limit"},
    {"slice",
     "first turn of growth of a grasp's trees before others have theirs (iterations); b4p and "
     "redirectable-rrtconnect: every turn"},
    {"retreat_steps", "b4p: nodes in a row on each straight way out of a root; 0: no such ways (count)"},
    {"root_attempts",
     "b4p: placements tried per turn of root drawing; rrt-restart: per slice of growth (count)"},
    {"repair_iterations", "local replanning per colliding stretch before a repair fails (iterations)"},
    {"placement_attempts", "placements without a place root after which a grasp is given up (count)"},
    {"redraw", "0: a grasp without a place root is kept; 1: given up after placement_attempts"},
    {"restart_s", "time after which the trees are dropped for another grasp (s)"},
    {"restart_iterations",
     "> 0: drops all trees after so many steps of all threads (iterations); b4p: paper mode only"},
    {"shortcuts", "b4p: shortcuts tried on the path found; 0: none (count)"},
    {"growth", "each slice is so many times the one before (factor)"}};

const Meanings kOfReachPlanners{
    {"range", "longest motion added at once (joint distance: rad, m for sliding joints); 0: no limit"},
    {"steer_probability", "share of the iterations that steer the TCP to a grasp, the others grow randomly"},
    {"weighted_grasps", "1: near grasps are steered to more often; 0: all equally often"},
    {"cartesian_step", "longest step of the TCP while steering (m)"},
    {"steering_steps", "steps after which steering gives up (count)"},
    {"orientation_distance", "farther from the grasp only its position counts (m)"},
    {"scaled_metric", "1: nearest nodes by joints in shares of their range; 0: by joint distance"},
    {"ik_attempts", "random seeds of inverse kinematics per grasp and turn (count)"},
    {"iterations", "of the search to a configuration before its grasp is dropped (count)"},
    {"goal_bias", "share of the iterations that grow to goal configurations"},
    {"ik_probability", "share of the iterations that look for a further goal configuration"}};

const Meanings kOfPlacementPlanner{
    {"range", "longest motion added at once (joint distance: rad, m for sliding joints); 0: no limit"},
    {"slice", "of one arm before the next has its turn (iterations)"},
    {"iterations", "of motion planning between two drawings of placements, all arms together (count)"},
    {"draws", "placements drawn at most until one is valid (count)"},
    {"local", "1: placements that have been reached are improved locally"},
    {"local_step", "of the joints while improving (rad)"},
    {"local_steps", "while improving, at most (count)"},
    {"sampling", "tree search over arm, face and region, or a child drawn at each level, or all cells alike"},
    {"reward", "of a draw: staged by the tests passed, or a quarter for each constraint as printed (Eq. 3)"},
    {"exploration", "c of UCB1"},
    {"stage", "reward of a draw that fails at the arm's collisions alone"},
    {"discount", "factor on what has been learnt when the best objective rises"},
    {"ik_attempts", "random seeds of inverse kinematics per answer (count)"},
    {"postures", "answers of inverse kinematics tried per placement (count)"},
    {"pose_first", "1: the object's pose is tested before inverse kinematics; 0: the authors' order"},
    {"hand_first", "1: the hand alone is tested before inverse kinematics"},
    {"prune", "1: branches whose bound is below the best objective are closed"},
    {"take_back", "1: rewards that the best objective has overtaken are taken back"}};

std::string lookedUp(const Meanings& meanings, const std::string& name) {
  const auto found = meanings.find(name);
  return found == meanings.end() ? "" : found->second;
}

}  // namespace

std::string parameterMeaning(const ompl::base::Planner& planner, const std::string& name) {
  if (dynamic_cast<const ParallelPlanner*>(&planner) != nullptr ||
      dynamic_cast<const RedirectableRRTConnect*>(&planner) != nullptr)
    return lookedUp(kOfParallelPlanners, name);
  if (dynamic_cast<const PlacementPlanner*>(&planner) != nullptr) return lookedUp(kOfPlacementPlanner, name);
  if (dynamic_cast<const ReachPlanner*>(&planner) != nullptr) return lookedUp(kOfReachPlanners, name);
  return "";
}

}  // namespace b4p
