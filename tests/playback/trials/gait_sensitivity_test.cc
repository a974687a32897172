// SPDX-License-Identifier: BSD-3-Clause
#include "playback/trials/gait_sensitivity.h"

#include <gtest/gtest.h>

#include <cmath>

#include "kinematics/base/result.h"
#include "kinematics/spatial/pose.h"
#include "playback/trials/distribution.h"

namespace gaitwright {
namespace {

using Matrix3d = Eigen::Matrix3d;
using Vector3d = Eigen::Vector3d;

const GaitScale kScale{.leg_length_m = 0.3, .mass_kg = 12.0, .step_s = 0.25};

/// A gait with a known step-to-step map: x' = A x + B e, g = C x + D e.
struct LinearGait {
  Eigen::Matrix2d A;
  Eigen::Matrix<double, 2, 3> B;
  Eigen::Matrix<double, 3, 2> C;
  Matrix3d D;

  LinearGait() {
    A << 0.3, 0.2, -0.1, 0.25;
    B << 0.2, 1.1, -0.1, -0.3, 0.1, 0.9;
    C << 0.1, 0.05, 0.6, -0.2, 0.1, 0.8;
    D << -0.4, 0.02, 0.0, 0.3, 0.5, 0.0, 0.0, 0.1, 0.4;
  }

  /// Response after k steps.
  Matrix3d Response(int k) const {
    if (k == 0) return D;
    Eigen::Matrix<double, 2, 3> x = B;
    for (int i = 1; i < k; ++i) x = A * x;
    return C * x;
  }

  double Norm() const {
    double squared = 0.0;
    for (int k = 0; k <= kStepsAfter; ++k) squared += Response(k).squaredNorm();
    return std::sqrt(squared);
  }
};

/// Parameters of synthetic trials.
struct Makeup {
  int trials = 200, steps = 30;
  double noise = 0.0;
  std::array<double, 3> sizes = {0.004, 0.01, 0.01};  ///< standard deviations of the disturbances, scaled
  std::uint64_t seed = 1;
  bool habits = true;  ///< each step and each trial has its own offsets, and some steps do not land
};

std::vector<std::vector<GaitStep>> MakeTrials(const LinearGait& gait, const Makeup& how) {
  const double impulse = kScale.mass_kg * std::sqrt(kGravity * kScale.leg_length_m);
  std::vector<std::vector<GaitStep>> trials;
  for (int i = 0; i < how.trials; ++i) {
    NamedRandom random(how.seed * 100003 + static_cast<std::uint64_t>(i), "gait");
    Eigen::Vector2d x = Eigen::Vector2d::Zero();
    const double own = how.habits ? 0.1 * random.Normal() : 0.0;
    trials.emplace_back();
    for (int n = 0; n < how.steps; ++n) {
      Vector3d e;
      for (int d = 0; d < 3; ++d) e[d] = how.sizes[static_cast<std::size_t>(d)] * random.Normal();
      Vector3d g = gait.C * x + gait.D * e;
      x = gait.A * x + gait.B * e;
      for (int k = 0; k < 3; ++k) g[k] += how.noise * random.Normal();
      if (how.habits) g += Vector3d(0.2 * std::sin(n), 0.1 * std::cos(3 * n), 0.05 * n) + Vector3d::Constant(own);
      GaitStep step{e[0] * kScale.leg_length_m, e[1] * impulse, e[2] * impulse, true, 0.0, 0.0, 0.0};
      step.landed = !how.habits || random.Uniform() > 0.05;
      if (step.landed) {
        step.late_s = g[0] * kScale.step_s;
        step.forward_m = g[1] * kScale.leg_length_m;
        step.left_m = g[2] * kScale.leg_length_m;
      }
      trials.back().push_back(step);
    }
  }
  return trials;
}

TEST(GaitSensitivityTest, AKnownMapIsFound) {
  const LinearGait gait;
  const GaitSensitivity found = EstimateGaitSensitivity(MakeTrials(gait, {}), kScale);
  ASSERT_TRUE(found.norm) << found.missing;
  EXPECT_GT(gait.Norm(), 1.0);
  EXPECT_NEAR(*found.norm, gait.Norm(), 0.01 * gait.Norm());
  EXPECT_NEAR(*found.norm, gait.Norm(), 4.0 * *found.standard_error);
  EXPECT_LT(*found.standard_error, 0.01 * gait.Norm());
  EXPECT_EQ(found.missing, "");
  EXPECT_EQ(found.trials, 200);
  EXPECT_NEAR(found.steps, 200 * 30 * 0.95, 100);
  EXPECT_EQ(found.varied, (std::array<bool, 3>{true, true, true}));
  ASSERT_EQ(found.response.size(), static_cast<std::size_t>(kStepsAfter) + 1);
  for (int k = 0; k <= kStepsAfter; ++k) {
    EXPECT_LT((found.response[static_cast<std::size_t>(k)] - gait.Response(k)).norm(), 0.02) << k << " steps after";
  }
}

TEST(GaitSensitivityTest, WithoutNoiseAGaitThatForgetsIsFoundToRounding) {
  LinearGait gait;
  gait.A.setZero();
  const GaitSensitivity found = EstimateGaitSensitivity(MakeTrials(gait, {.trials = 40, .steps = 12}), kScale);
  ASSERT_TRUE(found.norm) << found.missing;
  EXPECT_NEAR(*found.norm, gait.Norm(), 1e-8);
}

TEST(GaitSensitivityTest, NoiseMakesItNoLarger) {
  const LinearGait gait;
  double mean = 0.0, plain = 0.0;
  constexpr int kRuns = 20;
  for (int run = 1; run <= kRuns; ++run) {
    const GaitSensitivity found = EstimateGaitSensitivity(
        MakeTrials(gait, {.trials = 50, .steps = 15, .noise = 0.02, .seed = static_cast<std::uint64_t>(run)}), kScale);
    ASSERT_TRUE(found.norm) << found.missing;
    mean += *found.norm / kRuns;
    double squared = 0.0;
    for (const GaitSensitivity::Response& one : found.response) squared += one.squaredNorm();
    plain += std::sqrt(squared) / kRuns;
  }
  EXPECT_GT(plain, 1.1 * gait.Norm()) << "so much does noise add to the plain estimate";
  EXPECT_NEAR(mean, gait.Norm(), 0.05 * gait.Norm());
}

TEST(GaitSensitivityTest, ScalesAreThoseOfTheRobot) {
  const LinearGait gait;
  std::vector<std::vector<GaitStep>> trials = MakeTrials(gait, {});
  const double norm = EstimateGaitSensitivity(trials, kScale).norm.value();
  for (auto& steps : trials) {  // the gait of a similar robot with four times the size and half the speed
    for (GaitStep& step : steps) {
      for (double* length : {&step.ground_m, &step.forward_m, &step.left_m}) *length *= 4.0;
      for (double* impulse : {&step.push_forward_n_s, &step.push_left_n_s}) *impulse *= 10.0 * 2.0;
      step.late_s *= 2.0;
    }
  }
  const GaitScale large{.leg_length_m = 1.2, .mass_kg = 120.0, .step_s = 0.5};
  EXPECT_NEAR(EstimateGaitSensitivity(trials, large).norm.value(), norm, 1e-9);
}

TEST(GaitSensitivityTest, WhatDoesNotVaryIsLeftOut) {
  const LinearGait gait;
  const GaitSensitivity pushed = EstimateGaitSensitivity(MakeTrials(gait, {.sizes = {0.0, 0.01, 0.0}}), kScale);
  ASSERT_TRUE(pushed.norm) << pushed.missing;
  EXPECT_EQ(pushed.varied, (std::array<bool, 3>{false, true, false}));
  double squared = 0.0;
  for (int k = 0; k <= kStepsAfter; ++k) squared += gait.Response(k).col(1).squaredNorm();
  EXPECT_NEAR(*pushed.norm, std::sqrt(squared), 0.02 * std::sqrt(squared));
  EXPECT_EQ(pushed.response[0].col(0).norm(), 0.0);
}

TEST(GaitSensitivityTest, WhereItCannotBeEstimatedItSaysWhy) {
  const LinearGait gait;
  const auto why = [](const std::vector<std::vector<GaitStep>>& trials, const GaitScale& scale = kScale) {
    const GaitSensitivity found = EstimateGaitSensitivity(trials, scale);
    EXPECT_FALSE(found.norm.has_value());
    EXPECT_FALSE(found.standard_error.has_value());
    EXPECT_TRUE(found.response.empty());
    return found.missing;
  };
  EXPECT_EQ(why({}), "no trial survived");
  EXPECT_EQ(why({{}, {}}), "the plan has no consecutive steps");
  EXPECT_EQ(why(MakeTrials(gait, {}), {0.3, 12.0, 0.0}), "the plan has no consecutive steps");
  EXPECT_EQ(why(MakeTrials(gait, {.trials = 19})), "19 trials survived; 20 or more are needed");
  EXPECT_NE(why(MakeTrials(gait, {.sizes = {0.0, 0.0, 0.0}})).find("no sampled disturbance"), std::string::npos);
  EXPECT_NE(why(MakeTrials(gait, {.trials = 20, .steps = 2})).find("are needed"), std::string::npos);
  LinearGait deaf;
  deaf.C.setZero();
  deaf.D.setZero();
  int reported = 0;
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const GaitSensitivity found =
        EstimateGaitSensitivity(MakeTrials(deaf, {.trials = 50, .noise = 0.1, .seed = seed}), kScale);
    reported += found.norm ? 1 : 0;
    EXPECT_TRUE(found.norm || found.missing.find("is not statistically significant") != std::string::npos)
        << found.missing;
  }
  EXPECT_LE(reported, 2) << "of twenty gaits that nothing disturbs";
  auto uneven = MakeTrials(gait, {});
  uneven[3].pop_back();
  EXPECT_THROW((void)EstimateGaitSensitivity(uneven, kScale), InvalidArgument);
}

}  // namespace
}  // namespace gaitwright
