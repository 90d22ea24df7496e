// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/forest_file.h"

#include <vector>

#include <ompl/base/PlannerData.h>
#include <nlohmann/json.hpp>

#include "experiments/output_file.h"

namespace b4p {

namespace ob = ompl::base;

namespace {

constexpr int kSchema = 1;

/// The vertex nearer to the tree's root: edges lead from picks to places, so that is the one before on the
/// pick side and the one after on the place side. The edge that joins the two sides belongs to neither.
int parentOf(const ob::PlannerData& data, unsigned vertex, bool pick) {
  std::vector<unsigned> neighbours;
  pick ? data.getIncomingEdges(vertex, neighbours) : data.getEdges(vertex, neighbours);
  for (const unsigned neighbour : neighbours)
    if (data.getVertex(neighbour).getTag() == data.getVertex(vertex).getTag())
      return static_cast<int>(neighbour);
  return -1;
}

}  // namespace

void writeForests(const std::string& file, const std::string& scene, const PlanningProblem& problem,
                  const ob::Planner& planner) {
  constexpr int kPickTag = 1;
  ob::PlannerData data(problem.si);
  planner.getPlannerData(data);
  nlohmann::json nodes = nlohmann::json::array();
  nlohmann::json openings = nlohmann::json::object();
  for (unsigned i = 0; i < data.numVertices(); ++i) {
    const auto* state = data.getVertex(i).getState()->as<ManipulationStateSpace::StateType>();
    const bool pick = data.getVertex(i).getTag() == kPickTag;
    openings[std::to_string(state->grasp)] = problem.opening_m(state->grasp);
    nodes.push_back({{"side", pick ? 0 : 1},
                     {"grasp", state->grasp},
                     {"parent", parentOf(data, i, pick)},
                     {"q", std::vector<double>(state->q, state->q + problem.space->dof())}});
  }
  const nlohmann::json document{{"schema", kSchema},
                                {"scene", scene},
                                {"openings_m", std::move(openings)},
                                {"nodes", std::move(nodes)}};
  writeFile(file, document.dump() + "\n");
}

}  // namespace b4p
