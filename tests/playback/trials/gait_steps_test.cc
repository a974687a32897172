// SPDX-License-Identifier: BSD-3-Clause
#include "playback/trials/gait_steps.h"

#include <gtest/gtest.h>

#include <cmath>

#include "playback/engine/bumps.h"
#include "playback/engine/world.h"
#include "tests/playback/synthetic.h"

namespace gaitwright {
namespace {

constexpr double kSpeed = 0.3, kStride = 0.5;  // [m/s], time of a step [s]

/// A biped that heads along y of W and steps every half second, left foot first, and its log, which equals the plan.
class GaitStepsTest : public testing::Test {
 protected:
  GaitStepsTest() {
    plan_.terrain = FlatTerrain();
    plan_.whole_body.step_s = 0.005;
    for (int k = 0; k <= 400; ++k) {
      plan_.whole_body.q.push_back(StateAt(0.005 * k));
      plan_.whole_body.v.push_back(VectorX::Zero(model_.nv()));
      plan_.whole_body.v.back()[1] = kSpeed;
      plan_.whole_body.a.push_back(VectorX::Zero(model_.nv()));
    }
    plan_.whole_body.tau.assign(401, VectorX::Zero(model_.num_dofs()));
    plan_.whole_body.wrenches.assign(401, std::vector<ContactWrench>(2));
    for (int foot = 0; foot < 2; ++foot) AddFoothold(foot, 0.0);
    for (int step = 1; step <= 3; ++step) AddFoothold((step + 1) % 2, kStride * step);
    for (int k = 1; k <= 400; ++k) {
      LogSample sample;
      sample.time_s = 0.005 * k;
      sample.q = StateAt(sample.time_s);
      log_.samples.push_back(sample);
    }
    for (const Foothold& foothold : plan_.footsteps.footholds) {
      StanceRecord stance;
      stance.foot = foothold.foot;
      stance.touchdown_s = foothold.touchdown_s;
      stance.p_touchdown_W = foothold.X_WF.translation();
      log_.stances.push_back(stance);
    }
  }

  VectorX StateAt(double time_s) const {
    VectorX q = VectorX::Zero(model_.nq());
    q.head<3>() << 0.0, kSpeed * time_s, synthetic::kHeight;
    q.segment<4>(3) << 0.0, 0.0, std::sqrt(0.5), std::sqrt(0.5);
    q.tail(model_.num_dofs()) = model_.standing_joints;
    return q;
  }

  /// Left is toward -x of W.
  void AddFoothold(int foot, double time_s) {
    Foothold foothold;
    foothold.foot = foot;
    foothold.X_WF.translation() << (foot == 0 ? -0.1 : 0.1), kSpeed * (time_s + 0.25), 0.0;
    foothold.touchdown_s = time_s;
    plan_.footsteps.footholds.push_back(foothold);
  }

  std::vector<GaitStep> Steps() const { return GaitStepsOf(model_, plan_, options_, log_); }

  const RobotModel model_ = synthetic::Robot(2, FootType::kSole);
  MotionPlan plan_;
  PlayOptions options_;
  PlaybackLog log_;
};

void ExpectStep(const GaitStep& step, double late_s, double forward_m, double left_m) {
  EXPECT_TRUE(step.landed);
  EXPECT_NEAR(step.late_s, late_s, 1e-9);
  EXPECT_NEAR(step.forward_m, forward_m, 1e-9);
  EXPECT_NEAR(step.left_m, left_m, 1e-9);
}

TEST_F(GaitStepsTest, OfAWalkAsPlannedAreZero) {
  const std::vector<GaitStep> steps = Steps();
  ASSERT_EQ(steps.size(), 3U) << "feet that stand at the start have not stepped";
  for (const GaitStep& step : steps) {
    ExpectStep(step, 0.0, 0.0, 0.0);
    EXPECT_EQ(step.ground_m, 0.0);
    EXPECT_EQ(step.push_forward_n_s, 0.0);
  }
  const GaitScale scale = GaitScaleOf(model_, plan_);
  EXPECT_NEAR(scale.step_s, kStride, 1e-12);
  EXPECT_EQ(scale.mass_kg, 10.0);
  EXPECT_EQ(scale.leg_length_m, model_.leg_length_m());
}

TEST_F(GaitStepsTest, LandingsAreBesideTheBaseAndInItsHeading) {
  log_.stances[3].touchdown_s += 0.012;                                             // the second step
  log_.stances[3].p_touchdown_W += Vector3(-0.03, 0.02, 0.0);                       // to the left, and forward
  for (LogSample& sample : log_.samples) sample.q.head<2>() += Vector2(0.5, -0.2);  // the base has drifted
  for (StanceRecord& stance : log_.stances) stance.p_touchdown_W.head<2>() += Vector2(0.5, -0.2);
  const std::vector<GaitStep> steps = Steps();
  ExpectStep(steps[0], 0.0, 0.0, 0.0);
  ExpectStep(steps[1], 0.012, 0.02, 0.03);
  ExpectStep(steps[2], 0.0, 0.0, 0.0);
}

TEST_F(GaitStepsTest, AFootThatDidNotLandNearItsTimeIsSaidSo) {
  log_.stances[3].touchdown_s += 0.2;
  const std::vector<GaitStep> steps = Steps();
  EXPECT_TRUE(steps[0].landed);
  EXPECT_FALSE(steps[1].landed);
  EXPECT_EQ(steps[1].late_s, 0.0);
  EXPECT_TRUE(steps[2].landed);
}

TEST_F(GaitStepsTest, FeetThatLandTogetherAreOneStep) {
  const double first = plan_.footsteps.footholds[2].touchdown_s;
  AddFoothold(1, first + 0.004);
  std::stable_sort(plan_.footsteps.footholds.begin(), plan_.footsteps.footholds.end(),
                   [](const Foothold& a, const Foothold& b) { return a.touchdown_s < b.touchdown_s; });
  StanceRecord stance = log_.stances[2];
  stance.foot = 1;
  stance.touchdown_s = first + 0.004 + 0.02;
  stance.p_touchdown_W = Vector3(0.1, kSpeed * (first + 0.004 + 0.25), 0.0);
  log_.stances.push_back(stance);
  const std::vector<GaitStep> steps = Steps();
  ASSERT_EQ(steps.size(), 3U);
  EXPECT_NEAR(steps[0].late_s, 0.01, 1e-9) << "one in time, one 20 ms late";
}

TEST_F(GaitStepsTest, PushesCountForTheStepInWhichTheyCome) {
  options_.push_force_W = Vector3(0.0, 30.0, 5.0);  // forward
  options_.push_at_s = 0.95;
  options_.push_for_s = 0.1;
  options_.more_pushes = {{Vector3(-20.0, 0.0, 0.0), 0.1, 0.2, "base"}};  // to the left
  const std::vector<GaitStep> steps = Steps();
  EXPECT_NEAR(steps[0].push_left_n_s, 4.0, 1e-9);
  EXPECT_NEAR(steps[0].push_forward_n_s, 0.0, 1e-9);
  EXPECT_NEAR(steps[1].push_forward_n_s, 1.5, 1e-9);
  EXPECT_NEAR(steps[2].push_forward_n_s, 1.5, 1e-9);
  EXPECT_NEAR(steps[2].push_left_n_s, 0.0, 1e-9);
}

TEST_F(GaitStepsTest, BumpsAreThoseThatTheFeetStandOn) {
  options_.world.ground_bumps_m = 0.01;
  options_.world.bump_wavelength_m = 0.1;
  options_.world.bump_free_radius_m = 0.01;
  options_.world.seed = 7;
  const Bumps bumps = BumpsOf(model_, plan_.whole_body.q.front(), options_.world);
  const auto under = [&](std::size_t stance) { return bumps.HeightAt(log_.stances[stance].p_touchdown_W.head<2>()); };
  std::vector<GaitStep> steps = Steps();
  EXPECT_NEAR(steps[0].ground_m, under(2) - under(1), 1e-12) << "the other foot stands where it stood at first";
  EXPECT_NEAR(steps[1].ground_m, under(3) - under(2), 1e-12);
  EXPECT_NEAR(steps[2].ground_m, under(4) - under(3), 1e-12);
  EXPECT_GT(std::abs(steps[1].ground_m), 1e-4);
  options_.world.ground_slope_deg = 5.0;
  options_.world.ground_slope_direction_deg = 90.0;
  const Pose X_tilt = GroundTilt(plan_.terrain, options_.world, bumps.start);
  for (StanceRecord& stance : log_.stances) stance.p_touchdown_W = X_tilt * stance.p_touchdown_W;
  EXPECT_NEAR(Steps()[1].ground_m, steps[1].ground_m, 1e-12) << "a slope is no bump";
}

}  // namespace
}  // namespace gaitwright
