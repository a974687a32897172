// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "workflows/study/sweep_files.h"
#include "workflows/study/tune.h"

namespace gaitwright {

/// The object of `tune --json`, see docs/json-output.md. Deterministic to the byte.
std::string TuneJson(const Study& study, const TuneReport& report, const TuneOptions& options,
                     const WrittenFiles& files);

/// The tuning as text.
std::string TuneText(const Study& study, const TuneReport& report, const TuneOptions& options);

/// The page of a tuning: verdict, present and tuned values, held-out test, metrics before and after, history of the
/// search and response to each option. Well-formed XML.
std::string TunePage(const Study& study, const TuneReport& report, const TuneOptions& options);

/// "better: 71.2 to 78.3 points on 150 held-out trials, difference 7.1 (95 % interval 5.0 to 9.2)" or why not.
std::string VerdictOf(const TuneResult& result);

}  // namespace gaitwright
