// SPDX-License-Identifier: BSD-3-Clause
#include "state_validity/lanes/lane_search.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace b4p::lanes {
namespace {

constexpr std::size_t kSlots = 1024;
// Parts that the samples on one side of a sample are cut into.
constexpr std::int64_t kFiner = 4;
// Bounds of motion are rounded up by this share.
constexpr double kUpwards = 1.0 + 1e-6;

std::uint32_t bit(int lane) { return 1u << lane; }

}  // namespace

LaneSearch::LaneSearch(std::shared_ptr<const LaneModel> model, PosedPieces& pieces)
    : model_(std::move(model)),
      pieces_(pieces),
      dof_(pieces.world().robot().dof()),
      known_(kSlots),
      q_lanes_(static_cast<std::size_t>(dof_ * kLanes)),
      q_(static_cast<std::size_t>(dof_)) {
  query_.q = q_lanes_.data();
}

const LaneSearch::Hands& LaneSearch::hands() {
  const HeldObject& held = pieces_.held();
  std::unique_ptr<Hands>& slot = known_[held.serial % kSlots];
  if (slot && slot->serial == held.serial) return *slot;
  slot = std::make_unique<Hands>();
  slot->serial = held.serial;
  slot->robot = model_->robot(pieces_.world(), pieces_.opening_m(), held.held ? &held.X_TO : nullptr);
  scratch_.makeRoom(model_->lanes(), slot->robot);
  return *slot;
}

void LaneSearch::boundPairTravel(Hands& in_hand) {
  const Eigen::MatrixXd& travel = pieces_.travel();
  const int moving = static_cast<int>(in_hand.robot.moving.size());
  const std::vector<PiecePair>& pairs = pieces_.pairs();
  const std::size_t count = in_hand.robot.pairs.size();
  in_hand.pair_travel_m.assign(static_cast<std::size_t>(dof_) * count, 0.0f);
  std::size_t index = 0;
  for (const PiecePair& pair : pairs) {
    if (pair.b >= model_->lanes().obstacle_begin) continue;
    for (const int joint : pair.joints) {
      const double closer = travel(joint, pair.a) + (pair.b < moving ? travel(joint, pair.b) : 0.0);
      in_hand.pair_travel_m[static_cast<std::size_t>(joint) * count + index] =
          static_cast<float>(closer * kUpwards);
    }
    ++index;
  }
}

bool LaneSearch::stateFree(const double* q) {
  bool free = false;
  statesFree(q, 1, &free);
  return free;
}

void LaneSearch::statesFree(const double* q, int count, bool* free) {
  const Hands& in_hand = hands();
  std::fill(query_.reach, query_.reach + kLanes, 0.0f);
  query_.body_motion_m = query_.pair_motion_m = nullptr;
  query_.among = nullptr;
  for (int begin = 0; begin < count; begin += kLanes) {
    const int used = std::min(kLanes, count - begin);
    for (int lane = 0; lane < kLanes; ++lane)
      for (int j = 0; j < dof_; ++j)
        q_lanes_[static_cast<std::size_t>(j * kLanes + lane)] =
            static_cast<float>(q[(begin + std::min(lane, used - 1)) * dof_ + j]);
    query_.used = used;
    query_.any = used == 1;
    query_.each = used > 1;
    checkBlock(model_->lanes(), in_hand.robot, query_, scratch_);
    query_.each = false;
    checked_ += static_cast<std::uint64_t>(used);
    for (int lane = 0; lane < used; ++lane) {
      bool collides = (scratch_.colliding & bit(lane)) != 0;
      bool placed = false;
      for (int i = 0; i < scratch_.count && !collides; ++i) {
        const PairLanes& pair = scratch_.pairs[static_cast<std::size_t>(i)];
        if ((pair.unsure & bit(lane)) == 0) continue;
        if (!placed) pieces_.place(q + (begin + lane) * dof_);
        placed = true;
        ++judged_;
        collides = pieces_.collide({pair.a, pair.b, {}});
      }
      free[begin + lane] = !collides;
    }
  }
}

bool LaneSearch::allFree(const EdgeSamples& samples) {
  const Hands& in_hand = hands();
  start(samples, in_hand.robot);
  Parts all;
  splitEvenly(samples.last(), all);
  parts_.push_back(all);
  // Taken from the front: coarse before fine.
  for (std::size_t front = 0; front < parts_.size(); ++front) {
    const Parts parts = parts_[front];
    run(samples, in_hand.robot, parts, front == 0, true);
    int blocked_lane = kLanes;
    if (scratch_.colliding != 0 || !judge(samples, parts, ~0u, blocked_lane)) return false;
    addFiner(parts, samples.last() + 1, false);
  }
  return true;
}

std::int64_t LaneSearch::firstBlocked(const EdgeSamples& samples, std::int64_t last) {
  const Hands& in_hand = hands();
  start(samples, in_hand.robot);
  Parts all;
  splitFinerAtFront(last, all);
  parts_.push_back(all);
  std::int64_t blocked = last + 1;
  // Taken from the back: what is nearer to q1 before the other.
  for (bool all_pairs = true; !parts_.empty(); all_pairs = false) {
    Parts parts = parts_.back();
    parts_.pop_back();
    while (parts.used > 0 && parts.part[parts.used - 1].first >= blocked) --parts.used;
    if (parts.used == 0) continue;
    run(samples, in_hand.robot, parts, all_pairs, false);
    near_.resize(parts.begin);
    int blocked_lane = kLanes;
    if (scratch_.colliding != 0) blocked_lane = __builtin_ctz(scratch_.colliding);
    judge(samples, parts, blocked_lane == kLanes ? ~0u : bit(blocked_lane) - 1u, blocked_lane);
    if (blocked_lane < kLanes) blocked = std::min(blocked, parts.part[blocked_lane].k);
    addFiner(parts, blocked, true);
  }
  return blocked;
}

void LaneSearch::start(const EdgeSamples& samples, const LaneRobot& robot) {
  asked_fcl_ = false;
  parts_.clear();
  near_.clear();
  query_.body_motion_m = query_.pair_motion_m = nullptr;
  if (samples.last() < kLanes) return;
  Hands& in_hand = *known_[pieces_.held().serial % kSlots];
  if (in_hand.pair_travel_m.empty()) boundPairTravel(in_hand);
  const Eigen::MatrixXd& travel = pieces_.travel();
  const std::size_t moving = robot.moving.size(), pairs = robot.pairs.size();
  const double per_sample = kUpwards / static_cast<double>(samples.last());
  body_motion_m_.assign(moving, 0.0f);
  pair_motion_m_.assign(pairs, 0.0f);
  for (int j = 0; j < dof_; ++j) {
    q_[static_cast<std::size_t>(j)] = std::abs(samples.q2()[j] - samples.q1()[j]) * per_sample;
    const auto joint_motion = static_cast<float>(q_[static_cast<std::size_t>(j)]);
    const float* travel_m = in_hand.pair_travel_m.data() + static_cast<std::size_t>(j) * pairs;
    for (std::size_t i = 0; i < pairs; ++i) pair_motion_m_[i] += joint_motion * travel_m[i];
  }
  const double* travel_m = travel.data();
  for (std::size_t i = 0; i < moving; ++i, travel_m += dof_) {
    double motion = 0.0;
    for (int j = 0; j < dof_; ++j) motion += travel_m[j] * q_[static_cast<std::size_t>(j)];
    body_motion_m_[i] = static_cast<float>(motion * kUpwards);
  }
  for (float& motion : pair_motion_m_) motion *= static_cast<float>(kUpwards);
  query_.body_motion_m = body_motion_m_.data();
  query_.pair_motion_m = pair_motion_m_.data();
}

void LaneSearch::run(const EdgeSamples& samples, const LaneRobot& robot, const Parts& parts, bool all_pairs,
                     bool any) {
  const double per_sample = 1.0 / static_cast<double>(samples.last());
  double t[kLanes];
  for (int lane = 0; lane < kLanes; ++lane) {
    const Part& part = parts.part[std::min(lane, parts.used - 1)];
    t[lane] = static_cast<double>(part.k) * per_sample;
    query_.reach[lane] = static_cast<float>(std::max(part.k - part.first, part.last - part.k));
  }
  for (int j = 0; j < dof_; ++j) {
    const double from = samples.q1()[j], way = samples.q2()[j] - from;
    float* to = q_lanes_.data() + j * kLanes;
    for (int lane = 0; lane < kLanes; ++lane) to[lane] = static_cast<float>(from + t[lane] * way);
  }
  query_.used = parts.used;
  query_.among = all_pairs ? nullptr : near_.data() + parts.begin;
  query_.among_count = all_pairs ? 0 : static_cast<int>(parts.end - parts.begin);
  query_.any = any;
  checkBlock(model_->lanes(), robot, query_, scratch_);
  checked_ += static_cast<std::uint64_t>(parts.used);
}

// Has FCL decide about what is unsure in the given lanes. False when something collides; the first such lane
// is blocked_lane then.
bool LaneSearch::judge(const EdgeSamples& samples, const Parts& parts, std::uint32_t lane_bits,
                       int& blocked_lane) {
  std::uint32_t unsure = 0;
  for (int i = 0; i < scratch_.count; ++i) unsure |= scratch_.pairs[static_cast<std::size_t>(i)].unsure;
  unsure &= lane_bits;
  asked_fcl_ = asked_fcl_ || unsure != 0;
  for (; unsure != 0; unsure &= unsure - 1) {
    const int lane = __builtin_ctz(unsure);
    samples.at(parts.part[lane].k, q_.data());
    pieces_.place(q_.data());
    for (int i = 0; i < scratch_.count; ++i) {
      const PairLanes& pair = scratch_.pairs[static_cast<std::size_t>(i)];
      if ((pair.unsure & bit(lane)) == 0) continue;
      ++judged_;
      if (!pieces_.collide({pair.a, pair.b, {}})) continue;
      blocked_lane = lane;
      return false;
    }
  }
  return true;
}

// Adds what is left to check of the samples before `end`, which has to be looked at more finely.
void LaneSearch::addFiner(const Parts& parts, std::int64_t end, bool nearest_last) {
  std::uint32_t near = 0;
  for (int i = 0; i < scratch_.count; ++i) near |= scratch_.pairs[static_cast<std::size_t>(i)].near;
  finer_.clear();
  const auto flush = [&](Parts& finer) {
    if (finer.used > 0) finer_.push_back(finer);
    finer.used = 0;
  };
  Parts finer;
  for (; near != 0; near &= near - 1) {
    const int lane = __builtin_ctz(near);
    if (lane >= parts.used) break;
    const Part& part = parts.part[lane];
    const std::int64_t sides[2][2] = {{part.first, std::min(part.k, end) - 1},
                                      {part.k + 1, std::min(part.last, end - 1)}};
    for (const auto& side : sides) {
      const std::int64_t length = side[1] - side[0] + 1;
      if (length <= 0) continue;
      const std::int64_t count = std::min(length, kFiner);
      for (std::int64_t i = 0; i < count; ++i) {
        const std::int64_t first = side[0] + length * i / count,
                           last = side[0] + length * (i + 1) / count - 1;
        finer.part[finer.used] = {first + (last - first) / 2, first, last};
        finer.parent[finer.used++] = lane;
        if (finer.used == kLanes) flush(finer);
      }
    }
  }
  flush(finer);
  if (nearest_last) std::reverse(finer_.begin(), finer_.end());
  for (Parts& child : finer_) {
    child.begin = near_.size();
    std::uint32_t children_of[kLanes] = {};
    for (int i = 0; i < child.used; ++i) children_of[child.parent[i]] |= bit(i);
    for (int i = 0; i < scratch_.count; ++i) {
      const PairLanes& pair = scratch_.pairs[static_cast<std::size_t>(i)];
      std::uint32_t lanes = 0;
      for (std::uint32_t bits = pair.near; bits != 0; bits &= bits - 1)
        lanes |= children_of[__builtin_ctz(bits)];
      if (lanes != 0) near_.push_back({pair.a, pair.b, pair.motion_m, static_cast<std::uint16_t>(lanes), 0});
    }
    child.end = near_.size();
    parts_.push_back(child);
  }
}

void LaneSearch::splitEvenly(std::int64_t last, Parts& into) {
  const std::int64_t length = last + 1;
  into.used = static_cast<int>(std::min<std::int64_t>(kLanes, length));
  for (int i = 0; i < into.used; ++i) {
    Part& part = into.part[i];
    part.first = length * i / into.used;
    part.last = length * (i + 1) / into.used - 1;
    part.k = part.first + (part.last - part.first) / 2;
  }
}

// Motions of search trees are mostly blocked near their start: part by part grows by the same factor.
void LaneSearch::splitFinerAtFront(std::int64_t last, Parts& into) {
  const std::int64_t length = last + 1;
  const double factor = std::pow(static_cast<double>(length), 1.0 / kLanes);
  double end = 1.0;
  into.used = 0;
  for (std::int64_t first = 0; first < length;) {
    end *= factor;
    const bool rest = into.used == kLanes - 1;
    const std::int64_t next = rest ? length : std::clamp(static_cast<std::int64_t>(end), first + 1, length);
    into.part[into.used++] = {first + (next - 1 - first) / 2, first, next - 1};
    first = next;
  }
}

}  // namespace b4p::lanes
