// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "kinematics/base/options.h"
#include "playback/trials/gait_sensitivity.h"
#include "playback/trials/push_record.h"
#include "playback/trials/sensitivity.h"
#include "playback/trials/trial_outcome.h"
#include "playback/trials/wilson.h"

namespace gaitwright {

/// A metric over all trials that have it.
struct MetricSpread {
  std::string key = {}, unit = {};
  int n = 0;  ///< trials that have it
  double lowest = 0.0, p05 = 0.0, median = 0.0, p95 = 0.0, highest = 0.0;
  std::optional<double> limit = {};  ///< of its gate, where it applied in any trial
  int broken = 0;                    ///< trials that broke the gate

  bool operator==(const MetricSpread&) const = default;
};

/// Something and how often it was.
struct Tally {
  std::string what = {};
  int count = 0;

  bool operator==(const Tally&) const = default;
};

/// Subject of a run of trials.
struct TrialSubject {
  std::string robot, robot_hash;
  std::string plan_hash;        ///< MotionHash: that of the logs
  std::string whole_plan_hash;  ///< PlanHash
  std::string controller;
  std::string disturbances;                            ///< as DisturbancesText has them
  OptionTexts options;                                 ///< of playback, controller and score, before trials change them
  std::vector<std::pair<std::string, double>> limits;  ///< of metrics that have a gate, by key
  std::uint64_t seed = 0;                              ///< of the run
  GaitScale gait_scale;                                ///< of robot and plan
  std::optional<double> own_push_s = {};               ///< when the push of the options begins, in each trial
  std::string repeat = {};                             ///< the command that repeats one, with PLAN and SEED in it

  bool operator==(const TrialSubject&) const = default;
};

/// What many trials of one plan showed. Always true: `outcomes` are in the order of their numbers, which run from 0
/// without a gap.
struct RobustnessReport {
  TrialSubject subject;
  int n = 0, survived = 0, passed = 0;
  int different = 0;  ///< of so many no earlier one has the same `log_hash`
  ShareInterval survival, pass_share;
  std::vector<MetricSpread> metrics;  ///< in the order of MetricRules
  std::vector<Tally> causes;          ///< of falls, the most frequent first
  std::vector<Tally> broken_gates;    ///< of trials that did not fall and did not pass, likewise
  std::vector<Sensitivity> sensitivity;
  GaitSensitivity gait_sensitivity;
  std::vector<PushBin> push_bins;  ///< empty without pushes
  std::vector<PushRecord> pushes;
  std::vector<int> worst;  ///< numbers of the worst trials, the worst first: falls, failures, passes, each by score
  std::vector<TrialOutcome> outcomes;

  /// That of the trial of that number. @throws std::out_of_range for none.
  const TrialOutcome& Outcome(int number) const { return outcomes.at(static_cast<std::size_t>(number)); }
};

/// Combines outcomes: a pure function of them, independent of the order of execution.
/// @param outcomes  in the order of their numbers, from 0 without a gap. @throws InvalidArgument otherwise.
RobustnessReport ReduceTrials(const TrialSubject& subject, std::vector<TrialOutcome> outcomes);

/// The JSON object that the program writes, see docs/json-output.md; deterministic to the byte.
std::string RobustnessJson(const RobustnessReport& report);

/// Caution for a report whose trials repeat one another, as a sentence; empty if all playbacks differ.
std::string RepeatsText(const RobustnessReport& report);

/// The report in words, for a terminal.
std::string RobustnessText(const RobustnessReport& report);

}  // namespace gaitwright
