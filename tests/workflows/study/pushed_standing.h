// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "tests/playback/standing_plan.h"
#include "tests/scratch_folder.h"
#include "workflows/study/run_trials.h"

namespace gaitwright {

/// A standing robot that is pushed and sometimes falls.
class PushedStanding : public testing::Test {
 protected:
  PushedStanding() {
    request_.play.world.solver_iterations = 20;
    request_.controller = "joint-pd";
    disturbances_ = ReadDisturbances(
                        "mass_scale: {uniform: [0.8, 1.2]}\nground_bumps_m: {uniform: [0, 0.005]}\n"
                        "start: {roll_rad: {uniform: [-0.05, 0.05]}}\n"
                        "pushes:\n  - {size_n: {uniform: [0, 900]}, at_s: 0.1, duration_s: 0.1}\n",
                        {}, "test")
                        .value();
    folder_ = ScratchFolder() / testing::UnitTest::GetInstance()->current_test_info()->name();
    std::filesystem::create_directories(folder_);
  }
  ~PushedStanding() override { std::filesystem::remove_all(folder_); }

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
  std::filesystem::path folder_;
};

}  // namespace gaitwright
