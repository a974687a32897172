// SPDX-License-Identifier: BSD-3-Clause
#include "optimisation/pipeline/leg_motors.h"

#include <gtest/gtest.h>

#include <cmath>

#include "kinematics/dynamics/dynamics.h"
#include "kinematics/dynamics/foot_contact.h"
#include "kinematics/model/actuator.h"
#include "kinematics/model/load_robot.h"
#include "tests/unusual_robots.h"

namespace gaitwright {
namespace {

/// Nearly massless legs of two links of length l under a body: knee angle k, base above the ankles. The hip is l sqrt(2
/// + 2 cos k) above the ankle; the knee's effect on its rise is dh/dk = -l^2 sin k / h.
std::string LightLegs() {
  unusual::UrdfText urdf;
  urdf.Link("body", 30.0, 0.4, urdf.Block(0.2, 0.2, 0.3, -0.2));
  for (const double side : {1.0, -1.0}) {
    const std::string n = side > 0.0 ? "l" : "r";
    for (const char* part : {"1", "2", "3", "4", "5"}) urdf.Link(n + part, 1e-4, 0.1);
    urdf.Link(n + "_foot", 1e-4, 0.1, urdf.Block(0.2, 0.1, 0.02, 0.05));
    urdf.Joint("body", n + "1", {0.0, 0.1 * side, 0.0}, {.axis = "0 0 1", .effort = 500.0});
    urdf.Joint(n + "1", n + "2", {0.0, 0.0, 0.0}, {.axis = "1 0 0", .effort = 500.0});
    urdf.Joint(n + "2", n + "3", {0.0, 0.0, 0.0}, {.lower = -2.0, .effort = 500.0});
    urdf.Joint(n + "3", n + "4", {0.0, 0.0, -0.3}, {.lower = 0.0, .upper = 2.3, .effort = 90.0, .speed = 8.0});
    urdf.Joint(n + "4", n + "5", {0.0, 0.0, -0.3}, {.effort = 500.0});
    urdf.Joint(n + "5", n + "_foot", {0.0, 0.0, 0.0}, {.axis = "1 0 0", .effort = 500.0});
  }
  return urdf.Done("light_legs");
}

TEST(LegMotors, KneesOfLightLegsGiveWhatTheirGeometrySays) {
  const RobotModel model = *LoadRobotFromText(LightLegs(), "");
  const int knee = model.DofIndex("l4_joint");
  const std::vector<PushOff> at = PushOffs(model, 2, 0.03, 1.0);
  ASSERT_GT(at.size(), 10U);
  int by_knee = 0;
  for (const PushOff& push : at) {
    const double k = push.q[7 + knee], h = 0.3 * std::sqrt(2.0 + 2.0 * std::cos(k));
    const double by_angle = 0.09 * std::sin(k) / h;  // [m/rad]
    EXPECT_NEAR(push.speed_m_s, 8.0 * by_angle, 2e-3 * push.speed_m_s) << k;
    if (model.dof_names[static_cast<std::size_t>(push.strongest)].find("4_joint") == std::string::npos) continue;
    // tau = F / 2 dh/dk, F = m (g + a)
    EXPECT_NEAR(push.gain_m_s2, 2.0 * 90.0 / by_angle / model.total_mass_kg - kGravity, 0.05) << k;
    ++by_knee;
  }
  EXPECT_GT(by_knee, 5);
}

TEST(LegMotors, GainFallsAlongTorqueSpeedCurves) {
  RobotModel model = *LoadRobotFromText(LightLegs(), "");
  const PushOff at = PushOffs(model, 2, 0.03, 1.0).back();
  EXPECT_NEAR(GainAtSpeed(model, at, 0.0, 1.0), at.gain_m_s2, 1e-9);
  EXPECT_NEAR(GainAtSpeed(model, at, 1.0, 1.0), at.gain_m_s2, 1e-9) << "no motor has a curve";
  model.motors.resize(static_cast<std::size_t>(model.num_dofs()));
  for (Motor& motor : model.motors) {
    motor.corner_speed = 1.0;
    motor.no_load_speed = 9.0;
  }
  // At half of the distance from corner to no-load speed, half of the knees' torque is left: m (g + a) halves.
  const double rising = 5.0 / std::abs(at.speed_by_rise[at.strongest]);
  EXPECT_NEAR(kGravity + GainAtSpeed(model, at, rising, 1.0), 0.5 * (kGravity + at.gain_m_s2), 0.05);
}

TEST(LegMotors, PostureIsLevelAndItsHeightIsThatOfTheCentreOfMass) {
  const RobotModel nao = *LoadNamedRobot("nao");
  DynamicsScratch scratch(nao);
  ForwardKinematics(nao, StandingConfiguration(nao), scratch);
  const Vector3 standing = CentreOfMass(nao, scratch);
  double last = 1e9;
  bool found = false;
  for (const PushOff& push : PushOffs(nao, 2, 0.03, 0.95)) {
    ForwardKinematics(nao, push.q, scratch);
    const Vector3 p_WC = CentreOfMass(nao, scratch);
    EXPECT_NEAR(p_WC.z(), push.com_m, 1e-8);
    EXPECT_LT((p_WC - standing).head<2>().norm(), 1e-8);
    EXPECT_LT(push.com_m, last);
    last = push.com_m;
    found = found || std::abs(push.com_m - standing.z()) < 1e-9;
  }
  EXPECT_TRUE(found) << "that of standing is among them";
}

TEST(LegMotors, OneFootGivesLessThanTwo) {
  const RobotModel runner = *LoadRobotFromText(unusual::Runner(), "");
  const std::vector<PushOff> two = PushOffs(runner, 2, 0.03, 0.95), one = PushOffs(runner, 1, 0.03, 0.95);
  ASSERT_EQ(one.size(), two.size());
  for (std::size_t i = 0; i < one.size(); ++i) {
    EXPECT_LT(one[i].gain_m_s2, two[i].gain_m_s2);
    EXPECT_EQ(one[i].speed_m_s, two[i].speed_m_s);
  }
}

TEST(LegMotors, LightLegsOfAStrongRobotMoveFasterInFlightThanHeavyOnesOfAWeakOne) {
  const double a1 = FootAccelerationInFlight(*LoadNamedRobot("a1"), {0, 1, 2, 3});
  const double nao = FootAccelerationInFlight(*LoadNamedRobot("nao"), {0, 1});
  EXPECT_GT(a1, 500.0);
  EXPECT_GT(nao, kGravity) << "else its feet could not follow its body";
  EXPECT_LT(nao, 100.0);
}

/// With what contacts give in a row, the motors' efforts are those of the row.
TEST(MotorLimitsOf, AreTheMotorsRoomForForcesOnAFoot) {
  const RobotModel a1 = *LoadNamedRobot("a1");
  DynamicsScratch scratch(a1);
  const VectorX q = StandingConfiguration(a1), none = VectorX::Zero(a1.nv());
  WholeBodyTrajectory rows;
  rows.q = {q};
  rows.v = rows.a = {none};
  VectorX tau;
  InverseDynamics(a1, q, none, none, scratch, tau);
  std::vector<ContactWrench> wrenches(a1.feet.size());
  const Vector3 force_W(3.0, -2.0, 0.25 * a1.weight_n());
  for (int f = 0; f < static_cast<int>(a1.feet.size()); ++f) {
    wrenches[static_cast<std::size_t>(f)].force_W = force_W;
    AddPointForce(a1, scratch, a1.feet[static_cast<std::size_t>(f)].body, ContactFrame(a1, scratch, f).translation(),
                  -force_W, tau);
  }
  rows.tau = {tau.tail(a1.num_dofs())};
  rows.wrenches = {wrenches};
  const MotorLimits limits = MotorLimitsOf(a1, rows, 0, 1, scratch);
  ASSERT_EQ(limits.by_force.rows(), 3) << "of the leg";
  const VectorX alone = 0.5 * (limits.lower + limits.upper), efforts = alone - limits.by_force * force_W;
  Eigen::Index row = 0;
  for (const Actuator& motor : ActuatorsOf(a1)) {
    const double effort = motor.Effort(rows.tau[0]);
    if (row == 3 || std::abs(efforts[row] - effort) > 1e-9) continue;
    EXPECT_NEAR(limits.upper[row] - limits.lower[row], 2.0 * 0.95 * motor.effort_limit, 1e-9);
    ++row;
  }
  EXPECT_EQ(row, 3) << "each of the three is the effort of one motor";
  EXPECT_GT(limits.by_force.norm(), 0.1);
}

}  // namespace
}  // namespace gaitwright
