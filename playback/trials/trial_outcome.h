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

/// Outcome of one trial; a run's report is computed from these alone.
struct TrialOutcome {
  int number = 0;  ///< number in the run, from 0
  std::uint64_t seed = 0;
  bool survived = false;  ///< it did not fall and reached the plan's end
  bool passed = false;    ///< it also kept all gates
  double score = 0.0;
  double ended_s = 0.0;  ///< time of the fall, on the plan's clock, or of the end
  std::string cause;     ///< short words that many trials can share, see StabilityReport::cause; empty for a pass
  std::string reason;    ///< the reason in its report
  std::string log_hash;  ///< of all samples of its log; repeating the trial gives the same hash
  std::vector<SampledValue> sampled;
  std::vector<std::pair<std::string, std::optional<double>>> metrics;  ///< by key, in the order of MetricRules
  std::vector<std::string> gates;                                      ///< keys of the applied gates
  std::vector<std::string> broken_gates;                               ///< keys of the applied gates that were violated
  std::vector<GaitStep> steps;                                         ///< of a trial that survived; else empty

  bool operator==(const TrialOutcome&) const = default;
};

/// The outcome of a scored playback, without its steps.
TrialOutcome OutcomeOf(int number, const SampledTrial& trial, const PlaybackLog& log, const StabilityReport& report);

/// Hash of times, states, torques and contact forces of all samples.
std::string SamplesHash(const PlaybackLog& log);

/// One line of JSON without line end; reading it gives exactly the same outcome.
std::string OutcomeToLine(const TrialOutcome& outcome);

/// @throws InvalidArgument if the line is not an outcome.
TrialOutcome OutcomeFromLine(const std::string& line);

}  // namespace gaitwright
