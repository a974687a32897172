// SPDX-License-Identifier: BSD-3-Clause
#include "playback/trials/disturbances.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "playback/sensing/sensor_options.h"
#include "tests/playback/standing_plan.h"

namespace gaitwright {
namespace {

double noise = 0.0, delay = 0.0;  // of the sensors
int sensor_seed = 0;
const OptionFields kSensors = {{"noise_rad", &noise, "rad", 0.0, 0.1, "", {}},
                               {"delay_s", &delay, "s", 0.0, 0.1, "", {}},
                               {"seed", &sensor_seed, "1", 0, 10, "", {}}};

Disturbances Read(const std::string& text) { return ReadDisturbances(text, kSensors, "d.yaml").value(); }

double Value(const SampledTrial& trial, const std::string& name) {
  for (const SampledValue& one : trial.values) {
    if (one.name == name) return one.value;
  }
  ADD_FAILURE() << "nothing sampled is called " << name;
  return std::nan("");
}

class DisturbancesTest : public testing::Test {
 protected:
  SampledTrial Sample(const Disturbances& disturbances, std::uint64_t seed) const {
    return SampleTrial(disturbances, model_, plan_, seed);
  }

  const RobotModel model_ = standing::Load("a1");
  const MotionPlan plan_ = standing::Plan(model_, 2.0);
};

TEST_F(DisturbancesTest, APushDrawnFromABellHasADuration) {
  const Disturbances bell = Read("pushes:\n  - {size_n: 30, duration_s: {normal: {mean: 0.1, std: 0.1}}}\n");
  for (std::uint64_t seed = 0; seed < 200; ++seed) EXPECT_GT(Sample(bell, seed).pushes[0].for_s, 0.0);
}

TEST_F(DisturbancesTest, ASeedOfBumpsIsWhole) {
  const Disturbances seeds = Read("bump_seed: {uniform: [3, 9]}\n");
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const SampledTrial trial = Sample(seeds, seed);
    EXPECT_EQ(Value(trial, "bump_seed"), std::round(Value(trial, "bump_seed")));
    EXPECT_EQ(trial.options.at(0).value, Value(trial, "bump_seed")) << "what is told is what is played";
  }
}

TEST_F(DisturbancesTest, WhatIsDrawnForOneFigureDoesNotChangeWithTheOthers) {
  const Disturbances few = Read("mass_scale: {uniform: [0.9, 1.1]}\n");
  const Disturbances more =
      Read("friction: {uniform: [0.4, 1]}\nmass_scale: {uniform: [0.9, 1.1]}\nground_bumps_m: 0.01\n");
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    EXPECT_EQ(Value(Sample(few, seed), "mass_scale"), Value(Sample(more, seed), "mass_scale"));
    EXPECT_EQ(Sample(more, seed).values, Sample(more, seed).values);
  }
  EXPECT_NE(Value(Sample(few, 1), "mass_scale"), Value(Sample(few, 2), "mass_scale"));
}

TEST_F(DisturbancesTest, APushIsInTheHeadingOfThePlanAtItsTime) {
  MotionPlan turned = plan_;
  for (VectorX& q : turned.whole_body.q) q.segment<4>(3) << 0.0, 0.0, std::sqrt(0.5), std::sqrt(0.5);  // to the left
  const Disturbances push =
      Read("pushes:\n  - {size_of_weight: 0.1, direction_deg: 0, at_share: 0.5, duration_s: 0.2}\n");
  const SampledTrial trial = SampleTrial(push, model_, turned, 1);
  ASSERT_EQ(trial.pushes.size(), 1U);
  EXPECT_NEAR((trial.pushes[0].force_W - Vector3(0.0, 0.1 * model_.weight_n(), 0.0)).norm(), 0.0, 1e-9);
  EXPECT_NEAR(trial.pushes[0].at_s, 1.0, 1e-12);
  EXPECT_EQ(trial.pushes[0].for_s, 0.2);
  EXPECT_NEAR(Value(trial, "push1.ahead_n"), 0.1 * model_.weight_n(), 1e-9);
  EXPECT_NEAR(Value(trial, "push1.left_n"), 0.0, 1e-9);
  EXPECT_THROW(SampleTrial(Read("pushes:\n  - {size_n: 1, place: FR_claf}\n"), model_, plan_, 1), InvalidArgument);
}

TEST_F(DisturbancesTest, PartsAcrossARightAngleAreNone) {
  for (const char* degrees : {"90", "-90", "270"}) {
    const std::string push = fmt::format("pushes:\n  - {{size_n: 300, direction_deg: {}, at_share: 0.5}}\n", degrees);
    EXPECT_EQ(Value(SampleTrial(Read(push), model_, plan_, 1), "push1.ahead_n"), 0.0) << degrees;
    const std::string slope =
        fmt::format("ground_slope_deg: {{uniform: [1, 3]}}\nground_slope_direction_deg: {}\n", degrees);
    EXPECT_EQ(Value(SampleTrial(Read(slope), model_, plan_, 1), "ground_slope_x_deg"), 0.0) << degrees;
  }
}

TEST_F(DisturbancesTest, AShiftHasItsLengthInEveryDirection) {
  const Disturbances shift = Read("com_shift_m: 0.02\n");
  Vector3 mean = Vector3::Zero();
  constexpr int kTrials = 2000;
  for (int i = 0; i < kTrials; ++i) {
    const SampledTrial trial = Sample(shift, static_cast<std::uint64_t>(i));
    const Vector3 p(Value(trial, "com_shift_x_m"), Value(trial, "com_shift_y_m"), Value(trial, "com_shift_z_m"));
    EXPECT_NEAR(p.norm(), 0.02, 1e-12);
    mean += p / kTrials;
  }
  EXPECT_LT(mean.norm(), 0.002);
}

TEST_F(DisturbancesTest, ADirectionOfASlopeIsReportedByComponentsToo) {
  const std::string direction = "ground_slope_direction_deg: {uniform: [0, 360]}\n";
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const SampledTrial both = Sample(Read(direction + "ground_slope_deg: {uniform: [-3, 3]}\n"), seed);
    const double slope = Value(both, "ground_slope_deg");
    const double angle = Value(both, "ground_slope_direction_deg") * std::numbers::pi / 180.0;
    EXPECT_NEAR(Value(both, "ground_slope_x_deg"), slope * std::cos(angle), 1e-12);
    EXPECT_NEAR(Value(both, "ground_slope_y_deg"), slope * std::sin(angle), 1e-12);
    const SampledTrial alone = Sample(Read(direction), seed);
    EXPECT_NEAR(Value(alone, "ground_slope_direction_x"), std::cos(angle), 1e-12);
    EXPECT_NEAR(Value(alone, "ground_slope_direction_y"), std::sin(angle), 1e-12);
  }
  EXPECT_EQ(Sample(Read("ground_slope_deg: {uniform: [-3, 3]}\n"), 1).values.size(), 1U) << "its sign says it all";
}

TEST_F(DisturbancesTest, ExtremesAreWhatCanComeOut) {
  const Disturbances wide = Read(
      "mass_scale: {uniform: [0.9, 1.1]}\nfriction: {normal: {mean: 0.7, std: 0.1}}\nlatency_s: {choice: [0.02, "
      "0.01]}\n"
      "com_shift_m: {uniform: [0.01, 0.02]}\nstart: {joints_rad: {uniform: [-0.01, 0.02]}}\n"
      "pushes:\n  - {size_n: {uniform: [5, 50]}, at_s: {uniform: [0.5, 1.5]}, place: {choice: [base, robot]}}\n");
  const SampledTrial low = ExtremeTrial(wide, model_, plan_, RangeEnd::kLowest);
  const SampledTrial high = ExtremeTrial(wide, model_, plan_, RangeEnd::kHighest);
  for (std::uint64_t seed = 0; seed < 50; ++seed) {
    const SampledTrial any = Sample(wide, seed);
    ASSERT_EQ(any.options.size(), low.options.size());
    for (std::size_t i = 0; i < any.options.size(); ++i) {
      EXPECT_EQ(any.options[i].key, low.options[i].key);
      EXPECT_LE(low.options[i].value, any.options[i].value) << any.options[i].key;
      EXPECT_GE(high.options[i].value, any.options[i].value) << any.options[i].key;
    }
    EXPECT_GE(high.start_joints.minCoeff(), any.start_joints.maxCoeff());
  }
  ASSERT_EQ(high.pushes.size(), 1U);
  EXPECT_EQ(high.pushes[0].at_s, 1.5);
  EXPECT_NEAR(high.pushes[0].force_W.norm(), 50.0, 1e-9);
  EXPECT_NEAR(Value(high, "com_shift_x_m"), 0.02, 1e-12);
  EXPECT_NEAR(Value(low, "com_shift_z_m"), -0.02, 1e-12);
}

TEST_F(DisturbancesTest, FactorsAndOffsetsGoTogetherWithWhatIsSetAndValuesTakeItsPlace) {
  SensorOptions sensors;
  const Disturbances some =
      ReadDisturbances(
          "mass_scale: 1.1\nlatency_s: 0.002\nfriction: 0.5\nground_slope_deg: 2\ncom_shift_m: 0.01\n"
          "stiffness_scale: 0.9\nsensors: {encoder_noise_rad: 0.001}\n",
          sensors.Fields(), "test")
          .value();
  EXPECT_EQ(DrawnInPlaceOf(some, {"play.mass_scale", "command_delay_s", "play.com_shift_x_m", "gains.stiffness_scale"}),
            std::vector<std::string>());
  EXPECT_EQ(DrawnInPlaceOf(some, {"sensors.encoder_noise_rad", "play.friction", "play.ground_bumps_m"}),
            (std::vector<std::string>{"friction", "sensors.encoder_noise_rad"}));
  const SampledTrial trial = Sample(some, 1);
  const auto effect = [&](const std::string& key) {
    for (const DrawnOption& option : trial.options) {
      if (option.key == key) return option.effect;
    }
    ADD_FAILURE() << key;
    return DisturbanceEffect::kValue;
  };
  EXPECT_EQ(effect("play.mass_scale"), DisturbanceEffect::kFactor);
  EXPECT_EQ(effect("gains.stiffness_scale"), DisturbanceEffect::kFactor);
  EXPECT_EQ(effect("command_delay_s"), DisturbanceEffect::kOffset);
  EXPECT_EQ(effect("play.com_shift_y_m"), DisturbanceEffect::kOffset);
  EXPECT_EQ(effect("play.friction"), DisturbanceEffect::kValue);
  for (const SampledValue& one : trial.values) {
    if (one.name == "sensors.encoder_noise_rad") {
      EXPECT_EQ(one.unit, "rad");
    }
  }
}

TEST_F(DisturbancesTest, APushBeyondAllBoundsIsRefused) {
  Disturbances hard;
  hard.pushes = {{{"size_of_weight", Distribution::Uniform(0.0, 2e5 / model_.weight_n())}}};
  EXPECT_THROW((void)Sample(hard, 1), InvalidArgument);
  hard.pushes = {{{"size_n", Distribution::Fixed(1e5)}}};
  EXPECT_EQ(Sample(hard, 1).pushes.size(), 1U);
}

TEST_F(DisturbancesTest, EveryRuleIsWithinTheOptionThatItSets) {
  PlayOptions play;
  const OptionFields fields = Prefixed("play", play.Fields());
  int compared = 0;
  for (const DisturbanceRule& rule : DisturbanceRules()) {
    for (const OptionField& field : fields) {
      if (field.key != rule.option) continue;
      EXPECT_GE(rule.lowest, field.lowest) << rule.key;
      EXPECT_LE(rule.highest, field.highest) << rule.key;
      ++compared;
    }
  }
  EXPECT_GT(compared, 15);
}

TEST_F(DisturbancesTest, JointsStartEachByItsOwn) {
  const SampledTrial trial = Sample(Read("start: {joints_rad: {uniform: [-0.01, 0.01]}}\n"), 5);
  ASSERT_EQ(trial.start_joints.size(), model_.num_dofs());
  EXPECT_NE(trial.start_joints[0], trial.start_joints[1]);
  EXPECT_LE(trial.start_joints.cwiseAbs().maxCoeff(), 0.01);
  EXPECT_EQ(Value(trial, "start.joint." + model_.dof_names[3] + "_rad"), trial.start_joints[3]);
}

}  // namespace
}  // namespace gaitwright
