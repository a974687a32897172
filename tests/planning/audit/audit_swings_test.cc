// SPDX-License-Identifier: BSD-3-Clause
// Swings of a good plan are changed: the audit names the swing that disagrees with q, the footholds or the schedule.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "kinematics/spatial/rotation.h"
#include "tests/planning/audit/good_plan.h"

namespace gaitwright {
namespace {

class AuditSwings : public testing::TestWithParam<std::string> {
 protected:
  const RobotModel& model() const { return GoodPlanOf(GetParam()).model; }
  const MotionPlan& good() const { return GoodPlanOf(GetParam()).plan; }
  const std::string& foot() const { return model().feet[0].name; }

  /// Changes the good plan. Only consistency may be violated then, and only at this place.
  Violation Changed(const std::string& where, const std::function<void(MotionPlan&)>& change) const {
    MotionPlan plan = good();
    change(plan);
    const auto found = ViolationsOf(model(), plan);
    EXPECT_EQ(LawsOf(found), std::vector<Law>{Law::kConsistency}) << where;
    return At(found, where);
  }
  static std::size_t SwingOfFoot0(const MotionPlan& plan) {
    std::size_t i = 0;
    while (plan.swings[i].foot != 0) ++i;
    return i;
  }
};

INSTANTIATE_TEST_SUITE_P(Robots, AuditSwings, testing::Values("a1", "nao"),
                         [](const auto& robot) { return robot.param; });

TEST_P(AuditSwings, OfASwingWithThePathOfItsFoot) {
  const std::size_t i = SwingOfFoot0(good());
  const SwingTrajectory& swing = good().swings[i];
  for (const double lift : {0.0, 0.5}) {
    const Violation found = Changed(foot() + " off its swing", [&](MotionPlan& plan) { plan.swings[i].lift_m = lift; });
    EXPECT_NEAR(found.value, std::abs(lift - swing.lift_m), 1e-3);
    EXPECT_NEAR(found.at_s, 0.5 * (swing.start_s + swing.end_s), 3e-3);
  }
  const auto detour = [&](MotionPlan& plan) { plan.swings[i].detour_W.assign(4, {0.0, 0.0, swing.lift_m + 0.02}); };
  EXPECT_GT(Changed(foot() + " off its swing", detour).value, 0.01);
}

/// The curve of a swing is checked against the ground, too, whatever path the foot has in q.
TEST_P(AuditSwings, ASwingsCurveThroughTheGroundIsNamedForThat) {
  MotionPlan plan = good();
  SwingTrajectory& swing = plan.swings[SwingOfFoot0(plan)];
  swing.lift_m = -0.05;
  const auto found = ViolationsOf(model(), plan);
  EXPECT_EQ(LawsOf(found), (std::vector<Law>{Law::kConsistency, Law::kFootClearance}));
  const Violation& depth = At(found, foot() + " on its swing");
  EXPECT_NEAR(depth.value, -0.05, 1e-3);
  EXPECT_NEAR(depth.at_s, 0.5 * (swing.start_s + swing.end_s), 3e-3);
}

TEST_P(AuditSwings, OfASwingWithItsFootholds) {
  const std::size_t i = SwingOfFoot0(good());
  const auto moved = [&](MotionPlan& plan) { plan.swings[i].X_WF_end.translation().x() += 0.01; };
  EXPECT_NEAR(Changed(foot() + " swing off its footholds", moved).value, 0.01, 1e-6);
  const auto turned = [&](MotionPlan& plan) {
    for (Pose* X_WF : {&plan.swings[i].X_WF_start, &plan.swings[i].X_WF_end}) X_WF->linear() *= YawRotation(0.1);
  };
  EXPECT_NEAR(Changed(foot() + " swing rotated from its footholds", turned).value, 0.1, 1e-6);
}

TEST_P(AuditSwings, OfSwingsWithTheSchedule) {
  const std::size_t i = SwingOfFoot0(good());
  const double end_s = good().swings[i].end_s;
  const Violation late =
      Changed(foot() + " swing's end against schedule", [&](MotionPlan& plan) { plan.swings[i].end_s += 0.2; });
  EXPECT_NEAR(late.value, end_s + 0.2, 1e-9);
  EXPECT_NEAR(late.limit, end_s, 1e-9);
  const Violation none = Changed(foot() + " number of swings", [](MotionPlan& plan) { plan.swings.clear(); });
  EXPECT_EQ(none.value, 0.0);
  EXPECT_GT(none.limit, 0.0);
  const Violation twice =
      Changed(foot() + " number of swings", [&](MotionPlan& plan) { plan.swings.push_back(plan.swings[i]); });
  EXPECT_EQ(twice.value, twice.limit + 1.0);
  const Violation nobody = Changed("swing of an unknown foot", [&](MotionPlan& plan) { plan.swings[i].foot = -1; });
  EXPECT_EQ(nobody.value, -1.0);
}

TEST_P(AuditSwings, OfASwingThatStartsEarlyNamesItsStart) {
  const std::size_t i = SwingOfFoot0(good());
  const double start_s = good().swings[i].start_s;
  const Violation early =
      Changed(foot() + " swing's start against schedule", [&](MotionPlan& plan) { plan.swings[i].start_s -= 0.05; });
  EXPECT_NEAR(early.value, start_s - 0.05, 1e-9);
  EXPECT_NEAR(early.limit, start_s, 1e-9);
  EXPECT_NEAR(early.at_s, start_s, 1e-9);
}

}  // namespace
}  // namespace gaitwright
