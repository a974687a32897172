// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <functional>
#include <numbers>

#include "planning/plan/plan_json.h"
#include "playback/play/play.h"
#include "tests/playback/short_walk.h"
#include "tests/playback/standing_plan.h"

namespace gaitwright {
namespace {

/// A plan with all data that a hash may cover.
const MotionPlan& Rich() {
  static const MotionPlan rich = [] {
    const RobotModel model = standing::Load("nao");
    MotionPlan plan = ShortWalk(model, "walk", 6, 0.04);
    for (TerrainPatch& patch : plan.terrain.patches) patch.X_WT.rotate(Eigen::AngleAxisd(0.1, Vector3::UnitY()));
    plan.terrain.height_fields.push_back({"field", {5.0, 5.0}, 0.1, 2, 2, {0.0, 0.1, 0.2, 0.3}, 0.7});
    plan.terrain.obstacles.push_back({"post", ShapeType::kCylinder, Pose::Identity(), {0.1, 1.0, 0.0}, {}});
    plan.terrain.obstacles.push_back(
        {"rock", ShapeType::kMesh, Pose::Identity(), {}, {{9, 9, 0}, {9, 8, 0}, {8, 8, 0}, {8, 9, 1}}});
    double turn = 0.0;
    for (Foothold& foothold : plan.footsteps.footholds)
      foothold.X_WF.rotate(Eigen::AngleAxisd(turn += 0.1, Vector3(0.6, 0.0, 0.8)));
    return plan;
  }();
  return rich;
}

TEST(MotionHash, ChangesWithAllThatAPlaybackDependsOn) {
  using Change = std::function<void(MotionPlan&)>;
  const std::vector<std::pair<const char*, Change>> changes = {
      {"robot", [](MotionPlan& p) { p.robot_hash += "x"; }},
      {"friction", [](MotionPlan& p) { p.terrain.patches.front().friction = 0.4; }},
      {"slope",
       [](MotionPlan& p) { p.terrain.patches.front().X_WT.rotate(Eigen::AngleAxisd(1e-4, Vector3::UnitX())); }},
      {"height", [](MotionPlan& p) { p.terrain.height_fields.front().height_m[2] += 1e-9; }},
      {"post", [](MotionPlan& p) { p.terrain.obstacles[0].size_m[0] += 1e-9; }},
      {"rock", [](MotionPlan& p) { p.terrain.obstacles[1].vertices_O[3].z() += 1e-9; }},
      {"time", [](MotionPlan& p) { p.schedule.phases.front().end_s += 1e-9; }},
      {"stance", [](MotionPlan& p) { p.schedule.phases.front().stance ^= FootBit(0); }},
      {"foothold", [](MotionPlan& p) { p.footsteps.footholds.back().X_WF.translation().y() += 1e-9; }},
      {"turned",
       [](MotionPlan& p) { p.footsteps.footholds[1].X_WF.rotate(Eigen::AngleAxisd(1e-4, Vector3::UnitZ())); }},
      {"patch", [](MotionPlan& p) { p.footsteps.footholds[1].patch = 1; }},
      {"step", [](MotionPlan& p) { p.whole_body.step_s += 1e-9; }},
      {"q", [](MotionPlan& p) { p.whole_body.q[3][9] += 1e-9; }},
      {"v", [](MotionPlan& p) { p.whole_body.v[3][9] += 1e-9; }},
      {"a", [](MotionPlan& p) { p.whole_body.a[3][9] += 1e-9; }},
      {"tau", [](MotionPlan& p) { p.whole_body.tau[3][9] += 1e-9; }},
      {"force", [](MotionPlan& p) { p.whole_body.wrenches[3][1].force_W.x() += 1e-9; }},
      {"moment", [](MotionPlan& p) { p.whole_body.wrenches[3][1].moment_W.x() += 1e-9; }}};
  const std::string before = MotionHash(Rich());
  for (const auto& [what, change] : changes) {
    MotionPlan changed = Rich();
    change(changed);
    EXPECT_NE(MotionHash(changed), before) << what;
    EXPECT_NE(PlanHash(changed), PlanHash(Rich())) << what;
  }
}

TEST(MotionHash, DoesNotChangeWithWhatOnlyTellsOrJudges) {
  MotionPlan changed = Rich();
  changed.provenance.seed = 9;
  changed.goal.x_m += 0.1;
  changed.warnings.push_back("none");
  changed.terrain.name = "other";
  changed.terrain.patches.front().name = "other";
  EXPECT_EQ(MotionHash(changed), MotionHash(Rich()));
  EXPECT_NE(PlanHash(changed), PlanHash(Rich()));
}

TEST(MotionHash, IsThatOfThePlanAsItIsReadBack) {
  MotionPlan plan = Rich();
  plan.whole_body.tau[2][0] = -0.0;
  for (int turns = 0; turns < 40; ++turns) {  // rotations read back with rounding
    const std::string before = MotionHash(plan);
    const Result<MotionPlan> back = PlanFromJson(PlanToJson(plan), "plan");
    ASSERT_TRUE(back) << back.failure().message;
    EXPECT_EQ(MotionHash(*back), before);
    plan = *back;
    for (Foothold& foothold : plan.footsteps.footholds)
      foothold.X_WF.rotate(Eigen::AngleAxisd(0.25 * std::numbers::pi, Vector3::UnitZ()));
  }
}

}  // namespace
}  // namespace gaitwright
