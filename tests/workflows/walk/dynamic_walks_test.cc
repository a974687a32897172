// SPDX-License-Identifier: BSD-3-Clause
#include "tests/workflows/walk/dynamic_walks.h"

#include <gtest/gtest.h>

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

}  // namespace
}  // namespace gaitwright
