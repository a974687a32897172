// SPDX-License-Identifier: BSD-3-Clause
#include "optimisation/search/audited_plan.h"

#include <gtest/gtest.h>

#include "planning/plan/built_in_terrain.h"

namespace gaitwright {
namespace {

TEST(WithFootholds, AreReversedOnRequestOnly) {
  MotionOptions options;
  EXPECT_EQ(options.footholds, "as-needed");
  EXPECT_EQ(WithFootholds(options, false).footholds, "as-needed");
  EXPECT_EQ(WithFootholds(options, true).footholds, "free");
  options.footholds = "free";
  EXPECT_EQ(WithFootholds(options, false).footholds, "free");
  EXPECT_EQ(WithFootholds(options, true).footholds, "held");
}

TEST(MayMoveFeet, OnGroundThatIsNotFlatUnlessTheyAreToBeHeld) {
  MotionOptions options;
  Terrain steps = FlatTerrain();
  steps.patches.push_back(PatchThrough("step", {{1, -1, 0.1}, {2, -1, 0.1}, {2, 1, 0.1}, {1, 1, 0.1}}, 0.6));
  EXPECT_FALSE(MayMoveFeet(options, FlatTerrain()));
  EXPECT_TRUE(MayMoveFeet(options, steps));
  options.footholds = "held";
  EXPECT_FALSE(MayMoveFeet(options, steps));
}

}  // namespace
}  // namespace gaitwright
