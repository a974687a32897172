// SPDX-License-Identifier: BSD-3-Clause
// Plans and audits a walk with the planning libraries alone: no physics engine, no network, no MPI.
#include <cstdio>

#include "kinematics/model/load_robot.h"
#include "optimisation/optimisation.h"

int main() {
  const auto robot = gaitwright::LoadRobot(ROBOTS_DIR "/a1/robot.urdf");
  if (!robot.ok()) return 1;
  gaitwright::WalkRequest request;
  request.command.distance_m = 0.3;
  const auto planned = gaitwright::PlanWalk(robot.value(), request);
  if (!planned.ok()) {
    std::fprintf(stderr, "%s\n", planned.failure().message.c_str());
    return 1;
  }
  std::printf("audit: %s\n", planned.value().audit.pass() ? "pass" : "fail");
  return 0;
}
