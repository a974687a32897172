// SPDX-License-Identifier: BSD-3-Clause
#include "tests/workflows/walk/dynamic_walks.h"

#include <gtest/gtest.h>

#include "kinematics/model/load_robot.h"
#include "tests/unusual_robots.h"

namespace gaitwright {
namespace {

TEST(DynamicWalks, A1Bounds) { ExpectToFly({"bound", 0.8, 1.0}); }

TEST(DynamicWalks, A1LeapsOverFourTenthsOfAMetre) {
  WalkRequest request;
  request.gait = "jump";
  request.command.extent = WalkCommand::Extent::kSteps;
  request.command.steps = 4;
  request.command.step_length_m = 0.1;
  ExpectToFly(request);
}

TEST(DynamicWalks, A1JumpsOntoABlockOf15Centimetres) {
  WalkRequest request;
  request.gait = "jump";
  request.terrain = "block:height_m=0.15,start_m=0.31,length_m=2";
  request.command.extent = WalkCommand::Extent::kSteps;
  request.command.steps = 4;
  request.command.step_length_m = 0.13;
  ExpectToFly(request);
}

TEST(DynamicWalks, ABipedHopsInPlace) {
  WalkRequest request;
  request.gait = "hop";
  request.command.extent = WalkCommand::Extent::kDuration;
  request.command.duration_s = 1.0;
  ExpectToFly(*LoadRobotFromText(unusual::Runner(), ""), request);
}

TEST(DynamicWalks, ABipedRuns) {
  WalkRequest request;
  request.gait = "run";
  request.command.speed_m_s = 0.8;
  request.command.distance_m = 1.0;
  ExpectToFly(*LoadRobotFromText(unusual::Runner(), ""), request);
}

}  // namespace
}  // namespace gaitwright
