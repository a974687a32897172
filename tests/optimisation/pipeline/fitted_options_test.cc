// SPDX-License-Identifier: BSD-3-Clause
#include "optimisation/pipeline/fitted_options.h"

#include <gtest/gtest.h>

#include "kinematics/model/load_robot.h"

namespace gaitwright {
namespace {

double StanceWeight(const std::string& robot, double flight_s) {
  return FittedOptions(*LoadNamedRobot(robot), flight_s, 0.0, {.weights = {.stance = 20.0}}).weights.stance;
}

TEST(FittedOptions, StanceCountsByTheLegsLengthAndLessWhereTheBodyIsThrownFar) {
  EXPECT_NEAR(StanceWeight("a1", 0.0), 20.0, 0.1) << "a leg of 0.42 m";
  EXPECT_NEAR(StanceWeight("a1", 0.1), StanceWeight("a1", 0.0), 1e-12) << "1.2 cm up";
  const double far = StanceWeight("a1", 0.4), farther = StanceWeight("a1", 0.8);
  EXPECT_LT(far, 0.1 * StanceWeight("a1", 0.0));
  EXPECT_NEAR(far / farther, 16.0, 1e-9) << "four times as high";
  const double a1 = LoadNamedRobot("a1")->leg_length_m(), nao = LoadNamedRobot("nao")->leg_length_m();
  EXPECT_NEAR(StanceWeight("nao", 0.0) / StanceWeight("a1", 0.0), a1 * a1 / (nao * nao), 1e-9);
}

TEST(FittedOptions, NodesAreCloserWhereFlightsAreShortForMotors) {
  const RobotModel nao = *LoadNamedRobot("nao");
  EXPECT_EQ(FittedOptions(nao, 0.06, 0.0, {.spacing_s = 0.04}).spacing_s, 0.04);
  EXPECT_NEAR(FittedOptions(nao, 0.06, 0.3, {.spacing_s = 0.04}).spacing_s, 0.4 * 2.0 * 0.3 / kGravity, 1e-12);
}

}  // namespace
}  // namespace gaitwright
