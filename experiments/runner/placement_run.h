// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "experiments/placement/placement_query.h"
#include "experiments/runner/benchmark_run.h"

namespace b4p {

/// A run that finds ever better placements until its time is up. It has solved its scene when all its
/// placements are verified and there is one; its time is that of the first.
class PlacementRun : public BenchmarkRun {
 public:
  PlacementRun(const ListedScene& listed, const PlannerCatalogue& catalogue, const QuerySettings& settings,
               const std::string& where);

  /// Planner, parameters and limits, without the scene's preparation. @throws InputError
  static void check(const ListedScene& listed, const PlannerCatalogue& catalogue,
                    const QuerySettings& settings, const std::string& where);

  ompl::geometric::SimpleSetup& setup() const override { return *query_.problem().setup; }
  const std::shared_ptr<DeadlinePlanner>& planner() const override { return query_.planner(); }
  void conclude(const ompl::base::PlannerStatus& status) override;
  bool finished() const override;
  void fill(RunRecord& record) const override;
  std::map<std::string, std::string> columns() const override;
  void write(const std::string& file) const override { writePlacementResult(file, result_); }

 private:
  bool verified() const { return result_.solved() && failure_.empty(); }
  double firstTime_s() const;

  QuerySettings settings_;
  PlacementQuery query_;
  PlacementResult result_;
  std::string failure_;  ///< of verification
};

}  // namespace b4p
