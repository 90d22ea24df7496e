// SPDX-License-Identifier: BSD-3-Clause
#include "state_validity/lanes/lane_model.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "robots/joint_motion.h"
#include "state_validity/link_groups.h"
#include "state_validity/posed_pieces.h"

namespace b4p::lanes {
namespace {

constexpr double kRoundoff = 0x1p-24;
// What a joint's rotation adds to the error of its frame's orientation, in roundings, besides that of its
// value.
constexpr double kRoundingsPerTurn = 40.0;
// Roundings of positions, relative to the largest coordinate that takes part.
constexpr double kRoundingsPerMove = 8.0;
constexpr double kRoundingsPerDistance = 64.0;
// Meshes with more distinct faces than this are known by their bounding box only.
constexpr std::size_t kMostFaces = 64;
constexpr double kSameFace = 1e-9;

LanePose lanePose(const Eigen::Isometry3d& X) {
  LanePose pose;
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column)
      pose.r[3 * row + column] = static_cast<float>(X.linear()(row, column));
    pose.p[row] = static_cast<float>(X.translation()[row]);
  }
  return pose;
}

// Largest value that a planned joint is covered at.
double largestValue(const Joint& joint) {
  const double largest = std::max(std::abs(joint.lower), std::abs(joint.upper));
  return joint.type == JointType::kPrismatic ? std::min(largest, LaneModel::kLongestSlide_m) : largest;
}

// Rounded upwards, so that the face lies no deeper than it is.
float upwards(double value) {
  return std::nextafter(static_cast<float>(value), std::numeric_limits<float>::infinity());
}

std::shared_ptr<const LaneMesh> laneMesh(const ConvexMesh& mesh, const Eigen::Vector3d& middle) {
  auto lane_mesh = std::make_shared<LaneMesh>();
  std::vector<Eigen::Vector3d> normals;
  for (const std::array<int, 3>& face : mesh.triangles) {
    const auto vertex = [&](int i) -> const Eigen::Vector3d& {
      return mesh.vertices[static_cast<std::size_t>(face[static_cast<std::size_t>(i)])];
    };
    const Eigen::Vector3d area = (vertex(1) - vertex(0)).cross(vertex(2) - vertex(0));
    if (area.norm() == 0.0) continue;
    const Eigen::Vector3d n = area.normalized();
    if (std::any_of(normals.begin(), normals.end(),
                    [&n](const auto& m) { return n.dot(m) > 1.0 - kSameFace; }))
      continue;
    normals.push_back(n);
    if (normals.size() > kMostFaces) return nullptr;
    // The plane is put where the mesh ends in the direction that single precision makes of the normal.
    const Eigen::Vector3d rounded = n.cast<float>().cast<double>();
    double offset = -std::numeric_limits<double>::infinity();
    for (const Eigen::Vector3d& v : mesh.vertices) offset = std::max(offset, rounded.dot(v - middle));
    lane_mesh->nx.push_back(static_cast<float>(n.x()));
    lane_mesh->ny.push_back(static_cast<float>(n.y()));
    lane_mesh->nz.push_back(static_cast<float>(n.z()));
    lane_mesh->offset.push_back(upwards(offset));
  }
  for (const Eigen::Vector3d& v : mesh.vertices) {
    lane_mesh->x.push_back(static_cast<float>(v.x() - middle.x()));
    lane_mesh->y.push_back(static_cast<float>(v.y() - middle.y()));
    lane_mesh->z.push_back(static_cast<float>(v.z() - middle.z()));
  }
  return lane_mesh;
}

LaneKind kindOf(const Shape& shape) {
  if (std::holds_alternative<Box>(shape)) return LaneKind::kBox;
  if (std::holds_alternative<Cylinder>(shape)) return LaneKind::kCylinder;
  if (std::holds_alternative<Sphere>(shape) || std::holds_alternative<Capsule>(shape))
    return LaneKind::kSegment;
  return LaneKind::kMesh;
}

}  // namespace

LaneModel::LaneModel(const FclWorld& world) {
  const CollisionPieces& pieces = world.pieces();
  lanes_.moving_end = pieces.stillBegin();
  lanes_.obstacle_begin = pieces.obstacleBegin();
  lanes_.clear_m = static_cast<float>(PosedPieces::kClearlyApart_m);
  addJoints(world.robot());
  for (int i = 0; i < pieces.count(); ++i) {
    const auto* mesh = std::get_if<std::shared_ptr<const ConvexMesh>>(&pieces[i].grown);
    meshes_.push_back(mesh ? laneMesh(**mesh, pieces[i].bounds.centre) : nullptr);
    if (mesh && !meshes_.back()) coarse_ += (coarse_.empty() ? "" : ", ") + pieces[i].owner;
  }
  addStill(world);
}

void LaneModel::addJoints(const Manipulator& robot) {
  const RobotModel& model = robot.model();
  lane_joint_.assign(model.joints.size(), -1);
  std::vector<Carried> links(model.links.size(), {-1, robot.X_WB()});
  for (std::size_t j = 0; j < model.joints.size(); ++j) {
    const Joint& joint = model.joints[j];
    const Carried& parent = links[static_cast<std::size_t>(joint.parent_link)];
    Carried& child = links[static_cast<std::size_t>(joint.child_link)];
    const int q_index = plannedIndex(robot, static_cast<int>(j));
    if (q_index < 0) {
      child = {parent.joint, parent.X_JL * childInParent(joint, robot.restValue(static_cast<int>(j)))};
      continue;
    }
    const Eigen::Isometry3d to_axis(Eigen::Quaterniond::FromTwoVectors(Eigen::Vector3d::UnitZ(), joint.axis));
    const Eigen::Isometry3d X = parent.X_JL * joint.X_PJ * to_axis;
    const bool revolute = joint.type == JointType::kRevolute;
    lane_joint_[j] = static_cast<int>(lanes_.joints.size());
    child = {lane_joint_[j], to_axis.inverse()};
    X_joint_link_.push_back(child.X_JL);
    lanes_.joints.push_back({parent.joint, q_index, revolute, lanePose(X)});
    if (!revolute) slides_.push_back(q_index);

    const Error before = parent.joint < 0 ? Error{} : errors_[static_cast<std::size_t>(parent.joint)];
    const double largest = largestValue(joint),
                 offset_m = X.translation().norm() + (revolute ? 0.0 : largest);
    Error error;
    error.farthest_m = before.farthest_m + offset_m;
    error.angle = before.angle + kRoundoff * (kRoundingsPerTurn + (revolute ? 4.0 * largest : 0.0));
    error.place_m =
        before.place_m + error.angle * offset_m + kRoundoff * kRoundingsPerMove * error.farthest_m;
    errors_.push_back(error);
  }
}

LaneBody LaneModel::body(const Piece& piece, int joint, const Eigen::Isometry3d& X_JS) const {
  LaneBody body;
  body.kind = kindOf(piece.grown);
  body.joint = joint;
  Eigen::Isometry3d X = X_JS;
  X.translate(piece.bounds.centre);
  body.in_joint = lanePose(X);
  for (int i = 0; i < 3; ++i) body.half[i] = static_cast<float>(piece.bounds.half[i]);
  body.radius = static_cast<float>(piece.bounds.radius);
  const double size = piece.bounds.half.norm() + piece.bounds.radius;
  body.size = static_cast<float>(size);
  const Error error = joint < 0 ? Error{} : errors_[static_cast<std::size_t>(joint)];
  const double arm_m = X.translation().norm() + size;
  body.margin = upwards(error.place_m + error.angle * arm_m +
                        kRoundoff * kRoundingsPerDistance * (error.farthest_m + arm_m));
  return body;
}

std::vector<LaneModel::Carried> LaneModel::carriedLinks(const Manipulator& robot, double opening_m) const {
  const RobotModel& model = robot.model();
  std::vector<Carried> links(model.links.size(), {-1, robot.X_WB()});
  for (std::size_t j = 0; j < model.joints.size(); ++j) {
    const Joint& joint = model.joints[j];
    const Carried& parent = links[static_cast<std::size_t>(joint.parent_link)];
    Carried& child = links[static_cast<std::size_t>(joint.child_link)];
    if (const int lane_joint = lane_joint_[j]; lane_joint >= 0) {
      child = {lane_joint, X_joint_link_[static_cast<std::size_t>(lane_joint)]};
    } else {
      const int model_joint = static_cast<int>(j);
      const double value = isFingerJoint(robot, model_joint) ? opening_m / 2.0 : robot.restValue(model_joint);
      child = {parent.joint, parent.X_JL * childInParent(joint, value)};
    }
  }
  return links;
}

void LaneModel::addStill(const FclWorld& world) {
  const CollisionPieces& pieces = world.pieces();
  const std::vector<Carried> links = carriedLinks(world.robot(), world.robot().description().max_opening_m);
  for (int i = pieces.stillBegin(); i < pieces.count(); ++i) {
    const int link = pieces[i].link;
    const Eigen::Isometry3d X_WS =
        link < 0 ? pieces[i].X_BS : links[static_cast<std::size_t>(link)].X_JL * pieces[i].X_BS;
    lanes_.still.push_back(body(pieces[i], -1, X_WS));
    lanes_.still.back().mesh = meshes_[static_cast<std::size_t>(i)];
    if (i < pieces.obstacleBegin()) continue;
    const Aabb around = pieces[i].bounds.posed(X_WS).aabb();
    const double margin = lanes_.still.back().margin;
    for (int k = 0; k < 3; ++k) {
      lanes_.obstacles.low[k].push_back(static_cast<float>(around.centre[k] - around.half[k] - margin));
      lanes_.obstacles.high[k].push_back(static_cast<float>(around.centre[k] + around.half[k] + margin));
    }
  }
  lanes_.obstacle_groups = groupObstacles(lanes_.obstacles);
}

LaneRobot LaneModel::robot(const FclWorld& world, double opening_m, const Eigen::Isometry3d* X_TO) const {
  const CollisionPieces& pieces = world.pieces();
  const Manipulator& manipulator = world.robot();
  const std::vector<Carried> links = carriedLinks(manipulator, opening_m);
  LaneRobot robot;
  const int count = X_TO ? pieces.stillBegin() : pieces.objectBegin();
  for (int i = 0; i < count; ++i) {
    const bool carried = i >= pieces.objectBegin();
    const Carried& link = links[static_cast<std::size_t>(carried ? manipulator.tcpLink() : pieces[i].link)];
    const Eigen::Isometry3d X_LS = carried ? *X_TO * pieces[i].X_BS : pieces[i].X_BS;
    robot.moving.push_back(body(pieces[i], link.joint, link.X_JL * X_LS));
    robot.moving.back().mesh = meshes_[static_cast<std::size_t>(i)];
  }
  robot.meets_obstacles.assign(static_cast<std::size_t>(count), 0);
  for (const PiecePair& pair : world.pairs(X_TO != nullptr).moving) {
    if (pair.b >= pieces.obstacleBegin())
      robot.meets_obstacles[static_cast<std::size_t>(pair.a)] = 1;
    else
      robot.pairs.push_back({pair.a, pair.b, static_cast<int>(robot.pairs.size())});
  }
  return robot;
}

bool LaneModel::covers(const double* q) const {
  return std::all_of(slides_.begin(), slides_.end(),
                     [q](int i) { return std::abs(q[i]) <= kLongestSlide_m; });
}

}  // namespace b4p::lanes
