// SPDX-License-Identifier: BSD-3-Clause
#include "optimisation/search/plan_walk.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <string>

#include "planning/gait/read_sequence.h"
#include "planning/terrain/load_terrain.h"
#include "tests/named_robot.h"

namespace gaitwright {
namespace {

std::string TextOfField(const OptionFields& fields, const std::string& key) {
  for (const auto& [name, text] : TextsOf(fields)) {
    if (name == key) return text;
  }
  return "no such key";
}

TEST(RequestFields, HoldNoFolderOfAFile) {
  WalkRequest request;
  request.gait = "/home/me/gaits/mine.yaml:lope";
  request.terrain = "../grounds/hill.yaml";
  request.sequence = "/tmp/parts.yaml";
  const OptionFields fields = RequestFields(request);
  EXPECT_EQ(TextOfField(fields, "gait"), "mine.yaml:lope");
  EXPECT_EQ(TextOfField(fields, "terrain"), "hill.yaml");
  EXPECT_EQ(TextOfField(fields, "sequence"), "parts.yaml");
}

TEST(RequestFields, ASequenceInWordsStaysAsItIs) {
  WalkRequest request;
  request.sequence = "trot: speed=0.3, distance=1/2; stand: duration=1";
  EXPECT_EQ(TextOfField(RequestFields(request), "sequence"), "trot: speed=0.3, distance=1/2; stand: duration=1");
}

TEST(RequestFields, HaveEachKeyOnce) {
  WalkRequest request;
  std::set<std::string> seen;
  for (const auto& [key, text] : TextsOf(RequestFields(request))) EXPECT_TRUE(seen.insert(key).second) << key;
  for (const char* key : {"gait", "terrain", "sequence", "gait.cycle_s", "search.max_plans", "pipeline.grid_step_s",
                          "footsteps.reach", "rigid_body.method"})
    EXPECT_TRUE(seen.contains(key)) << key;
}

TEST(PlanWalk, OptionsOutOfRangeAreRefused) {
  WalkRequest request;
  request.search.max_plans = 0;
  EXPECT_THROW((void)PlanWalk(NamedRobot("a1"), request), InvalidArgument);
  EXPECT_THROW((void)PlanWalkOn(NamedRobot("a1"), FlatTerrain(), request), InvalidArgument);
  request.search.max_plans = 1;
  request.motion.pipeline.grid_step_s = 0.5;
  EXPECT_THROW((void)PlanWalk(NamedRobot("a1"), request), InvalidArgument);
}

TEST(PlanWalk, AGroundThatDoesNotExistIsRefusedAsByLoadTerrain) {
  const RobotModel& a1 = NamedRobot("a1");
  WalkRequest request;
  request.terrain = "swamp";
  const Result<PlannedWalk> planned = PlanWalk(a1, request);
  ASSERT_FALSE(planned.ok());
  EXPECT_EQ(planned.failure(), LoadTerrain("swamp", ScaleOf(a1)).failure());
}

TEST(PlanWalk, AnUnreadableSequenceIsRefusedAsByReadSequence) {
  WalkRequest request;
  request.sequence = "trot: velocity=1; stand: duration=1";
  const Result<PlannedWalk> planned = PlanWalk(NamedRobot("a1"), request);
  ASSERT_FALSE(planned.ok());
  EXPECT_EQ(planned.failure(), ReadSequence(request.sequence).failure());
}

TEST(PlanWalkOn, APlanTellsItsSeedAndItsGround) {
  WalkRequest request;
  request.sequence = "stand: duration=0.3";
  request.terrain = "folder/named.yaml";
  request.seed = 77;
  request.motion.pipeline.grid_step_s = 0.01;
  const Result<PlannedWalk> planned = PlanWalkOn(NamedRobot("a1"), FlatTerrain(), request);
  ASSERT_TRUE(planned.ok()) << planned.failure().message;
  const Provenance& provenance = planned->motion.plan.provenance;
  EXPECT_EQ(provenance.seed, 77U);
  EXPECT_EQ(provenance.options, TextsOf(RequestFields(request)));
  EXPECT_GE(planned->planning_cpu_s, 0.0);
}

}  // namespace
}  // namespace gaitwright
