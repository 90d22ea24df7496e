// SPDX-License-Identifier: BSD-3-Clause
// A clone in the Jogramop framework's layout becomes scenes that load: furniture as exact boxes, all else as
// hulls, grasps and start as they were. Bad input is refused before anything is written.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "experiments/fixtures.h"
#include "experiments/import/obj_pieces.h"
#include "experiments/scene.h"

namespace b4p::test {
namespace {

namespace fs = std::filesystem;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

/// The text of a mesh in the making. Corners come in as world coordinates and go out in the frame of the
/// robot's base, which stands at (1, 0, 0.05) and looks along the world's y axis.
class Mesh {
 public:
  /// A prism over a polygon that runs counter-clockwise.
  void addPrism(const std::vector<Eigen::Vector2d>& polygon, double low, double high) {
    const int n = static_cast<int>(polygon.size()), first = count_ + 1;
    for (const double z : {low, high})
      for (const Eigen::Vector2d& p : polygon) {
        text_ += "v " + std::to_string(p.y()) + " " + std::to_string(1.0 - p.x()) + " " +
                 std::to_string(z - 0.05) + "\n";
        ++count_;
      }
    std::string floor = "f", roof = "f";
    for (int i = 0; i < n; ++i) {
      const int next = (i + 1) % n;
      floor += " " + std::to_string(first + n - 1 - i);
      roof += " " + std::to_string(first + n + i);
      text_ += "f " + std::to_string(first + i) + " " + std::to_string(first + next) + "//1 " +
               std::to_string(first + n + next) + "/2/3 " + std::to_string(first + n + i) + "\n";
    }
    text_ += floor + "\n" + roof + "\n";
  }
  void addBox(const Eigen::Vector3d& low, const Eigen::Vector3d& high) {
    addPrism({{low.x(), low.y()}, {high.x(), low.y()}, {high.x(), high.y()}, {low.x(), high.y()}}, low.z(),
             high.z());
  }
  const std::string& text() const { return text_; }

 private:
  std::string text_ = "# a comment\no thing\n";
  int count_ = 0;
};

constexpr const char* kScene = R"(bg_objects:
- object_type: table
  pose:
  - [1.0, 0.0, 0.0, 0.0]
  - [0.0, 1.0, 0.0, 0.6]
  - [0.0, 0.0, 1.0, 0.0]
  - [0.0, 0.0, 0.0, 1.0]
- object_type: lamp
  pose:
  - [1.0, 0.0, 0.0, 0.3]
  - [0.0, 1.0, 0.0, 0.7]
  - [0.0, 0.0, 1.0, 0.5]
  - [0.0, 0.0, 0.0, 1.0]
ground_area_x: 2
objects: []
)";
constexpr const char* kGrasps =
    "0,1,0,0.9,1,0,0,0.1,0,0,-1,0.6,0,0,0,1\n"
    "1.0e+00,0,0,9.5e-01,0,-1,0,0,0,0,-1,0.55,0,0,0,1.0\n";
constexpr const char* kStart = "0\n0\n0\n-0.76\n0\n-2.34\n0\n1.54\n0.75\n";

class ImportJogramop : public ::testing::Test {
 protected:
  ImportJogramop() {
    Mesh mesh;
    mesh.addBox({0.95, 0.9, 0.51}, {1.0, 0.95, 0.55});  // two pieces of the target, which share a face
    mesh.addBox({1.0, 0.9, 0.51}, {1.05, 0.95, 0.55});
    mesh.addBox({0.001, 0.6, 0}, {0.1, 1.4, 0.4});  // the table, a millimetre off
    mesh.addBox({1.9, 0.6, 0}, {2, 1.4, 0.4});
    mesh.addBox({0, 0.6, 0.4}, {2, 1.4, 0.5});
    mesh.addPrism({{0.3, 0.7}, {0.5, 0.7}, {0.5, 0.75}, {0.35, 0.75}, {0.35, 0.9}, {0.3, 0.9}}, 0.51,
                  0.7);  // an L
    for (const char* id : {"021", "022"}) {
      fs::create_directories(clone_ / ("scenarios/" + std::string(id) + "/export"));
      write(id, "scene.yaml", kScene);
      write(id, "export/grasps.csv", kGrasps);
      write(id, "export/robot_start_conf.csv", kStart);
      write(id, "export/obstacles.obj", mesh.text());
      write(id, "export/grasp_IK_solutions.csv", "no matter");
    }
  }

  std::string path(const std::string& id, const std::string& name) const {
    return clone_ / ("scenarios/" + id + "/" + name);
  }
  void write(const std::string& id, const std::string& name, const std::string& text) const {
    writeText(path(id, name), text);
  }
  CommandRun run() const { return runB4p("import jogramop " + clone_.path() + " --out " + out()); }
  std::string out() const { return out_ / "scenes"; }

  /// With one file of the second scenario changed.
  void expectRefused(const std::string& name, const std::string& text, const std::string& where) const {
    const std::string before = readFile(path("022", name));
    write("022", name, text);
    expectRefusedAsItIs(path("022", name), where);
    write("022", name, before);
  }
  void expectRefusedAsItIs(const std::string& file, const std::string& where) const {
    const CommandRun refused = run();
    EXPECT_EQ(refused.exit_code, 2) << refused.err;
    EXPECT_EQ(refused.errorLines(), 1) << refused.err;
    EXPECT_EQ(refused.err.rfind("b4p: " + file + ": ", 0), 0u) << refused.err;
    EXPECT_THAT(refused.err, HasSubstr(where));
    EXPECT_FALSE(fs::exists(out())) << "nothing is written";
  }

  TemporaryFolder clone_, out_;
};

TEST_F(ImportJogramop, ScenesLoadAndMeanWhatTheCloneSays) {
  const CommandRun imported = run();
  ASSERT_EQ(imported.exit_code, 0) << imported.err;
  for (const char* id : {"021", "022"}) {
    const Scene scene = loadScene(out() + "/" + id + ".yaml");
    EXPECT_EQ(scene.name, std::string("jogramop_") + id);
    EXPECT_THAT(scene.robot.file, HasSubstr("mobile_panda"));
    std::vector<std::string> names;
    for (const Obstacle& obstacle : scene.obstacles) names.push_back(obstacle.name);
    EXPECT_THAT(names, ElementsAre("floor", "table_leg_left_1", "table_leg_right_2", "table_top_3",
                                   "target_1", "target_2", "mesh_1"));
    const auto& task = std::get<ReachTask>(scene.task);
    EXPECT_THAT(task.start, ElementsAre(0, 0, 0, -0.76, 0, -2.34, 0, 1.54, 0.75));
    ASSERT_EQ(task.X_WT.size(), 2u);
    // 0.9 m ahead of the base and 0.1 m to its left, in the world.
    EXPECT_TRUE(task.X_WT[0].translation().isApprox(Eigen::Vector3d(0.9, 0.9, 0.65), 1e-6));
    EXPECT_TRUE(task.X_WT[0].linear().col(2).isApprox(-Eigen::Vector3d::UnitZ(), 1e-6));
    EXPECT_TRUE(task.X_WT[1].linear().col(0).isApprox(Eigen::Vector3d::UnitY(), 1e-6));
  }
}

TEST_F(ImportJogramop, FurnitureIsExactAndTheRestIsInTheWorld) {
  ASSERT_EQ(run().exit_code, 0);
  const Scene scene = loadScene(out() + "/021.yaml");
  const auto& leg = scene.obstacles[1].shape;
  EXPECT_TRUE(std::get<Box>(leg.shape).size.isApprox(Eigen::Vector3d(0.1, 0.8, 0.4), 1e-9));
  EXPECT_TRUE(leg.X_BS.translation().isApprox(Eigen::Vector3d(0.05, 1.0, 0.2), 1e-9));
  const auto bounds = [&](std::size_t i) {
    Eigen::AlignedBox3d box;
    for (const auto& v :
         std::get<std::shared_ptr<const ConvexMesh>>(scene.obstacles[i].shape.shape)->vertices)
      box.extend(scene.obstacles[i].shape.X_BS * v);
    return box;
  };
  EXPECT_TRUE(bounds(4).min().isApprox(Eigen::Vector3d(0.95, 0.9, 0.51), 1e-5));
  EXPECT_TRUE(bounds(5).max().isApprox(Eigen::Vector3d(1.05, 0.95, 0.55), 1e-5));
  EXPECT_TRUE(bounds(6).max().isApprox(Eigen::Vector3d(0.5, 0.9, 0.7), 1e-5));
}

TEST_F(ImportJogramop, SaysWhatDiffers) {
  const std::string said = run().out;
  for (const char* words :
       {"a floor is added", "3 exact boxes stand for 3 pieces", "lamp has no known dimensions",
        "piece 6 of the mesh is not convex", "grasp_IK_solutions.csv"})
    EXPECT_THAT(said, HasSubstr(words));
  EXPECT_THAT(readFile(out() + "/022.yaml"), HasSubstr("is not convex"));
}

TEST_F(ImportJogramop, MissingFilesAreNamed) {
  for (const char* name :
       {"export/grasps.csv", "export/obstacles.obj", "export/robot_start_conf.csv", "scene.yaml"}) {
    fs::rename(path("022", name), path("022", "aside"));
    expectRefusedAsItIs(path("022", name), "");
    fs::rename(path("022", "aside"), path("022", name));
  }
  fs::rename(path("022", "export"), path("022", "aside"));
  expectRefusedAsItIs(path("022", "export"), "no such folder");
  fs::rename(path("022", "aside"), path("022", "export"));
  fs::rename(clone_ / "scenarios/022", clone_ / "scenarios/022-b");
  expectRefusedAsItIs(clone_ / "scenarios/022-b", "name");
  fs::rename(clone_ / "scenarios", clone_ / "elsewhere");
  expectRefusedAsItIs(clone_ / "scenarios", "no such folder");
}

TEST_F(ImportJogramop, AMeshWithoutATargetIsRefused) {
  Mesh mesh;
  mesh.addBox({0.95, 0.9, 0.5}, {1.05, 0.95, 0.508});  // so thin that it counts as the table's
  mesh.addBox({0.001, 0.6, 0}, {0.1, 1.4, 0.4});
  mesh.addBox({1.9, 0.6, 0}, {2, 1.4, 0.4});
  mesh.addBox({0, 0.6, 0.4}, {2, 1.4, 0.5});
  mesh.addBox({0.3, 0.7, 0.51}, {0.35, 0.9, 0.7});
  expectRefused("export/obstacles.obj", mesh.text(), "no piece of the target");
}

TEST_F(ImportJogramop, BadGraspsAreRefused) {
  const std::string good = kGrasps;
  expectRefused("export/grasps.csv", "", "no grasp");
  expectRefused("export/grasps.csv", good + "1,0,0,0\n", "row 3");
  expectRefused("export/grasps.csv", replaced(good, "0.6", "nan"), "row 1");
  expectRefused("export/grasps.csv", replaced(good, "0.6", "high"), "row 1");
  expectRefused("export/grasps.csv", replaced(good, "1.0e+00,0,0", "1.1,0,0"), "row 2");
}

TEST_F(ImportJogramop, BadStartsAreRefused) {
  const std::string good = kStart;
  expectRefused("export/robot_start_conf.csv", good + "0\n", "10 numbers");
  expectRefused("export/robot_start_conf.csv", "", "0 numbers");
  expectRefused("export/robot_start_conf.csv", replaced(good, "1.54", "inf"), "row 8");
  expectRefused("export/robot_start_conf.csv", replaced(good, "-2.34", "2.34"), "panda_joint4");
}

TEST_F(ImportJogramop, BadMeshesAreRefused) {
  const std::string good = readFile(path("022", "export/obstacles.obj"));
  expectRefused("export/obstacles.obj", "", "no faces");
  expectRefused("export/obstacles.obj", good + "f 1 2 999\n", "999");
  expectRefused("export/obstacles.obj", good + "f 1 2\n", "fewer than three");
  expectRefused("export/obstacles.obj", "v 0 0 x\n" + good, "line 1");
  expectRefused("export/obstacles.obj", good + "v 0 0 9\nv 1 0 9\nv 0 1 9\nf -1 -2 -3\n", "piece 7");
  Mesh only_target;
  only_target.addBox({0.95, 0.9, 0.51}, {1.0, 0.95, 0.55});
  write("022", "export/obstacles.obj", only_target.text());
  expectRefusedAsItIs(path("022", "scene.yaml"), "table");
}

TEST_F(ImportJogramop, BadSceneDescriptionsAreRefused) {
  expectRefused("scene.yaml", replaced(kScene, "[0.0, 1.0, 0.0, 0.6]", "[0.0, 1.1, 0.0, 0.6]"), "pose");
  expectRefused("scene.yaml", replaced(kScene, "[0.0, 1.0, 0.0, 0.6]", "[0.0, 1.0, 0.6]"), "pose");
  expectRefused("scene.yaml", "objects: []\n", "bg_objects");
}

TEST(ObjPieces, PiecesThatTouchStayApartAndConcavityIsMeasured) {
  const TemporaryFolder folder;
  Mesh mesh;
  mesh.addBox({0, 0, 0}, {1, 1, 1});
  mesh.addBox({1, 0, 0}, {2, 1, 1});
  mesh.addPrism({{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 3}, {0, 3}}, 0, 1);
  writeText(folder / "mesh.obj", mesh.text());
  const std::vector<MeshPiece> pieces = readObjPieces(folder / "mesh.obj");
  ASSERT_EQ(pieces.size(), 3u);
  EXPECT_EQ(pieces[1].vertices.size(), 8u);
  EXPECT_NEAR(pieces[1].concavity_m(), 0.0, 1e-9);
  EXPECT_NEAR(pieces[2].concavity_m(), 1.0, 1e-9);
}

}  // namespace
}  // namespace b4p::test
