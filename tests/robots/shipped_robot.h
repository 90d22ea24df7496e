// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <random>
#include <string>

#include "robots/manipulator.h"

namespace b4p {

/// What robots/NAME.yaml says, read without the project's own reader of scene files.
ManipulatorDescription shippedDescription(const std::string& name);

/// One of the robots that ship with b4p.
std::shared_ptr<const Manipulator> shippedRobot(
    const std::string& name, const Eigen::Isometry3d& X_WB = Eigen::Isometry3d::Identity());

/// A configuration uniform inside the limits.
Eigen::VectorXd randomConfiguration(const Manipulator& robot, std::mt19937_64& random);

/// The Panda on a carriage that slides along x and y, -1 m to 1 m: nine joints.
std::shared_ptr<const Manipulator> pandaOnCarriage();

/// A pose that is nothing special.
Eigen::Isometry3d unevenPose();

}  // namespace b4p
