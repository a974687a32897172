// SPDX-License-Identifier: BSD-3-Clause
#include "workflows/study/tune_search.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <filesystem>
#include <mutex>
#include <nlohmann/json.hpp>
#include <set>

#include "kinematics/base/random.h"
#include "tests/scratch_folder.h"
#include "workflows/study/tune_files.h"

namespace gaitwright {
namespace {

StudyAxis Range(const std::string& key, double low, double high) {
  return {.key = key, .unit = "1", .values = {}, .low = low, .high = high};
}

/// Noise of a trial: a part that all candidates share, and a part for each candidate.
double Noise(const StudyPoint& values, int number, double shared, double own) {
  std::uint64_t seed = static_cast<std::uint64_t>(number) * 1000003U;
  SplitMix common(seed);
  for (const std::string& value : values) seed = seed * 31U + static_cast<std::uint64_t>(std::stod(value) * 1e6);
  SplitMix each(seed);
  return shared * common.Normal() + own * each.Normal();
}

/// The optimum is at a = 0.7, b = 0.3; the present values are a = 0.2, b = 0.8.
double Hill(const StudyPoint& values) {
  const double a = std::stod(values[0]) - 0.7, b = std::stod(values[1]) - 0.3;
  return 80.0 - 60.0 * a * a - 40.0 * b * b - 20.0 * a * b;
}

TuneProblem Problem(const std::function<double(const StudyPoint&)>& mean, double shared, double own) {
  TuneProblem problem{{Range("a", 0.0, 1.0), Range("b", 0.0, 1.0)}, {"0.2", "0.8"}, {}};
  problem.judge = [=](const StudyPoint& values, int first, int count) {
    CandidateWorth worth;
    for (int number = first; number < first + count; ++number)
      worth.trials.push_back({std::clamp(mean(values) + Noise(values, number, shared, own), 0.0, 100.0), true});
    return worth;
  };
  return problem;
}

TuneResult Searched(const TuneProblem& problem, const TuneOptions& options, std::uint64_t seed = 1, int threads = 1) {
  JobJournal none;
  Result<TuneResult> result = SearchTuning(problem, options, seed, none, {threads});
  EXPECT_TRUE(result);
  return std::move(*result);
}

/// Distance of the favourite from the optimum.
double Missed(const TuneResult& result) {
  const StudyPoint& values = result.candidates[result.favourite].values;
  return std::hypot(std::stod(values[0]) - 0.7, std::stod(values[1]) - 0.3);
}

TEST(TuneSearch, ASmoothHillIsClimbedByItsSurface) {
  const TuneResult result = Searched(Problem(Hill, 10.0, 0.5), {.evaluations = 40});
  EXPECT_LT(Missed(result), 0.1);
  EXPECT_TRUE(result.better());
  ASSERT_TRUE(result.proof);
  EXPECT_GT(result.proof->value.low, 10.0) << "the usual values lie 21 below the top";
  ASSERT_TRUE(result.surface);
  EXPECT_GT(result.surface->predicted, 0.9);
  EXPECT_EQ(result.candidates.size(), 40U);
  EXPECT_EQ(result.candidates.front().found_by, "usual");
  EXPECT_EQ(result.candidates.back().found_by, "surface");
}

TEST(TuneSearch, ARoughHillIsClimbedByCmaEs) {
  const auto cliffs = [](const StudyPoint& values) {
    const double a = std::abs(std::stod(values[0]) - 0.7), b = std::abs(std::stod(values[1]) - 0.3);
    return 60.0 - 40.0 * std::sqrt(a) - 30.0 * std::sqrt(b) + 8.0 * std::cos(40.0 * a) * std::cos(40.0 * b);
  };
  TuneOptions options{.evaluations = 90};
  options.method = "cma-es";
  const TuneResult result = Searched(Problem(cliffs, 5.0, 0.2), options);
  EXPECT_LT(Missed(result), 0.12);
  EXPECT_TRUE(result.better());
  EXPECT_EQ(result.candidates.back().found_by, "cma-es");
}

TEST(TuneSearch, NoiseAloneIsNoBetter) {
  int better = 0;
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const TuneResult result = Searched(Problem([](const StudyPoint&) { return 50.0; }, 5.0, 15.0),
                                       {.evaluations = 30, .trials = 5, .held_out = 100}, seed);
    const TuneCandidate& favourite = result.candidates[result.favourite];
    EXPECT_TRUE(result.favourite == 0 || *favourite.value > *result.candidates.front().value - 15.0);
    better += result.better() ? 1 : 0;
    EXPECT_TRUE(result.better() || result.chosen == 0U) << "the present values are kept";
  }
  EXPECT_LE(better, 2) << "the search finds lucky candidates; the proof does not believe them";
}

TEST(TuneSearch, TheProofUsesTrialsThatTheSearchNeverSaw) {
  TuneProblem problem = Problem(Hill, 5.0, 0.5);
  std::mutex mutex;
  std::set<int> searched, proved;
  const auto judge = problem.judge;
  constexpr int kTrials = 4, kHeldOut = 30;
  problem.judge = [&](const StudyPoint& values, int first, int count) {
    const std::lock_guard lock(mutex);
    for (int number = first; number < first + count; ++number) (first < 3 * kTrials ? searched : proved).insert(number);
    return judge(values, first, count);
  };
  const TuneResult result = Searched(problem, {.evaluations = 20, .trials = kTrials, .held_out = kHeldOut});
  ASSERT_TRUE(result.proof);
  EXPECT_EQ(proved.size(), static_cast<std::size_t>(kHeldOut));
  EXPECT_EQ(searched.size(), 3U * kTrials);
  for (const int number : proved) EXPECT_FALSE(searched.contains(number)) << number;
}

TEST(TuneSearch, RefusedCandidatesAreBornAndTheUsualOneStays) {
  TuneProblem problem = Problem(Hill, 5.0, 0.5);
  const auto judge = problem.judge;
  problem.judge = [&](const StudyPoint& values, int first, int count) -> CandidateWorth {
    if (std::stod(values[0]) > 0.5) return {"too fast", {}};
    return judge(values, first, count);
  };
  for (const char* method : {"auto", "surface", "cma-es"}) {
    TuneOptions options{.evaluations = 60};
    options.method = method;
    const TuneResult result = Searched(problem, options);
    const StudyPoint& values = result.candidates[result.favourite].values;
    EXPECT_LE(std::stod(values[0]), 0.5) << method;
    EXPECT_GT(Hill(values), 74.0) << method << ": at the edge of what is refused";
    EXPECT_TRUE(result.better()) << method;
    const bool some_refused = std::any_of(result.candidates.begin(), result.candidates.end(),
                                          [](const auto& c) { return !c.value && c.worth.refusal == "too fast"; });
    EXPECT_TRUE(some_refused);
  }
}

TEST(TuneSearch, WhereTheUsualValuesAreBestTheyAreKept) {
  TuneProblem problem = Problem(Hill, 5.0, 0.2);
  problem.usual = {"0.7", "0.3"};
  const TuneResult result = Searched(problem, {.evaluations = 30});
  EXPECT_FALSE(result.better());
  EXPECT_EQ(result.chosen, 0U);
}

TEST(TuneSearch, AUsualValueOutOfTheRangesIsACandidateAllTheSame) {
  TuneProblem problem = Problem(Hill, 5.0, 0.5);
  problem.axes[0] = Range("a", 0.5, 1.0);
  problem.usual = {"0", "0.8"};
  const TuneResult result = Searched(problem, {.evaluations = 30});
  EXPECT_EQ(result.candidates.front().values, (StudyPoint{"0", "0.8"}));
  EXPECT_TRUE(result.candidates.front().value.has_value());
  for (std::size_t i = 1; i < result.candidates.size(); ++i) EXPECT_GE(std::stod(result.candidates[i].values[0]), 0.5);
}

bool SameCandidates(const TuneResult& a, const TuneResult& b) {
  return std::equal(a.candidates.begin(), a.candidates.end(), b.candidates.begin(), b.candidates.end(),
                    [](const auto& x, const auto& y) { return x.values == y.values && x.worth == y.worth; }) &&
         a.finalists == b.finalists && a.chosen == b.chosen;
}

TEST(TuneSearch, ThreadsChangeNothingAndSeedsDo) {
  const TuneProblem problem = Problem(Hill, 10.0, 3.0);
  const TuneResult one = Searched(problem, {.evaluations = 40}, 1, 1);
  EXPECT_TRUE(SameCandidates(one, Searched(problem, {.evaluations = 40}, 1, 4)));
  EXPECT_FALSE(SameCandidates(one, Searched(problem, {.evaluations = 40}, 2, 1)));
}

TEST(TuneSearch, GoesOnWhereItWasCutOff) {
  TuneProblem problem = Problem(Hill, 10.0, 3.0);
  const TuneOptions options{.evaluations = 40};
  const TuneResult whole = Searched(problem, options);
  const std::filesystem::path path = ScratchFile("tune.so-far");
  std::filesystem::remove(path);
  std::atomic<int> judged = 0;
  const auto judge = problem.judge;
  problem.judge = [&](const StudyPoint& values, int first, int count) {
    ++judged;
    return judge(values, first, count);
  };
  {
    Result<JobJournal> journal = JobJournal::Open(path.string(), "tune", false);
    ASSERT_TRUE(journal);
    const Result<TuneResult> cut = SearchTuning(problem, options, 1, *journal, {1, {}, [&] { return judged >= 25; }});
    ASSERT_FALSE(cut);
    EXPECT_EQ(cut.failure().code, FailureCode::kInterrupted);
  }
  const int before = judged;
  EXPECT_EQ(before, 25);
  Result<JobJournal> journal = JobJournal::Open(path.string(), "tune", true);
  ASSERT_TRUE(journal);
  const Result<TuneResult> resumed = SearchTuning(problem, options, 1, *journal, {2});
  ASSERT_TRUE(resumed);
  EXPECT_TRUE(SameCandidates(whole, *resumed));
  EXPECT_EQ(judged - before, 40 - 25 + 5 + 30) << "the rest of the candidates, the finalists, the proof in blocks";
  journal->Remove();
}

TEST(TuneSearch, WhenStoppedItTriesNothingMore) {
  const TuneProblem problem = Problem(Hill, 10.0, 3.0);
  for (const char* method : {"auto", "surface", "cma-es"}) {
    TuneOptions options{.evaluations = 60};
    options.method = method;
    JobJournal none;
    int asked = 0, stopped = 0;  // `stopped`: number of calls after the stop
    const auto stop = [&] { return ++asked > 30 && ++stopped > 0; };
    const Result<TuneResult> cut = SearchTuning(problem, options, 1, none, {1, {}, stop});
    ASSERT_FALSE(cut);
    EXPECT_EQ(cut.failure().code, FailureCode::kInterrupted);
    EXPECT_EQ(stopped, 1) << method << ": it asks no more once it was told";
  }
}

/// Refuses the present values, or the favourite, from a given trial on.
TuneProblem RefusingFrom(int first_refused, bool usual) {
  TuneProblem problem = Problem(Hill, 5.0, 0.5);
  const auto judge = problem.judge;
  problem.judge = [=](const StudyPoint& values, int first, int count) -> CandidateWorth {
    const bool is_usual = values == StudyPoint{"0.2", "0.8"};
    if (is_usual == usual && first >= first_refused) return {"no such ground", {}};
    return judge(values, first, count);
  };
  return problem;
}

TEST(TuneSearch, HeldOutTrialsThatCannotBePlayedAreNoZeros) {
  const TuneOptions options{.evaluations = 20, .trials = 4, .held_out = 30};
  for (const bool usual : {true, false}) {
    JobJournal none;
    const Result<TuneResult> result = SearchTuning(RefusingFrom(3 * 4 + 10, usual), options, 1, none, {1});
    ASSERT_FALSE(result);
    EXPECT_EQ(result.failure().code, FailureCode::kHeldOut);
    EXPECT_NE(result.failure().message.find(usual ? "of the present values" : "of the favourite values"),
              std::string::npos)
        << result.failure().message;
    EXPECT_NE(result.failure().message.find("no such ground"), std::string::npos);
  }
}

TEST(TuneSearch, UsualValuesWithoutAPlanAreNotCountedAsZero) {
  TuneReport report{Searched(RefusingFrom(0, true), {.evaluations = 20, .trials = 4, .held_out = 30}), {}, {}, {}};
  const TuneResult& result = report.result;
  EXPECT_FALSE(result.candidates.front().value);
  ASSERT_NE(result.favourite, 0U);
  EXPECT_EQ(result.chosen, result.favourite);
  ASSERT_TRUE(result.proof);
  EXPECT_EQ(result.proof->no_before, "no such ground");
  EXPECT_NEAR(result.proof->value.after, Hill(result.candidates[result.favourite].values) + 50.0, 5.0);
  Study study;
  study.axes = {Range("a", 0.0, 1.0), Range("b", 0.0, 1.0)};
  EXPECT_NE(VerdictOf(result).find("the present values have no plan that passes its audit (no such ground)"),
            std::string::npos)
      << VerdictOf(result);
  const auto json = nlohmann::json::parse(TuneJson(study, report, {}, {}));
  for (const char* figure : {"value", "score", "survival"}) {
    for (const char* key : {"before", "difference", "low", "high"})
      EXPECT_TRUE(json.at("held_out").at(figure).at(key).is_null()) << figure << " " << key;
    EXPECT_TRUE(json.at("held_out").at(figure).at("after").is_number());
  }
  EXPECT_EQ(json.at("held_out").at("no_before"), "no such ground");
  for (const std::string& text : {TuneText(study, report, {}), TunePage(study, report, {}), VerdictOf(result)})
    EXPECT_EQ(text.find(" 0.00 "), std::string::npos) << text;
  study.model.name = "heron";
  study.walk.command.speed_m_s = 0.25;
  for (const char* text : {"the present values have no plan that passes its audit", "heron", "speed=0.25"})
    EXPECT_NE(TunedOptions(study, result).find(text), std::string::npos) << text;
}

TEST(TuneSearch, WhatCannotBeSearchedIsRefused) {
  TuneProblem problem = Problem(Hill, 0.0, 0.0);
  JobJournal none;
  EXPECT_THROW((void)SearchTuning(problem, {.evaluations = 1}, 1, none, {}), InvalidArgument);
  problem.usual = {"0.2"};
  EXPECT_THROW((void)SearchTuning(problem, {}, 1, none, {}), InvalidArgument);
  problem.usual = {"0.2", "1"};
  problem.axes[1].values = {"1", "2"};
  EXPECT_THROW((void)SearchTuning(problem, {}, 1, none, {}), InvalidArgument);
}

}  // namespace
}  // namespace gaitwright
