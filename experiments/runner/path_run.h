// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "experiments/runner/benchmark_run.h"

namespace b4p {

/// A run that ends with its first path: of pick and place, and of reaching.
class PathRun : public BenchmarkRun {
 public:
  PathRun(const ListedScene& listed, const PlannerCatalogue& catalogue, const QuerySettings& settings,
          const std::string& where);

  ompl::geometric::SimpleSetup& setup() const override { return *query_.problem().setup; }
  const std::shared_ptr<DeadlinePlanner>& planner() const override { return query_.planner(); }
  void conclude(const ompl::base::PlannerStatus& status) override;
  bool finished() const override { return result_.solved; }
  void fill(RunRecord& record) const override;
  std::map<std::string, std::string> columns() const override;
  void write(const std::string& file) const override { writeResult(file, result_); }

 private:
  Query query_;
  PlanResult result_;
};

}  // namespace b4p
