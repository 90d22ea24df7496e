// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <memory>
#include <random>

#include "robots/manipulator.h"
#include "state_validity/collision_checker.h"

namespace b4p::testing {

/// The project's Panda on the world's origin, described as in robots/panda.yaml.
inline std::shared_ptr<const Manipulator> panda() {
  static const std::shared_ptr<const Manipulator> robot = [] {
    ManipulatorDescription description;
    for (const char* joint : {"1", "2", "3", "4", "5", "6", "7"})
      description.joints.push_back(std::string("panda_joint") + joint);
    description.tcp_link = "panda_tcp";
    description.finger_joints = {"panda_finger_joint1", "panda_finger_joint2"};
    description.finger_links = {"panda_leftfinger", "panda_rightfinger"};
    description.max_opening_m = 0.08;
    const auto skip = [&description](const std::string& a, std::initializer_list<const char*> others) {
      for (const char* b : others)
        description.skip_self_collision.emplace_back("panda_" + a, std::string("panda_") + b);
    };
    skip("link0", {"link2", "link3", "link4"});
    skip("link1", {"link3", "link4"});
    skip("link2", {"link4"});
    skip("link3", {"link5", "link6", "link7"});
    skip("link5", {"link7"});
    skip("hand", {"link3", "link4", "link5", "link6"});
    for (const char* finger : {"leftfinger", "rightfinger"})
      skip(finger, {"link3", "link4", "link6", "link7"});
    return std::make_shared<const Manipulator>(loadUrdf(B4P_ROBOTS_DIR "/urdf/panda.urdf"), description,
                                               Eigen::Isometry3d::Identity(), "panda.h");
  }();
  return robot;
}

using PandaConfiguration = std::array<double, 7>;

inline PandaConfiguration randomPanda(std::mt19937_64& random) {
  PandaConfiguration q;
  for (int i = 0; i < 7; ++i)
    q[static_cast<std::size_t>(i)] =
        std::uniform_real_distribution<>(panda()->lower()[i], panda()->upper()[i])(random);
  return q;
}

/// A shelf-like clutter of boxes around the Panda, none at its foot.
inline std::vector<Obstacle> clutter(int count, std::mt19937_64& random) {
  std::uniform_real_distribution<> angle(-3.14, 3.14), distance(0.45, 0.9), height(0.1, 1.0), side(0.03, 0.2);
  std::vector<Obstacle> obstacles;
  for (int i = 0; i < count; ++i) {
    PlacedShape box{Box{{side(random), side(random), side(random)}}, Eigen::Isometry3d::Identity()};
    const double around = angle(random), away = distance(random);
    box.X_BS.translation() =
        Eigen::Vector3d(away * std::cos(around), away * std::sin(around), height(random));
    obstacles.push_back({"box" + std::to_string(i), box});
  }
  return obstacles;
}

/// A box of 6 x 6 x 12 cm held at its middle from above, its long side across the fingers.
inline CollisionProblem pandaProblem(int boxes, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  return {panda(), clutter(boxes, random), {{Box{{0.06, 0.06, 0.12}}, Eigen::Isometry3d::Identity()}}};
}

inline Grasp pandaGrasp() {
  Grasp grasp;
  grasp.X_OT =
      Eigen::Translation3d(0.0, 0.0, 0.04) * Eigen::AngleAxisd(3.141592653589793, Eigen::Vector3d::UnitX());
  grasp.opening_m = 0.062;
  return grasp;
}

}  // namespace b4p::testing
