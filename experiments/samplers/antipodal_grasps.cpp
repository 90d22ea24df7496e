// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/samplers/antipodal_grasps.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "experiments/floating_body.h"
#include "experiments/samplers/unit_draw.h"

namespace b4p {
namespace {

constexpr double kPi = 3.14159265358979323846;

/// Two unit vectors that make a right-handed frame with z.
std::pair<Eigen::Vector3d, Eigen::Vector3d> across(const Eigen::Vector3d& z) {
  const Eigen::Vector3d x = z.unitOrthogonal();
  return {x, z.cross(x)};
}

/// Uniform by solid angle among the directions at most `angle` off `axis`.
Eigen::Vector3d drawInCone(const Eigen::Vector3d& axis, double angle, std::mt19937_64& random) {
  const double cosine = 1.0 - unitDraw(random) * (1.0 - std::cos(angle));
  const double sine = std::sqrt(1.0 - cosine * cosine), turn = 2.0 * kPi * unitDraw(random);
  const auto [x, y] = across(axis);
  return cosine * axis + sine * (std::cos(turn) * x + std::sin(turn) * y);
}

std::shared_ptr<const CollisionChecker> handChecker(const std::shared_ptr<const Manipulator>& robot,
                                                    const std::vector<PlacedShape>& obstacles,
                                                    double clearance_m) {
  CollisionProblem problem;
  problem.robot = robot;
  problem.padding_m = clearance_m;
  for (const PlacedShape& shape : obstacles) problem.obstacles.push_back({"obstacle", shape});
  return FloatingBody::makeChecker(problem, FloatingBody::Parts::kGripper);
}

/// The robot with nothing to collide but its fingers.
std::shared_ptr<const Manipulator> fingersOnly(const Manipulator& robot) {
  RobotModel model = robot.model();
  for (std::size_t i = 0; i < model.links.size(); ++i) {
    const std::vector<int>& fingers = robot.fingerLinks();
    if (std::find(fingers.begin(), fingers.end(), static_cast<int>(i)) == fingers.end())
      model.links[i].shapes.clear();
  }
  return std::make_shared<const Manipulator>(model, robot.description(), robot.X_WB(), "fingers");
}

}  // namespace

AntipodalSampler::AntipodalSampler(const std::vector<PlacedShape>& object, double max_opening_m,
                                   const AntipodalRules& rules)
    : max_opening_m_(max_opening_m), rules_(rules) {
  if (object.empty()) throw std::invalid_argument("an object without shapes has no grasps");
  if (!(rules.friction_cone_rad >= 0.0 && rules.friction_cone_rad < kPi / 2.0))
    throw std::invalid_argument("the friction cone has to be from 0 to less than a right angle");
  if (!(rules.pad_clearance_m >= 0.0) || !(rules.hand_clearance_m >= 0.0) ||
      !std::isfinite(rules.contact_depth_m))
    throw std::invalid_argument("clearances of a grasp have to be at least 0");
  for (const PlacedShape& shape : object) {
    pieces_.emplace_back(shape);
    area_m2_ += pieces_.back().area_m2();
  }
}

const Surface& AntipodalSampler::drawPiece(std::mt19937_64& random) const {
  double share = unitDraw(random) * area_m2_;
  std::size_t i = 0;
  while (i + 1 < pieces_.size() && share >= pieces_[i].area_m2()) share -= pieces_[i++].area_m2();
  return pieces_[i];
}

bool AntipodalSampler::buried(const Eigen::Vector3d& p_O, const Surface& piece) const {
  constexpr double kRounding_m = 1e-9;
  for (const Surface& other : pieces_)
    if (&other != &piece && other.signedDistance(p_O) < -kRounding_m) return true;
  return false;
}

std::optional<Grasp> AntipodalSampler::draw(std::mt19937_64& random) const {
  const Surface& piece = drawPiece(random);
  const Eigen::Vector3d contact = piece.sample(random);
  const Eigen::Vector3d closing = drawInCone(-piece.normal(contact), rules_.friction_cone_rad, random);
  const Eigen::Vector3d opposite = piece.exit(contact, closing);
  const double roll = 2.0 * kPi * unitDraw(random);
  if (piece.normal(opposite).dot(closing) < std::cos(rules_.friction_cone_rad)) return {};
  const double opening_m = (opposite - contact).norm() + 2.0 * rules_.pad_clearance_m;
  if (opening_m > max_opening_m_ || buried(contact, piece) || buried(opposite, piece)) return {};
  const auto [x, y] = across(closing);
  const Eigen::Vector3d approach = std::cos(roll) * x + std::sin(roll) * y;
  Grasp grasp;
  grasp.X_OT.linear() << closing.cross(approach), closing, approach;
  grasp.X_OT.translation() = (contact + opposite) / 2.0 + rules_.contact_depth_m * approach;
  grasp.opening_m = opening_m;
  return grasp;
}

std::vector<Grasp> antipodalGrasps(const std::shared_ptr<const Manipulator>& robot,
                                   const std::vector<PlacedShape>& object,
                                   const std::vector<PlacedShape>& support, const AntipodalRules& rules,
                                   std::size_t count, std::uint64_t seed) {
  constexpr int kMostDraws = 1000000;
  const double max_opening_m = robot->description().max_opening_m;
  const AntipodalSampler sampler(object, max_opening_m, rules);
  FloatingBody hand(*handChecker(robot, object, rules.hand_clearance_m));
  FloatingBody fingers(*handChecker(fingersOnly(*robot), support, 0.0));
  Grasp open;
  open.opening_m = max_opening_m;
  std::mt19937_64 random(seed);
  std::vector<Grasp> grasps;
  for (int draw = 0; draw < kMostDraws && grasps.size() < count; ++draw) {
    const std::optional<Grasp> grasp = sampler.draw(random);
    if (grasp && fingers.isFree(grasp->X_OT, open) && hand.isFree(grasp->X_OT, open))
      grasps.push_back(*grasp);
  }
  if (grasps.size() < count)
    throw std::invalid_argument("only " + std::to_string(grasps.size()) + " of " + std::to_string(count) +
                                " antipodal grasps found in " + std::to_string(kMostDraws) + " draws");
  return grasps;
}

}  // namespace b4p
