// SPDX-License-Identifier: BSD-3-Clause
#include "robots/robot_model.h"
#include "state_validity/collision_checker.h"

int main(int argc, char** argv) {
  return argc > 1 ? static_cast<int>(b4p::loadUrdf(argv[1]).links.size()) : 0;
}
