// SPDX-License-Identifier: BSD-3-Clause
#include <filesystem>
#include <fstream>
#include <iterator>
#include <utility>

#include <tinyxml2.h>
#include <urdf_model/model.h>

#include "robots/capsule_fusion.h"
#include "robots/input_error.h"
#include "robots/mesh_loader.h"
#include "robots/robot_model.h"
#include "robots/urdf_validation.h"
#include "robots/urdfdom_parser.h"

namespace b4p {
namespace {

constexpr double kTurn_rad = 6.283185307179586476925;

std::string readText(const std::string& file) {
  std::error_code ignored;
  if (!std::filesystem::is_regular_file(file, ignored)) throw InputError(file, "", "no such file");
  std::ifstream stream(file, std::ios::binary);
  if (!stream) throw InputError(file, "", "cannot be read");
  return {std::istreambuf_iterator<char>(stream), {}};
}

const tinyxml2::XMLElement& parseXml(const std::string& file, const std::string& text,
                                     tinyxml2::XMLDocument& document) {
  if (document.Parse(text.data(), text.size()) != tinyxml2::XML_SUCCESS)
    throw InputError(file, "line " + std::to_string(document.ErrorLineNum()),
                     std::string("malformed XML, ") + document.ErrorName());
  const tinyxml2::XMLElement* robot = document.RootElement();
  if (robot == nullptr || std::string(robot->Name()) != "robot")
    throw InputError(file, "",
                     std::string("the top element has to be <robot>, not <") +
                         (robot == nullptr ? "" : robot->Name()) + ">");
  return *robot;
}

Eigen::Vector3d toEigen(const urdf::Vector3& v) { return {v.x, v.y, v.z}; }

Eigen::Isometry3d toEigen(const urdf::Pose& pose) {
  Eigen::Isometry3d X = Eigen::Isometry3d::Identity();
  X.translation() = toEigen(pose.position);
  const urdf::Rotation& r = pose.rotation;
  X.linear() = Eigen::Quaterniond(r.w, r.x, r.y, r.z).normalized().toRotationMatrix();
  return X;
}

/// Turns urdfdom's robot into a RobotModel.
class ModelBuilder {
 public:
  ModelBuilder(std::string file, const tinyxml2::XMLElement& declared)
      : file_(std::move(file)),
        folder_(std::filesystem::path(file_).parent_path().string()),
        declared_(declared) {}

  RobotModel build(const urdf::ModelInterface& parsed) {
    model_.name = parsed.getName();
    addLink(*parsed.getRoot(), -1);
    // Depth first, without recursion: a parent is always added before its children.
    std::vector<std::pair<urdf::LinkConstSharedPtr, int>> open{{parsed.getRoot(), 0}};
    while (!open.empty()) {
      const auto [link, index] = open.back();
      open.pop_back();
      for (const auto& parsed_joint : link->child_joints) {
        const auto child = parsed.getLink(parsed_joint->child_link_name);
        model_.joints.push_back(joint(*parsed_joint));
        model_.joints.back().parent_link = index;
        model_.joints.back().child_link = static_cast<int>(model_.links.size());
        open.emplace_back(child, model_.joints.back().child_link);
        addLink(*child, static_cast<int>(model_.joints.size()) - 1);
      }
    }
    return std::move(model_);
  }

 private:
  [[noreturn]] void fail(const urdf::Link& link, const std::string& problem) const {
    throw InputError(file_, "link '" + link.name + "'", problem);
  }

  Joint joint(const urdf::Joint& parsed) const {
    Joint joint;
    joint.name = parsed.name;
    joint.X_PJ = toEigen(parsed.parent_to_joint_origin_transform);
    if (parsed.type == urdf::Joint::FIXED) return joint;
    joint.type = parsed.type == urdf::Joint::PRISMATIC ? JointType::kPrismatic : JointType::kRevolute;
    joint.axis = toEigen(parsed.axis).stableNormalized();
    if (parsed.type == urdf::Joint::CONTINUOUS) {
      joint.lower = -kTurn_rad;
      joint.upper = kTurn_rad;
    } else {
      joint.lower = parsed.limits->lower;
      joint.upper = parsed.limits->upper;
    }
    // Exporters write a velocity of 0 for "not known".
    if (parsed.limits && parsed.limits->velocity > 0.0) joint.max_velocity = parsed.limits->velocity;
    if (parsed.mimic) joint.mimicked_joint = parsed.mimic->joint_name;
    return joint;
  }

  void addLink(const urdf::Link& parsed, int parent_joint) {
    Link link;
    link.name = parsed.name;
    link.parent_joint = parent_joint;
    for (const auto& collision : parsed.collision_array)
      if (collision && collision->geometry)
        link.shapes.push_back({shape(parsed, *collision->geometry), toEigen(collision->origin)});
    if (const std::size_t declared = declaredShapes(declared_, link.name); link.shapes.size() != declared)
      fail(parsed, std::to_string(declared) + " collision shapes are declared but urdfdom read only " +
                       std::to_string(link.shapes.size()));
    fuseCapsules(link.shapes);
    model_.links.push_back(std::move(link));
  }

  Shape shape(const urdf::Link& link, const urdf::Geometry& geometry) const {
    Shape shape;
    switch (geometry.type) {
      case urdf::Geometry::BOX:
        shape = Box{toEigen(static_cast<const urdf::Box&>(geometry).dim)};
        break;
      case urdf::Geometry::SPHERE:
        shape = Sphere{static_cast<const urdf::Sphere&>(geometry).radius};
        break;
      case urdf::Geometry::CYLINDER: {
        const auto& cylinder = static_cast<const urdf::Cylinder&>(geometry);
        shape = Cylinder{cylinder.radius, cylinder.length};
        break;
      }
      case urdf::Geometry::MESH:
        shape = mesh(link, static_cast<const urdf::Mesh&>(geometry));
        break;
    }
    if (const std::string problem = shapeProblem(shape); !problem.empty()) fail(link, problem);
    return shape;
  }

  std::shared_ptr<const ConvexMesh> mesh(const urdf::Link& link, const urdf::Mesh& parsed) const {
    try {
      return loadMeshHull(meshFile(parsed.filename, folder_), toEigen(parsed.scale));
    } catch (const std::runtime_error& error) {
      fail(link, "mesh '" + parsed.filename + "': " + error.what());
    }
  }

  std::string file_;
  std::string folder_;
  const tinyxml2::XMLElement& declared_;
  RobotModel model_;
};

}  // namespace

RobotModel loadUrdf(const std::string& file) {
  const std::string text = readText(file);
  tinyxml2::XMLDocument document;
  const tinyxml2::XMLElement& robot = parseXml(file, text, document);
  validateUrdfTree(file, robot);
  validateUrdfValues(file, robot);
  return ModelBuilder(file, robot).build(*parseWithUrdfdom(file, text));
}

}  // namespace b4p
