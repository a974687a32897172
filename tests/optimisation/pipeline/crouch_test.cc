// SPDX-License-Identifier: BSD-3-Clause
#include "optimisation/pipeline/crouch.h"

#include <gtest/gtest.h>

#include "kinematics/dynamics/dynamics.h"
#include "kinematics/model/load_robot.h"
#include "optimisation/pipeline/leg_motors.h"
#include "tests/unusual_robots.h"

namespace gaitwright {
namespace {

/// Standing on both feet, in the air, and standing again.
ContactSchedule OneFlight(double flight_s) {
  return {{{0.0, 0.5, AllFeet(2)}, {0.5, 0.5 + flight_s, 0}, {0.5 + flight_s, 1.5, AllFeet(2)}}};
}

double HeightOf(const RobotModel& model) {
  DynamicsScratch scratch(model);
  ForwardKinematics(model, StandingConfiguration(model), scratch);
  return CentreOfMass(model, scratch).z();
}

TEST(Crouch, IsForLegsThatAreTooStraightToBeFast) {
  const RobotModel nao = *LoadNamedRobot("nao");
  const Result<std::optional<Crouch>> crouch = CrouchFor(nao, OneFlight(0.06));
  ASSERT_TRUE(crouch.ok()) << crouch.failure().message;
  ASSERT_TRUE(crouch->has_value());
  EXPECT_LT(HeightOf((*crouch)->model), (*crouch)->highest_m);
  EXPECT_LT((*crouch)->highest_m, HeightOf(nao));
  EXPECT_GT((*crouch)->fastest_m_s, 0.5 * kGravity * 0.06) << "what the flight takes";
  EXPECT_EQ((*crouch)->model.hash, nao.hash);
  // A deeper crouch gives faster legs, so a shorter flight needs less.
  const Result<std::optional<Crouch>> less = CrouchFor(nao, OneFlight(0.045));
  ASSERT_TRUE(less.ok() && less->has_value());
  EXPECT_GT((*less)->highest_m, (*crouch)->highest_m);
}

TEST(Crouch, IsNotForLegsThatAreFastEnoughAsTheyStand) {
  const RobotModel runner = *LoadRobotFromText(unusual::Runner(), "");
  const Result<std::optional<Crouch>> standing = CrouchFor(runner, OneFlight(0.15));
  ASSERT_TRUE(standing.ok());
  EXPECT_FALSE(standing->has_value());
  const Result<std::optional<Crouch>> longer = CrouchFor(runner, OneFlight(0.35));
  ASSERT_TRUE(longer.ok()) << longer.failure().message;
  EXPECT_TRUE(longer->has_value());
  const Result<std::optional<Crouch>> grounded = CrouchFor(runner, {{{0.0, 1.0, AllFeet(2)}}});
  ASSERT_TRUE(grounded.ok());
  EXPECT_FALSE(grounded->has_value());
}

TEST(Crouch, FlightsThatNoHeightGivesAreRefusedWithTheirMotor) {
  const RobotModel nao = *LoadNamedRobot("nao");
  const Result<std::optional<Crouch>> crouch = CrouchFor(nao, OneFlight(0.12));
  ASSERT_FALSE(crouch.ok());
  EXPECT_EQ(crouch.failure().code, FailureCode::kLegsTooSlow);
  EXPECT_NE(crouch.failure().message.find("KneePitch' is limited to 6.4"), std::string::npos)
      << crouch.failure().message;
  EXPECT_NE(crouch.failure().message.find("needs a lift-off speed of 0.59 m/s"), std::string::npos);
  // No height is faster than the message says.
  double fastest = 0.0;
  for (const PushOff& at : PushOffs(nao, 2, 0.03, 0.95)) fastest = std::max(fastest, 0.95 * at.speed_m_s);
  EXPECT_LT(fastest, 0.5 * kGravity * 0.12);
  ASSERT_FALSE(crouch.failure().suggestions.empty());
  EXPECT_NE(crouch.failure().suggestions.front().text.find("flights of 0.06"), std::string::npos)
      << crouch.failure().suggestions.front().text;
}

TEST(Crouch, TorqueSpeedCurvesShortenFlights) {
  RobotModel runner = *LoadRobotFromText(unusual::Runner(), "");
  ASSERT_TRUE(CrouchFor(runner, OneFlight(0.35)).ok());
  runner.motors.resize(static_cast<std::size_t>(runner.num_dofs()));
  for (Motor& motor : runner.motors) {
    motor.corner_speed = 0.5;
    motor.no_load_speed = 3.0;
  }
  const Result<std::optional<Crouch>> slower = CrouchFor(runner, OneFlight(0.35));
  ASSERT_FALSE(slower.ok());
  EXPECT_EQ(slower.failure().code, FailureCode::kLegsTooWeak) << slower.failure().message;
  EXPECT_NE(slower.failure().message.find("rises by 0.150 m"), std::string::npos) << "g T^2 / 8";
}

TEST(Crouch, TheBodyIsCarriedAtTheHeightAskedFor) {
  const RobotModel a1 = *LoadNamedRobot("a1");
  const ContactSchedule trot = {{{0.0, 1.0, AllFeet(4)}}};
  const Result<std::optional<Crouch>> low = CrouchFor(a1, trot, 0.8 * HeightOf(a1));
  ASSERT_TRUE(low.ok() && low->has_value());
  EXPECT_NEAR(HeightOf((*low)->model), 0.8 * HeightOf(a1), 1e-4);
  const Result<std::optional<Crouch>> stretched = CrouchFor(a1, trot, 1.5 * HeightOf(a1));
  ASSERT_FALSE(stretched.ok());
  EXPECT_EQ(stretched.failure().code, FailureCode::kHeight) << stretched.failure().message;
}

TEST(Crouch, LegsThatAreFastEnoughOnlyLowerDownAreNotCarriedHigh) {
  const RobotModel nao = *LoadNamedRobot("nao");
  const Result<std::optional<Crouch>> high = CrouchFor(nao, OneFlight(0.06), HeightOf(nao));
  ASSERT_FALSE(high.ok());
  EXPECT_EQ(high.failure().code, FailureCode::kHeight);
  EXPECT_NE(high.failure().message.find("fast enough"), std::string::npos) << high.failure().message;
  const Result<std::optional<Crouch>> low =
      CrouchFor(nao, OneFlight(0.06), 0.98 * (*CrouchFor(nao, OneFlight(0.06)))->highest_m);
  ASSERT_TRUE(low.ok() && low->has_value());
  EXPECT_GT((*low)->fastest_m_s, 0.0);
}

TEST(Crouch, LegsThatCannotHoldTheBodyOnOneFootAreTooWeak) {
  RobotModel weak = *LoadRobotFromText(unusual::Runner(), "");
  for (Joint& joint : weak.joints) joint.effort_limit *= 0.1;
  ContactSchedule running = OneFlight(0.15);
  running.phases.front().stance = FootBit(0);
  const Result<std::optional<Crouch>> crouch = CrouchFor(weak, running);
  ASSERT_FALSE(crouch.ok());
  EXPECT_EQ(crouch.failure().code, FailureCode::kLegsTooWeak) << crouch.failure().message;
  EXPECT_NE(crouch.failure().message.find(" N m"), std::string::npos) << crouch.failure().message;
}

}  // namespace
}  // namespace gaitwright
