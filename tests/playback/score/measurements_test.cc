// SPDX-License-Identifier: BSD-3-Clause
#include "playback/score/measurements.h"

#include <gtest/gtest.h>

#include "tests/playback/played.h"

namespace gaitwright {
namespace {

struct Case : synthetic::Played {
  Case() : Played(synthetic::Walked()) {}
};

TEST(Measurements, AnExtremeKnowsItsTime) {
  Extreme least(Extreme::Kind::kSmallest), most(Extreme::Kind::kLargest);
  for (int i = 0; i < 10; ++i) {
    const double value = (i - 6) * (i - 6);
    least.See(value, i);
    most.See(value, i);
  }
  EXPECT_EQ(*least.at_s, 6.0);
  EXPECT_EQ(*most.value, 36.0);
  EXPECT_EQ(*most.at_s, 0.0);
  EXPECT_FALSE(Extreme(Extreme::Kind::kLargest).value.has_value());
}

TEST(Measurements, ClearanceIsTheSwingsHeightAQuarterIn) {
  const Case c;
  // 64 lift (s (1 - s))^3 at s = 1/4.
  EXPECT_NEAR(c.Planned("clearance_min_m"), 64.0 * 0.04 * std::pow(0.25 * 0.75, 3), 1e-6);
  Case low = c;
  const double middle = low.plan.schedule.phases[1].start_s + 0.2;
  LogSample& sample = low.log.samples[static_cast<std::size_t>(std::lround(middle / synthetic::kStep))];
  sample.q[9] -= 0.035;  // the left foot swings first
  EXPECT_NEAR(low.Value("clearance_min_m"), 0.005, 1e-6);
}

TEST(Measurements, StanceFiguresAreSumsAndExtremesBeforeTheFall) {
  Case c;
  for (StanceRecord& stance : c.log.stances) stance.slip_m = 0.001;
  c.log.stances[2].slip_m = 0.006;
  c.log.stances[3].penetration_m = 0.0011;
  c.log.stances[4].peak_normal_n = 3.0 * c.model.weight_n();
  c.log.stances[5].touchdown_speed_m_s = 0.7;
  c.log.stances[1].friction_use_max = 0.9;
  const double count = static_cast<double>(c.log.stances.size());
  EXPECT_NEAR(c.Value("slip_total_m"), 0.001 * (count - 1.0) + 0.006, 1e-12);
  EXPECT_NEAR(c.Value("slip_max_step_m"), 0.006, 1e-12);
  EXPECT_NEAR(c.Value("penetration_max_m"), 0.0011, 1e-12);
  EXPECT_NEAR(c.Value("impact_max_n_per_mg"), 3.0, 1e-12);
  EXPECT_NEAR(c.Value("touchdown_speed_max_m_s"), 0.7, 1e-12);
  EXPECT_NEAR(c.Value("friction_use_max"), 0.9, 1e-12);
  c.log.body_contacts = {{0.5 * (c.log.stances[3].touchdown_s + c.log.stances[4].touchdown_s), "trunk"}};
  EXPECT_LT(c.Value("impact_max_n_per_mg"), 2.0) << "what comes after the fall is not measured";
}

TEST(Measurements, PlannedFrictionIsThatOfThePlansOwnForces) {
  const Case c;
  double largest = 0.0;
  for (const VectorX& a : c.plan.whole_body.a) largest = std::max(largest, a.head<2>().norm() / kGravity / 0.8);
  EXPECT_NEAR(c.Planned("friction_use_max"), largest, 0.02 * largest)
      << "forces are parallel to gravity plus acceleration";
}

TEST(Measurements, ThePercentileIsNotTheMinimum) {
  Case c;
  c.plan = synthetic::StandingPlan(c.model, 2.0);
  c.log = synthetic::PerfectLog(c.model, c.plan);
  const auto outside = [&](std::size_t count) {
    Case shifted = c;
    for (std::size_t k = 100; k < 100 + count; ++k) {
      for (ContactWrench& wrench : shifted.log.samples[k].wrenches) wrench.moment_W.y() -= 0.1 * wrench.force_W.z();
    }
    ScoreOptions raw;
    raw.zmp_filter_s = 0.0;
    return Score(shifted.model, shifted.plan, shifted.log, raw);
  };
  const StabilityReport few = outside(8), many = outside(40);  // of 401
  EXPECT_NEAR(*few.At("zmp_margin_min_m").value, -0.02, 1e-9);
  EXPECT_NEAR(*few.At("zmp_margin_p05_m").value, 0.08, 1e-9);
  EXPECT_NEAR(*many.At("zmp_margin_p05_m").value, -0.02, 1e-9);
  EXPECT_NEAR(*many.At("zmp_outside_fraction").value, 40.0 / 401.0, 1e-12);
}

TEST(Measurements, DcmErrorIsThatOfPositionPlusVelocityOverOmega) {
  Case c;
  c.plan = synthetic::StandingPlan(c.model, 1.0);
  c.log = synthetic::PerfectLog(c.model, c.plan);
  const double omega = std::sqrt(kGravity / synthetic::kHeight);
  for (LogSample& sample : c.log.samples) sample.v[0] = 0.05 * omega;
  EXPECT_NEAR(c.Value("dcm_error_mean_m"), 0.05, 1e-9);
  EXPECT_NEAR(c.Value("dcm_error_max_m"), 0.05, 1e-9);
}

TEST(Measurements, JerkOfAKnownWave) {
  Case c;
  const double amplitude = 0.3, frequency = 4.0;
  for (LogSample& sample : c.log.samples) {
    sample.v.tail(c.model.num_dofs()).setConstant(amplitude * std::sin(frequency * sample.time_s));
  }
  // Root mean square of amplitude frequency^2 sin: exact over whole periods, and a close approximation here.
  EXPECT_NEAR(c.Value("smoothness_jerk_rms"), amplitude * frequency * frequency / std::sqrt(2.0), 0.1);
}

TEST(Measurements, TorqueStepsCountAtContactSwitchesOnly) {
  Case c;
  for (LogSample& sample : c.log.samples) sample.tau.setZero();
  const double switch_s = c.plan.schedule.phases[1].start_s;
  c.log.samples[20].tau[0] = 150.0;  // in the rest before the first step
  const std::size_t at = static_cast<std::size_t>(std::lround(switch_s / synthetic::kStep));
  for (std::size_t k = at; k < c.log.samples.size(); ++k) c.log.samples[k].tau[3] = 40.0;
  EXPECT_NEAR(c.Value("torque_step_use_max"), 0.2, 1e-12);
}

TEST(Measurements, TrackingIsAgainstThePlanInTheWorld) {
  Case c;
  for (LogSample& sample : c.log.samples) {
    sample.q[0] += 0.03;
    sample.q[1] += 0.04;
    sample.q[7] += 0.06;
  }
  EXPECT_NEAR(c.Value("tracking_base_rms_m"), 0.05, 1e-9);
  EXPECT_NEAR(c.Value("tracking_com_rms_m"), 0.05, 1e-9);
  EXPECT_NEAR(c.Value("tracking_joint_rms_rad"), 0.06 / std::sqrt(6.0), 1e-9) << "one joint of six";
}

}  // namespace
}  // namespace gaitwright
