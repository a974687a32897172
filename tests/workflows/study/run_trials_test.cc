// SPDX-License-Identifier: BSD-3-Clause
#include "workflows/study/run_trials.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>

#include "kinematics/base/file.h"
#include "playback/log/log_json.h"
#include "playback/score/reason.h"
#include "tests/playback/standing_plan.h"
#include "tests/scratch_folder.h"

namespace gaitwright {
namespace {

namespace fs = std::filesystem;

/// A robot that stands and is pushed, sometimes over.
class RunTrialsTest : public testing::Test {
 protected:
  RunTrialsTest() {
    request_.play.world.solver_iterations = 20;
    request_.controller = "joint-pd";
    disturbances_ = ReadDisturbances(
                        "mass_scale: {uniform: [0.8, 1.2]}\nground_bumps_m: {uniform: [0, 0.005]}\n"
                        "start: {roll_rad: {uniform: [-0.05, 0.05]}}\n"
                        "pushes:\n  - {size_n: {uniform: [0, 900]}, at_s: 0.1, duration_s: 0.1}\n",
                        {}, "test")
                        .value();
    folder_ = ScratchFolder() / testing::UnitTest::GetInstance()->current_test_info()->name();
    fs::create_directories(folder_);
  }
  ~RunTrialsTest() override { fs::remove_all(folder_); }

  TrialStudy Study() const { return {model_, plan_, request_, disturbances_}; }
  TrialOptions Some(int n, int threads = 1) const {
    TrialOptions options;
    options.trials = n;
    options.threads = threads;
    return options;
  }
  std::string Journal() const { return (folder_ / "run.so-far").string(); }
  std::string JsonOf(const TrialOptions& options, const TrialHooks& hooks = {}) const {
    const auto report = RunTrials(Study(), options, hooks);
    EXPECT_TRUE(report.ok()) << report.failure().message;
    return report.ok() ? RobustnessJson(*report) : "";
  }
  /// Runs until `count` more trials are in the journal.
  void Interrupt(const TrialOptions& options, int count, bool resume = false) const {
    int left = count;
    TrialHooks hooks{.journal = Journal(), .resume = resume};
    hooks.progress = [&](const TrialProgress&) { --left; };
    hooks.stop = [&] { return left <= 0; };
    const auto report = RunTrials(Study(), options, hooks);
    ASSERT_FALSE(report.ok());
    EXPECT_EQ(report.failure().code, FailureCode::kInterrupted);
    EXPECT_NE(report.failure().suggestions.at(0).text.find("--resume"), std::string::npos);
  }

  const RobotModel model_ = standing::Load("a1");
  const MotionPlan plan_ = standing::Plan(model_, 0.6);
  PlayRequest request_;
  Disturbances disturbances_;
  fs::path folder_;
};

TEST_F(RunTrialsTest, ThreadsChangeNothing) {
  const std::string one = JsonOf(Some(8, 1));
  EXPECT_EQ(JsonOf(Some(8, 3)), one);
  TrialOptions other = Some(8, 1);
  other.seed = 1;
  EXPECT_NE(JsonOf(other), one);
}

TEST_F(RunTrialsTest, SomeFallAndSomeStand) {
  const RobustnessReport report = RunTrials(Study(), Some(12)).value();
  EXPECT_GT(report.survived, 0);
  EXPECT_LT(report.survived, 12);
  EXPECT_FALSE(report.causes.empty());
  EXPECT_EQ(report.subject.plan_hash, MotionHash(plan_));
  for (const TrialOutcome& outcome : report.outcomes) {
    EXPECT_EQ(outcome.cause.empty(), outcome.passed) << outcome.reason;
    EXPECT_EQ(IsCauseOfFall(outcome.cause), !outcome.survived) << outcome.cause;
  }
  ASSERT_FALSE(report.worst.empty());
  const TrialOutcome& worst = report.Outcome(report.worst[0]);
  const PlayedTrial again = PlayTrial(Study(), worst.number, worst.seed).value();
  EXPECT_EQ(again.outcome, worst);
  EXPECT_TRUE(LogToJson(again.played.log) == LogToJson(PlayTrial(Study(), 99, worst.seed).value().played.log));
  EXPECT_EQ(SamplesHash(again.played.log), worst.log_hash);
}

TEST_F(RunTrialsTest, WhatIsSampledReachesThePlayback) {
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

TEST_F(RunTrialsTest, AnInterruptedRunIsResumedToTheSameBytes) {
  const std::string whole = JsonOf(Some(7));
  Interrupt(Some(7), 2);
  Interrupt(Some(7), 3, true);
  ASSERT_TRUE(fs::exists(Journal()));
  int played = 0;
  TrialHooks hooks{.journal = Journal(), .resume = true};
  hooks.progress = [&](const TrialProgress&) { ++played; };
  EXPECT_EQ(JsonOf(Some(7, 2), hooks), whole);
  EXPECT_EQ(played, 2);
  EXPECT_FALSE(fs::exists(Journal()));
}

TEST_F(RunTrialsTest, WhatIsDoneBeyondTheEndOfAResumedRunIsKept) {
  const std::string whole = JsonOf(Some(6));
  Interrupt(Some(6), 4);
  EXPECT_EQ(JsonOf(Some(2), {.journal = Journal(), .resume = true}), JsonOf(Some(2)));
  ASSERT_TRUE(fs::exists(Journal()));
  TrialOptions narrow = Some(6);
  narrow.until_width = 0.99;
  narrow.until_least = 1;
  TrialBook book = TrialBook::Open(Study(), narrow, {.journal = Journal(), .resume = true}).value();
  EXPECT_EQ(book.Report().value().n, 1) << "narrow enough";
  EXPECT_EQ(book.beyond(), 3);
  book.Close();
  { const TrialBook let_go = std::move(book); }
  int played = 0;
  TrialHooks hooks{.journal = Journal(), .resume = true};
  hooks.progress = [&](const TrialProgress&) { ++played; };
  EXPECT_EQ(JsonOf(Some(6), hooks), whole);
  EXPECT_EQ(played, 2);
  EXPECT_FALSE(fs::exists(Journal()));
}

TEST_F(RunTrialsTest, ATornLastLineIsDropped) {
  const std::string whole = JsonOf(Some(4));
  Interrupt(Some(4), 3);
  const std::string text = ReadFile(Journal()).value();
  for (const std::size_t cut : {std::size_t{1}, std::size_t{40}, text.size() - 5}) {
    std::ofstream(Journal(), std::ios::binary | std::ios::trunc) << text.substr(0, text.size() - cut);
    EXPECT_EQ(JsonOf(Some(4), {.journal = Journal(), .resume = true}), whole) << cut;
  }
}

TEST_F(RunTrialsTest, AJournalOfAnotherRunIsRefused) {
  Interrupt(Some(4), 2);
  const auto refused = [&](const TrialOptions& options, bool resume, const std::string& part) {
    const auto report = RunTrials(Study(), options, {.journal = Journal(), .resume = resume});
    ASSERT_FALSE(report.ok());
    EXPECT_EQ(report.failure().code, FailureCode::kSoFar);
    EXPECT_NE(report.failure().message.find(part), std::string::npos) << report.failure().message;
  };
  refused(Some(4), false, "unfinished work");
  TrialOptions seeded = Some(4);
  seeded.seed = 5;
  refused(seeded, true, "other work");
  request_.play.hold_s = 0.1;
  refused(Some(4), true, "other work");
  request_.play.hold_s = PlayOptions().hold_s;
  disturbances_.figures[0].distribution = Distribution::Fixed(1.0);
  refused(Some(4), true, "other work");
}

TEST_F(RunTrialsTest, ABrokenOutcomeInTheJournalIsRefused) {
  Interrupt(Some(4), 2);
  const std::string text = ReadFile(Journal()).value();
  const auto expect_broken = [&](const std::string& part, const std::string& by) {
    std::string broken = text;
    broken.replace(broken.find(part), part.size(), by);
    std::ofstream(Journal(), std::ios::binary | std::ios::trunc) << broken;
    const auto report = RunTrials(Study(), Some(4), {.journal = Journal(), .resume = true});
    ASSERT_FALSE(report.ok());
    EXPECT_EQ(report.failure().code, FailureCode::kJournalLine);
    EXPECT_NE(report.failure().message.find("is damaged at trial"), std::string::npos) << report.failure().message;
  };
  expect_broken("\"survived\"", "\"surived\"");
  expect_broken("\"number\":", "\"number\":1");
}

TEST_F(RunTrialsTest, StopsEarlyWhereTheIntervalIsNarrowWhoeverIsQuick) {
  disturbances_.pushes.clear();  // nobody falls
  TrialOptions options = Some(40, 1);
  options.until_width = 0.5;
  options.until_least = 3;
  const RobustnessReport report = RunTrials(Study(), options).value();
  EXPECT_EQ(report.survived, report.n);
  EXPECT_LT(report.survival.width(), 0.5);
  EXPECT_GE(WilsonInterval(report.n - 1, report.n - 1).width(), 0.5);
  options.threads = 3;
  EXPECT_EQ(RobustnessJson(RunTrials(Study(), options).value()), RobustnessJson(report));
  options.until_least = report.n + 2;
  EXPECT_EQ(RunTrials(Study(), options).value().n, report.n + 2);
}

TEST_F(RunTrialsTest, TheBookEndsInOrderWhateverArrivesFirst) {
  TrialOptions options = Some(10);
  options.until_width = 0.6;
  options.until_least = 4;
  TrialBook book = TrialBook::Open(Study(), options, {}).value();
  const auto outcome = [](int number) {
    TrialOutcome o;
    o.number = number;
    o.survived = true;
    return o;
  };
  for (int i = 0; i < 8; ++i) EXPECT_EQ(book.Next(), i);
  for (const int i : {7, 6, 5, 3, 2, 1}) book.Add(outcome(i));
  EXPECT_FALSE(book.complete());
  EXPECT_EQ(book.Report().failure().code, FailureCode::kInterrupted);
  book.Add(outcome(0));
  EXPECT_TRUE(book.complete());
  EXPECT_FALSE(book.Next().has_value());
  EXPECT_EQ(book.Report().value().n, 4);
}

TEST_F(RunTrialsTest, WhatCannotBePlayedIsRefusedBeforeTheFirstTrial) {
  const auto refusal = [&] {
    TrialHooks hooks{.journal = Journal()};
    hooks.progress = [](const TrialProgress&) { ADD_FAILURE() << "a trial was played"; };
    const auto report = RunTrials(Study(), Some(4, 2), hooks);
    EXPECT_FALSE(report.ok());
    EXPECT_FALSE(fs::exists(Journal()));
    EXPECT_FALSE(PlayTrial(Study(), 0, 1).ok()) << "nor is one by itself";
    return report.ok() ? Failure() : report.failure();
  };
  const Disturbances before = disturbances_;
  disturbances_.pushes[0][1].distribution = Distribution::Uniform(0.1, 1.0);  // most are in time
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

TEST_F(RunTrialsTest, ADelayIsRoundedToWhatMayBe) {
  SampledTrial late;
  late.options = {{"command_delay_s", 0.1, DisturbanceEffect::kOffset}};
  request_.play.world.step_s = 0.008;
  EXPECT_NEAR(DisturbedRequest(request_, late).sensing.command_delay_s, 0.096, 1e-12) << "thirteen steps are too many";
  request_.play.world.step_s = 0.001;
  EXPECT_NEAR(DisturbedRequest(request_, late).sensing.command_delay_s, 0.1, 1e-12);
}

TEST_F(RunTrialsTest, WhatIsDrawnGoesTogetherWithWhatIsSet) {
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

TEST_F(RunTrialsTest, WhatIsSaidTwiceIsRefusedAndLeftOutOfTheStandardSet) {
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

TEST_F(RunTrialsTest, RatesThatAreDrawnAreOnesAtWhichASensorCanBeRead) {
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

TEST_F(RunTrialsTest, TheReportSaysHowToRepeatOne) {
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

TEST_F(RunTrialsTest, PhysicsThatBlowsUpIsAFallAndNotTheEndOfTheRun) {
  disturbances_.pushes.clear();  // which fell it before
  for (const double at_s : {0.0, 0.3}) {
    request_.play.more_pushes = {{Vector3(0.0, std::nan(""), 0.0), at_s, 0.1, "base"}};
    const auto report = RunTrials(Study(), Some(3, 2));
    ASSERT_TRUE(report.ok()) << report.failure().message;
    EXPECT_EQ(report->survived, 0);
    ASSERT_EQ(report->causes.size(), 1U);
    EXPECT_EQ(report->causes[0].what, "the physics came to no number");
    for (const TrialOutcome& outcome : report->outcomes) {
      EXPECT_NEAR(outcome.ended_s, at_s, 0.01);
      EXPECT_NE(outcome.reason.find("the physics gave a state that is not finite"), std::string::npos)
          << outcome.reason;
      EXPECT_EQ(OutcomeFromLine(OutcomeToLine(outcome)), outcome);
    }
  }
}

TEST_F(RunTrialsTest, TheBookCountsWhatItHas) {
  TrialOptions options = Some(10);
  options.until_width = 0.6;
  options.until_least = 4;
  TrialProgress last;
  TrialHooks hooks;
  hooks.progress = [&](const TrialProgress& p) { last = p; };
  TrialBook book = TrialBook::Open(Study(), options, hooks).value();
  const auto add = [&](int number, bool survived) {
    TrialOutcome o;
    o.number = number;
    o.survived = survived;
    book.Add(o);
  };
  for (const int i : {9, 5, 3, 2, 1}) add(i, i != 2);
  EXPECT_EQ(last.done, 5);
  EXPECT_EQ(last.survived, 4);
  EXPECT_EQ(last.wanted, 10);
  add(0, true);
  add(4, true);
  const int end = book.progress().wanted;
  EXPECT_LT(end, 10) << "narrow enough";
  EXPECT_EQ(book.progress().done, end);
  EXPECT_EQ(book.progress().survived, end - 1);
}

}  // namespace
}  // namespace gaitwright
