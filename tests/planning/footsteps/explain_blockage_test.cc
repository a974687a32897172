// SPDX-License-Identifier: BSD-3-Clause
#include "planning/footsteps/explain_blockage.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "tests/named_robot.h"
#include "tests/planning/footsteps/grounds.h"
#include "tests/planning/footsteps/search_rig.h"
#include "tests/planning/paths/walled_grounds.h"

namespace gaitwright {
namespace {

/// The failure of a search that did not leave its start.
Failure Explained(const char* robot, const Terrain& terrain, const char* gait = "", bool out_of_budget = false) {
  SearchRig rig(NamedRobot(robot), terrain, gait, 2.0);
  const int start = rig.graph.StanceOf(rig.start, 0);
  return ExplainBlockage(rig.Scene(), rig.graph, {start, out_of_budget});
}

bool Suggests(const Failure& failure, const std::string& what) {
  return std::any_of(failure.suggestions.begin(), failure.suggestions.end(),
                     [&](const Suggestion& suggestion) { return suggestion.what == what; });
}

bool Names(const Failure& failure, const std::string& text) { return failure.message.find(text) != std::string::npos; }

TEST(ExplainBlockage, IsAlwaysAnInfeasibleSearchForFootholds) {
  for (const Terrain& terrain : {FlatTerrain(), Gap(0.5, 1.0), StepUp(0.5, 0.3)}) {
    const Failure failure = Explained("a1", terrain, "trot");
    EXPECT_EQ(failure.kind, FailureKind::kInfeasible);
    EXPECT_EQ(failure.code, FailureCode::kNoFootholds);
    EXPECT_EQ(failure.stage, "SearchFootsteps");
    EXPECT_FALSE(failure.message.empty());
  }
}

TEST(ExplainBlockage, AGapHasItsPlaceAndWidth) {
  const Failure failure = Explained("a1", Gap(0.6, 0.5), "trot");
  EXPECT_TRUE(Names(failure, "the gap at x = 0.60 m is 0.50 m wide")) << failure.message;
  EXPECT_TRUE(Suggests(failure, "gait")) << "it may be leapt over";
  EXPECT_FALSE(Suggests(Explained("a1", Gap(0.6, 1.5), "trot"), "gait")) << "but not one so wide";
  EXPECT_FALSE(Suggests(Explained("nao", Gap(0.3, 0.5)), "gait")) << "nor by a biped";
}

TEST(ExplainBlockage, AStepIsHeldAgainstTheLiftOfTheFeet) {
  const Failure up = Explained("a1", StepUp(0.6, 0.25), "trot"), down = Explained("a1", StepUp(0.6, -0.25), "trot");
  EXPECT_TRUE(Names(up, "step up of 0.25 m at x = 0.60 m")) << up.message;
  EXPECT_TRUE(Names(down, "step down of 0.25 m at x = 0.60 m")) << down.message;
  EXPECT_TRUE(Suggests(up, "footsteps.search.step_height"));
}

TEST(ExplainBlockage, ASlopeHasItsAngle) {
  const Failure failure = Explained("a1", RampUp(0.6, 0.8, 0.7), "trot");
  EXPECT_TRUE(Names(failure, "slope of 40 degrees at x = 0.60 m")) << failure.message;
}

TEST(ExplainBlockage, TheNearerOfTwoHurdlesIsNamed) {
  Terrain terrain = Gap(0.5, 0.6);
  terrain.patches.push_back(Rectangle("block", {1.3, -5.0}, {2.0, 5.0}, 0.4));
  const Failure failure = Explained("a1", terrain, "trot");
  EXPECT_TRUE(Names(failure, "the gap at x = 0.50 m")) << failure.message;
}

TEST(ExplainBlockage, GroundThatEndsIsNoGap) {
  Terrain ledge;
  ledge.patches = {Rectangle("ledge", {-1.0, -1.0}, {0.7, 1.0}, 0.0)};
  const Failure failure = Explained("a1", ledge, "trot");
  EXPECT_TRUE(Names(failure, "the ground ends at x = 0.70 m")) << failure.message;
  EXPECT_FALSE(Suggests(failure, "gait"));
}

TEST(ExplainBlockage, ObstaclesOnThePathAreNamed) {
  const Failure one = Explained("a1", Walled({Wall("barrier", {0.5, -1.0}, {0.5, 1.0})}), "trot");
  EXPECT_TRUE(Names(one, "'barrier'")) << one.message;
  const Failure two = Explained(
      "a1", Walled({Wall("left post", {0.5, 0.1}, {0.5, 1.0}), Wall("right post", {0.5, -1.0}, {0.5, -0.1})}), "trot");
  EXPECT_TRUE(Names(two, "'left post'") && Names(two, "'right post'")) << two.message;
}

TEST(ExplainBlockage, ASearchThatRanOutMayBeGivenMore) {
  const std::string option = "footsteps.search.max_expansions";
  EXPECT_TRUE(Suggests(Explained("a1", FlatTerrain(), "trot", true), option));
  EXPECT_FALSE(Suggests(Explained("a1", FlatTerrain(), "trot", false), option));
  EXPECT_FALSE(Suggests(Explained("a1", StepUp(0.6, 0.25), "trot", true), option)) << "a step is the reason";
}

}  // namespace
}  // namespace gaitwright
