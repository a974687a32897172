// SPDX-License-Identifier: BSD-3-Clause
#include "optimisation/pipeline/flight_swings.h"

#include <gtest/gtest.h>

#include <cmath>

#include "kinematics/model/load_robot.h"
#include "kinematics/trajectory/swing_curve.h"
#include "optimisation/swing/swing_lift.h"
#include "tests/unusual_robots.h"

namespace gaitwright {
namespace {

/// All feet on the ground, then in the air, then on the ground again.
ContactSchedule Leap(const RobotModel& model, double flight_s) {
  const FootSet all = AllFeet(static_cast<int>(model.feet.size()));
  return {{{0.0, 0.5, all}, {0.5, 0.5 + flight_s, 0}, {0.5 + flight_s, 1.5, all}}};
}

double PeakAcceleration(const FlightSwing& swing, double time_s) {
  SwingCurve curve;
  curve.end_s = time_s;
  curve.lift_m = swing.lift_m;
  curve.cruise = swing.cruise;
  double peak = 0.0;
  for (int k = 0; k <= 300; ++k) peak = std::max(peak, std::abs(Evaluate(curve, time_s * k / 300).a_WF.z()));
  return peak;
}

TEST(FlightSwings, LightLegsGoAlongWithTheBody) {
  const RobotModel a1 = *LoadNamedRobot("a1");
  const ContactSchedule schedule = Leap(a1, 0.15);
  const FlightSwing swing = FlightSwings(a1, schedule, {}).At(0.5, 0.65);
  EXPECT_NEAR(swing.lift_m, SwingLift(a1, {}) + kGravity * 0.15 * 0.15 / 8.0, 1e-12);
  EXPECT_NEAR(swing.cruise, 0.6, 1e-12) << "all of the swing is flight";
}

TEST(FlightSwings, HeavyLegsAreLiftedByNoMoreThanMotorsMove) {
  constexpr double kFlight = 0.15;
  const RobotModel model = *LoadRobotFromText(unusual::Runner(), "");
  const ContactSchedule schedule = Leap(model, kFlight);
  const FlightSwing swing = FlightSwings(model, schedule, {}).At(0.5, 0.5 + kFlight);
  const double most = 0.4 * FootAccelerationInFlight(model, {0, 1}) - kGravity;
  EXPECT_GT(swing.lift_m, 0.1 * SwingLift(model, {}));
  EXPECT_LT(swing.lift_m, SwingLift(model, {}));
  EXPECT_NEAR(PeakAcceleration(swing, kFlight), most, 0.02 * most);
}

/// Feet that stayed on the ground would not fly.
TEST(FlightSwings, ATenthOfTheUsualLiftIsKeptWhateverTheMotors) {
  for (const auto& [name, flight_s] : {std::pair{"nao", 0.06}, std::pair{"g1", 0.115}}) {
    const RobotModel model = *LoadNamedRobot(name);
    const ContactSchedule schedule = Leap(model, flight_s);
    const FlightSwing swing = FlightSwings(model, schedule, {}).At(0.5, 0.5 + flight_s);
    const double most = 0.4 * FootAccelerationInFlight(model, {0, 1}) - kGravity;
    EXPECT_NEAR(swing.lift_m, 0.1 * SwingLift(model, {}), 1e-12) << name;
    EXPECT_EQ(swing.cruise, 0.0) << name;
    EXPECT_GT(PeakAcceleration(swing, flight_s), most) << name;
  }
}

TEST(FlightSwings, OthersAndLiftsThatAreAskedForAreLeftAlone) {
  const RobotModel nao = *LoadNamedRobot("nao");
  const ContactSchedule schedule = Leap(nao, 0.06);
  SwingOptions options;
  options.height_m = 0.04;
  EXPECT_NEAR(FlightSwings(nao, schedule, options).At(0.5, 0.56).lift_m, 0.04 + kGravity * 0.06 * 0.06 / 8.0, 1e-12);
  const FlightSwing grounded = FlightSwings(nao, schedule, {}).At(0.7, 1.2);
  EXPECT_EQ(grounded.lift_m, SwingLift(nao, {}));
  EXPECT_EQ(grounded.cruise, 0.0);
}

}  // namespace
}  // namespace gaitwright
