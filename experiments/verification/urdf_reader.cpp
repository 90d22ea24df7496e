// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/verification/urdf_reader.h"

#include <charconv>
#include <cmath>
#include <cstddef>
#include <sstream>

#include <tinyxml2.h>

#include "experiments/verification/mesh_points.h"
#include "robots/input_error.h"

namespace b4p::verification {
namespace {

using tinyxml2::XMLElement;

constexpr double kFullTurn_rad = 2.0 * 3.14159265358979323846;
constexpr double kShortestAxis = 1e-9;

/// One link's or joint's element, with what its errors have to name.
struct Context {
  const std::string& file;
  std::string element;

  [[noreturn]] void fail(const std::string& problem) const { throw InputError(file, element, problem); }
};

const char* requireText(const XMLElement& xml, const char* attribute, const Context& context) {
  const char* text = xml.Attribute(attribute);
  if (text == nullptr || *text == '\0') context.fail(std::string("<") + xml.Name() + "> has no " + attribute);
  return text;
}

const XMLElement& requireChild(const XMLElement& xml, const char* name, const Context& context) {
  const XMLElement* child = xml.FirstChildElement(name);
  if (child == nullptr) context.fail(std::string("<") + xml.Name() + "> has no <" + name + ">");
  return *child;
}

template <int kCount>
Eigen::Matrix<double, kCount, 1> requireNumbers(const XMLElement& xml, const char* attribute,
                                                const Context& context) {
  const char* text = requireText(xml, attribute, context);
  std::istringstream words(text);
  Eigen::Matrix<double, kCount, 1> numbers;
  int count = 0;
  for (std::string word; words >> word; ++count) {
    const char* begin = word.data() + (word[0] == '+' ? 1 : 0);
    const char* end = word.data() + word.size();
    double number = 0.0;
    const auto [stop, error] = std::from_chars(begin, end, number);
    if (error != std::errc() || stop != end || !std::isfinite(number) || count == kCount)
      context.fail(std::string(attribute) + "=\"" + text + "\" is not " + std::to_string(kCount) +
                   " finite numbers");
    numbers[count] = number;
  }
  if (count != kCount)
    context.fail(std::string(attribute) + "=\"" + text + "\" is not " + std::to_string(kCount) +
                 " finite numbers");
  return numbers;
}

double requireNumber(const XMLElement& xml, const char* attribute, const Context& context) {
  return requireNumbers<1>(xml, attribute, context)[0];
}

double requirePositive(const XMLElement& xml, const char* attribute, const Context& context) {
  const double number = requireNumber(xml, attribute, context);
  if (number <= 0.0)
    context.fail(std::string(attribute) + "=\"" + xml.Attribute(attribute) + "\" is not positive");
  return number;
}

Eigen::Isometry3d readOrigin(const XMLElement& parent, const Context& context) {
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  const XMLElement* origin = parent.FirstChildElement("origin");
  if (origin == nullptr) return pose;
  if (origin->Attribute("xyz") != nullptr) pose.translation() = requireNumbers<3>(*origin, "xyz", context);
  if (origin->Attribute("rpy") != nullptr) {
    const Eigen::Vector3d rpy = requireNumbers<3>(*origin, "rpy", context);
    pose.linear() = (Eigen::AngleAxisd(rpy.z(), Eigen::Vector3d::UnitZ()) *
                     Eigen::AngleAxisd(rpy.y(), Eigen::Vector3d::UnitY()) *
                     Eigen::AngleAxisd(rpy.x(), Eigen::Vector3d::UnitX()))
                        .toRotationMatrix();
  }
  return pose;
}

ConvexBody readMesh(const XMLElement& mesh, const Context& context) {
  Eigen::Vector3d scale = Eigen::Vector3d::Ones();
  if (mesh.Attribute("scale") != nullptr) scale = requireNumbers<3>(mesh, "scale", context);
  auto points = readMeshPoints(requireText(mesh, "filename", context), context.file, context.element);
  for (Eigen::Vector3d& p : points) p = scale.cwiseProduct(p);
  return ConvexBody::hull(std::move(points));
}

ConvexBody readGeometry(const XMLElement& geometry, const Context& context) {
  const XMLElement* shape = geometry.FirstChildElement();
  if (shape == nullptr || shape->NextSiblingElement() != nullptr)
    context.fail("<geometry> does not hold one shape");
  const std::string kind = shape->Name();
  if (kind == "mesh") return readMesh(*shape, context);
  if (kind == "sphere") return ConvexBody::sphere(requirePositive(*shape, "radius", context));
  if (kind == "cylinder") {
    const double radius = requirePositive(*shape, "radius", context);
    return ConvexBody::cylinder(radius, requirePositive(*shape, "length", context));
  }
  if (kind != "box") context.fail("unknown shape <" + kind + ">");
  const Eigen::Vector3d size = requireNumbers<3>(*shape, "size", context);
  if (size.minCoeff() <= 0.0)
    context.fail("size=\"" + std::string(shape->Attribute("size")) + "\" is not positive");
  return ConvexBody::box(size);
}

UrdfLink readLink(const XMLElement& xml, const std::string& file) {
  UrdfLink link;
  link.name = requireText(xml, "name", Context{file, "link"});
  const Context context{file, "link '" + link.name + "'"};
  for (const XMLElement* collision = xml.FirstChildElement("collision"); collision != nullptr;
       collision = collision->NextSiblingElement("collision"))
    link.bodies.push_back({readGeometry(requireChild(*collision, "geometry", context), context),
                           readOrigin(*collision, context)});
  return link;
}

void readMotion(const XMLElement& xml, const std::string& type, UrdfJoint& joint, const Context& context) {
  joint.type = type == "prismatic" ? UrdfJointType::kPrismatic : UrdfJointType::kRevolute;
  if (const XMLElement* axis = xml.FirstChildElement("axis"))
    joint.axis = requireNumbers<3>(*axis, "xyz", context);
  if (joint.axis.norm() < kShortestAxis) context.fail("its axis is zero");
  joint.axis.normalize();
  if (type == "continuous") {
    joint.lower = -kFullTurn_rad;
    joint.upper = kFullTurn_rad;
    return;
  }
  const XMLElement& limit = requireChild(xml, "limit", context);
  if (limit.Attribute("lower") != nullptr) joint.lower = requireNumber(limit, "lower", context);
  if (limit.Attribute("upper") != nullptr) joint.upper = requireNumber(limit, "upper", context);
  if (!(joint.lower < joint.upper)) context.fail("its lower limit is not below its upper one");
}

void readJoint(const XMLElement& xml, const std::string& file, UrdfTree& tree) {
  UrdfJoint joint;
  joint.name = requireText(xml, "name", Context{file, "joint"});
  const Context context{file, "joint '" + joint.name + "'"};
  const auto linkNamed = [&](const char* role) {
    const std::string name = requireText(requireChild(xml, role, context), "link", context);
    const int index = tree.linkIndex(name);
    if (index < 0) context.fail("there is no link '" + name + "'");
    return index;
  };
  joint.parent_link = linkNamed("parent");
  joint.child_link = linkNamed("child");
  joint.X_PJ = readOrigin(xml, context);
  const std::string type = requireText(xml, "type", context);
  if (type == "revolute" || type == "continuous" || type == "prismatic")
    readMotion(xml, type, joint, context);
  else if (type != "fixed")
    context.fail("joints of type " + type + " are not supported");
  UrdfLink& child = tree.links[joint.child_link];
  if (child.parent_joint >= 0) context.fail("its child '" + child.name + "' has two parents");
  if (tree.jointIndex(joint.name) >= 0) context.fail("is there twice");
  child.parent_joint = static_cast<int>(tree.joints.size());
  tree.joints.push_back(joint);
}

/// Lists the links from the root outwards; what is not reached is no tree.
void orderLinks(UrdfTree& tree, const std::string& file) {
  for (std::size_t i = 0; i < tree.links.size(); ++i)
    if (tree.links[i].parent_joint < 0) tree.root_first.push_back(static_cast<int>(i));
  if (tree.root_first.size() != 1)
    throw InputError(file, "robot", "has " + std::to_string(tree.root_first.size()) + " root links, not one");
  for (std::size_t next = 0; next < tree.root_first.size(); ++next)
    for (const UrdfJoint& joint : tree.joints)
      if (joint.parent_link == tree.root_first[next]) tree.root_first.push_back(joint.child_link);
  if (tree.root_first.size() != tree.links.size()) throw InputError(file, "robot", "has a loop of links");
}

template <class Named>
int indexOf(const std::vector<Named>& list, const std::string& name) {
  for (std::size_t i = 0; i < list.size(); ++i)
    if (list[i].name == name) return static_cast<int>(i);
  return -1;
}

}  // namespace

int UrdfTree::linkIndex(const std::string& name) const { return indexOf(links, name); }
int UrdfTree::jointIndex(const std::string& name) const { return indexOf(joints, name); }

UrdfTree readUrdf(const std::string& file) {
  tinyxml2::XMLDocument document;
  if (document.LoadFile(file.c_str()) != tinyxml2::XML_SUCCESS)
    throw InputError(file, "line " + std::to_string(document.ErrorLineNum()), document.ErrorName());
  const XMLElement* robot = document.FirstChildElement("robot");
  if (robot == nullptr) throw InputError(file, "", "has no <robot>");
  UrdfTree tree;
  for (const XMLElement* link = robot->FirstChildElement("link"); link != nullptr;
       link = link->NextSiblingElement("link")) {
    UrdfLink read = readLink(*link, file);
    if (tree.linkIndex(read.name) >= 0) throw InputError(file, "link '" + read.name + "'", "is there twice");
    tree.links.push_back(std::move(read));
  }
  for (const XMLElement* joint = robot->FirstChildElement("joint"); joint != nullptr;
       joint = joint->NextSiblingElement("joint"))
    readJoint(*joint, file, tree);
  orderLinks(tree, file);
  return tree;
}

}  // namespace b4p::verification
