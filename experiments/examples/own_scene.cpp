// SPDX-License-Identifier: BSD-3-Clause
// Pick and place from C++ with a scene file, and so with one's own URDF: load, plan, verify, use the path.
// Usage: example_own_scene [SCENE]
#include <iostream>
#include <memory>

#include "experiments/problem.h"
#include "experiments/scene.h"
#include "planners/b4p/b4p_planner.h"
#include "robots/input_error.h"

int main(int argc, char** argv) try {
  const b4p::Problem problem = b4p::makeProblem(b4p::loadScene(argc > 1 ? argv[1] : "maze"));
  const auto planner = std::make_shared<b4p::B4P>(problem.si);
  planner->params()["threads"] = 2;
  problem.setup->setPlanner(planner);
  if (problem.setup->solve(problem.scene.budget_s) != ompl::base::PlannerStatus::EXACT_SOLUTION) return 1;

  using StateType = b4p::ManipulationStateSpace::StateType;
  const auto& path = problem.setup->getSolutionPath();
  const b4p::GraspId grasp = path.getState(0)->as<StateType>()->grasp;
  std::cout << "grasp " << grasp << ", object at (m)\n";
  for (std::size_t i = 0; i < path.getStateCount(); ++i) {
    const double* q = path.getState(static_cast<unsigned>(i))->as<StateType>()->q;
    std::cout << problem.region->objectPose(q, problem.region->grasp(grasp)).translation().transpose()
              << "\n";
  }
  return 0;
} catch (const b4p::InputError& e) {
  std::cerr << e.what() << std::endl;
  return 2;
}
