// SPDX-License-Identifier: BSD-3-Clause
#include "planning/gait/find_gait.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "planning/gait/load_gaits.h"
#include "tests/named_robot.h"

namespace gaitwright {
namespace {

Gait GaitFor(const char* robot, const std::string& name, double speed_m_s, const GaitOptions& options = {}) {
  const Result<Gait> gait = FindGait(NamedRobot(robot), name, speed_m_s, options);
  EXPECT_TRUE(gait.ok()) << gait.failure().message;
  return gait.ok() ? *gait : Gait{};
}

TEST(FindGait, NoNameAndWalkStandForTheGaitOfThatNumberOfFeet) {
  EXPECT_EQ(GaitFor("a1", "", 0.2).name, "trot");
  EXPECT_EQ(GaitFor("a1", "walk", 0.2).name, "crawl");
  EXPECT_EQ(GaitFor("nao", "", 0.1).name, "biped");
  EXPECT_EQ(GaitFor("nao", "walk", 0.1), GaitFor("nao", "", 0.1));
}

TEST(FindGait, FasterWalksStepAsFastOrFasterButNeverTwiceAsFast) {
  const Gait own = GaitFor("a1", "trot", 0.0);
  double last = own.cycle_s;
  for (double speed = 0.05; speed < 4.0; speed += 0.05) {
    const Gait gait = GaitFor("a1", "trot", speed);
    EXPECT_GE(gait.cycle_s, 0.5 * own.cycle_s - 1e-12) << speed;
    if (gait.duty_factor != own.duty_factor) continue;  // the gait runs
    EXPECT_LE(gait.cycle_s, last + 1e-12) << speed;
    last = gait.cycle_s;
  }
  EXPECT_LT(last, 0.8 * own.cycle_s);
}

TEST(FindGait, TheBodyGoesNoFartherOverAFootThanItsTravel) {
  for (const double travel : {0.3, 0.42, 0.6}) {
    GaitOptions options;
    options.stance_travel = travel;
    for (const double speed : {0.2, 0.5, 0.8}) {
      const Gait gait = GaitFor("a1", "trot", speed, options);
      if (HasFlight(gait)) continue;
      const double gone = speed * gait.duty_factor.front() * gait.cycle_s;
      EXPECT_LE(gone, travel * NamedRobot("a1").leg_length_m() + 1e-9) << speed;
    }
  }
}

TEST(FindGait, ABipedWithoutAnkleRollFallsFromFootToFootInShortCycles) {
  const RobotModel h1 = NamedRobot("h1");
  const double leg_time_s = std::sqrt(h1.leg_length_m() / kGravity);
  EXPECT_LE(GaitFor("h1", "biped", 0.1).cycle_s, 2.4 * leg_time_s + 1e-12);
  RobotModel rolls = h1;
  for (Foot& foot : rolls.feet) foot.type = FootType::kSole;
  EXPECT_GT(FindGait(rolls, "biped", 0.1, {}).value().cycle_s, 8.0 * leg_time_s);
  EXPECT_EQ(FindGait(rolls, "run", 1.0, {}).value(), GaitFor("h1", "run", 1.0)) << "a gait with shorter cycles";
}

TEST(FindGait, GivenTimesAreTakenAsTheyAre) {
  GaitOptions options;
  options.cycle_s = 0.77;
  options.duty_factor = 0.63;
  for (const double speed : {0.0, 0.3, 2.0}) {
    const Gait gait = GaitFor("a1", "trot", speed, options);
    EXPECT_DOUBLE_EQ(gait.cycle_s, 0.77);
    for (const double duty : gait.duty_factor) EXPECT_DOUBLE_EQ(duty, 0.63);
  }
}

TEST(FindGait, ACycleIsRoundedToWholeStepsOneAtLeast) {
  GaitOptions options;
  options.cycle_step_s = 0.04;
  for (const double speed : {0.0, 0.35, 0.9}) {
    const double exact = GaitFor("a1", "trot", speed).cycle_s, rounded = GaitFor("a1", "trot", speed, options).cycle_s;
    EXPECT_NEAR(rounded / 0.04, std::round(rounded / 0.04), 1e-9);
    EXPECT_NEAR(rounded, exact, 0.02 + 1e-12);
  }
  options.cycle_s = 0.05;
  options.cycle_step_s = 0.05;
  EXPECT_DOUBLE_EQ(GaitFor("a1", "trot", 0.0, options).cycle_s, 0.05);
}

TEST(FindGait, AFastTrotFliesForAMomentRatherThanExchangesItsFeetAtOnce) {
  for (double speed = 0.8; speed < 3.0; speed += 0.1) {
    const Gait gait = GaitFor("a1", "trot", speed);
    if (!HasFlight(gait)) continue;
    // Each time, all feet are off the ground for 5 ms or more.
    const double gap = gait.cycle_s * (0.5 - *std::max_element(gait.duty_factor.begin(), gait.duty_factor.end()));
    EXPECT_GE(gap, 0.005 - 1e-6) << speed;
  }
}

TEST(CycleLimits, AreHalfAndTwiceTheOwnCycleOrWhatIsGiven) {
  const RobotModel& a1 = NamedRobot("a1");
  const double own = GaitFor("a1", "trot", 0.0).cycle_s;
  EXPECT_NEAR(*ShortestCycle(a1, "trot", {}), 0.5 * own, 1e-12);
  EXPECT_NEAR(*LongestCycle(a1, "trot", {}), 2.0 * own, 1e-12);
  GaitOptions given;
  given.cycle_s = 0.6;
  EXPECT_EQ(*ShortestCycle(a1, "trot", given), 0.6);
  EXPECT_EQ(*LongestCycle(a1, "trot", given), 0.6);
}

TEST(CycleLimits, OfAGaitThatDoesNotExistFailAsFindGaitDoes) {
  const RobotModel& a1 = NamedRobot("a1");
  const Failure failure = FindGait(a1, "tort", 0.0, {}).failure();
  EXPECT_EQ(failure.kind, FailureKind::kBadInput);
  EXPECT_EQ(failure.code, FailureCode::kGait);
  EXPECT_EQ(ShortestCycle(a1, "tort", {}).failure(), failure);
  EXPECT_EQ(LongestCycle(a1, "tort", {}).failure(), failure);
  EXPECT_EQ(OwnStride(a1, "tort").failure(), failure);
}

TEST(FindGait, OptionsTooSmallAreRefused) {
  const RobotModel& a1 = NamedRobot("a1");
  GaitOptions cycle, duty;
  cycle.cycle_s = 0.049;
  duty.duty_factor = 0.049;
  EXPECT_EQ(FindGait(a1, "trot", 0.3, cycle).failure().code, FailureCode::kGait);
  EXPECT_EQ(FindGait(a1, "trot", 0.3, duty).failure().code, FailureCode::kGait);
  cycle.cycle_s = duty.duty_factor = 0.05;
  EXPECT_TRUE(FindGait(a1, "trot", 0.3, cycle).ok());
  EXPECT_TRUE(FindGait(a1, "trot", 0.3, duty).ok());
}

TEST(GaitFileOf, IsWhatEndsAsYamlOrStandsBeforeTheGaitsName) {
  EXPECT_EQ(GaitFileOf("trot"), "");
  EXPECT_EQ(GaitFileOf(""), "");
  EXPECT_EQ(GaitFileOf("mine.yaml"), "mine.yaml");
  EXPECT_EQ(GaitFileOf("a/b.yml:lope"), "a/b.yml");
  EXPECT_EQ(GaitFileOf("a.yaml/b.yaml:lope"), "a.yaml/b.yaml");
  EXPECT_EQ(GaitFileOf("yaml"), "");
}

TEST(FindGait, TheBuiltInGaitsAreFoundByTheirNamesInTheirFile) {
  const RobotModel& a1 = NamedRobot("a1");
  const Result<std::vector<GaitEntry>> listed = BuiltInGaits();
  ASSERT_TRUE(listed.ok()) << listed.failure().message;
  int found = 0;
  for (const GaitEntry& entry : *listed) {
    if (entry.gait.num_feet() != 4) continue;
    ++found;
    const Result<Gait> by_name = FindGait(a1, entry.gait.name, 0.2, {});
    const Result<Gait> by_file = FindGait(a1, BuiltInGaitsFile() + ":" + entry.gait.name, 0.2, {});
    ASSERT_TRUE(by_name.ok() && by_file.ok()) << entry.gait.name;
    EXPECT_EQ(*by_name, *by_file);
  }
  EXPECT_GT(found, 3);
}

}  // namespace
}  // namespace gaitwright
