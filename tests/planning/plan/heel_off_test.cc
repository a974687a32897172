// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>

#include "kinematics/base/result.h"
#include "kinematics/spatial/rotation.h"
#include "planning/plan/heel_off_internal.h"

namespace gaitwright {
namespace {

Foot RectangularFoot() {
  Foot foot;
  foot.type = FootType::kSole;
  foot.sole_F = {{-0.05, -0.03}, {0.12, -0.03}, {0.12, 0.03}, {-0.05, 0.03}};
  return foot;
}

Pose SomePose() {
  Pose X_WF = Pose::Identity();
  X_WF.translation() = Vector3(0.4, -0.2, 0.1);
  X_WF.linear() = YawRotation(0.7);
  return X_WF;
}

TEST(FrontEdge, HasTheCornersAtTheFront) {
  const Polygon edge = FrontEdge(RectangularFoot().sole_F);
  ASSERT_EQ(edge.size(), 2u);
  EXPECT_EQ(edge[0], Vector2(0.12, -0.03));
  EXPECT_EQ(edge[1], Vector2(0.12, 0.03));
  EXPECT_EQ(FrontEdge({{-0.05, -0.03}, {0.12, 0.0}, {-0.05, 0.03}}), Polygon{Vector2(0.12, 0.0)});
  EXPECT_EQ(FrontEdge({{0.0, 0.0}, {0.1, -0.02}, {0.1005, 0.0}, {0.1, 0.02}}).size(), 2u) << "round by less than 1 mm";
  EXPECT_THROW(static_cast<void>(FrontEdge({})), InvalidArgument);
}

TEST(TurnedAboutEdge, KeepsTheEdgeAndRaisesTheHeel) {
  const Foot foot = RectangularFoot();
  const Pose X_WF = SomePose();
  for (const double pitch : {1e-7, 0.05, 0.4, 1.1}) {
    const Pose turned = TurnedAboutEdge(foot, X_WF, pitch);
    const EdgeTurn turn = EdgeTurnOf(foot, X_WF, turned);
    EXPECT_NEAR(turn.pitch_rad, pitch, 1e-12);
    EXPECT_LT(turn.off_m, 1e-12);
    EXPECT_LT(turn.turned_rad, 1e-12);
    const Vector3 heel_F(-0.05, 0.03, 0.0);
    EXPECT_NEAR((turned * heel_F).z() - (X_WF * heel_F).z(), 0.17 * std::sin(pitch), 1e-12);
  }
}

TEST(EdgeTurnOf, SeesWhatIsNoTurnAboutTheEdge) {
  const Foot foot = RectangularFoot();
  Pose moved = TurnedAboutEdge(foot, SomePose(), 0.3);
  moved.translation() += Vector3(0.0, 0.004, 0.003);
  EXPECT_NEAR(EdgeTurnOf(foot, SomePose(), moved).off_m, 0.005, 1e-12);
  Pose yawed = SomePose();
  yawed.linear() = yawed.linear() * YawRotation(0.02);
  EXPECT_NEAR(EdgeTurnOf(foot, SomePose(), yawed).turned_rad, 0.02, 1e-12);
  EXPECT_GT(EdgeTurnOf(foot, SomePose(), yawed).off_m, 0.002);
}

TEST(SupportAt, IsTheFrontEdgeAfterHeelOff) {
  const Foot foot = RectangularFoot();
  Foothold foothold;
  foothold.touchdown_s = 1.0;
  foothold.liftoff_s = 2.0;
  EXPECT_EQ(SupportAt(foot, foothold, foot.sole_F, 1.9), foot.sole_F);
  foothold.heel_off_s = 1.8;
  EXPECT_FALSE(StandsOnEdge(foothold, 1.79));
  EXPECT_TRUE(StandsOnEdge(foothold, 1.8));
  EXPECT_EQ(SupportAt(foot, foothold, foot.sole_F, 1.79), foot.sole_F);
  EXPECT_EQ(SupportAt(foot, foothold, foot.sole_F, 1.9), FrontEdge(foot.sole_F));
}

}  // namespace
}  // namespace gaitwright
