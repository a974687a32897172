// SPDX-License-Identifier: BSD-3-Clause
// Motors that drive several joints together.
#include "kinematics/model/transmission.h"

#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <random>

#include "kinematics/base/result.h"
#include "kinematics/model/actuator.h"
#include "kinematics/model/describe.h"
#include "kinematics/model/joint_losses.h"
#include "tests/kinematics/model/small_urdf.h"

namespace gaitwright {
namespace {

/// Two motors of 10 N m and 4 rad/s that turn hip and knee of leg A as a symmetric differential.
std::string Differential(const std::string& first = "1, 1", const std::string& second = "1, -1",
                         const std::string& more = "") {
  return "transmissions:\n"
         "  - name: leg\n"
         "    joints: [A_hip, A_knee]\n"
         "    motors:\n"
         "      - {name: m1, ratios: [" +
         first + "], effort_nm: 10, velocity_rad_s: 4" + more +
         "}\n"
         "      - {name: m2, ratios: [" +
         second + "], effort_nm: 10, velocity_rad_s: 4" + more + "}\n";
}

RobotModel ModelWith(const std::string& yaml) {
  Result<RobotModel> model = LoadRobotFromText(FourLegs(), yaml);
  EXPECT_TRUE(model.ok()) << (model.ok() ? "" : model.failure().message);
  return std::move(model).value();
}

VectorX AtJoints(const RobotModel& model, double hip, double knee) {
  VectorX joints = VectorX::Zero(model.num_dofs());
  joints[model.DofIndex("A_hip")] = hip;
  joints[model.DofIndex("A_knee")] = knee;
  return joints;
}

TEST(Transmission, MotorsAreAsManyAsJointsAndStandWhereTheseStand) {
  const RobotModel model = ModelWith(Differential());
  const std::vector<Actuator> motors = ActuatorsOf(model);
  ASSERT_EQ(motors.size(), model.dof_names.size());
  for (int d = 0; d < model.num_dofs(); ++d) {
    const Actuator& motor = motors[static_cast<std::size_t>(d)];
    const std::string& joint = model.dof_names[static_cast<std::size_t>(d)];
    const std::string expected = joint == "A_hip" ? "m1" : joint == "A_knee" ? "m2" : joint;
    EXPECT_EQ(motor.name, expected);
    EXPECT_EQ(motor.shared(), expected != joint);
    EXPECT_EQ(motor.effort_limit, motor.shared() ? 10.0 : 30.0);
    EXPECT_EQ(motor.velocity_limit, motor.shared() ? 4.0 : 20.0);
  }
}

TEST(Transmission, OfOneJointBothMotorsGiveTwiceWhatOneGivesAndOfBothLess) {
  const RobotModel model = ModelWith(Differential());
  const int hip = model.DofIndex("A_hip"), knee = model.DofIndex("A_knee");
  EXPECT_EQ(model.dof_effort_limit(hip), 20.0) << "the box around what they give";
  EXPECT_EQ(model.dof_effort_limit(knee), 20.0);
  EXPECT_EQ(model.dof_velocity_limit(hip), 4.0);
  EXPECT_NEAR(LargestEffortUse(model, AtJoints(model, 20.0, 0.0)).share, 1.0, 1e-12);
  EXPECT_NEAR(LargestEffortUse(model, AtJoints(model, 0.0, -20.0)).share, 1.0, 1e-12);
  const LargestUse mixed = LargestEffortUse(model, AtJoints(model, 15.0, -15.0));
  EXPECT_NEAR(mixed.share, 1.5, 1e-12) << "within the box, and past one motor's limit";
  EXPECT_EQ(ActuatorOf(model, mixed.motor).name, "m2");
  EXPECT_NEAR(LargestSpeedUse(model, AtJoints(model, 3.0, 3.0)).share, 1.5, 1e-12);
}

TEST(Transmission, ClampHoldsEachMotorToItsLimit) {
  const RobotModel model = ModelWith(Differential());
  const VectorX torques = ClampedEfforts(model, AtJoints(model, 15.0, 15.0));
  EXPECT_TRUE(torques.isApprox(AtJoints(model, 10.0, 10.0), 1e-12)) << "m1 gives 10, m2 nothing";
  const VectorX kept = AtJoints(model, 12.0, -7.0);
  EXPECT_TRUE(ClampedEfforts(model, kept).isApprox(kept, 1e-12)) << "what motors give is left alone";
  VectorX other = VectorX::Zero(model.num_dofs());
  other[model.DofIndex("B_hip")] = 50.0;
  EXPECT_EQ(ClampedEfforts(model, other)[model.DofIndex("B_hip")], 30.0);
  EXPECT_TRUE(ClampedSpeeds(model, AtJoints(model, 3.0, 3.0)).isApprox(AtJoints(model, 2.0, 2.0), 1e-12));
}

TEST(Transmission, PowerIsConservedAndDirectionsAreInverse) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> number(-3.0, 3.0);
  for (int trial = 0; trial < 50; ++trial) {
    RobotModel model = ModelWith("");
    Transmission t{"t", {model.DofIndex("A_hip"), model.DofIndex("C_knee"), model.DofIndex("D_hip")}, {}, {}, {}};
    t.motors.resize(3);
    t.ratios = MatrixX::NullaryExpr(3, 3, [&] { return number(random); });
    if (Regularity(t.ratios) < 0.05) continue;
    AddTransmission(t, model);
    const VectorX v = VectorX::NullaryExpr(model.num_dofs(), [&] { return number(random); });
    const VectorX tau = VectorX::NullaryExpr(model.num_dofs(), [&] { return number(random); });
    double power = 0.0;
    for (const Actuator& motor : ActuatorsOf(model)) power += motor.Effort(tau) * motor.Speed(v);
    EXPECT_NEAR(power, tau.dot(v), 1e-9 * (1.0 + tau.norm() * v.norm()));
    EXPECT_TRUE(ClampedEfforts(model, tau).isApprox(tau, 1e-12)) << "no limit is known";
    const Transmission& added = model.transmissions[0];
    EXPECT_TRUE((added.ratios * added.inverse).isIdentity(1e-9));
  }
}

TEST(Transmission, IdentityIsWhatBoxesAre) {
  const RobotModel plain = ModelWith("");
  const RobotModel same = ModelWith(
      "transmissions: [{name: t, joints: [A_hip, A_knee], motors: [{name: A_hip, ratios: [1, 0], effort_nm: 30, "
      "velocity_rad_s: 20}, {name: A_knee, ratios: [0, 1], effort_nm: 30, velocity_rad_s: 20}]}]");
  for (int d = 0; d < plain.num_dofs(); ++d) {
    EXPECT_EQ(same.dof_effort_limit(d), plain.dof_effort_limit(d));
    EXPECT_EQ(same.dof_velocity_limit(d), plain.dof_velocity_limit(d));
    const VectorX tau = VectorX::LinSpaced(plain.num_dofs(), -50.0, 40.0);
    EXPECT_EQ(ActuatorOf(same, d).Effort(tau), ActuatorOf(plain, d).Effort(tau));
    EXPECT_EQ(ActuatorOf(same, d).name, ActuatorOf(plain, d).name);
    EXPECT_EQ(ClampedEfforts(same, tau), ClampedEfforts(plain, tau));
  }
}

TEST(Transmission, RotorsCoupleTheJointsThatTheyTurnWith) {
  const RobotModel model = ModelWith(Differential("2, 1", "0, 3", ", rotor_inertia_kg_m2: 0.1"));
  const int hip = 6 + model.DofIndex("A_hip"), knee = 6 + model.DofIndex("A_knee");
  MatrixX M = MatrixX::Zero(model.nv(), model.nv());
  AddRotorInertia(model, M);
  EXPECT_NEAR(M(hip, hip), 0.4, 1e-12);
  EXPECT_NEAR(M(hip, knee), 0.2, 1e-12);
  EXPECT_NEAR(M(knee, hip), 0.2, 1e-12);
  EXPECT_NEAR(M(knee, knee), 1.0, 1e-12);
  EXPECT_NEAR(RotorInertiaAt(model, knee - 6), 1.0, 1e-12);
  MatrixX none = MatrixX::Zero(model.nv(), model.nv());
  AddRotorInertia(WithoutLosses(model), none);
  EXPECT_TRUE(none.isZero(0.0));
}

TEST(Transmission, LimitsThatAreNotGivenAreNotKnown) {
  const RobotModel model = ModelWith(
      "transmissions: [{name: t, joints: [A_hip, A_knee], motors: [{name: a, ratios: [1, 0], effort_nm: 5}, "
      "{name: b, ratios: [1, 1], velocity_rad_s: 3}]}]");
  const int hip = model.DofIndex("A_hip"), knee = model.DofIndex("A_knee");
  EXPECT_TRUE(std::isinf(model.dof_effort_limit(hip))) << "b helps with any torque";
  EXPECT_TRUE(std::isinf(model.dof_velocity_limit(knee)));
  EXPECT_EQ(ActuatorOf(model, hip).effort_limit, 5.0);
  EXPECT_EQ(ActuatorOf(model, knee).velocity_limit, 3.0);
  EXPECT_NEAR(LargestEffortUse(model, AtJoints(model, 0.0, 2.0)).share, 0.4, 1e-12) << "a holds against b";
}

TEST(Transmission, IsReportedWithTheRobot) {
  const RobotModel model = ModelWith(Differential("2, 1", "0, 3"));
  const auto json = nlohmann::json::parse(RobotJson(model));
  ASSERT_EQ(json["transmissions"].size(), 1U);
  EXPECT_EQ(json["transmissions"][0]["joints"], nlohmann::json({"A_hip", "A_knee"}));
  EXPECT_EQ(json["transmissions"][0]["motors"][0]["ratios"], nlohmann::json({2.0, 1.0}));
  EXPECT_EQ(json["transmissions"][0]["motors"][1]["effort_limit"], 10.0);
  ExpectSays(DescribeRobot(model), {"leg: joints A_hip, A_knee", "ratios [2, 1]", "motors of transmission 'leg'"});
}

TEST(Transmission, RegularityDoesNotMindUnitsAndGears) {
  MatrixX ratios(2, 2);
  ratios << 1.0, 1.0, 1.0, -1.0;
  EXPECT_NEAR(Regularity(ratios), 1.0, 1e-12);
  ratios << 1e-4, 1e2, 1e-2, -1e4;
  EXPECT_NEAR(Regularity(ratios), 1.0, 1e-9);
  ratios << 1.0, 2.0, 2.0, 4.0;
  EXPECT_LT(Regularity(ratios), 1e-12);
  EXPECT_EQ(Regularity(MatrixX::Zero(2, 2)), 0.0);
}

TEST(TransmissionYaml, RefusesByLine) {
  struct Case {
    std::string yaml;
    std::vector<std::string> says;
  };
  const std::string two = "    motors: [{name: a, ratios: [1, 0]}, {name: b, ratios: [0, 1]}]\n";
  const std::string head = "transmissions:\n  - name: t\n    joints: ";
  const std::vector<Case> cases = {
      {Differential("1, 2", "2, 4"), {"line 2", "'leg'", "singular", "0.001 or more"}},
      {head + "[A_hip, A_kne]\n" + two, {"line 2", "'A_kne'", "A_knee"}},
      {head + "[A_hip, A_hip]\n" + two, {"line 3", "'A_hip' twice"}},
      {head + "[A_hip]\n" + two, {"line 3", "1 joints; 2 to 8"}},
      {head + "[A_hip, A_knee, B_hip]\n" + two, {"line 4", "2 motors but 3 joints"}},
      {head + "[A_hip, A_knee]\n    motors: [{name: a, ratios: [1, 0]}, {name: b, ratios: [1]}]\n",
       {"line 4", "motor 'b' has 1 ratios"}},
      {head + "[A_hip, A_knee]\n    motors: [{name: a, ratios: [1, 0]}, {name: a, ratios: [0, 1]}]\n",
       {"line 4", "two motors are named 'a'"}},
      {head + "[A_hip, A_knee]\n    motors: [{name: a, ratios: [1, 0]}, {name: B_hip, ratios: [0, 1]}]\n",
       {"line 4", "'B_hip'", "name of a joint"}},
      {head + "[A_hip, A_knee]\n    motors: [{name: a, ratios: [1, 0], effort_nm: 0}, {name: b, ratios: [0, 1]}]\n",
       {"line 4", "'effort_nm' is 0"}},
      {head + "[A_hip, A_knee]\n    motors: [{name: a, ratios: [1, .nan]}, {name: b, ratios: [0, 1]}]\n", {"line 4"}},
      {head + "[A_hip, A_knee]\n    motors: [{name: a, ratios: [1, 0], effort: 3}, {name: b, ratios: [0, 1]}]\n",
       {"line 4", "unknown key 'effort'"}},
      {head +
           "[A_hip, A_knee]\n    motors: [{name: a, ratios: [1, 0], effort_nm: 3, effort_n: 3}, {name: b, ratios: [0, "
           "1]}]\n",
       {"line 4", "motor 'a'", "both a revolute motor and a prismatic one"}},
      {head +
           "[A_hip, A_knee]\n    motors: [{name: a, ratios: [1, 0], corner_velocity_rad_s: 3}, {name: b, ratios: [0, "
           "1]}]\n",
       {"line 4", "motor 'a'", "one end"}},
      {head + "[A_hip, A_knee]\n" + two +
           "  - name: u\n    joints: [B_hip, A_knee]\n    motors: [{name: c, ratios: [1, "
           "0]}, {name: d, ratios: [0, 1]}]\n",
       {"line 5", "'A_knee'", "'t' also drives"}},
      {"limits: {A_hip: {effort_nm: 3}}\n" + Differential(), {"line 1", "'A_hip'", "'leg'"}},
      {"motors: {A_knee: {continuous_nm: 3}}\n" + Differential(), {"line 1", "'A_knee'", "'leg'"}},
      {"motors: {A_knee: {rotor_inertia_kg_m2: 3}}\n" + Differential("1, 1", "1, -1", ", rotor_inertia_kg_m2: 1"),
       {"line 1", "'A_knee'", "set only one of them"}},
      {Differential("1, 1e-9"), {"line 5", "'ratios' is 1e-09"}},
      {"transmissions: {a: b}\n", {"line 1"}},
      {"transmissions: [3]\n", {"line 1"}},
  };
  for (const Case& c : cases) {
    SCOPED_TRACE(c.yaml);
    const std::string why = MessageOf(FourLegs(), c.yaml);
    ASSERT_NE(why, "");
    ExpectSays(why, c.says);
  }
}

TEST(TransmissionYaml, JointsKeepTheirOwnLimitsOfPositionAndLosses) {
  const RobotModel model =
      ModelWith("limits: {A_hip: {lower_rad: -1.2}}\nmotors: {A_hip: {acceleration_rad_s2: 9, friction_nm: 0.5}}\n" +
                Differential());
  const int hip = model.DofIndex("A_hip");
  EXPECT_EQ(model.dof_lower(hip), -1.2);
  EXPECT_EQ(model.MotorOf(hip).acceleration_limit, 9.0);
  EXPECT_EQ(LossesOf(model, hip).friction, 0.5);
}

TEST(TransmissionYaml, RefusesAJointThatMimicsAnother) {
  const std::string urdf = Replaced(FourLegs(), "<!--A_extra-->", "<mimic joint='A_hip'/>");
  const std::string why = MessageOf(urdf, Differential());
  ExpectSays(why, {"line 2", "'A_knee'", "mimics"});
}

}  // namespace
}  // namespace gaitwright
