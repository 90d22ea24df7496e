// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/import/jogramop.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <optional>
#include <sstream>
#include <stdexcept>

#include "experiments/import/obj_pieces.h"
#include "experiments/scene.h"
#include "experiments/scene_families/confined_furniture.h"
#include "experiments/scene_families/confined_scenario.h"
#include "experiments/scene_families/grasp_text.h"
#include "experiments/scene_families/scene_text.h"
#include "experiments/scene_files/grasp_table.h"
#include "experiments/scene_files/yaml_value.h"
#include "robots/input_error.h"
#include "robots/number_text.h"
#include "robots/shape.h"

namespace b4p {
namespace {

namespace fs = std::filesystem;

constexpr const char* kRobot = "mobile_panda";

Eigen::Isometry3d poseOf(const YamlValue& matrix) {
  constexpr double kRotationError = 1e-4;
  const std::vector<YamlValue> rows = matrix.items();
  if (rows.size() != 4) matrix.fail("is no 4 x 4 matrix");
  Eigen::Matrix4d M;
  for (Eigen::Index row = 0; row < 4; ++row) {
    const std::vector<double> numbers = rows[static_cast<std::size_t>(row)].numbers(4, kFarthest_m);
    for (Eigen::Index column = 0; column < 4; ++column)
      M(row, column) = numbers[static_cast<std::size_t>(column)];
  }
  const Eigen::Matrix3d R = M.topLeftCorner<3, 3>();
  if ((R.transpose() * R - Eigen::Matrix3d::Identity()).cwiseAbs().maxCoeff() > kRotationError ||
      R.determinant() < 0.0 || M.row(3) != Eigen::RowVector4d(0.0, 0.0, 0.0, 1.0))
    matrix.fail("is no pose");
  return Eigen::Isometry3d(M);
}

/// Boxes of furniture in its own frame, of the kinds whose dimensions are known.
std::optional<std::vector<Obstacle>> furniture(const std::string& type) {
  static const std::string kGate = "gate_0_";
  if (type == "table") return tableBoxes();
  if (type == "open_shelf") return openShelfBoxes();
  if (type == "pedestal") return pedestalBoxes();
  if (type == "wall_segment_80") return wallBoxes("wall");
  double opening_m = 0.0;
  if (type.compare(0, kGate.size(), kGate) != 0) return {};
  const std::string number = "0." + type.substr(kGate.size());
  const auto [end, error] = std::from_chars(number.data(), number.data() + number.size(), opening_m);
  if (error != std::errc() || end != number.data() + number.size() || !(opening_m > 0.0)) return {};
  return gateBoxes(opening_m);
}

/// Whether all of a piece lies in the boxes, but for 10 mm.
bool liesIn(const MeshPiece& piece, const std::vector<Obstacle>& boxes) {
  constexpr double kMargin_m = 0.01;
  const auto inside = [&](const Eigen::Vector3d& p_W) {
    return std::any_of(boxes.begin(), boxes.end(), [&](const Obstacle& box) {
      const Eigen::Vector3d p = box.shape.X_BS.inverse() * p_W;
      return (p.cwiseAbs() - std::get<Box>(box.shape.shape).size / 2.0).maxCoeff() <= kMargin_m;
    });
  };
  return std::all_of(piece.vertices.begin(), piece.vertices.end(), inside);
}

std::vector<double> numbersIn(const std::string& file) {
  std::ifstream in(file);
  if (!in) throw InputError(file, "", "no such file, or it cannot be read");
  std::vector<double> numbers;
  int row = 0;
  for (std::string line; std::getline(in, line);) {
    ++row;
    std::replace(line.begin(), line.end(), ',', ' ');
    std::istringstream words(line);
    for (std::string word; words >> word;) {
      double value = 0.0;
      const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
      if (error != std::errc() || end != word.data() + word.size() || !std::isfinite(value))
        throw InputError(file, "row " + std::to_string(row), "is not a finite number (" + word + ")");
      numbers.push_back(value);
    }
  }
  return numbers;
}

std::vector<double> readStart(const std::string& file, const Manipulator& robot) {
  std::vector<double> start = numbersIn(file);
  if (static_cast<int>(start.size()) != robot.dof())
    throw InputError(
        file, "",
        "has " + std::to_string(start.size()) + " numbers instead of " + std::to_string(robot.dof()));
  for (int i = 0; i < robot.dof(); ++i) {
    const double value = start[static_cast<std::size_t>(i)];
    if (value < robot.lower()[i] || value > robot.upper()[i])
      throw InputError(file, "row " + std::to_string(i + 1),
                       numberText(value) + " is outside the limits of " +
                           robot.description().joints[static_cast<std::size_t>(i)] + ", " +
                           numberText(robot.lower()[i]) + " to " + numberText(robot.upper()[i]));
  }
  return start;
}

/// One scenario on its way from the clone's files to ours.
class ScenarioImport {
 public:
  ScenarioImport(const fs::path& folder, const Manipulator& robot) : folder_(folder), robot_(robot) {
    result_.id = folder.filename().string();
  }

  ImportedScenario run() {
    const std::vector<Eigen::Isometry3d> grasps = readGraspTable(exported("grasps.csv"));
    const std::vector<double> start = readStart(exported("robot_start_conf.csv"), robot_);
    readPieces();
    obstacles_ = shapeLine("floor", boxObstacle("floor", {-2, -2, -0.1}, {4, 4, 0}).shape);
    remark("a floor is added");
    replaceFurniture();
    addHulls();
    remark("grasp_IK_solutions.csv and grasps.npy are not used");
    addFile(result_.id + ".grasps.csv", graspText(grasps));
    addFile(result_.id + ".yaml", sceneText(start));
    return std::move(result_);
  }

 private:
  std::string exported(const char* name) const { return (folder_ / "export" / name).string(); }
  void remark(const std::string& text) { result_.remarks.push_back(text); }
  void addFile(const std::string& name, std::string content) {
    result_.files.emplace_back(name, std::move(content));
  }

  void readPieces() {
    pieces_ = readObjPieces(exported("obstacles.obj"));
    for (MeshPiece& piece : pieces_)
      for (Eigen::Vector3d& vertex : piece.vertices) vertex = confinedRobotBase() * vertex;
    replaced_.assign(pieces_.size(), false);
  }

  void replaceFurniture() {
    const std::string file = (folder_ / "scene.yaml").string();
    int boxes = 0;
    for (const YamlValue& item : YamlValue::load(file)["bg_objects"].items()) {
      const YamlValue type = item["object_type"];
      const Eigen::Isometry3d X_WF = poseOf(item["pose"]);
      std::optional<std::vector<Obstacle>> parts = furniture(type.text());
      if (!parts) {
        remark(type.text() + " has no known dimensions: the hulls of its pieces stand for it");
        continue;
      }
      for (Obstacle& part : *parts) part.shape.X_BS = X_WF * part.shape.X_BS;
      bool found = false;
      for (std::size_t i = 0; i < pieces_.size(); ++i) {
        if (!liesIn(pieces_[i], *parts)) continue;
        found = true;
        replaced_[i] = true;
      }
      if (!found) type.failWithValue("stands where " + exported("obstacles.obj") + " has nothing");
      for (const Obstacle& part : *parts)
        obstacles_ += shapeLine(part.name + "_" + std::to_string(++boxes), part.shape);
    }
    const auto count = std::count(replaced_.begin(), replaced_.end(), true);
    remark(std::to_string(boxes) + " exact boxes stand for " + std::to_string(count) + " pieces of the mesh");
  }

  /// The target comes first in the mesh, so that pieces before the first of the furniture are its own.
  void addHulls() {
    int targets = 0, others = 0;
    bool target = true;
    for (std::size_t i = 0; i < pieces_.size(); ++i) {
      target = target && !replaced_[i];
      if (replaced_[i]) continue;
      addHull(pieces_[i], "piece " + std::to_string(i + 1),
              target ? "target_" + std::to_string(++targets) : "mesh_" + std::to_string(++others));
    }
    if (targets + others == 0)
      throw InputError(exported("obstacles.obj"), "", "holds nothing but furniture, no object to grasp");
    if (targets == 0)
      throw InputError(exported("obstacles.obj"), "",
                       "has no piece of the target before the furniture, or only such as lie in it");
    remark(std::to_string(targets) + " hulls make the target, " + std::to_string(others) +
           " are other obstacles");
  }

  void addHull(const MeshPiece& piece, const std::string& place, const std::string& name) {
    constexpr double kConvex_m = 1e-3;
    const std::string file = result_.id + "." + name + ".obj";
    try {
      const auto hull = convexHull(piece.vertices);
      addFile(file, objText(hull->vertices, hull->triangles));
    } catch (const std::invalid_argument& error) {
      throw InputError(exported("obstacles.obj"), place, error.what());
    }
    const double concavity_m = piece.concavity_m();
    if (concavity_m > kConvex_m)
      remark(place + " of the mesh is not convex (by " + numberText(concavity_m) +
             " m): its hull replaces it");
    obstacles_ += meshLine(name, "'" + file + "'", true);
  }

  std::string sceneText(const std::vector<double>& start) const {
    constexpr int kDecimals = 9;
    std::string text = "# Scenario " + result_.id + " of the Jogramop framework, by b4p import jogramop.\n";
    for (const std::string& words : result_.remarks) text += commentLines(words);
    text += "schema: 1\nname: jogramop_" + result_.id + "\nrobot: " + kRobot +
            "\nrobot_base: {position_m: [1, 0, 0.05], rpy_rad: [0, 0, 1.5707963267948966]}\n"
            "edge_step_m: 0.01\nbudget_s: 10\nobstacles:\n" +
            obstacles_ + "reach:\n  start: [";
    for (std::size_t i = 0; i < start.size(); ++i)
      text += (i == 0 ? "" : ", ") + sceneNumber(start[i], kDecimals);
    return text + "]\n  grasps: {file: '" + result_.id + ".grasps.csv'}\n";
  }

  const fs::path folder_;
  const Manipulator& robot_;
  ImportedScenario result_;
  std::vector<MeshPiece> pieces_;  ///< in the world
  std::vector<bool> replaced_;     ///< pieces for which boxes stand
  std::string obstacles_;
};

/// Folders' names become parts of names in scene files.
bool isName(const std::string& name) {
  return !name.empty() && std::all_of(name.begin(), name.end(),
                                      [](unsigned char c) { return std::isalnum(c) != 0 || c == '_'; });
}

}  // namespace

std::vector<ImportedScenario> importJogramop(const std::string& folder) {
  const fs::path root = fs::path(folder) / "scenarios";
  std::error_code error;
  std::vector<fs::path> folders;
  for (const auto& entry : fs::directory_iterator(root, error)) {
    const bool exported = fs::is_directory(entry.path() / "export", error);
    if (!exported && !fs::exists(entry.path() / "scene.yaml", error)) continue;
    if (!exported) throw InputError((entry.path() / "export").string(), "", "no such folder");
    if (!isName(entry.path().filename().string()))
      throw InputError(entry.path().string(), "", "a scenario's name has letters, digits and _ only");
    folders.push_back(entry.path());
  }
  if (folders.empty())
    throw InputError(root.string(), "", "no such folder, or none in it that holds a folder export");
  std::sort(folders.begin(), folders.end());
  const RobotFile file = loadRobotFile(kRobot);
  const Manipulator robot(loadUrdf(file.urdf_file), file.description, confinedRobotBase(), file.file);
  std::vector<ImportedScenario> scenarios;
  for (const fs::path& scenario : folders) scenarios.push_back(ScenarioImport(scenario, robot).run());
  return scenarios;
}

}  // namespace b4p
