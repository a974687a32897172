// SPDX-License-Identifier: BSD-3-Clause
#include "workflows/study/run_sweep.h"

#include <gtest/gtest.h>

#include <atomic>
#include <filesystem>
#include <fstream>

#include "kinematics/base/file.h"
#include "kinematics/model/load_robot.h"
#include "tests/scratch_folder.h"
#include "workflows/study/tune.h"

namespace gaitwright {
namespace {

/// A short walk of the a1 at two speeds, one of which is infeasible, each played with two gains.
Study ShortStudy() {
  Study study;
  study.model = *LoadNamedRobot("a1");
  study.walk.gait = "trot";
  study.walk.command.distance_m = 0.3;
  study.axes = ParseAxes({"stabilised.dcm_gain=1,1.5", "speed=0.3,4"}, StudyLayout::kGrid);
  study.points = GridPoints(study.axes);
  study.metrics = {"goal_error_m", "torque_use_max"};
  study.trials = 2;
  study.play_trial = [](const RobotModel&, const MotionPlan& plan, const PlayRequest& play, int number) {
    return TrialWorth{play.stabilised.dcm_gain * plan.duration_s() + number, number == 0};
  };
  return study;
}

std::vector<PointOutcome> RunWith(const Study& study, int threads) {
  JobJournal none;
  const Result<std::vector<PointOutcome>> outcomes = RunSweep(study, none, {threads});
  EXPECT_TRUE(outcomes);
  return *outcomes;
}

TEST(RunSweep, GivesEachPointInItsPlaceForAnyNumberOfThreads) {
  const Study study = ShortStudy();
  const std::vector<PointOutcome> outcomes = RunWith(study, 1);
  ASSERT_EQ(outcomes.size(), 4U);
  for (const std::size_t stands : {0U, 2U}) {
    EXPECT_EQ(outcomes[stands].point, stands);
    EXPECT_EQ(outcomes[stands].status, PointStatus::kPass) << outcomes[stands].reason;
    EXPECT_GT(outcomes[stands].score, 50.0);
    EXPECT_EQ(outcomes[stands].metrics.size(), 2U);
    ASSERT_TRUE(outcomes[stands].survival);
    EXPECT_EQ(outcomes[stands].survival->survived, 1);
  }
  EXPECT_NE(outcomes[0].metrics, outcomes[2].metrics) << "the gain matters";
  for (const std::size_t refused : {1U, 3U}) {
    EXPECT_EQ(outcomes[refused].status, PointStatus::kRefused);
    EXPECT_FALSE(outcomes[refused].code.empty());
    EXPECT_FALSE(outcomes[refused].reason.empty());
    EXPECT_FALSE(outcomes[refused].survival);
  }
  EXPECT_EQ(outcomes, RunWith(study, 3));

  // Interrupted after one point and a second one with a truncated line.
  const std::filesystem::path path = ScratchFile("sweep.so-far");
  std::filesystem::remove(path);
  {
    Result<JobJournal> journal = JobJournal::Open(path.string(), StudyIdentity(study, ""), false);
    ASSERT_TRUE(journal);
    std::atomic<int> begun = 0;
    const Result<std::vector<PointOutcome>> cut = RunSweep(study, *journal, {1, {}, [&] { return begun++ >= 2; }});
    ASSERT_FALSE(cut);
    EXPECT_EQ(cut.failure().code, FailureCode::kInterrupted);
  }
  std::filesystem::resize_file(path, std::filesystem::file_size(path) - 5);
  Result<JobJournal> journal = JobJournal::Open(path.string(), StudyIdentity(study, ""), true);
  ASSERT_TRUE(journal) << journal.failure().message;
  EXPECT_EQ(journal->found(), 1U);
  const Result<std::vector<PointOutcome>> resumed = RunSweep(study, *journal, {2});
  ASSERT_TRUE(resumed);
  EXPECT_EQ(*resumed, outcomes);
  journal->Remove();
}

TEST(RunSweep, PointsThatShareAPlanArePlannedOnce) {
  Study study = ShortStudy();
  study.axes = ParseAxes({"stabilised.dcm_gain=1,1.5", "speed=0.3,0.35"}, StudyLayout::kGrid);
  study.points = GridPoints(study.axes);
  StudyPlans plans(study, {0, 1, 2, 3});
  const StudyPlans::Shared first = plans.Take(0), second = plans.Take(2), other = plans.Take(1);
  EXPECT_EQ(first, second);
  EXPECT_NE(first, other);
  EXPECT_EQ(plans.made(), 2);
  EXPECT_EQ(OrderByPlan(study, {0, 1, 2, 3}), (std::vector<std::size_t>{0, 2, 1, 3}));
  EXPECT_EQ(OrderByPlan(study, {1, 2, 3}), (std::vector<std::size_t>{1, 3, 2}));
}

TEST(RunSweep, TheIdentityIsThatOfTheWork) {
  const Study study = ShortStudy();
  const std::string identity = StudyIdentity(study, "");
  EXPECT_EQ(identity, StudyIdentity(ShortStudy(), ""));
  EXPECT_NE(identity, StudyIdentity(study, "mass_scale: 1.1"));
  Study other = study;
  other.walk.command.distance_m = 0.4;
  EXPECT_NE(identity, StudyIdentity(other, ""));
  other = study;
  other.play.play.world.friction = 0.5;
  EXPECT_NE(identity, StudyIdentity(other, ""));
  other = study;
  other.points.pop_back();
  EXPECT_NE(identity, StudyIdentity(other, ""));
}

TEST(RunSweep, TheIdentityIsOfWhatStandsInFilesToo) {
  const auto in = [](const std::string& name) { return ScratchFile(name); };
  const auto write = [&](const std::string& name, const std::string& text) { std::ofstream(in(name)) << text; };
  Study study = ShortStudy();
  study.walk.terrain = in("yard.yaml");
  study.walk.gait = in("own.yaml:hop");
  study.walk.sequence = in("parts.yaml");
  write("bed.csv", "0,0\n0,0\n");
  write("yard.yaml", "builtin: flat\nfiles: ['bed.csv:resolution_m=0.1']\n");
  write("own.yaml", "hop: {feet: 4, cycle_s: 0.5, duty_factor: 0.6, phase: [0, 0.5, 0.5, 0]}\n");
  write("others.yaml", "skip: {feet: 4, cycle_s: 0.5, duty_factor: 0.6, phase: [0, 0.5, 0.5, 0]}\n");
  write("parts.yaml", "- {gait: 'others.yaml:skip', duration: 1}\n");
  const std::string identity = StudyIdentity(study, "");
  EXPECT_EQ(identity, StudyIdentity(study, ""));
  TuneOptions tune;
  const std::string of_tuning = TuneIdentity(study, tune, "");
  for (const std::string name : {"bed.csv", "yard.yaml", "own.yaml", "others.yaml", "parts.yaml"}) {
    const std::string before = ReadFile(in(name)).value();
    write(name, before + (name == "bed.csv" ? "0,0.01\n" : "# another word\n"));
    EXPECT_NE(identity, StudyIdentity(study, "")) << name;
    EXPECT_NE(of_tuning, TuneIdentity(study, tune, "")) << name;
    std::filesystem::remove(in(name));
    EXPECT_NE(identity, StudyIdentity(study, "")) << name;
    write(name, before);
    EXPECT_EQ(identity, StudyIdentity(study, "")) << name;
  }
  for (const std::string name : {"bed.csv", "yard.yaml", "own.yaml", "others.yaml", "parts.yaml"})
    std::filesystem::remove(in(name));
}

TEST(RunSweep, WhatACallerGetsWrongAtAPointIsItsRefusal) {
  Study study = ShortStudy();
  study.walk.gait = "no such gait";
  study.points.resize(1);
  const std::vector<PointOutcome> outcomes = RunWith(study, 1);
  EXPECT_EQ(outcomes[0].status, PointStatus::kRefused);
  EXPECT_NE(outcomes[0].reason.find("no such gait"), std::string::npos);
}

}  // namespace
}  // namespace gaitwright
