// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "planners/b4p/worker.h"

namespace b4p {

/// The worker as printed (Algorithms 2-4): a fixed number of roots, one forest per side for all grasps,
/// nearest tree by nearest node, a connection attempt at every iteration in which both sides moved, Eq. 3
/// after it.
class PaperWorker : public Worker {
 public:
  using Worker::Worker;

 protected:
  void advance() override;
  void salvage(const PathRepair&) override {}
  void discard(const Junction&) override {}

 private:
  bool spawnForest();
  void connect(const Junction& junction);
};

}  // namespace b4p
