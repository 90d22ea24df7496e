// SPDX-License-Identifier: BSD-3-Clause
#include "state_validity/collision_pairs.h"

#include <algorithm>
#include <iterator>

#include "state_validity/link_groups.h"

namespace b4p {
namespace {

class PairList {
 public:
  PairList(const Manipulator& robot, const CollisionPieces& pieces) : robot_(robot), pieces_(pieces) {}

  void addAgainstObstacles(int a) {
    for (int b = pieces_.obstacleBegin(); b < pieces_.count(); ++b) add(a, b);
  }

  void addObjectAgainstRobot(int a) {
    const std::vector<int>& fingers = robot_.fingerLinks();
    for (int b = 0; b < pieces_.obstacleBegin(); ++b)
      if (const int link = pieces_[b].link;
          link >= 0 && std::find(fingers.begin(), fingers.end(), link) == fingers.end())
        add(a, b);
  }

  void addLinkAgainstLinks(int a) {
    for (int b = a + 1; b < pieces_.obstacleBegin(); ++b)
      if (const int link = pieces_[b].link; link >= 0 && !mayTouch(robot_, pieces_[a].link, link)) add(a, b);
  }

  CollisionPairs pairs;

 private:
  void add(int a, int b) {
    const std::vector<int> above_a = jointsAbove(a), above_b = jointsAbove(b);
    PiecePair pair{a, b, {}};
    std::set_symmetric_difference(above_a.begin(), above_a.end(), above_b.begin(), above_b.end(),
                                  std::back_inserter(pair.joints));
    (pair.joints.empty() ? pairs.rigid : pairs.moving).push_back(std::move(pair));
  }

  std::vector<int> jointsAbove(int piece) const {
    if (piece >= pieces_.stillBegin()) return {};
    return planningJointsAbove(robot_,
                               piece < pieces_.objectBegin() ? pieces_[piece].link : robot_.tcpLink());
  }

  const Manipulator& robot_;
  const CollisionPieces& pieces_;
};

}  // namespace

CollisionPairs collisionPairs(const Manipulator& robot, const CollisionPieces& pieces, bool with_object) {
  PairList list(robot, pieces);
  const int object_end = with_object ? pieces.stillBegin() : pieces.objectBegin();
  for (int a = pieces.objectBegin(); a < object_end; ++a) list.addAgainstObstacles(a);
  for (int a = 0; a < pieces.objectBegin(); ++a) list.addAgainstObstacles(a);
  for (int a = pieces.objectBegin(); a < object_end; ++a) list.addObjectAgainstRobot(a);
  for (int a = 0; a < pieces.objectBegin(); ++a) list.addLinkAgainstLinks(a);
  return std::move(list.pairs);
}

}  // namespace b4p
