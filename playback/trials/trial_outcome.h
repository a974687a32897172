// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "playback/log/playback_log.h"
#include "playback/score/stability_report.h"
#include "playback/trials/disturbances.h"
#include "playback/trials/gait_steps.h"

namespace gaitwright {

/// What came of one trial: all that the report of a run is made of.
struct TrialOutcome {
  int number = 0;  ///< in its run, from 0
  std::uint64_t seed = 0;
  bool survived = false;  ///< it did not fall and reached the plan's end
  bool passed = false;    ///< it kept all gates too
  double score = 0.0;
  double ended_s = 0.0;  ///< when it fell, on the plan's clock, or the end
  std::string cause;     ///< short words that many trials share, see StabilityReport::cause; empty for a pass
  std::string reason;    ///< the sentence of its report
  std::string log_hash;  ///< of all samples of its log: the same again when it is repeated
  std::vector<SampledValue> sampled;
  std::vector<std::pair<std::string, std::optional<double>>> metrics;  ///< by key, in the order of MetricRules
  std::vector<std::string> gates;                                      ///< keys of those that applied
  std::vector<std::string> broken_gates;                               ///< and of these, keys of those not kept
  std::vector<GaitStep> steps;                                         ///< of a trial that survived, else none

  bool operator==(const TrialOutcome&) const = default;
};

/// The outcome of a playback that was scored, without its steps.
TrialOutcome OutcomeOf(int number, const SampledTrial& trial, const PlaybackLog& log, const StabilityReport& report);

/// Hash of times, states, torques and contact forces of all samples.
std::string SamplesHash(const PlaybackLog& log);

/// One line of JSON without its end; reading it gives the same outcome exactly.
std::string OutcomeToLine(const TrialOutcome& outcome);

/// @throws InvalidArgument when the line is no outcome.
TrialOutcome OutcomeFromLine(const std::string& line);

}  // namespace gaitwright
