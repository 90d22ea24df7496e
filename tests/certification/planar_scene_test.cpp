// SPDX-License-Identifier: BSD-3-Clause
// Cells called blocked collide, says the checker that planning uses, wherever one looks in them; and the
// cells that it finds in collision are mostly called blocked.
#include "experiments/certification/planar/planar_scene.h"

#include <gtest/gtest.h>

#include <random>

#include "experiments/certification/certificate.h"
#include "experiments/fixtures.h"
#include "experiments/problem.h"

namespace b4p::test {
namespace {

using planar::BitVolume;
using planar::GridSize;
using planar::Se2Grid;

bool never() { return false; }

struct Cell {
  int layer, row, column;
};

Cell cellAt(const Se2Grid& grid, const double* q) {
  const int layer = static_cast<int>(std::lround(q[2] / grid.layerAngle())) % grid.layers;
  return {(layer + grid.layers) % grid.layers,
          static_cast<int>(std::floor((q[1] - grid.min_m.y()) / grid.cell_m)),
          static_cast<int>(std::floor((q[0] - grid.min_m.x()) / grid.cell_m))};
}

/// The cells of a planar scene under one grasp, and the exact checker of bare shapes.
class PlanarCells {
 public:
  PlanarCells(const Scene& scene, GraspId grasp, const GridSize& size)
      : problem_(makeProblem(scene)),
        grasp_(problem_.region->grasp(grasp)),
        task_(planar::planarTask(scene, *problem_.robot, grasp_)),
        grid_(planar::gridOf(task_, size)),
        blocked_(*planar::blockedCells(task_, grid_, never)) {
    CollisionProblem bare = problem_.checker->problem();
    bare.padding_m = 0.0;
    collisions_ = makeFclChecker(bare)->makeContext();
  }

  const Se2Grid& grid() const { return grid_; }
  const Manipulator& robot() const { return *problem_.robot; }
  const planar::PlanarTask& task() const { return task_; }
  bool isFree(const double* q) const { return collisions_->isFree(q, &grasp_); }
  bool blocked(const Cell& cell) const { return blocked_.test(cell.layer, cell.row, cell.column); }
  bool blocked(const double* q) const { return blocked(cellAt(grid_, q)); }

  /// Uniform over the joint limits, within one turn.
  void draw(std::mt19937_64& random, double* q) const {
    for (int i = 0; i < 2; ++i)
      q[i] = std::uniform_real_distribution<double>(robot().lower()[i], robot().upper()[i])(random);
    q[2] = std::uniform_real_distribution<double>(-planar::kPi, planar::kPi)(random);
  }

  /// Somewhere in a cell; q[2] in [-pi, pi].
  void drawIn(const Cell& cell, std::mt19937_64& random, double* q) const {
    std::uniform_real_distribution<double> off(-0.5, 0.5);
    q[0] = grid_.xOf(cell.column) + off(random) * grid_.cell_m;
    q[1] = grid_.yOf(cell.row) + off(random) * grid_.cell_m;
    q[2] = std::remainder(grid_.angleOf(cell.layer) + off(random) * grid_.layerAngle(), 2.0 * planar::kPi);
  }

 private:
  Problem problem_;
  Grasp grasp_;
  planar::PlanarTask task_;
  Se2Grid grid_;
  BitVolume blocked_;
  std::unique_ptr<CollisionContext> collisions_;
};

void expectSound(const PlanarCells& cells) {
  constexpr int kDraws = 4000, kDrawsPerCell = 5;
  std::mt19937_64 random(1);
  int colliding = 0, called_blocked = 0, checked = 0;
  double q[3];
  for (int draw = 0; draw < kDraws; ++draw) {
    cells.draw(random, q);
    if (!cells.isFree(q)) ++colliding;
    const Cell cell = cellAt(cells.grid(), q);
    if (!cells.blocked(cell)) continue;
    ++called_blocked;
    for (int i = 0; i < kDrawsPerCell; ++i) {
      cells.drawIn(cell, random, q);
      if (!cells.robot().withinLimits(q)) continue;
      ++checked;
      ASSERT_FALSE(cells.isFree(q)) << q[0] << " " << q[1] << " " << q[2];
    }
  }
  EXPECT_GT(checked, 500);
  EXPECT_LT(colliding, 0.99 * kDraws) << "everything collides anyway";
  EXPECT_GT(called_blocked, 0.75 * colliding) << "too cautious to prove anything";
  EXPECT_LE(called_blocked, colliding);
}

TEST(PlanarScene, BlockedCellsOfTheMazeCollide) {
  const Scene maze = loadScene("maze");
  for (const GraspId grasp : {0, 2, 7, 13, 19}) expectSound(PlanarCells(maze, grasp, {0.02, 128}));
}

TEST(PlanarScene, BlockedCellsAmongObstaclesOfAllKindsCollide) {
  const std::vector<SceneCopy::Change> round{
      {"  - {name: west, box: {size_m: [0.1, 3.0, 0.1]}, position_m: [-1.5, 0, 0]}\n",
       "  - {name: ball, sphere: {radius_m: 0.3}, position_m: [2.3, 0.6, 0.1]}\n"
       "  - {name: pillar, cylinder: {radius_m: 0.2, length_m: 0.4}, position_m: [-0.6, 0.5, 0]}\n"
       "  - {name: log, capsule: {radius_m: 0.1, length_m: 0.5}, position_m: [2.4, -0.6, 0.02], "
       "rpy_rad: [1.3, 0.4, 0]}\n"
       "  - {name: beam, box: {size_m: [0.2, 0.3, 0.9]}, position_m: [-0.5, -0.5, 0], rpy_rad: [0.5, 0.6, "
       "0]}\n"
       "  - {name: wedge, prism: {height_m: 0.1, polygon_m: [[0, 0], [0.5, 0.1], [0.1, 0.4]]}, "
       "position_m: [0.4, 0.6, 0.04], rpy_rad: [0, 0, 0.7]}\n"}};
  const SceneCopy copy(round);
  const Scene scene = loadScene(copy.scene());
  for (const GraspId grasp : {0, 3}) expectSound(PlanarCells(scene, grasp, {0.02, 128}));
}

TEST(PlanarScene, BaseThatIsTurnedAndMovedChangesNothing) {
  // The scene turned by 0.5 rad about the origin, base included: the same task in a turned frame.
  const SceneCopy copy;
  Scene scene = loadScene(copy.scene());
  const Eigen::Isometry3d X(Eigen::AngleAxisd(0.5, Eigen::Vector3d::UnitZ()));
  scene.X_WB = X;
  scene.pickPlace().X_WO_start = X * scene.pickPlace().X_WO_start;
  for (Obstacle& obstacle : scene.obstacles) obstacle.shape.X_BS = X * obstacle.shape.X_BS;
  const Problem problem = makeProblem(scene);
  const planar::PlanarTask task = planar::planarTask(scene, *problem.robot, problem.region->grasp(1));
  double q[3];
  ASSERT_TRUE(problem.region->makeSceneContext(1)->pickRoot(1, q));
  const Eigen::Vector3d position = X * Eigen::Vector3d(q[0], q[1], 0.0);
  EXPECT_NEAR((task.start.position - position.head<2>()).norm(), 0.0, 1e-4);
  EXPECT_NEAR(std::remainder(task.start.angle_rad - q[2], 2.0 * planar::kPi), 0.0, 1e-3);
  for (const double x : {-1.0, 3.0})
    for (const double y : {-1.0, 1.0}) {
      const Eigen::Vector3d corner = X * Eigen::Vector3d(x, y, 0.0);
      EXPECT_TRUE((corner.head<2>().array() >= task.min_m.array() - 1e-9).all());
      EXPECT_TRUE((corner.head<2>().array() <= task.max_m.array() + 1e-9).all());
    }
}

TEST(PlanarScene, VerifiedPathOfTheMazeKeepsOutOfBlockedCells) {
  const Scene maze = loadScene("maze");
  const auto witness = readCertificate(certificateFile(maze)).witness;
  ASSERT_TRUE(witness.has_value());
  for (const GridSize& size : {GridSize{0.05, 64}, GridSize{0.02, 128}, GridSize{0.01, 256}}) {
    const PlanarCells cells(maze, witness->grasp_id, size);
    constexpr int kSamples = 50;
    for (std::size_t i = 0; i + 1 < witness->path.size(); ++i)
      for (int sample = 0; sample <= kSamples; ++sample) {
        double q[3];
        for (std::size_t j = 0; j < 3; ++j)
          q[j] = witness->path[i][j] + (witness->path[i + 1][j] - witness->path[i][j]) * sample / kSamples;
        ASSERT_FALSE(cells.blocked(q)) << i << " " << sample;
      }
    EXPECT_FALSE(planar::floodFromStart(cells.task(), size, never)->blocked);
  }
}

TEST(PlanarScene, ArmsAreRefusedWithAReason) {
  EXPECT_EQ(planar::whyNotPlanar(*makeProblem(loadScene("maze")).robot), "");
  EXPECT_NE(planar::whyNotPlanar(*makeProblem(loadScene("grocery")).robot), "");
  const std::vector<SceneCopy::Change> tilted{
      {"<child link=\"body\"/><axis xyz=\"0 0 1\"/>", "<child link=\"body\"/><axis xyz=\"0 1 0\"/>"}};
  const SceneCopy copy(tilted, "planar.urdf");
  EXPECT_NE(planar::whyNotPlanar(*makeProblem(loadScene(copy.scene())).robot).find("turn"),
            std::string::npos);
}

}  // namespace
}  // namespace b4p::test
