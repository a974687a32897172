// SPDX-License-Identifier: BSD-3-Clause
#include "kinematics/model/actuator.h"

#include "tests/kinematics/model/small_urdf.h"
#include "tests/kinematics/random_state.h"

namespace gaitwright {
namespace {

/// Four legs. Hip and knee of the first leg are driven together, with ratios 2 and -3 and limited motors.
RobotModel GearedLegs() {
  RobotModel model = *LoadRobotFromText(FourLegs(), "");
  Transmission t;
  t.name = "ankle";
  t.dofs = {model.DofIndex("A_hip"), model.DofIndex("A_knee")};
  t.motors = {{.name = "m1", .effort_limit = 6.0, .velocity_limit = 5.0}, {.name = "m2", .effort_limit = 9.0}};
  t.ratios.resize(2, 2);
  t.ratios << 2.0, 1.0, 0.0, -3.0;
  AddTransmission(t, model);
  return model;
}

TEST(Actuator, SpeedAndEffortAreThoseOfTheMatrixOfRatios) {
  const RobotModel model = GearedLegs();
  RandomState random(3);
  const VectorX v = random.Vector(model.num_dofs()), tau = random.Vector(model.num_dofs());
  const int hip = model.DofIndex("A_hip"), knee = model.DofIndex("A_knee");
  const Actuator first = ActuatorOf(model, hip), second = ActuatorOf(model, knee);
  EXPECT_EQ(first.name, "m1");
  EXPECT_EQ(first.transmission, 0);
  EXPECT_NEAR(first.Speed(v), 2.0 * v[hip] + v[knee], 1e-12);
  EXPECT_NEAR(second.Speed(v), -3.0 * v[knee], 1e-12);
  // tau = R^T m: tau_hip = 2 m1, tau_knee = m1 - 3 m2.
  EXPECT_NEAR(first.Effort(tau), tau[hip] / 2.0, 1e-12);
  EXPECT_NEAR(second.Effort(tau), (tau[hip] / 2.0 - tau[knee]) / 3.0, 1e-12);
  const Actuator single = ActuatorOf(model, model.DofIndex("B_hip"));
  EXPECT_FALSE(single.shared());
  EXPECT_EQ(single.Effort(tau), tau[model.DofIndex("B_hip")]);
  EXPECT_EQ(single.effort_limit, 30.0);
}

TEST(Actuator, ClampingLeavesNoMotorBeyondItsLimitAndIsDoneOnce) {
  const RobotModel model = GearedLegs();
  RandomState random(5);
  for (int i = 0; i < 50; ++i) {
    const VectorX tau = 40.0 * random.Vector(model.num_dofs()), v = 30.0 * random.Vector(model.num_dofs());
    const VectorX efforts = ClampedEfforts(model, tau), speeds = ClampedSpeeds(model, v);
    EXPECT_LE(LargestEffortUse(model, efforts).share, 1.0 + 1e-9);
    EXPECT_LE(LargestSpeedUse(model, speeds).share, 1.0 + 1e-9);
    EXPECT_LT((ClampedEfforts(model, efforts) - efforts).norm(), 1e-9);
    EXPECT_LT((ClampedSpeeds(model, speeds) - speeds).norm(), 1e-9);
    for (const Actuator& motor : ActuatorsOf(model)) {
      const double asked = motor.Effort(tau);
      if (std::abs(asked) <= motor.effort_limit) {
        EXPECT_NEAR(motor.Effort(efforts), asked, 1e-9) << "a motor within its limit keeps its effort";
      }
    }
  }
}

TEST(Actuator, TheLargestUseNamesTheMotorNearestToItsLimit) {
  const RobotModel model = GearedLegs();
  VectorX tau = VectorX::Zero(model.num_dofs());
  EXPECT_EQ(LargestEffortUse(model, tau).share, 0.0);
  tau[model.DofIndex("B_hip")] = -15.0;
  EXPECT_EQ(LargestEffortUse(model, tau).motor, model.DofIndex("B_hip"));
  EXPECT_EQ(LargestEffortUse(model, tau).share, 0.5);
  tau[model.DofIndex("A_hip")] = 9.0;  // 4.5 of 6 in m1
  const LargestUse use = LargestEffortUse(model, tau);
  EXPECT_EQ(ActuatorOf(model, use.motor).name, "m1");
  EXPECT_NEAR(use.share, 0.75, 1e-12);
}

TEST(Actuator, UnknownLimitsCountForNothing) {
  RobotModel model = GearedLegs();
  VectorX v = VectorX::Zero(model.num_dofs());
  v[model.DofIndex("A_knee")] = 1.0;  // m2 turns with -3 and has no limit; m1 with 1 of 5
  EXPECT_NEAR(LargestSpeedUse(model, v).share, 0.2, 1e-12);
  for (Joint& joint : model.joints) joint.velocity_limit_is_placeholder = true;
  model.transmissions.clear();
  EXPECT_EQ(LargestSpeedUse(model, v).motor, -1);
  EXPECT_EQ(LargestSpeedUse(model, v).share, 0.0);
  EXPECT_EQ(ClampedSpeeds(model, 1e6 * v), 1e6 * v);
}

TEST(Actuator, UnitsAreThoseOfItsKind) {
  const std::string sliding = Replaced(Replaced(FourLegs(), "_knee' type='revolute'", "_knee' type='prismatic'"),
                                       "lower='-2' upper='1'", "lower='-0.1' upper='0.1'");
  const Result<RobotModel> model = LoadRobotFromText(sliding, "");
  ASSERT_TRUE(model.ok()) << model.failure().message;
  const Actuator slide = ActuatorOf(*model, model->DofIndex("A_knee")),
                 turn = ActuatorOf(*model, model->DofIndex("A_hip"));
  EXPECT_STREQ(slide.speed_unit(), "m/s");
  EXPECT_STREQ(slide.effort_unit(), "N");
  EXPECT_STREQ(turn.speed_unit(), "rad/s");
  EXPECT_STREQ(turn.effort_unit(), "N m");
}

TEST(Motor, TheCurveFallsFromTheCornerToNothing) {
  Motor motor;
  EXPECT_EQ(motor.EffortAt(1e9, 5.0), 5.0) << "without a curve";
  motor.corner_speed = 4.0;
  motor.no_load_speed = 8.0;
  EXPECT_EQ(motor.EffortAt(-20.0, 5.0), 5.0) << "braking has the full peak";
  EXPECT_EQ(motor.EffortAt(4.0, 5.0), 5.0);
  EXPECT_EQ(motor.EffortAt(6.0, 5.0), 2.5);
  EXPECT_EQ(motor.EffortAt(8.0, 5.0), 0.0);
  EXPECT_EQ(motor.EffortAt(9.0, 5.0), 0.0);
}

}  // namespace
}  // namespace gaitwright
