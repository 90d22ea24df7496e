// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/query_export/query_export.h"

#include <filesystem>
#include <utility>

#include "experiments/problem.h"
#include "experiments/query_export/shape_json.h"
#include "experiments/query_export/solved_roots.h"
#include "experiments/result_json.h"
#include "robots/input_error.h"

namespace b4p {
namespace {

constexpr int kSchema = 1;

enum Stream : std::uint64_t { kGraspStream, kRootStream };

Json listOf(const Eigen::Vector3d& v) { return Json::array({v.x(), v.y(), v.z()}); }

Json posesJson(const std::vector<Eigen::Isometry3d>& poses, const char* name) {
  Json list = Json::array();
  for (const Eigen::Isometry3d& X : poses) list.push_back(poseJson(X, name));
  return list;
}

Json jointJson(const Joint& joint) {
  const bool slides = joint.type == JointType::kPrismatic;
  return {{"name", joint.name},
          {"type", slides ? "prismatic" : "revolute"},
          {slides ? "lower_m" : "lower_rad", joint.lower},
          {slides ? "upper_m" : "upper_rad", joint.upper}};
}

Json robotJson(const Manipulator& robot, const Scene& scene) {
  const ManipulatorDescription& description = robot.description();
  Json joints = Json::array(), skipped = Json::array();
  for (const int joint : robot.plannedJoints())
    joints.push_back(jointJson(robot.model().joints[static_cast<std::size_t>(joint)]));
  for (const auto& [first, second] : description.skip_self_collision)
    skipped.push_back(Json::array({first, second}));
  return {{"name", robot.model().name},
          {"urdf_file", std::filesystem::absolute(scene.robot.urdf_file).lexically_normal().string()},
          {"X_WB", poseJson(robot.X_WB(), "X_WB")},
          {"joints", std::move(joints)},
          {"tcp_link", description.tcp_link},
          {"finger_joints", description.finger_joints},
          {"finger_links", description.finger_links},
          {"max_opening_m", description.max_opening_m},
          {"rest", Json(description.rest)},
          {"skip_self_collision", std::move(skipped)}};
}

Json obstaclesJson(const std::vector<Obstacle>& obstacles) {
  Json list = Json::array();
  for (const Obstacle& obstacle : obstacles) {
    Json named{{"name", obstacle.name}};
    named.update(shapeJson(obstacle.shape, "X_WS"));
    list.push_back(std::move(named));
  }
  return list;
}

Json objectJson(const PickPlaceTask& task) {
  Json shapes = Json::array();
  for (const PlacedShape& shape : task.object) shapes.push_back(shapeJson(shape, "X_OS"));
  return {{"name", task.object_name}, {"shapes", std::move(shapes)}};
}

Json regionJson(const PlacementSource& region) {
  return {{"min_m", listOf(region.min_m)},
          {"max_m", listOf(region.max_m)},
          {"upright", region.upright},
          {"yaw_rad", Json::array({region.yaw_min_rad, region.yaw_max_rad})}};
}

Json rootsJson(const std::vector<SolvedRoot>& roots) {
  Json list = Json::array();
  for (const SolvedRoot& root : roots) {
    Json one{{"grasp", root.grasp}};
    if (root.placement != kNoPlacement) one["placement"] = root.placement;
    one["q"] = root.q;
    list.push_back(std::move(one));
  }
  return list;
}

Json worldJson(const Scene& scene, const Manipulator& robot, const char* task, std::uint64_t seed) {
  return {{"schema", kSchema},
          {"scene", scene.name},
          {"task", task},
          {"seed", seed},
          {"robot", robotJson(robot, scene)},
          {"edge_step_m", scene.edge_step_m},
          {"obstacles", obstaclesJson(scene.obstacles)}};
}

ExportedQuery exportPickPlace(const Scene& scene, const QueryExportSettings& settings) {
  const PickPlaceTask& task = scene.pickPlace();
  const Problem open = makeProblem(scene);
  const auto sampler = makeGraspSampler(task.grasps, scene.robot.description.max_opening_m);
  const std::vector<Grasp> grasps =
      drawGrasps(*sampler, settings.grasps, derivedSeed(settings.seed, kGraspStream));
  const Problem problem = withGraspsOnly(open, grasps);
  const SolvedRoots roots =
      solveRoots(problem, settings.placements, settings.place_roots, derivedSeed(settings.seed, kRootStream));
  ExportedQuery query;
  query.failure = rootsProblem(problem, roots);
  query.document = worldJson(scene, *problem.robot, "pick and place", settings.seed);
  query.document["object"] = objectJson(task);
  query.document["X_WO_start"] = poseJson(task.X_WO_start, "X_WO_start");
  query.document["placement_region"] = regionJson(task.placement);
  Json& listed = query.document["grasps"] = Json::array();
  for (const Grasp& grasp : grasps) listed.push_back(graspJson(grasp));
  query.document["X_WO_placements"] = posesJson(roots.placements, "X_WO_placements");
  query.document["pick_roots"] = rootsJson(roots.picks);
  query.document["place_roots"] = rootsJson(roots.places);
  query.document["pairs_tried"] = roots.pairs_tried;
  query.summary = std::to_string(grasps.size()) + " grasps, " + std::to_string(roots.picks.size()) +
                  " with a pick root; " + std::to_string(roots.placements.size()) + " placements, " +
                  std::to_string(roots.places.size()) + " place roots of " +
                  std::to_string(roots.pairs_tried) + " pairs";
  return query;
}

ExportedQuery exportReach(const Scene& scene, const ReachTask& task, const QueryExportSettings& settings) {
  const Manipulator robot(loadUrdf(scene.robot.urdf_file), scene.robot.description, scene.X_WB,
                          scene.robot.file);
  ExportedQuery query;
  query.document = worldJson(scene, robot, "reach", settings.seed);
  query.document["start"] = task.start;
  if (task.orientation_free) {
    Json& positions = query.document["p_WT_targets_m"] = Json::array();
    for (const Eigen::Isometry3d& X_WT : task.X_WT) positions.push_back(listOf(X_WT.translation()));
  } else {
    query.document["X_WT_targets"] = posesJson(task.X_WT, "X_WT_targets");
  }
  Json tolerance{{"position_m", task.position_tolerance_m}};
  if (!task.orientation_free)
    tolerance.update({{"angle_rad", task.angle_tolerance_rad}, {"flip", task.flip}});
  query.document["tolerance"] = std::move(tolerance);
  query.summary = std::to_string(task.X_WT.size()) + " targets of the TCP";
  return query;
}

}  // namespace

void requireExportable(const Scene& scene) {
  if (scene.kind() == TaskKind::kPlacement)
    throw InputError(scene.file, "place",
                     "is a task of placement; those of pick and place and of reaching can be exported");
}

ExportedQuery exportQuery(const Scene& scene, const QueryExportSettings& settings) {
  requireExportable(scene);
  if (const auto* reach = std::get_if<ReachTask>(&scene.task)) return exportReach(scene, *reach, settings);
  return exportPickPlace(scene, settings);
}

}  // namespace b4p
