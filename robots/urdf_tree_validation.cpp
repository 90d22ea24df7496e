// SPDX-License-Identifier: BSD-3-Clause
#include <map>
#include <string>

#include "robots/input_error.h"
#include "robots/urdf_validation.h"

namespace b4p {
namespace {

using tinyxml2::XMLAttribute;
using tinyxml2::XMLElement;

/// Finds what xacro would have expanded anywhere in the text. A mere xmlns:xacro attribute is harmless: xacro
/// itself leaves it behind.
class XacroFinder : public tinyxml2::XMLVisitor {
 public:
  explicit XacroFinder(const std::string& file) : file_(file) {}

  bool VisitEnter(const XMLElement& element, const XMLAttribute* attribute) override {
    const std::string name = element.Name();
    if (name.rfind("xacro:", 0) == 0) fail(element, "<" + name + ">");
    for (; attribute != nullptr; attribute = attribute->Next()) {
      const std::string value = attribute->Value();
      if (value.find("${") != std::string::npos || value.find("$(") != std::string::npos)
        fail(element, std::string(attribute->Name()) + "=\"" + value + "\"");
    }
    return true;
  }

 private:
  void fail(const XMLElement& element, const std::string& found) const {
    throw InputError(file_, "line " + std::to_string(element.GetLineNum()),
                     "xacro that was not expanded: " + found);
  }

  const std::string& file_;
};

struct DeclaredJoint {
  std::string name, parent, child;
};

/// The tree as declared.
class Tree {
 public:
  Tree(const std::string& file, const XMLElement& robot) : file_(file) {
    for (auto* link = robot.FirstChildElement("link"); link != nullptr;
         link = link->NextSiblingElement("link"))
      addLink(*link);
    if (joint_above_.empty()) throw InputError(file_, "robot", "has no links");
    for (auto* joint = robot.FirstChildElement("joint"); joint != nullptr;
         joint = joint->NextSiblingElement("joint"))
      addJoint(*joint);
  }

  /// One root, and every link reaches it.
  void checkRoots() const {
    std::string root;
    for (const auto& [link, joint] : joint_above_) {
      checkAncestors(link);
      if (!joint.empty()) continue;
      if (!root.empty()) fail("link '" + link + "'", "is a second root beside '" + root + "'");
      root = link;
    }
  }

 private:
  [[noreturn]] void fail(const std::string& element, const std::string& problem) const {
    throw InputError(file_, element, problem);
  }

  std::string nameOf(const XMLElement& element) const {
    const char* name = element.Attribute("name");
    if (name == nullptr || *name == '\0')
      fail("line " + std::to_string(element.GetLineNum()),
           "<" + std::string(element.Name()) + "> has no name");
    return name;
  }

  void addLink(const XMLElement& link) {
    const std::string name = nameOf(link);
    if (!joint_above_.emplace(name, "").second) fail("link '" + name + "'", "is declared twice");
  }

  std::string linkOf(const XMLElement& joint, const std::string& name, const char* role) const {
    const XMLElement* element = joint.FirstChildElement(role);
    const char* link = element == nullptr ? nullptr : element->Attribute("link");
    if (link == nullptr) fail("joint '" + name + "'", std::string("has no ") + role + " link");
    if (joint_above_.count(link) == 0)
      fail("joint '" + name + "'", std::string(role) + " link '" + link + "' does not exist");
    return link;
  }

  void addJoint(const XMLElement& element) {
    const std::string name = nameOf(element);
    const DeclaredJoint joint{name, linkOf(element, name, "parent"), linkOf(element, name, "child")};
    if (!joints_.emplace(name, joint).second) fail("joint '" + name + "'", "is declared twice");
    std::string& above = joint_above_.at(joint.child);
    if (!above.empty())
      fail("link '" + joint.child + "'", "is the child of two joints, '" + above + "' and '" + name + "'");
    above = name;
  }

  /// The way up from a link ends within as many steps as there are joints, or it runs in a circle.
  void checkAncestors(const std::string& link) const {
    std::string place = link;
    for (std::size_t step = 0; !joint_above_.at(place).empty(); ++step) {
      if (step == joints_.size()) fail("link '" + place + "'", "is its own ancestor");
      place = joints_.at(joint_above_.at(place)).parent;
    }
  }

  const std::string& file_;
  std::map<std::string, std::string> joint_above_;  ///< per link the joint to its parent; empty for roots
  std::map<std::string, DeclaredJoint> joints_;
};

}  // namespace

void validateUrdfTree(const std::string& file, const XMLElement& robot) {
  XacroFinder finder(file);
  robot.Accept(&finder);
  Tree(file, robot).checkRoots();
}

}  // namespace b4p
