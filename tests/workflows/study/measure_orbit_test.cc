// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "kinematics/model/load_robot.h"
#include "workflows/study/measure_orbit_internal.h"

namespace gaitwright {
namespace {

class OrbitOfATrot : public testing::Test {
 protected:
  static MotionPlan Over(double distance_m) {
    WalkRequest walk;
    walk.gait = "trot";
    walk.command.speed_m_s = 1.0;
    walk.command.distance_m = distance_m;
    return PlanWalk(Robot(), walk).value().motion.plan;
  }

  static const RobotModel& Robot() {
    static const RobotModel a1 = LoadNamedRobot("a1").value();
    return a1;
  }

  static const MotionPlan& Long() {
    static const MotionPlan plan = Over(4.0);
    return plan;
  }

  static OrbitStability Measured(const MotionPlan& plan, const std::string& controller) {
    PlayRequest play;
    play.controller = controller;
    return MeasureOrbit(Robot(), plan, play, {.threads = 0}).value();
  }
};

TEST_F(OrbitOfATrot, IsStableWithFeedbackAndNeutralWithout) {
  const OrbitStability fed_back = Measured(Long(), "stabilised"), replayed = Measured(Long(), "joint-pd");
  ASSERT_EQ(fed_back.missing, "");
  ASSERT_EQ(replayed.missing, "");
  EXPECT_EQ(fed_back.verdict(), OrbitVerdict::kStable);
  EXPECT_LT(fed_back.multipliers.largest(), 0.7);
  EXPECT_NEAR(replayed.multipliers.largest(), 1.0, 0.15) << "nothing brings place and heading back";
  EXPECT_GE(fed_back.cycles, kLeastOrbitCycles);
  EXPECT_EQ(fed_back.playbacks, 24);
  EXPECT_NEAR(fed_back.impulse_n_s, 0.01 * Robot().total_mass_kg * std::sqrt(kGravity * Robot().leg_length_m()), 1e-12);
  const auto json = nlohmann::json::parse(OrbitJson(fed_back));
  EXPECT_EQ(json.at("verdict"), "stable");
  EXPECT_EQ(json.at("multipliers").size(), fed_back.multipliers.values.size());
  EXPECT_EQ(json.at("largest"), fed_back.multipliers.largest());
}

TEST_F(OrbitOfATrot, TheSamePlaybacksGiveTheSameMultipliersOnAnyNumberOfThreads) {
  PlayRequest play;
  const OrbitStability one = MeasureOrbit(Robot(), Long(), play, {.threads = 1}).value();
  const OrbitStability two = MeasureOrbit(Robot(), Long(), play, {.threads = 2}).value();
  EXPECT_EQ(OrbitJson(one), OrbitJson(two));
}

TEST_F(OrbitOfATrot, NeedsCyclesThatRepeat) {
  const OrbitStability orbit = Measured(Over(0.3), "stabilised");
  EXPECT_LT(orbit.cycles, kLeastOrbitCycles);
  EXPECT_FALSE(orbit.missing.empty());
  EXPECT_EQ(orbit.verdict(), OrbitVerdict::kUnknown);
  EXPECT_EQ(nlohmann::json::parse(OrbitJson(orbit)).at("verdict"), "unknown");
}

}  // namespace
}  // namespace gaitwright
