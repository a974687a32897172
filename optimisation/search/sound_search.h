// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "optimisation/search/evaluator.h"
#include "optimisation/search/pace_search.h"
#include "optimisation/search/slower_pace.h"

namespace gaitwright {

/// A walk for which a sound plan is searched.
struct SearchProblem {
  SearchSituation situation;
  PaceRange paces;        ///< `asked` is the speed of the requested walk
  bool in_place = false;  ///< it has no displacement, so no slower walk exists
  bool any_plan = false;  ///< the plan of the requested walk is accepted, sound or not
  /// Kind of the same gait at duty factors without flight; nothing if the gait always has flight.
  std::optional<SearchSituation::Kind> grounded;
};

/// The best candidate of a search.
struct SearchResult {
  Candidate candidate;             ///< a sound one, or the requested walk
  Evaluation evaluation;           ///< of `candidate`
  std::optional<FailureCode> why;  ///< why the requested walk is refused, if it is
};

/// Evaluates the requested walk. If it is refused, returns the first sound candidate: on level ground, where limits of
/// joints or motors refuse it, the same walk with the whole body optimised, if the plan leaves ample room for a
/// controller; then those of VariationsFor; then those of FinishedVariationsFor. If its speed may be lowered on level
/// ground, returns the largest speed with a sound plan. Where flat soles find no footholds on uneven ground, returns
/// the walk with heels that rise. Other candidates are first evaluated on the start of the walk; a whole walk is
/// planned only if its start is sound.
SearchResult FindSound(const SearchProblem& problem, Evaluator& evaluator);

/// The largest speed below the requested one that has, or may have, a sound plan; for failure messages. Gaits with
/// flight are only evaluated cheaply; gaits whose flight depends on the speed are also tried at duty factors without
/// flight. Nothing if FindSound has already lowered the speed.
SlowerPace SlowerThatIsSound(const SearchProblem& problem, Evaluator& evaluator);

}  // namespace gaitwright
