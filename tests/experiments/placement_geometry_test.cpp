// SPDX-License-Identifier: BSD-3-Clause
// Promises: a cell is occupied exactly when a shape overlaps it; surfaces are those counted by hand; objects
// stand on the faces they can stand on; distances and clearances are those of a search over all cells; the
// bound of the clearance holds; boxes around points are the cells that hold them; scenes that are no good are
// refused in one line.
#include <cmath>
#include <fstream>
#include <random>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "experiments/fixtures.h"
#include "experiments/placement/placement_file.h"
#include "experiments/placement/placement_geometry.h"
#include "experiments/placement/point_boxes.h"
#include "experiments/placement/solid.h"
#include "experiments/verification/separation.h"
#include "robots/input_error.h"

namespace b4p::test {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

constexpr double kCell = 0.005;

Lattice latticeOf(int x, int y, int z) {
  Lattice lattice;
  lattice.origin_m = {0.1, -0.2, 0.3};
  lattice.cell_m = kCell;
  lattice.count = {x, y, z};
  return lattice;
}

template <class Visit>
void forCells(const Lattice& lattice, const Visit& visit) {
  for (int z = 0; z < lattice.count.z(); ++z)
    for (int y = 0; y < lattice.count.y(); ++y)
      for (int x = 0; x < lattice.count.x(); ++x) visit(Eigen::Vector3i(x, y, z));
}

/// Fills a block of cells, both corners included.
void fill(OccupancyGrid& grid, const Eigen::Vector3i& low, const Eigen::Vector3i& high) {
  for (int z = low.z(); z <= high.z(); ++z)
    for (int y = low.y(); y <= high.y(); ++y)
      for (int x = low.x(); x <= high.x(); ++x) grid.occupy({x, y, z});
}

Eigen::Isometry3d turned(const Eigen::Vector3d& p, double angle, const Eigen::Vector3d& axis) {
  Eigen::Isometry3d X = Eigen::Isometry3d::Identity();
  X.translation() = p;
  X.linear() = Eigen::AngleAxisd(angle, axis.normalized()).toRotationMatrix();
  return X;
}

TEST(OccupancyGrid, OccupiesWhatABallOverlapsAndNothingElse) {
  const Lattice lattice = latticeOf(20, 18, 16);
  const Eigen::Vector3d centre = lattice.origin_m + Eigen::Vector3d(0.052, 0.043, 0.036);
  constexpr double kRadius = 0.031;
  OccupancyGrid grid(lattice);
  grid.add({Sphere{kRadius}, turned(centre, 0.4, {1, 2, 3})});
  int occupied = 0;
  forCells(lattice, [&](const Eigen::Vector3i& cell) {
    const Eigen::Array3d away = (centre - lattice.centre(cell)).array().abs() - kCell / 2.0;
    const double distance = away.max(0.0).matrix().norm();
    if (std::abs(distance - kRadius) < 1e-5) return;
    EXPECT_EQ(grid.occupied(cell), distance < kRadius) << cell.transpose();
    occupied += grid.occupied(cell);
  });
  EXPECT_GT(occupied, 800);
}

TEST(OccupancyGrid, OccupiesWhatEveryKindOfShapeOverlapsByTheVerifiersDistances) {
  const Lattice lattice = latticeOf(24, 24, 24);
  const Eigen::Vector3d middle = lattice.origin_m + Eigen::Vector3d(0.062, 0.057, 0.066);
  const auto hull =
      convexHull({{0.03, 0, 0}, {-0.02, 0.03, 0}, {-0.02, -0.03, 0.01}, {0, 0, 0.05}, {0, 0, -0.02}});
  const std::vector<Shape> shapes{Box{{0.05, 0.03, 0.004}}, Cylinder{0.02, 0.05}, Capsule{0.012, 0.04}, hull};
  const auto cell_body = verification::ConvexBody::box(Eigen::Vector3d::Constant(kCell));
  constexpr double kUndecided = 2e-5;
  for (const Shape& shape : shapes) {
    const PlacedShape placed{shape, turned(middle, 0.7, {1, -2, 0.5})};
    const auto body = verification::ConvexBody::of(shape);
    OccupancyGrid grid(lattice);
    grid.add(placed);
    int occupied = 0;
    forCells(lattice, [&](const Eigen::Vector3i& cell) {
      Eigen::Isometry3d X = Eigen::Isometry3d::Identity();
      X.translation() = lattice.centre(cell);
      const double apart =
          verification::separation(cell_body, X, body, placed.X_BS, Eigen::Vector3d::UnitX()).distance_m;
      occupied += grid.occupied(cell);
      if (apart > kUndecided || apart < -1e-9) {
        EXPECT_EQ(grid.occupied(cell), apart < 0.0) << shape.index() << " " << cell.transpose();
      }
    });
    EXPECT_GT(occupied, 100);
  }
}

TEST(OccupancyGrid, FacesThatOnlyTouchOccupyNothing) {
  const Lattice lattice = latticeOf(10, 10, 10);
  OccupancyGrid grid(lattice);
  PlacedShape slab{Box{{1.0, 1.0, 0.1}}, Eigen::Isometry3d::Identity()};
  slab.X_BS.translation() = lattice.origin_m + Eigen::Vector3d(0.0, 0.0, 4 * kCell - 0.05);
  grid.add(slab);
  forCells(lattice, [&](const Eigen::Vector3i& cell) { EXPECT_EQ(grid.occupied(cell), cell.z() < 4); });
}

TEST(ContactSurfaces, AreThoseCountedByHand) {
  // A slab of 8 x 6 cells in layer 2, with a post of 1 cell on it at (4, 3), two layers high, and a block of
  // 4 x 3 cells whose top is in the lowest layer.
  OccupancyGrid grid(latticeOf(20, 12, 8));
  fill(grid, {2, 2, 2}, {9, 7, 2});
  fill(grid, {5, 5, 3}, {5, 5, 4});
  fill(grid, {13, 2, 0}, {16, 4, 0});
  const ContactSurfaces surfaces(grid);
  ASSERT_EQ(surfaces.regions().size(), 2u);
  // The block: 2 x 1 cells have all nine beneath them. The slab: 6 x 4, less the post's own cell.
  EXPECT_EQ(surfaces.regions()[0].cells.size(), 2u);
  EXPECT_NEAR(surfaces.regions()[0].height_m, 0.3 + 1.5 * kCell, 1e-12);
  EXPECT_EQ(surfaces.regions()[1].cells.size(), 23u);
  EXPECT_NEAR(surfaces.regions()[1].height_m, 0.3 + 3.5 * kCell, 1e-12);
  int cells = 0;
  forCells(grid.lattice(), [&](const Eigen::Vector3i& cell) {
    cells += surfaces.regionAt(grid.lattice().centre(cell)) >= 0;
  });
  EXPECT_EQ(cells, 25);
  EXPECT_EQ(surfaces.regionAt({1e9, 0, 0}), -1);
  EXPECT_EQ(surfaces.regionAt({std::nan(""), 0, 0}), -1);
}

TEST(ContactSurfaces, JoinDiagonallyAndAreCutIntoTiles) {
  OccupancyGrid grid(latticeOf(80, 12, 3));
  fill(grid, {0, 0, 0}, {4, 4, 0});
  fill(grid, {3, 3, 0}, {7, 7, 0});  // overlaps the first: their surfaces touch at a corner only
  fill(grid, {10, 0, 0}, {79, 11, 0});
  const ContactSurfaces surfaces(grid, 0.30);
  ASSERT_EQ(surfaces.regions().size(), 3u);
  std::vector<std::size_t> sizes;
  for (const ContactRegion& region : surfaces.regions()) {
    sizes.push_back(region.cells.size());
    Eigen::AlignedBox2d box;
    for (const auto& cell : region.cells) box.extend(cell);
    EXPECT_LE((box.max() - box.min()).maxCoeff() + kCell, 0.30 + 1e-9);
  }
  // 68 x 10 surface cells are 0.34 m long: two tiles of 34 x 10.
  EXPECT_THAT(sizes, ::testing::UnorderedElementsAre(9u + 9u, 340u, 340u));
}

TEST(ContactSurfaces, LowestLayerAndPointedThingsCarryNothing) {
  OccupancyGrid grid(latticeOf(9, 9, 4));
  fill(grid, {2, 2, 1}, {3, 6, 1});  // two cells wide
  EXPECT_TRUE(ContactSurfaces(grid).regions().empty());
}

/// The distance by its definition.
double searched(const OccupancyGrid& grid, const Eigen::Vector3i& from) {
  double nearest = grid.lattice().cell_m * grid.lattice().count.cast<double>().norm();
  forCells(grid.lattice(), [&](const Eigen::Vector3i& cell) {
    if (cell.z() >= from.z() && grid.occupied(cell))
      nearest = std::min(nearest, (grid.lattice().centre(cell) - grid.lattice().centre(from)).norm());
  });
  return nearest;
}

OccupancyGrid scattered(unsigned seed) {
  OccupancyGrid grid(latticeOf(17, 13, 9));
  std::mt19937 random(seed);
  for (int i = 0; i < 12; ++i)
    grid.occupy(
        {static_cast<int>(random() % 17), static_cast<int>(random() % 13), static_cast<int>(random() % 7)});
  return grid;
}

TEST(DistanceField, IsTheNearestCellAtOrAbove) {
  for (unsigned seed = 1; seed <= 5; ++seed) {
    const OccupancyGrid grid = scattered(seed);
    const DistanceField field(grid);
    forCells(grid.lattice(), [&](const Eigen::Vector3i& cell) {
      EXPECT_NEAR(field.cell(cell), searched(grid, cell), 1e-6);
      EXPECT_NEAR(field.at(grid.lattice().centre(cell)), searched(grid, cell), 1e-6);
    });
    EXPECT_NEAR(field.at({99, 99, 99}), searched(grid, {16, 12, 8}), 1e-6)
        << "the nearest value holds outside";
  }
}

TEST(DistanceField, WhatCarriesTheObjectDoesNotCount) {
  OccupancyGrid grid(latticeOf(40, 40, 6));
  fill(grid, {0, 0, 1}, {39, 39, 1});
  grid.occupy({0, 0, 4});
  const DistanceField field(grid);
  EXPECT_GT(field.cell({39, 39, 2}), 0.25);
  EXPECT_EQ(field.cell({39, 39, 1}), 0.0);
}

TEST(ClearanceObjective, IsTheMeanOverThePointsAndItsBoundHolds) {
  const OccupancyGrid grid = scattered(3);
  const auto field = std::make_shared<const DistanceField>(grid);
  const Lattice& lattice = grid.lattice();
  // Points at centres of cells, so that nothing is interpolated.
  std::vector<Eigen::Vector3d> points;
  double mean = 0.0;
  for (int i = 0; i < 5; ++i) {
    points.push_back(lattice.centre({4 + i, 6, 2 + i % 2}) - lattice.centre({6, 6, 2}));
    mean += searched(grid, {4 + i, 6, 2 + i % 2}) / 5.0;
  }
  const ClearanceObjective largest(field, points, ClearanceGoal::kLargest);
  const ClearanceObjective smallest(field, points, ClearanceGoal::kSmallest);
  Eigen::Isometry3d X_WO = Eigen::Isometry3d::Identity();
  X_WO.translation() = lattice.centre({6, 6, 2});
  EXPECT_NEAR(largest.value(X_WO), mean, 1e-6);
  EXPECT_NEAR(smallest.value(X_WO), -mean, 1e-6);

  std::mt19937 random(4);
  std::uniform_real_distribution<double> unit(-1.0, 1.0);
  double tightest = 1.0;
  for (int i = 0; i < 20000; ++i) {
    const Eigen::Vector3d pivot_O(0.02 * unit(random), 0.02 * unit(random), 0.0);
    PoseNeighbourhood poses;
    poses.X_WO = turned(
        lattice.origin_m +
            0.08 * (Eigen::Vector3d(unit(random), unit(random), unit(random)).array() + 1.0).matrix() / 2.0,
        3.0 * unit(random), {0, 0, 1});
    poses.p_WV = poses.X_WO * pivot_O;
    poses.radius_m = 0.01 * (1.0 + unit(random));
    poses.half_angle_rad = 0.4 * (1.0 + unit(random));
    const double way = poses.radius_m * std::abs(unit(random)), towards = 3.2 * unit(random);
    const Eigen::Isometry3d turn =
        turned(poses.p_WV + way * Eigen::Vector3d(std::cos(towards), std::sin(towards), 0.0),
               poses.half_angle_rad * unit(random), {0, 0, 1});
    Eigen::Isometry3d back = Eigen::Isometry3d::Identity();
    back.translation() = -poses.p_WV;
    const Eigen::Isometry3d X = turn * back * poses.X_WO;
    for (const ClearanceObjective* objective : {&largest, &smallest}) {
      const double slack = objective->upperBound(poses) - objective->value(X);
      ASSERT_GE(slack, 0.0);
      tightest = std::min(tightest, slack);
    }
  }
  EXPECT_LT(tightest, 0.002) << "a bound that is never near says little";
}

TEST(ClearanceObjective, QuickBoundIsNeverBelowTheValueAndOftenNear) {
  const OccupancyGrid grid = scattered(5);
  const auto field = std::make_shared<const DistanceField>(grid);
  std::vector<Eigen::Vector3d> points;
  for (int x = 0; x < 7; ++x)
    for (int y = 0; y < 4; ++y)
      for (int z = 0; z < 5; ++z) points.push_back(kCell * Eigen::Vector3d(x - 3.3, y - 1.2, z));
  std::mt19937 random(6);
  std::uniform_real_distribution<double> unit(-1.0, 1.0);
  for (const ClearanceGoal goal : {ClearanceGoal::kLargest, ClearanceGoal::kSmallest}) {
    const ClearanceObjective objective(field, points, goal);
    double tightest = 1.0;
    for (int i = 0; i < 20000; ++i) {
      const Eigen::Vector3d p(unit(random), unit(random), unit(random));  // also outside of the lattice
      const Eigen::Isometry3d X_WO = turned(grid.lattice().origin_m + 0.08 * p, 3.0 * unit(random),
                                            {unit(random), unit(random), 1.5 + unit(random)});
      const double slack = objective.quickBound(X_WO) - objective.value(X_WO);
      ASSERT_GE(slack, 0.0);
      tightest = std::min(tightest, slack);
    }
    EXPECT_LT(tightest, 2.0 * kCell);
  }
}

TEST(PlacementFaces, FactsObjectsStandOnTheFacesTheyShould) {
  const auto counted = [](const std::string& item) {
    const Scene scene = loadPlacementScene("placement/panda_table_cluttered_" + item);
    const auto points = hullPoints(scene.placing().object);
    const auto faces = placementFaces(points, scene.placing().p_OCom);
    for (const PlacementFace& face : faces) {
      // Nothing reaches below the face, its corners touch, and the frame has the reference vertex at its
      // origin.
      for (const Eigen::Vector3d& p : points) EXPECT_GT((face.X_FO * p).z(), -1e-9);
      for (const Eigen::Vector3d& p : face.vertices_O) EXPECT_LT((face.X_FO * p).z(), 1e-3);
      EXPECT_LT((face.X_FO * face.vertices_O.front()).norm(), 1e-12);
      EXPECT_NEAR(face.X_FO.linear().determinant(), 1.0, 1e-12);
      // 9.9 mm to any side of the centre of mass there is still face beneath: no half plane through there
      // misses all corners.
      const Eigen::Vector2d com = (face.X_FO * scene.placing().p_OCom).head<2>();
      for (double angle = 0.0; angle < 6.3; angle += 0.05) {
        const Eigen::Vector2d side(std::cos(angle), std::sin(angle));
        double reach = -1.0;
        for (const Eigen::Vector3d& p : face.vertices_O)
          reach = std::max(reach, side.dot((face.X_FO * p).head<2>() - com));
        EXPECT_GE(reach, 0.0099);
      }
    }
    return faces.size();
  };
  EXPECT_EQ(counted("large_crayons"), 6u);
  EXPECT_EQ(counted("small_crayons"), 6u);
  EXPECT_EQ(counted("wine_glass"), 2u);
  EXPECT_EQ(counted("toy_table"), 6u);
}

TEST(PlacementFaces, ACentreOfMassAtTheEdgeIsNotEnough) {
  const auto points = hullPoints({{Box{{0.1, 0.1, 0.1}}, Eigen::Isometry3d::Identity()}});
  // 9 mm from one side: the four faces around that side's normal lack room.
  EXPECT_EQ(placementFaces(points, {0.041, 0.0, 0.0}).size(), 2u);
  EXPECT_EQ(placementFaces(points, {0.039, 0.0, 0.0}).size(), 6u);
  EXPECT_EQ(placementFaces(hullPoints({{Sphere{0.05}, Eigen::Isometry3d::Identity()}}), {0, 0, 0}).size(),
            0u);
}

TEST(Solid, CentreOfMassIsThatOfTheVolume) {
  const auto hull = convexHull(hullPoints({{Box{{0.2, 0.1, 0.3}}, turned({1, 2, 3}, 0.0, {0, 0, 1})}}));
  EXPECT_TRUE(centreOfMass({{hull, Eigen::Isometry3d::Identity()}}).isApprox(Eigen::Vector3d(1, 2, 3), 1e-9));
  PlacedShape small{Box{{0.1, 0.1, 0.1}}, Eigen::Isometry3d::Identity()},
      large{Box{{0.1, 0.1, 0.3}}, Eigen::Isometry3d::Identity()};
  large.X_BS.translation() << 0.4, 0, 0;
  EXPECT_TRUE(centreOfMass({small, large}).isApprox(Eigen::Vector3d(0.3, 0, 0), 1e-12));
}

TEST(PointBoxes, AreExactlyTheCellsThatHoldPoints) {
  const Lattice lattice = latticeOf(12, 10, 8);
  std::mt19937 random(9);
  std::vector<Eigen::Vector3d> points;
  std::vector<char> filled(lattice.size(), 0);
  for (int i = 0; i < 500; ++i) {
    const Eigen::Vector3i cell(static_cast<int>(random() % 12), static_cast<int>(random() % 10),
                               static_cast<int>(random() % 8));
    points.push_back(lattice.centre(cell));
    filled[lattice.index(cell)] = 1;
  }
  OccupancyGrid grid(lattice);
  const auto boxes = boxesAround(points, lattice.origin_m, kCell, "cloud");
  for (const Obstacle& box : boxes) grid.add(box.shape);
  forCells(lattice, [&](const Eigen::Vector3i& cell) {
    EXPECT_EQ(grid.occupied(cell), filled[lattice.index(cell)] != 0);
  });
  EXPECT_LT(boxes.size(), 300u);
}

// Scenes.

std::string shipped(const std::string& name) {
  return readFile(std::string(B4P_SOURCE) + "/experiments/scenes/placement/" + name + ".yaml");
}

std::string sceneRefusal(const std::string& from, const std::string& to) {
  const TemporaryFolder folder;
  writeText(folder / "task.yaml", replaced(shipped("panda_table_cluttered_small_crayons"), from, to));
  try {
    const PlacementGeometry geometry(loadPlacementScene(folder / "task.yaml"));
  } catch (const InputError& e) {
    EXPECT_THAT(e.what(), AllOf(HasSubstr("task.yaml"), Not(HasSubstr("\n"))));
    return e.what();
  }
  return "accepted";
}

TEST(PlacementScene, WhatMakesNoSenseIsRefusedInOneLine) {
  const std::string volume = "volume: {min_m: [-0.4, 0.29, 0], max_m: [0.4, 0.78, 0.2]}";
  const std::string object = "box: {size_m: [0.094, 0.021, 0.071]}";
  EXPECT_EQ(sceneRefusal(volume, volume), "accepted");
  EXPECT_THAT(sceneRefusal("max_m: [0.4, 0.78, 0.2]", "max_m: [0.4, 0.18, 0.2]"),
              AllOf(HasSubstr("place.volume.max_m"), HasSubstr("less than min_m")));
  EXPECT_THAT(sceneRefusal("max_m: [0.4, 0.78, 0.2]", "max_m: [0.4, 0.78, 0.001]"),
              HasSubstr("thinner than a cell"));
  EXPECT_THAT(sceneRefusal("max_m: [0.4, 0.78, 0.2]", "max_m: [400, 700, 100]"),
              HasSubstr("50 million cells"));
  EXPECT_THAT(sceneRefusal(volume, "volume: {min_m: [-0.4, 0.29, 0.6], max_m: [0.4, 0.78, 0.9]}"),
              AllOf(HasSubstr("place.volume"), HasSubstr("no surface")));
  EXPECT_THAT(sceneRefusal(object, "sphere: {radius_m: 0.05}"),
              AllOf(HasSubstr("object"), HasSubstr("no face")));
  EXPECT_THAT(sceneRefusal(object, "box: {size_m: [2, 2, 2]}"),
              AllOf(HasSubstr("object"), HasSubstr("larger than the target volume")));
  EXPECT_THAT(sceneRefusal("objective: max_clearance", "objective: max_fun"), HasSubstr("max_fun"));
  EXPECT_THAT(
      sceneRefusal("objective: max_clearance", "objective: max_clearance\n  centre_of_mass_m: [0.05, 0, 0]"),
      AllOf(HasSubstr("place.centre_of_mass_m"), HasSubstr("outside the object")));
  EXPECT_THAT(sceneRefusal("edge_step_m: 0.004", "edge_step_m: 0.005"), HasSubstr("edge_step_m"));
  EXPECT_THAT(sceneRefusal("start: [0, ", "start: ["), HasSubstr("start"));
  EXPECT_THAT(sceneRefusal("opening_m: 0.0218", "opening_m: 0.2"), HasSubstr("opening_m"));
  EXPECT_THAT(sceneRefusal("objective: max_clearance",
                           "objective: max_clearance\n  points: {name: cloud, file: none.pcd}"),
              HasSubstr("none.pcd"));
  EXPECT_THAT(sceneRefusal(object, "mesh: {file: none.obj}"),
              AllOf(HasSubstr("none.obj"), Not(HasSubstr("convex_hull"))));
  EXPECT_THROW(loadPlacementScene("placement/panda_moon"), InputError);
}

TEST(PlacementScene, APointCloudIsPlacedOn) {
  const TemporaryFolder folder;
  std::ostringstream cloud;
  int points = 0;
  std::ostringstream rows;
  for (double x = -0.1; x < 0.1; x += 0.004)
    for (double y = 0.4; y < 0.6; y += 0.004, ++points) rows << x << ' ' << y << " 0.101\n";
  cloud << "ply\nformat ascii 1.0\nelement vertex " << points
        << "\nproperty float x\nproperty float y\nproperty float z\nend_header\n"
        << rows.str();
  writeText(folder / "cloud.ply", cloud.str());
  std::string text = shipped("panda_table_cluttered_small_crayons");
  text = text.substr(0, text.find("  - {name: table,")) + text.substr(text.find("object:"));
  text = replaced(text, "place:\n", "place:\n  points: {name: board, file: cloud.ply}\n");
  writeText(folder / "task.yaml", text);
  const PlacementGeometry geometry(loadPlacementScene(folder / "task.yaml"));
  ASSERT_EQ(geometry.surfaces().regions().size(), 1u);
  EXPECT_NEAR(geometry.surfaces().regions()[0].height_m, 0.1075, 1e-9);
  EXPECT_NEAR(static_cast<double>(geometry.surfaces().regions()[0].cells.size()), 38.0 * 38.0, 120.0);
}

}  // namespace
}  // namespace b4p::test
