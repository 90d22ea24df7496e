// SPDX-License-Identifier: BSD-3-Clause
// reach_survey ATTEMPTS SCENE...: how many grasps of a reaching task there are, at how many the open hand
// alone is free, and for how many ATTEMPTS random restarts of inverse kinematics, with the flip where it
// counts as the same, find a free configuration; answers a second of the inverse kinematics alone, and free
// ones a second with the checks. For the fastest inverse kinematics there is and for damped least squares.
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <random>
#include <string>
#include <utility>

#include "experiments/floating_body.h"
#include "experiments/scene.h"
#include "planners/processor_time.h"
#include "robots/input_error.h"
#include "robots/inverse_kinematics.h"

namespace b4p {
namespace {

struct Survey {
  std::size_t grasps = 0, hand_free = 0, feasible = 0;
  std::size_t attempts = 0, answers = 0, free_answers = 0;
  double ik_s = 0.0, check_s = 0.0;
};

using Maker = std::unique_ptr<InverseKinematics> (*)(std::shared_ptr<const Manipulator>, IkTolerance);

Survey survey(const Scene& scene, int attempts, Maker make_ik) {
  const auto& task = std::get<ReachTask>(scene.task);
  const auto robot = std::make_shared<const Manipulator>(
      loadUrdf(scene.robot.urdf_file), scene.robot.description, scene.X_WB, scene.robot.file);
  CollisionProblem problem;
  problem.robot = robot;
  problem.obstacles = scene.obstacles;
  problem.edge_step_m = scene.edge_step_m;
  const auto checker = makeFclChecker(problem);
  const auto context = checker->makeContext();
  FloatingBody hand(*FloatingBody::makeChecker(problem, FloatingBody::Parts::kGripper));
  Grasp open;
  open.opening_m = robot->description().max_opening_m;
  const auto ik = make_ik(robot, {});
  const Eigen::Isometry3d flip(Eigen::AngleAxisd(3.14159265358979323846, Eigen::Vector3d::UnitZ()));
  std::mt19937_64 random(1);
  Eigen::VectorXd q;
  Survey found;
  for (const Eigen::Isometry3d& X_WT : task.X_WT) {
    ++found.grasps;
    if (!hand.isFree(X_WT, open)) continue;
    ++found.hand_free;
    bool feasible = false;
    for (int i = 0; i < attempts && !feasible; ++i) {
      const Eigen::Isometry3d target = task.flip && i % 2 == 1 ? X_WT * flip : X_WT;
      const double begin_s = threadTime_s();
      const bool answer = ik->solve(target, random, 1, q);
      const double solved_s = threadTime_s();
      ++found.attempts;
      found.answers += answer ? 1 : 0;
      found.ik_s += solved_s - begin_s;
      feasible = answer && context->isFree(q.data(), nullptr);
      if (answer) found.check_s += threadTime_s() - solved_s;
      found.free_answers += feasible ? 1 : 0;
    }
    found.feasible += feasible ? 1 : 0;
  }
  return found;
}

int run(int attempts, const std::vector<std::string>& scenes) {
  const std::pair<const char*, Maker> makers[] = {{"fastest", makeInverseKinematics},
                                                  {"damped", makeDampedInverseKinematics}};
  for (const std::string& name : scenes) {
    for (const auto& [solver, make] : makers) {
      const Survey s = survey(loadScene(name), attempts, make);
      std::cout << name << " " << solver << ": " << s.grasps << " grasps, hand free at " << s.hand_free
                << ", feasible " << s.feasible << "; " << s.attempts << " attempts, " << s.answers
                << " answers, " << std::lround(static_cast<double>(s.answers) / s.ik_s) << " a second; "
                << s.free_answers << " free, "
                << std::lround(static_cast<double>(s.free_answers) / (s.ik_s + s.check_s)) << " a second"
                << std::endl;
    }
  }
  return 0;
}

}  // namespace
}  // namespace b4p

int main(int argc, char** argv) {
  if (argc < 3) {
    std::cerr << "reach_survey ATTEMPTS SCENE...\n";
    return 2;
  }
  try {
    return b4p::run(std::atoi(argv[1]), {argv + 2, argv + argc});
  } catch (const b4p::InputError& error) {
    std::cerr << error.what() << "\n";
    return 2;
  }
}
