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

/// A metric over all trials in which it has a value.
struct MetricSpread {
  std::string key = {}, unit = {};
  int n = 0;  ///< trials with a value
  double lowest = 0.0, p05 = 0.0, median = 0.0, p95 = 0.0, highest = 0.0;
  std::optional<double> limit = {};  ///< of its gate, if it applied in any trial
  int broken = 0;                    ///< trials that violated the gate

  bool operator==(const MetricSpread&) const = default;
};

/// A cause and its number of occurrences.
struct Tally {
  std::string what = {};
  int count = 0;

  bool operator==(const Tally&) const = default;
};

/// Subject of a run of trials.
struct TrialSubject {
  std::string robot, robot_hash;
  std::string plan_hash;        ///< MotionHash, which the logs contain
  std::string whole_plan_hash;  ///< PlanHash
  std::string controller;
  std::string disturbances;                            ///< text as of DisturbancesText
  OptionTexts options;                                 ///< of playback, controller and score, before trials change them
  std::vector<std::pair<std::string, double>> limits;  ///< of metrics with a gate, by key
  std::uint64_t seed = 0;                              ///< of the run
  GaitScale gait_scale;                                ///< of robot and plan
  std::optional<double> own_push_s = {};               ///< start of the push of the options, in each trial
  std::string repeat = {};  ///< the command that repeats a trial, with PLAN and SEED as placeholders

  bool operator==(const TrialSubject&) const = default;
};

/// Results of many trials of one plan. Invariant: `outcomes` are in the order of their numbers, which run from 0
/// without a gap.
struct RobustnessReport {
  TrialSubject subject;
  int n = 0, survived = 0, passed = 0;
  int different = 0;  ///< number of trials with different `log_hash`
  ShareInterval survival, pass_share;
  std::vector<MetricSpread> metrics;  ///< in the order of MetricRules
  std::vector<Tally> causes;          ///< of falls, the most frequent first
  std::vector<Tally> broken_gates;    ///< of trials without a fall that did not pass, the most frequent first
  std::vector<Sensitivity> sensitivity;
  GaitSensitivity gait_sensitivity;
  std::vector<PushBin> push_bins;  ///< empty without pushes
  std::vector<PushRecord> pushes;
  std::vector<int>
      worst;  ///< numbers of the worst trials, the worst first: falls, failures, passes, each group by score
  std::vector<TrialOutcome> outcomes;

  /// The outcome of a trial by its number. @throws std::out_of_range if it does not exist.
  const TrialOutcome& Outcome(int number) const { return outcomes.at(static_cast<std::size_t>(number)); }
};

/// Combines outcomes: a pure function of them, independent of the order of execution.
/// @param outcomes  in the order of their numbers, from 0 without a gap. @throws InvalidArgument otherwise.
RobustnessReport ReduceTrials(const TrialSubject& subject, std::vector<TrialOutcome> outcomes);

/// The JSON object that the program writes, see docs/json-output.md; deterministic to the byte.
std::string RobustnessJson(const RobustnessReport& report);

/// Caution, as a sentence, for a report in which trials repeat one another; empty if all playbacks differ.
std::string RepeatsText(const RobustnessReport& report);

/// The report as text, for a terminal.
std::string RobustnessText(const RobustnessReport& report);

}  // namespace gaitwright
