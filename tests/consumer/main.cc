// SPDX-License-Identifier: BSD-3-Clause
// Loads a robot from the installed data and prints what it weighs.
#include <cstdio>

#include "kinematics/kinematics.h"
#include "workflows/workflows.h"

int main() {
  const auto robot = gaitwright::LoadRobot(ROBOTS_DIR "/a1/robot.urdf");
  if (!robot.ok()) {
    std::fprintf(stderr, "%s\n", robot.failure().message.c_str());
    return 1;
  }
  std::printf("gaitwright %s: a1 weighs %.3f kg\n", gaitwright::Version().c_str(), robot.value().total_mass_kg);
  return 0;
}
