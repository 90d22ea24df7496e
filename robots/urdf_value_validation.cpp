// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <cstring>

#include "robots/urdf_text.h"
#include "robots/urdf_validation.h"

namespace b4p {
namespace {

using tinyxml2::XMLElement;

constexpr std::size_t kVector = 3;

void checkOrigin(const UrdfText& parent) {
  const auto origin = parent.child("origin");
  if (!origin) return;
  for (const char* attribute : {"xyz", "rpy"})
    if (origin->has(attribute)) origin->numbers(attribute, kVector);
}

void checkPositive(const UrdfText& shape, const char* attribute, std::size_t count) {
  const std::vector<double> sizes = shape.numbers(attribute, count);
  if (*std::min_element(sizes.begin(), sizes.end()) <= 0.0) shape.failAt(attribute, "has to be positive");
}

void checkShape(const UrdfText& shape) {
  const std::string kind = shape.element().Name();
  if (kind == "box") {
    checkPositive(shape, "size", kVector);
  } else if (kind == "sphere") {
    checkPositive(shape, "radius", 1);
  } else if (kind == "cylinder") {
    checkPositive(shape, "radius", 1);
    checkPositive(shape, "length", 1);
  } else if (kind == "mesh") {
    shape.text("filename");
    if (!shape.has("scale")) return;
    const std::vector<double> scale = shape.numbers("scale", kVector);
    if (std::count(scale.begin(), scale.end(), 0.0) > 0) shape.failAt("scale", "must not be zero");
  } else {
    shape.fail("unknown shape <" + kind + ">; known are box, sphere, cylinder and mesh");
  }
}

void checkCollision(const UrdfText& collision) {
  checkOrigin(collision);
  const auto geometry = collision.child("geometry");
  const XMLElement* shape = geometry ? geometry->element().FirstChildElement() : nullptr;
  if (shape == nullptr) collision.fail("<collision> has no shape");
  if (shape->NextSiblingElement() != nullptr) collision.fail("<geometry> has more than one shape");
  checkShape(*geometry->child(shape->Name()));
}

void checkAxis(const UrdfText& joint) {
  const auto axis = joint.child("axis");
  if (!axis) return;
  const std::vector<double> v = axis->numbers("xyz", kVector);
  const double length = std::hypot(v[0], v[1], v[2]);
  if (!(length > 0.0) || !std::isfinite(length)) axis->failAt("xyz", "has no direction");
}

void checkTravel(const UrdfText& limit) {
  if (!limit.has("lower") && !limit.has("upper")) limit.fail("limit has neither lower nor upper");
  // URDF takes an end that is left out for zero.
  const double lower = limit.has("lower") ? limit.number("lower") : 0.0;
  const double upper = limit.has("upper") ? limit.number("upper") : 0.0;
  if (!(lower < upper)) {
    const char* attribute = limit.has("lower") ? "lower" : "upper";
    limit.failAt(attribute, std::string("has to be below upper '") +
                                (limit.has("upper") ? limit.text("upper") : "0") + "'");
  }
}

void checkLimit(const UrdfText& joint, bool has_travel) {
  const auto limit = joint.child("limit");
  if (!limit) {
    if (has_travel) joint.fail("has no limit");
    return;
  }
  if (has_travel) checkTravel(*limit);
  if (limit->number("velocity") < 0.0) limit->failAt("velocity", "must not be negative");
  limit->number("effort");
}

void checkMimic(const UrdfText& joint, const XMLElement& robot) {
  const auto mimic = joint.child("mimic");
  if (!mimic) return;
  const std::string other = mimic->text("joint");
  bool found = false;
  for (auto* j = robot.FirstChildElement("joint"); j != nullptr; j = j->NextSiblingElement("joint"))
    found = found || other == j->Attribute("name");
  if (!found) mimic->failAt("joint", "does not exist");
  if (mimic->has("multiplier") && mimic->number("multiplier") != 1.0)
    mimic->failAt("multiplier", "is not supported; only 1 is");
  if (mimic->has("offset") && mimic->number("offset") != 0.0)
    mimic->failAt("offset", "is not supported; only 0 is");
}

void checkJoint(const UrdfText& joint, const XMLElement& robot) {
  const std::string type = joint.text("type");
  checkOrigin(joint);
  if (type == "fixed") return;
  if (type != "revolute" && type != "prismatic" && type != "continuous")
    joint.failAt("type", "is not supported; known are fixed, revolute, continuous and prismatic");
  checkAxis(joint);
  checkLimit(joint, type != "continuous");
  checkMimic(joint, robot);
}

}  // namespace

void validateUrdfValues(const std::string& file, const XMLElement& robot) {
  for (auto* link = robot.FirstChildElement("link"); link != nullptr;
       link = link->NextSiblingElement("link")) {
    const std::string owner = std::string("link '") + link->Attribute("name") + "'";
    for (auto* c = link->FirstChildElement("collision"); c != nullptr; c = c->NextSiblingElement("collision"))
      checkCollision(UrdfText(file, owner, *c));
  }
  for (auto* joint = robot.FirstChildElement("joint"); joint != nullptr;
       joint = joint->NextSiblingElement("joint")) {
    const std::string owner = std::string("joint '") + joint->Attribute("name") + "'";
    checkJoint(UrdfText(file, owner, *joint), robot);
  }
}

std::size_t declaredShapes(const XMLElement& robot, const std::string& link) {
  std::size_t count = 0;
  for (auto* l = robot.FirstChildElement("link"); l != nullptr; l = l->NextSiblingElement("link")) {
    if (link != l->Attribute("name")) continue;
    for (auto* c = l->FirstChildElement("collision"); c != nullptr; c = c->NextSiblingElement("collision"))
      ++count;
  }
  return count;
}

}  // namespace b4p
