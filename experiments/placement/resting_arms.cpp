// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/placement/resting_arms.h"

#include <algorithm>
#include <filesystem>
#include <map>
#include <string>
#include <utility>

#include "robots/input_error.h"
#include "robots/number_text.h"
#include "robots/robot_model.h"

namespace b4p {
namespace {

constexpr double kSamePose = 1e-9;  // m, and entries of rotation matrices

bool sameRobot(const PlacementArm& a, const PlacementArm& b) {
  std::error_code error;
  const bool same_file =
      a.urdf_file == b.urdf_file || std::filesystem::equivalent(a.urdf_file, b.urdf_file, error);
  return same_file && (a.X_WB.matrix() - b.X_WB.matrix()).cwiseAbs().maxCoeff() <= kSamePose;
}

bool contains(const std::vector<std::string>& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

/// Values of the joints that other arms of the robot leave where they are.
class RestValues {
 public:
  RestValues(const Scene& scene, const RobotModel& model, const PlacementArm& moving)
      : scene_(scene), model_(model), moving_(moving) {}

  void add(const PlacementArm& other) {
    const ManipulatorDescription& description = other.description;
    for (std::size_t i = 0; i < description.joints.size(); ++i)
      add(other, "start", description.joints[i], other.start[i]);
    for (const std::string& finger : description.finger_joints)
      add(other, "rest_opening_m", finger, other.rest_opening_m / 2.0);
  }

  const std::map<std::string, double>& values() const { return values_; }

 private:
  void add(const PlacementArm& other, const char* key, const std::string& name, double value) {
    if (contains(moving_.description.joints, name) || contains(moving_.description.finger_joints, name))
      return;
    const auto fail = [&](const std::string& problem) {
      throw InputError(scene_.file, "place.arms." + other.name + "." + key, problem);
    };
    const int index = model_.jointIndex(name);
    if (index < 0) throw InputError(other.robot_file, "joints", "there is no joint '" + name + "'");
    const Joint& joint = model_.joints[static_cast<std::size_t>(index)];
    if (!(value >= joint.lower && value <= joint.upper))
      fail("joint '" + name + "' at " + numberText(value) + " is outside its limits, " +
           numberText(joint.lower) + " to " + numberText(joint.upper));
    const auto [known, first] = values_.emplace(name, value);
    if (!first && known->second != value)
      fail("joint '" + name + "' is at " + numberText(value) + ", but another arm has it rest at " +
           numberText(known->second));
  }

  const Scene& scene_;
  const RobotModel& model_;
  const PlacementArm& moving_;
  std::map<std::string, double> values_;
};

}  // namespace

std::shared_ptr<const Manipulator> robotWithOthersAtRest(const Scene& scene, std::size_t arm) {
  const std::vector<PlacementArm>& arms = scene.placing().arms;
  const PlacementArm& moving = arms[arm];
  RobotModel model = loadUrdf(moving.urdf_file);
  RestValues others(scene, model, moving);
  for (std::size_t i = 0; i < arms.size(); ++i)
    if (i != arm && sameRobot(arms[i], moving)) others.add(arms[i]);
  ManipulatorDescription description = moving.description;
  for (const auto& [joint, value] : others.values()) description.rest[joint] = value;
  return std::make_shared<Manipulator>(std::move(model), std::move(description), moving.X_WB,
                                       moving.robot_file);
}

std::vector<Obstacle> otherRobots(const Scene& scene, std::size_t arm) {
  const std::vector<PlacementArm>& arms = scene.placing().arms;
  std::vector<Obstacle> obstacles;
  std::vector<Eigen::Isometry3d> X_WL;
  for (std::size_t i = 0; i < arms.size(); ++i) {
    const auto isSame = [&](const PlacementArm& other) { return sameRobot(other, arms[i]); };
    const auto here = arms.begin() + static_cast<std::ptrdiff_t>(i);
    if (isSame(arms[arm]) || std::any_of(arms.begin(), here, isSame)) continue;
    const auto robot = robotWithOthersAtRest(scene, i);
    robot->linkPoses(arms[i].start.data(), arms[i].rest_opening_m, X_WL);
    for (std::size_t link = 0; link < X_WL.size(); ++link)
      for (const PlacedShape& placed : robot->model().links[link].shapes)
        obstacles.push_back({arms[i].name + ": " + robot->model().links[link].name,
                             {placed.shape, X_WL[link] * placed.X_BS}});
  }
  return obstacles;
}

}  // namespace b4p
