// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "workflows/study/tune_search.h"

namespace gaitwright {

/// A tuning, with the undisturbed walk of its present and its best values.
struct TuneReport {
  TuneResult result;
  PointOutcome before, after;        ///< with all keys of MetricRules()
  std::vector<std::string> metrics;  ///< these keys
};

/// @throws InvalidArgument for an axis that cannot be tuned: the command and the score, because scores are comparable
/// only for equal ones, and `play.*`, which describes the world.
void CheckTunable(const std::vector<StudyAxis>& axes);

/// The present values of a study's requests for its axes.
StudyPoint UsualValues(const Study& study);

/// Tunes the options that the study's axes name: see SearchTuning. The study's points are not used. Failures as of
/// SearchTuning; `no_plan` if no candidate has a plan that passes its audit.
Result<TuneReport> Tune(const Study& study, const TuneOptions& options, JobJournal& journal, const JobOptions& jobs);

/// Identity of a tuning for its journal; `trials` is a text that identifies the trials.
std::string TuneIdentity(const Study& study, const TuneOptions& options, const std::string& trials);

/// The chosen values as an option file, for `walk --options FILE`.
std::string TunedOptions(const Study& study, const TuneResult& result);

}  // namespace gaitwright
