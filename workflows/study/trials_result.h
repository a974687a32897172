// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "kinematics/base/options.h"
#include "kinematics/base/result.h"
#include "playback/trials/wilson.h"

namespace gaitwright {

/// Part of the result of `trials` that a preflight uses.
struct TrialsResult {
  /// A cause of falls and its number of trials.
  struct Cause {
    std::string name;
    int count = 0;
  };
  /// A trial worth inspecting.
  struct Worst {
    std::uint64_t seed = 0;
    std::string words;  ///< its `reason` or `cause`, or ""
  };

  int n = 0, survived = 0, passed = 0;  ///< `passed`: also passed every gate
  /// Counts over different trials: trials with equal `log_hash` are one playback and count once.
  int different = 0, different_survived = 0, different_passed = 0;
  double survival = 0.0, survival_low = 0.0, survival_high = 0.0;  ///< share, and its interval
  std::vector<Cause> causes;                                       ///< causes of falls
  std::vector<Worst> worst;
  std::string plan_hash, whole_plan_hash, robot_hash;  ///< MotionHash and PlanHash of the plan
  OptionTexts options;                                 ///< options of the playback, before trials changed them
  std::string disturbances;                            ///< as YAML text
  std::string controller, repeat;  ///< `repeat` is the command that repeats one trial; "" if missing

  /// Share of trials that passed every gate.
  ShareInterval pass_share() const { return WilsonInterval(passed, n); }
};

/// Reads a result from its JSON text, as `trials` writes it (docs/json-output.md): an object with `n`, `survived`,
/// `passed`, `survival`, `survival_low`, `survival_high`, `causes` (counts by name), `plan_hash`, `whole_plan_hash`,
/// `robot_hash`, `options` (a text for every option of a playback), `disturbances` (YAML) and `trials` (`columns` with
/// `survived`, `passed`, `cause` and `log_hash`, and `rows`); `controller`, `repeat` (texts) and `worst` (a list of
/// objects with a `seed` and a `reason`) may be missing. Other keys are ignored. Refused: text that is not JSON, a key
/// that is missing or has the wrong type, values that contradict each other or the rows, an unknown cause of falls.
/// @param source  name of the text in messages.
Result<TrialsResult> TrialsResultFromJson(const std::string& text, const std::string& source);

/// Reads a result from a file.
Result<TrialsResult> LoadTrialsResult(const std::string& path);

}  // namespace gaitwright
