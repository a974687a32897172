// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "workflows/study/tune_search.h"

namespace gaitwright {

/// A tuning and what its usual and its favourite values make of the undisturbed walk.
struct TuneReport {
  TuneResult result;
  PointOutcome before, after;        ///< with every key of MetricRules()
  std::vector<std::string> metrics;  ///< those keys
};

/// @throws InvalidArgument for an axis that is not to be tuned: the command and the score, since scores compare only
/// for the same of both, and `play.*`, which says what the world is like.
void CheckTunable(const std::vector<StudyAxis>& axes);

/// The values that the requests of a study have now for its axes.
StudyPoint UsualValues(const Study& study);

/// Tunes the options that the study's axes name: see SearchTuning. The study's points are not used.
/// Failures as SearchTuning; `no_plan` when no candidate has a plan that passes its audit.
Result<TuneReport> Tune(const Study& study, const TuneOptions& options, JobJournal& journal, const JobOptions& jobs);

/// What ties a journal to one tuning; `trials` is a text that says what the trials are.
std::string TuneIdentity(const Study& study, const TuneOptions& options, const std::string& trials);

/// The chosen values as a file of options, for `walk --options FILE`.
std::string TunedOptions(const Study& study, const TuneResult& result);

}  // namespace gaitwright
