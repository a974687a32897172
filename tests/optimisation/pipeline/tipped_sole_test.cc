// SPDX-License-Identifier: BSD-3-Clause
#include "optimisation/pipeline/tipped_sole.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "kinematics/dynamics/dynamics.h"
#include "optimisation/pipeline/sole_width.h"
#include "tests/kinematics/made_robots.h"

namespace gaitwright {
namespace {

/// A robot on feet without ankle roll joints that stands and is then rotated about the middle of its left sole.
WholeBodyTrajectory RolledOverItsLeftSole(const RobotModel& model, double roll_rad) {
  DynamicsScratch scratch(model);
  VectorX q = StandingConfiguration(model);
  ForwardKinematics(model, q, scratch);
  const Pose X_WF = FramePose(scratch, model.feet[0].body, model.feet[0].X_BF);
  WholeBodyTrajectory motion;
  motion.start_s = 2.0;
  motion.step_s = 0.25;
  motion.q.push_back(q);
  const Matrix3 R = Eigen::AngleAxisd(roll_rad, Vector3::UnitX()).toRotationMatrix();
  q.head<3>() = X_WF.translation() + R * (q.head<3>() - X_WF.translation());
  q.segment<4>(3) = Quaternion(R * BaseRotation(q)).coeffs();
  motion.q.push_back(q);
  return motion;
}

TEST(TippedSole, NamesTheFootTheTimeAndTheDepthOfItsEdge) {
  const RobotModel model = AnyRobot("line");
  ASSERT_EQ(model.feet[0].type, FootType::kLine);
  const double roll_rad = -0.03;  // the right foot goes up
  const auto failure = TippedSole(model, FlatTerrain(), RolledOverItsLeftSole(model, roll_rad));
  ASSERT_TRUE(failure);
  EXPECT_EQ(failure->kind, FailureKind::kInfeasible);
  EXPECT_EQ(failure->code, FailureCode::kTippedSole);
  const double depth_m = 0.5 * SoleWidth(model.feet[0]) * std::sin(0.03);
  const std::vector<std::string> figures = {"at 2.25 s", "'" + model.feet[0].name + "'",
                                            fmt::format("{:.1f} mm below", 1e3 * depth_m), "tilts by 0.030 rad",
                                            fmt::format("{:.3f} m wide", SoleWidth(model.feet[0]))};
  for (const std::string& figure : figures)
    EXPECT_NE(failure->message.find(figure), std::string::npos) << figure << " in: " << failure->message;
  EXPECT_EQ(failure->suggestions.size(), 2U);
}

TEST(TippedSole, ATiltThatHardlyEntersTheGroundIsNone) {
  const RobotModel model = AnyRobot("line");
  const double half_m = 0.5 * SoleWidth(model.feet[0]);
  EXPECT_FALSE(TippedSole(model, FlatTerrain(), RolledOverItsLeftSole(model, 0.0)));
  EXPECT_FALSE(TippedSole(model, FlatTerrain(), RolledOverItsLeftSole(model, -0.9e-4 / half_m)));
  EXPECT_TRUE(TippedSole(model, FlatTerrain(), RolledOverItsLeftSole(model, -1.1e-4 / half_m)));
}

TEST(TippedSole, GroundThatIsLowerIsNotEntered) {
  const RobotModel model = AnyRobot("line");
  Terrain lower = FlatTerrain();
  lower.patches[0].X_WT.translation().z() = -0.01;
  EXPECT_FALSE(TippedSole(model, lower, RolledOverItsLeftSole(model, -0.03)));
}

TEST(TippedSole, FeetWithAnAnkleRollJointAreNotItsMatter) {
  for (const char* name : {"a1", "nao"}) {
    const RobotModel model = AnyRobot(name);
    WholeBodyTrajectory sunk;
    sunk.q.push_back(StandingConfiguration(model));
    sunk.q[0].z() -= 0.05;
    EXPECT_FALSE(TippedSole(model, FlatTerrain(), sunk)) << name;
  }
}

TEST(SoleWidth, IsMeasuredAcrossTheFoot) {
  Foot foot;
  EXPECT_EQ(SoleWidth(foot), 0.0);
  foot.sole_F = {{-0.1, -0.02}, {0.2, -0.03}, {0.2, 0.05}, {-0.1, 0.04}};
  EXPECT_DOUBLE_EQ(SoleWidth(foot), 0.08);
}

}  // namespace
}  // namespace gaitwright
