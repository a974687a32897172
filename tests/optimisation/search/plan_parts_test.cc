// SPDX-License-Identifier: BSD-3-Clause
#include "optimisation/search/plan_parts.h"

#include <gtest/gtest.h>

#include "kinematics/model/load_robot.h"

namespace gaitwright {
namespace {

Result<PlannedWalk> PartsOn(const Terrain& ground, const std::string& sequence, const std::string& footholds = "") {
  WalkRequest request;
  request.sequence = sequence;
  if (!footholds.empty()) request.motion.footholds = footholds;
  return PlanPartsWithin(*LoadNamedRobot("a1"), ground, request, *ReadSequence(sequence));
}

std::string FootholdsOf(const MotionPlan& plan) {
  for (const auto& [key, value] : plan.provenance.options) {
    if (key == "footholds") return value;
  }
  return "";
}

/// Level ground with a step far beside the path, so that it is not flat.
Terrain WithStepBeside() {
  Terrain ground = FlatTerrain();
  ground.patches.push_back(PatchThrough("step", {{5, 5, 0.1}, {6, 5, 0.1}, {6, 6, 0.1}, {5, 6, 0.1}}, 0.8));
  return ground;
}

TEST(PlanParts, TheWholeIsSoundAndTellsThatFootholdsWereHeld) {
  const Result<PlannedWalk> planned = PartsOn(FlatTerrain(), "trot: speed=0.3, distance=0.2; stand: duration=0.3");
  ASSERT_TRUE(planned.ok()) << planned.failure().message;
  EXPECT_TRUE(planned->audit.pass());
  EXPECT_EQ(planned->motion.plan.parts.size(), 2U);
  EXPECT_TRUE(planned->motion.plan.adjustments.empty());
  EXPECT_EQ(FootholdsOf(planned->motion.plan), "as-needed");
}

TEST(PlanParts, FootholdsOfGaitsThatFlyMoveFirstWhereThatIsAskedFor) {
  const std::string bound = "bound: speed=0.5, distance=0.2";
  const Result<PlannedWalk> held = PartsOn(WithStepBeside(), bound), free = PartsOn(WithStepBeside(), bound, "free");
  ASSERT_TRUE(held.ok()) << held.failure().message;
  ASSERT_TRUE(free.ok()) << free.failure().message;
  EXPECT_EQ(FootholdsOf(held->motion.plan), "as-needed");
  EXPECT_EQ(FootholdsOf(free->motion.plan), "free");
}

}  // namespace
}  // namespace gaitwright
