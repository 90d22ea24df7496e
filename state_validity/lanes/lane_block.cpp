// SPDX-License-Identifier: BSD-3-Clause
#include "state_validity/lanes/lane_block.h"

#include <algorithm>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "state_validity/lanes/lane_block.cpp"
#include <hwy/foreach_target.h>  // compiles this file once per instruction set
#include <hwy/highway.h>

#include "state_validity/lanes/lane_distances-inl.h"
#include "state_validity/lanes/lane_kinematics-inl.h"

HWY_BEFORE_NAMESPACE();
namespace b4p::lanes::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

constexpr int kBodyFloats = 15 * kLanes;

class Block {
 public:
  Block(const LaneWorld& world, const LaneRobot& robot, const BlockQuery& query, BlockScratch& scratch)
      : world_(world), robot_(robot), query_(query), scratch_(scratch), active_((1u << query.used) - 1u) {}

  void run() {
    scratch_.count = 0;
    scratch_.colliding = 0;
    for (int lane = 0; lane < query_.used; lane += width_)
      poseJoints(world_, query_.q, lane, scratch_.joints);
    if (query_.among)
      runAmong();
    else
      runAll();
  }

 private:
  const LaneBody& body(int i) const {
    return i < world_.moving_end ? robot_.moving[static_cast<std::size_t>(i)] : world_.stillBody(i);
  }
  float* placed(int i) const { return scratch_.bodies + i * kBodyFloats; }
  bool ended() const { return query_.any && scratch_.colliding != 0; }

  void place(int i) {
    const LaneBody& moving = body(i);
    for (int lane = 0; lane < query_.used; lane += width_) {
      Placed out;
      placeBody(moving, scratch_.joints, lane, out);
      storePlaced(out, placed(i), lane);
    }
  }

  void runAmong() {
    ++scratch_.stamp;
    for (int i = 0; i < query_.among_count && !ended(); ++i) {
      const PairLanes& pair = query_.among[i];
      for (const int b : {pair.a, pair.b})
        if (b < world_.moving_end && scratch_.placed_at[static_cast<std::size_t>(b)] != scratch_.stamp) {
          place(b);
          scratch_.placed_at[static_cast<std::size_t>(b)] = scratch_.stamp;
        }
      look(pair.a, pair.b, pair.motion_m, pair.near & active_);
    }
  }

  // Neighbouring edges tend to be blocked by the same pair.
  void tryLastHit() {
    const int count = static_cast<int>(robot_.moving.size());
    const auto known = [&](int i) { return i < count || i >= world_.moving_end; };
    if (scratch_.hit_b < 0 || !known(scratch_.hit_a) || !known(scratch_.hit_b)) return;
    place(scratch_.hit_a);
    if (scratch_.hit_b < count) place(scratch_.hit_b);
    look(scratch_.hit_a, scratch_.hit_b, 0.0f, active_);
    scratch_.count = 0;
  }

  void runAll() {
    if (!query_.each) tryLastHit();
    const int count = static_cast<int>(robot_.moving.size());
    // From the hand to the base: what moves farthest is blocked first, and lanes behind that need no looking
    // at.
    for (int i = count - 1; i >= 0 && !ended(); --i) {
      place(i);
      sweep(i);
      if (robot_.meets_obstacles[static_cast<std::size_t>(i)]) lookAtObstacles(i);
    }
    for (const LanePair& pair : robot_.pairs) {
      if (ended()) return;
      if (pair.b < world_.moving_end && !sweptMeet(pair.a, pair.b)) continue;
      look(pair.a, pair.b, query_.pair_motion_m ? query_.pair_motion_m[pair.index] : 0.0f, active_);
    }
  }

  // The box around all that body i reaches from any of the configurations that are of interest.
  void sweep(int i) {
    const V motion = constant(query_.body_motion_m ? query_.body_motion_m[i] : 0.0f);
    const V around = constant(body(i).margin + world_.clear_m);
    V low[3], high[3];
    for (int k = 0; k < 3; ++k) {
      low[k] = constant(kFar);
      high[k] = constant(-kFar);
    }
    for (int lane = 0; lane < query_.used && (active_ >> lane) != 0; lane += width_) {
      const auto of_interest = maskOf((active_ >> lane) & lane_mask_);
      const V more = hn::MulAdd(motion, hn::LoadU(d_, query_.reach + lane), around);
      for (int k = 0; k < 3; ++k) {
        const V middle = hn::Load(d_, placed(i) + (9 + k) * kLanes + lane);
        const V extent = hn::Add(hn::Load(d_, placed(i) + (12 + k) * kLanes + lane), more);
        const V below = hn::Sub(middle, extent), above = hn::Add(middle, extent);
        low[k] = hn::IfThenElse(of_interest, hn::Min(low[k], below), low[k]);
        high[k] = hn::IfThenElse(of_interest, hn::Max(high[k], above), high[k]);
      }
    }
    for (int k = 0; k < 3; ++k) {
      scratch_.swept[6 * i + k] = hn::GetLane(hn::MinOfLanes(d_, low[k]));
      scratch_.swept[6 * i + 3 + k] = hn::GetLane(hn::MaxOfLanes(d_, high[k]));
    }
  }

  bool sweptMeet(int a, int b) const {
    const float *sa = scratch_.swept + 6 * a, *sb = scratch_.swept + 6 * b;
    for (int k = 0; k < 3; ++k)
      if (sa[k] > sb[3 + k] || sb[k] > sa[3 + k]) return false;
    return true;
  }

  // Those of the boxes from `first` on, a register's width of them, that meet a swept box.
  std::uint32_t meeting(const LaneBoxes& boxes, int first, const float* swept) const {
    auto meet = hn::FirstN(d_, hn::Lanes(d_));
    for (int k = 0; k < 3; ++k) {
      meet = hn::And(meet, hn::Le(hn::LoadU(d_, boxes.low[k].data() + first), constant(swept[3 + k])));
      meet = hn::And(meet, hn::Ge(hn::LoadU(d_, boxes.high[k].data() + first), constant(swept[k])));
    }
    return bitsOf(meet);
  }

  void lookAtObstacles(int i) {
    const float* swept = scratch_.swept + 6 * i;
    const ObstacleGroups& sorted = world_.obstacle_groups;
    for (int first = 0; first < sorted.count; first += width_)
      for (std::uint32_t bits = meeting(sorted.groups, first, swept); bits != 0; bits &= bits - 1)
        if (!lookAtGroup(i, first + lowestBit(bits))) return;
  }

  // False when that has ended the search.
  bool lookAtGroup(int i, int group) {
    const float* swept = scratch_.swept + 6 * i;
    const ObstacleGroups& sorted = world_.obstacle_groups;
    const float motion_m = query_.body_motion_m ? query_.body_motion_m[i] : 0.0f;
    for (int first = group * kLanes; first < (group + 1) * kLanes; first += width_)
      for (std::uint32_t bits = meeting(sorted.boxes, first, swept); bits != 0; bits &= bits - 1) {
        const int obstacle = sorted.order[static_cast<std::size_t>(first + lowestBit(bits))];
        look(i, world_.obstacle_begin + obstacle, motion_m, active_);
        if (ended()) return false;
      }
    return true;
  }

  static int lowestBit(std::uint32_t bits) {
    return static_cast<int>(hwy::Num0BitsBelowLS1Bit_Nonzero32(bits));
  }

  template <typename Mask>
  static std::uint32_t bitsOf(Mask mask) {
    std::uint8_t bytes[8] = {};
    hn::StoreMaskBits(Lanes(), mask, bytes);
    return static_cast<std::uint32_t>(bytes[0]) | static_cast<std::uint32_t>(bytes[1]) << 8;
  }

  static hn::Mask<Lanes> maskOf(std::uint32_t bits) {
    std::uint8_t bytes[8] = {static_cast<std::uint8_t>(bits), static_cast<std::uint8_t>(bits >> 8)};
    return hn::LoadMaskBits(Lanes(), bytes);
  }

  void load(int i, int lane, Placed& out) const {
    if (i < world_.moving_end)
      loadPlaced(placed(i), lane, out);
    else
      placeStill(world_.stillBody(i), out);
  }

  // Lanes in which the axis-aligned boxes around a moving body and an obstacle are farther apart than asked.
  std::uint32_t clearOfObstacle(const Placed& pa, int lane, int a, int b, V apart) const {
    const std::size_t o = static_cast<std::size_t>(b - world_.obstacle_begin);
    V square = hn::Zero(d_);
    for (int k = 0; k < 3; ++k) {
      const V extent = hn::Load(d_, placed(a) + (12 + k) * kLanes + lane);
      const V above = hn::Sub(hn::Sub(pa.middle[k], extent), constant(world_.obstacles.high[k][o]));
      const V below = hn::Sub(constant(world_.obstacles.low[k][o]), hn::Add(pa.middle[k], extent));
      const V gap = positive(hn::Max(above, below));
      square = hn::MulAdd(gap, gap, square);
    }
    return bitsOf(hn::Gt(square, hn::Mul(apart, apart)));
  }

  void look(int a, int b, float motion_m, std::uint32_t lanes) {
    if (lanes == 0) return;
    const LaneBody &first = body(a), &second = body(b);
    const float margin = first.margin + second.margin;
    const V clear = constant(world_.clear_m + margin);
    std::uint32_t near = 0, unsure = 0, colliding = 0;
    for (int lane = 0; lane < query_.used; lane += width_) {
      if (((lanes >> lane) & lane_mask_) == 0) continue;
      const V apart = hn::MulAdd(constant(motion_m), hn::LoadU(d_, query_.reach + lane), clear);
      Placed pa, pb;
      load(a, lane, pa);
      std::uint32_t open = lane_mask_;
      if (b >= world_.obstacle_begin) open &= ~clearOfObstacle(pa, lane, a, b, apart);
      if ((open & (lanes >> lane)) == 0) continue;
      load(b, lane, pb);
      const Question question{apart, clear, maskOf(~(open & (lanes >> lane)))};
      const Bounds bounds = first.kind <= second.kind ? distanceOf(first, pa, second, pb, question)
                                                      : distanceOf(second, pb, first, pa, question);
      near |= (open & bitsOf(hn::Not(hn::Gt(bounds.lower, apart)))) << lane;
      unsure |= (open & bitsOf(hn::Not(hn::Gt(bounds.lower, clear)))) << lane;
      colliding |= bitsOf(hn::Lt(bounds.upper, hn::Neg(clear))) << lane;
    }
    near &= lanes;
    colliding &= lanes;
    unsure &= lanes & ~colliding;
    if (colliding != 0) {
      scratch_.hit_a = a;
      scratch_.hit_b = b;
      scratch_.colliding |= colliding;
      if (!query_.each) {
        // Lanes up to the first collision are of interest still.
        active_ &= colliding ^ (colliding - 1);
        scratch_.colliding &= active_;
      }
    }
    if (near != 0 && !ended())
      scratch_.pairs[static_cast<std::size_t>(scratch_.count++)] = {
          a, b, motion_m, static_cast<std::uint16_t>(near), static_cast<std::uint16_t>(unsure)};
  }

  const Lanes d_{};
  const int width_ = static_cast<int>(hn::Lanes(d_));
  const std::uint32_t lane_mask_ = (1u << hn::Lanes(d_)) - 1u;
  const LaneWorld& world_;
  const LaneRobot& robot_;
  const BlockQuery& query_;
  BlockScratch& scratch_;
  std::uint32_t active_;
};

void checkBlock(const LaneWorld& world, const LaneRobot& robot, const BlockQuery& query,
                BlockScratch& scratch) {
  Block(world, robot, query, scratch).run();
}

const char* instructionSet() { return hwy::TargetName(HWY_TARGET); }

}  // namespace b4p::lanes::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace b4p::lanes {

HWY_EXPORT(checkBlock);
HWY_EXPORT(instructionSet);

void checkBlock(const LaneWorld& world, const LaneRobot& robot, const BlockQuery& query,
                BlockScratch& scratch) {
  HWY_DYNAMIC_DISPATCH(checkBlock)(world, robot, query, scratch);
}

const char* instructionSet() { return HWY_DYNAMIC_DISPATCH(instructionSet)(); }

void BlockScratch::makeRoom(const LaneWorld& world, const LaneRobot& robot) {
  constexpr std::size_t kAlign = 64 / sizeof(float);
  const auto moving = static_cast<std::size_t>(world.moving_end);
  const auto obstacles = static_cast<std::size_t>(world.bodyCount() - world.obstacle_begin);
  pairs.resize(std::max(pairs.size(), moving * obstacles + robot.pairs.size()));
  if (joints) return;
  const std::size_t joint_floats = world.joints.size() * 12 * kLanes, body_floats = moving * 15 * kLanes;
  storage.resize(joint_floats + body_floats + 6 * moving + kAlign);
  const auto address = reinterpret_cast<std::uintptr_t>(storage.data());
  joints = storage.data() + (64 - address % 64) % 64 / sizeof(float);
  bodies = joints + joint_floats;
  swept = bodies + body_floats;
  placed_at.assign(moving, 0);
}

}  // namespace b4p::lanes
#endif  // HWY_ONCE
