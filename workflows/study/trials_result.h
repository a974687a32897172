// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "kinematics/base/options.h"
#include "kinematics/base/result.h"
#include "playback/trials/wilson.h"

namespace gaitwright {

/// What a preflight takes of the result that `trials` writes.
struct TrialsResult {
  /// Why trials fell, and how many.
  struct Cause {
    std::string name;
    int count = 0;
  };
  /// A trial to look at.
  struct Worst {
    std::uint64_t seed = 0;
    std::string words;  ///< its `reason` or `cause`, or ""
  };

  int n = 0, survived = 0, passed = 0;  ///< `passed`: kept every gate too
  /// The same of the trials that differ: those with one `log_hash` are one playback, which counts once.
  int different = 0, different_survived = 0, different_passed = 0;
  double survival = 0.0, survival_low = 0.0, survival_high = 0.0;  ///< share, and its interval
  std::vector<Cause> causes;                                       ///< of falls
  std::vector<Worst> worst;
  std::string plan_hash, whole_plan_hash, robot_hash;  ///< MotionHash and PlanHash of the plan
  OptionTexts options;                                 ///< of the playback, before trials changed them
  std::string disturbances;                            ///< as YAML text
  std::string controller, repeat;  ///< the latter is the command that repeats one trial; "" where they are not said

  /// Of all that passed every gate.
  ShareInterval pass_share() const { return WilsonInterval(passed, n); }
};

/// A result from its JSON text, as `trials` writes it (docs/json-output.md): an object with `n`, `survived`, `passed`,
/// `survival`, `survival_low`, `survival_high`, `causes` (counts by name), `plan_hash`, `whole_plan_hash`,
/// `robot_hash`, `options` (a text for every option of a playback), `disturbances` (YAML) and `trials` (`columns` with
/// `survived`, `passed`, `cause` and `log_hash`, and `rows`); `controller`, `repeat` (texts) and `worst` (a list of
/// objects with a `seed` and a `reason`) may be missing. Other keys are passed over. Refused: text that is no JSON, a
/// key that is missing or of the wrong kind, figures that contradict each other or the rows, a cause that no fall has.
/// @param source names the text.
Result<TrialsResult> TrialsResultFromJson(const std::string& text, const std::string& source);

/// The result of a file.
Result<TrialsResult> LoadTrialsResult(const std::string& path);

}  // namespace gaitwright
