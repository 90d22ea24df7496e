// SPDX-License-Identifier: BSD-3-Clause
#include "state_validity/edge_search.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace b4p {

EdgeSearch::EdgeSearch(PosedPieces& pieces)
    : pieces_(pieces), q_(static_cast<std::size_t>(pieces.world().robot().dof())), joint_motion_(q_.size()) {}

bool EdgeSearch::allFree(const EdgeSamples& samples) {
  start(samples);
  const std::size_t all = active_.size();
  if (!check(samples, 0, samples.last(), 0, all)) return false;
  const std::size_t near_q1 = active_.size();
  if (near_q1 == all) return true;
  if (!check(samples, samples.last(), samples.last(), all, near_q1)) return false;
  push(1, samples.last() - 1, near_q1, active_.size());
  // Taken from the front: coarse before fine.
  for (std::size_t front = 0; front < stretches_.size(); ++front) {
    const Stretch stretch = stretches_[front];
    const std::int64_t k = stretch.middle();
    const std::size_t kept = active_.size();
    if (!check(samples, k, stretch.reach(), stretch.begin, stretch.end)) return false;
    const std::size_t end = active_.size();
    push(stretch.first, k - 1, kept, end);
    push(k + 1, stretch.last, kept, end);
  }
  return true;
}

std::int64_t EdgeSearch::firstBlocked(const EdgeSamples& samples, std::int64_t last) {
  start(samples);
  const std::size_t all = active_.size();
  if (!check(samples, 0, last, 0, all)) return 0;
  const std::size_t near_q1 = active_.size();
  // Most edges that a search tree asks for are blocked at once: they leave nodes that touch something.
  if (last >= 1 && !check(samples, 1, 0, all, near_q1)) return 1;
  push(2, last, all, near_q1);
  std::int64_t blocked = last + 1;
  // Taken from the back: the part nearer to q1 before the other. What the lists hold beyond a stretch's own
  // belongs to stretches that are done.
  while (!stretches_.empty()) {
    Stretch stretch = stretches_.back();
    stretches_.pop_back();
    if (stretch.first >= blocked) continue;
    stretch.last = std::min(stretch.last, blocked - 1);
    active_.resize(stretch.end);
    const std::int64_t k = stretch.middle();
    if (check(samples, k, stretch.reach(), stretch.begin, stretch.end)) {
      const std::size_t end = active_.size();
      push(k + 1, stretch.last, stretch.end, end);
      push(stretch.first, k - 1, stretch.end, end);
    } else {
      blocked = k;
      push(stretch.first, k - 1, stretch.begin, stretch.end);
    }
  }
  return blocked;
}

void EdgeSearch::start(const EdgeSamples& samples) {
  const Eigen::MatrixXd& travel = pieces_.travel();
  const std::vector<PiecePair>& pairs = pieces_.pairs();
  const int still_begin = pieces_.world().pieces().stillBegin();
  const double per_sample = 1.0 / static_cast<double>(samples.last());
  const auto motion = [&](int joint, int piece) {
    return piece < still_begin ? travel(joint, piece) * joint_motion_[static_cast<std::size_t>(joint)] : 0.0;
  };
  for (std::size_t j = 0; j < joint_motion_.size(); ++j)
    joint_motion_[j] = std::abs(samples.q2()[j] - samples.q1()[j]) * per_sample;
  pair_motion_m_.resize(pairs.size());
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    pair_motion_m_[i] = 0.0;
    for (const int joint : pairs[i].joints)
      pair_motion_m_[i] += motion(joint, pairs[i].a) + motion(joint, pairs[i].b);
  }
  active_.resize(pairs.size());
  std::iota(active_.begin(), active_.end(), 0);
  stretches_.clear();
}

bool EdgeSearch::check(const EdgeSamples& samples, std::int64_t k, std::int64_t reach, std::size_t begin,
                       std::size_t end) {
  ++checked_;
  samples.at(k, q_.data());
  pieces_.place(q_.data());
  for (std::size_t i = begin; i < end; ++i) {
    const int index = active_[i];
    const PiecePair& pair = pieces_.pairs()[static_cast<std::size_t>(index)];
    const double approach_m = static_cast<double>(reach) * pair_motion_m_[static_cast<std::size_t>(index)];
    const double enough_m = approach_m + PosedPieces::kClearlyApart_m;
    const double gap_m = pieces_.gap(pair, enough_m);
    if (gap_m > enough_m) continue;
    if (gap_m <= PosedPieces::kClearlyApart_m && pieces_.overlap(pair)) return false;
    if (approach_m > 0.0) active_.push_back(index);
  }
  return true;
}

void EdgeSearch::push(std::int64_t first, std::int64_t last, std::size_t begin, std::size_t end) {
  if (first <= last && begin < end) stretches_.push_back({first, last, begin, end});
}

}  // namespace b4p
