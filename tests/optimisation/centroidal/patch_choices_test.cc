// SPDX-License-Identifier: BSD-3-Clause
#include "optimisation/centroidal/patch_choices.h"

#include <gtest/gtest.h>

#include "optimisation/centroidal/plan_over_terrain.h"
#include "tests/optimisation/centroidal/rigid_bodies.h"

namespace gaitwright {
namespace {

/// Level ground from one x to another, at a height.
TerrainPatch LevelPart(double from, double to, double z) {
  return PatchThrough("level", {{from, -2.0, z}, {to, -2.0, z}, {to, 2.0, z}, {from, 2.0, z}}, 0.6);
}

/// A hop of 1.2 m over a kerb, too long for one leg, and its infeasible motion over the first choice of patches.
struct LongHop {
  Terrain ground{"kerb", {LevelPart(-2.0, 0.9, 0.0), LevelPart(0.9, 1.3, 0.05), LevelPart(1.3, 5.0, 0.0)}, {}, {}};
  PatchSearchOptions search{.near_m = 2.0, .most_steps = 1};
  PlanOverPatches first;

  LongHop() {
    (void)PlanOverTerrain(ground, rigid_bodies::Hopper(1.2), {.infeasible_m = 10.0}, {}, search, &first);
    EXPECT_GT(first.plan.summary.violations, 0.0);
  }
};

TEST(PatchChoices, GivesEachOtherPatchOfTheViolatedStanceOnce) {
  const LongHop hop;
  PatchChoices choices(hop.ground, RulesOf(hop.ground, 0.01), hop.search);
  EXPECT_FALSE(choices.has_best());
  EXPECT_FALSE(choices.Next().has_value()) << "there is no attempt to start from";
  EXPECT_TRUE(choices.Offer(hop.first));
  EXPECT_TRUE(choices.has_best());
  std::set<std::vector<int>> seen = {hop.first.choice.patches};
  while (const std::optional<ChosenFootholds> choice = choices.Next()) {
    EXPECT_TRUE(seen.insert(choice->patches).second) << "given twice";
    EXPECT_EQ(choice->patches[0], hop.first.choice.patches[0]) << "the fixed stance stays";
    EXPECT_TRUE(choice->problem.stances[0].X_WF.isApprox(hop.first.choice.problem.stances[0].X_WF));
  }
  EXPECT_EQ(seen.size(), 3U) << "three patches for the one stance that can move";
}

TEST(PatchChoices, TakesOnlyAttemptsThatAreBetterByAShare) {
  const LongHop hop;
  PatchChoices choices(hop.ground, RulesOf(hop.ground, 0.01), hop.search);
  ASSERT_TRUE(choices.Offer(hop.first));
  PlanOverPatches other = hop.first;
  other.choice = choices.Next().value();
  other.plan.summary.violations = 0.97 * hop.first.plan.summary.violations;
  EXPECT_FALSE(choices.Offer(other));
  other.plan.summary.violations = 0.94 * hop.first.plan.summary.violations;
  EXPECT_TRUE(choices.Offer(other));
  while (const std::optional<ChosenFootholds> next = choices.Next()) {
    EXPECT_NE(next->patches, hop.first.choice.patches);
    EXPECT_NE(next->patches, other.choice.patches);
  }
}

TEST(PatchChoices, ItsRulesTellWhereAStanceCanStand) {
  const LongHop hop;
  PatchRules nowhere;
  nowhere.put = [](int, const Vector3&, RigidStance&) { return false; };
  EXPECT_TRUE(PatchChanges(hop.ground, hop.first, nowhere, 2.0).empty());
  EXPECT_LT(PatchChanges(hop.ground, hop.first, RulesOf(hop.ground, 0.01), 1e-6).size(), 2U) << "not both are so near";
  const std::vector<PatchChange> changes = PatchChanges(hop.ground, hop.first, RulesOf(hop.ground, 0.01), 2.0);
  ASSERT_EQ(changes.size(), 2U);
  EXPECT_LE(changes[0].rank, changes[1].rank);
}

TEST(PatchChoices, APathThatIsNotFittedStaysAsItIs) {
  const LongHop hop;
  PatchRules rules = RulesOf(hop.ground, 0.01);
  PatchChoices fitted(hop.ground, rules, hop.search);
  rules.fits_path = false;
  PatchChoices fixed(hop.ground, rules, hop.search);
  ASSERT_TRUE(fitted.Offer(hop.first));
  ASSERT_TRUE(fixed.Offer(hop.first));
  const std::vector<Vector3>& before = hop.first.choice.problem.path.p_WC;
  EXPECT_EQ(fixed.Next().value().problem.path.p_WC, before);
  EXPECT_NE(fitted.Next().value().problem.path.p_WC, before);
}

}  // namespace
}  // namespace gaitwright
