// SPDX-License-Identifier: BSD-3-Clause
#include "cli/shown_motion.h"

#include <gtest/gtest.h>

#include "tests/named_robot.h"

namespace gaitwright::cli {
namespace {

/// A robot that stands and rises by 0.1 m in a second, in a plan that begins at 2 s.
MotionToShow Rising() {
  const RobotModel& model = NamedRobot("a1");
  MotionToShow shown{model, {}, {}, {}, "rising"};
  WholeBodyTrajectory& rows = shown.plan.whole_body;
  rows.start_s = 2.0;
  rows.step_s = 0.1;
  for (int k = 0; k <= 10; ++k) {
    rows.q.push_back(StandingConfiguration(model));
    rows.q.back()[2] += 0.01 * k;
    rows.v.push_back(VectorX::Zero(model.nv()));
    rows.v.back()[2] = 0.1;
    rows.a.push_back(VectorX::Zero(model.nv()));
    rows.tau.push_back(VectorX::Zero(model.num_dofs()));
    rows.wrenches.emplace_back(model.feet.size());
  }
  return shown;
}

TEST(ShownMotion, AsAGhostGivesThePosturesOfItsPlan) {
  const MotionToShow shown = Rising();
  const ShownGhost ghost = shown.AsGhost();
  EXPECT_EQ(ghost.title, "rising");
  const double standing_m = NamedRobot("a1").standing_base_height_m;
  EXPECT_NEAR(ghost.posture(0.0)[2], standing_m, 1e-9);
  EXPECT_NEAR(ghost.posture(0.55)[2], standing_m + 0.055, 1e-6) << "between rows";
  EXPECT_NEAR(ghost.posture(1.0)[2], standing_m + 0.1, 1e-9);
  EXPECT_EQ(ghost.posture(1.01).size(), 0) << "after its end";
}

TEST(ShownMotion, AsAGhostGivesTheMeasuredPosturesOfALog) {
  MotionToShow shown = Rising();
  shown.log.emplace();
  for (const double time_s : {2.0, 2.005, 2.01}) {
    LogSample& sample = shown.log->samples.emplace_back();
    sample.time_s = time_s;
    sample.q = VectorX::Constant(7, time_s);
  }
  const ShownGhost ghost = shown.AsGhost();
  EXPECT_EQ(ghost.posture(0.0)[0], 2.0);
  EXPECT_EQ(ghost.posture(0.0049)[0], 2.0) << "the sample before";
  EXPECT_EQ(ghost.posture(0.005)[0], 2.005);
  EXPECT_EQ(ghost.posture(0.01)[0], 2.01);
  EXPECT_EQ(ghost.posture(0.02).size(), 0) << "after its end";
}

}  // namespace
}  // namespace gaitwright::cli
