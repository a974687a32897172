// SPDX-License-Identifier: BSD-3-Clause
#include "workflows/study/trial.h"

#include <algorithm>
#include <cmath>

#include "tests/workflows/study/pushed_standing.h"

namespace gaitwright {
namespace {

using TrialOfStanding = PushedStanding;

TEST_F(TrialOfStanding, WhatIsSampledReachesThePlayback) {
  const PlayedTrial trial = PlayTrial(Study(), 0, 7).value();
  for (const SampledValue& one : trial.outcome.sampled) {
    const auto said = std::find_if(trial.played.log.options.begin(), trial.played.log.options.end(),
                                   [&](const auto& option) { return option.first == "trial." + one.name; });
    ASSERT_NE(said, trial.played.log.options.end()) << one.name;
    if (one.name == "mass_scale") {
      EXPECT_NEAR(trial.played.log.total_mass_kg, one.value * model_.total_mass_kg, 1e-9);
    }
  }
}

TEST_F(TrialOfStanding, WhatCannotBePlayedIsRefusedBeforeTheFirstTrial) {
  const auto refusal = [&] {
    TrialHooks hooks{.journal = Journal()};
    hooks.progress = [](const TrialProgress&) { ADD_FAILURE() << "a trial was played"; };
    const auto report = RunTrials(Study(), Some(4, 2), hooks);
    EXPECT_FALSE(report.ok());
    EXPECT_FALSE(std::filesystem::exists(Journal()));
    EXPECT_FALSE(PlayTrial(Study(), 0, 1).ok()) << "nor is one by itself";
    return report.ok() ? Failure() : report.failure();
  };
  const Disturbances before = disturbances_;
  disturbances_.pushes[0][1].distribution = Distribution::Uniform(0.1, 1.0);  // most come before the end of the plan
  EXPECT_EQ(refusal().code, FailureCode::kLatePush);
  EXPECT_NE(refusal().message.find("the push begins at 1 s"), std::string::npos) << refusal().message;
  disturbances_.pushes[0] = {{"size_n", Distribution::Fixed(1.0)},
                             {"place", Distribution::OneOf(std::vector<std::string>{"base", "nowhere"})}};
  EXPECT_EQ(refusal().code, FailureCode::kDisturbances);
  EXPECT_NE(refusal().message.find("'nowhere'"), std::string::npos) << refusal().message;
  disturbances_ = before;
  disturbances_.figures.push_back({"sensor_noise_scale", Distribution::Uniform(0.0, 3.0)});
  request_.sensing.sensors.contact_noise = 0.4;
  EXPECT_NE(refusal().message.find("'sensors.contact_noise'"), std::string::npos) << refusal().message;
  EXPECT_NE(refusal().message.find("with a sensor_noise_scale of 3"), std::string::npos) << refusal().message;
  request_.sensing.sensors.contact_noise = 0.3;
  disturbances_.figures.push_back({"sensors.contact_noise", Distribution::Uniform(0.0, 0.5)});
  EXPECT_NE(refusal().message.find("'sensors.contact_noise' is 1.5"), std::string::npos) << refusal().message;
  disturbances_.figures.back().distribution = Distribution::Uniform(0.0, 0.3);
  EXPECT_TRUE(RunTrials(Study(), Some(1)).ok()) << "as large as it may be";
  TrialOptions none = Some(0);
  EXPECT_THROW((void)RunTrials(Study(), none), InvalidArgument);
}

TEST_F(TrialOfStanding, ADelayIsRoundedToWhatMayBe) {
  SampledTrial late;
  late.options = {{"command_delay_s", 0.1, DisturbanceEffect::kOffset}};
  request_.play.world.step_s = 0.008;
  EXPECT_NEAR(DisturbedRequest(request_, late).sensing.command_delay_s, 0.096, 1e-12) << "thirteen steps are too many";
  request_.play.world.step_s = 0.001;
  EXPECT_NEAR(DisturbedRequest(request_, late).sensing.command_delay_s, 0.1, 1e-12);
}

TEST_F(TrialOfStanding, WhatIsDrawnGoesTogetherWithWhatIsSet) {
  request_.play.world.mass_scale = 1.5;
  request_.sensing.command_delay_s = 0.03;
  SampledTrial drawn;
  drawn.options = {{"play.mass_scale", 0.8, DisturbanceEffect::kFactor},
                   {"command_delay_s", 0.004, DisturbanceEffect::kOffset},
                   {"play.friction", 0.5}};
  const PlayRequest disturbed = DisturbedRequest(request_, drawn);
  EXPECT_DOUBLE_EQ(disturbed.play.world.mass_scale, 1.2);
  EXPECT_NEAR(disturbed.sensing.command_delay_s, 0.034, 1e-12);
  EXPECT_EQ(disturbed.play.world.friction, 0.5);
  EXPECT_TRUE(RunTrials(Study(), Some(1)).ok());
  request_.sensing.command_delay_s = 0.1;
  disturbances_.figures.push_back({"latency_s", Distribution::Uniform(0.0, 0.004)});
  EXPECT_EQ(RunTrials(Study(), Some(1)).failure().code, FailureCode::kDisturbances) << "too late in all";
}

TEST_F(TrialOfStanding, WhatIsSaidTwiceIsRefusedAndLeftOutOfTheStandardSet) {
  request_.play.world.ground_bumps_m = 0.01;
  const auto twice = RunTrials(Study(), Some(1));
  ASSERT_FALSE(twice.ok());
  EXPECT_EQ(twice.failure().code, FailureCode::kSaidTwice);
  EXPECT_NE(twice.failure().message.find("'ground_bumps_m'"), std::string::npos) << twice.failure().message;
  const auto has = [](const Disturbances& d, const std::string& key) {
    return std::any_of(d.figures.begin(), d.figures.end(), [&](const Disturbance& f) { return f.key == key; });
  };
  EXPECT_EQ(StandardBesides(model_, {}), StandardDisturbances(model_));
  const Disturbances besides = StandardBesides(model_, request_, {"play.ground_slope_deg", "play.mass_scale"});
  EXPECT_FALSE(has(besides, "ground_bumps_m"));
  EXPECT_FALSE(has(besides, "ground_slope_deg"));
  EXPECT_FALSE(has(besides, "ground_slope_direction_deg")) << "it would turn the slope that is said";
  EXPECT_TRUE(has(besides, "mass_scale")) << "it multiplies";
  EXPECT_TRUE(has(besides, "friction"));
  disturbances_ = besides;
  EXPECT_TRUE(RunTrials(Study(), Some(1)).ok());
}

TEST_F(TrialOfStanding, RatesThatAreDrawnAreOnesAtWhichASensorCanBeRead) {
  SampledTrial trial;
  trial.options = {{"sensors.imu_rate_hz", 400.0, DisturbanceEffect::kValue},
                   {"sensors.encoder_rate_hz", 2000.0, DisturbanceEffect::kValue}};
  const PlayRequest disturbed = DisturbedRequest(request_, trial);
  EXPECT_NEAR(disturbed.sensing.sensors.imu_rate_hz, 1000.0 / 3.0, 1e-9);
  EXPECT_NEAR(disturbed.sensing.sensors.encoder_rate_hz, 1000.0, 1e-9);
  request_.sensing.state = "estimated";
  request_.sensing.sensors.imu_rate_hz = 400.0;
  EXPECT_THROW(MakeController(model_, plan_, request_), InvalidArgument) << "what is set is to be met";
  for (const char* state : {"true", "measured"}) {
    request_.sensing.state = state;
    EXPECT_NO_THROW(MakeController(model_, plan_, request_)) << "no IMU is read";
  }
}

TEST_F(TrialOfStanding, TheReportSaysHowToRepeatOne) {
  request_.play.world.friction = 0.7;
  request_.sensing.state = "estimated";
  request_.sensing.sensors = SensorsOfKind("hobby");
  EXPECT_EQ(SubjectOf(Study(), 3).repeat,
            "gaitwright play PLAN --disturbances FILE --seed SEED --controller joint-pd --set state=estimated "
            "--sensors hobby --set play.solver_iterations=20 --set play.friction=0.7");
  request_ = {};
  disturbances_ = StandardBesides(model_, request_);
  EXPECT_EQ(SubjectOf(Study(), 3).repeat, "gaitwright play PLAN --disturbances standard --seed SEED");
}

}  // namespace
}  // namespace gaitwright
