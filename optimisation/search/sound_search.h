// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "optimisation/search/evaluator.h"
#include "optimisation/search/pace_search.h"
#include "optimisation/search/slower_pace.h"

namespace gaitwright {

/// A walk for which a sound plan is looked for.
struct SearchProblem {
  SearchSituation situation;
  PaceRange paces;        ///< `asked` is the pace of the walk as asked for
  bool in_place = false;  ///< it goes nowhere, so that there is no slower one
  bool any_plan = false;  ///< the plan of the walk as asked for is taken, sound or not
  /// Of the same gait at duty factors without flight; nothing where it always flies.
  std::optional<SearchSituation::Kind> grounded;
};

/// The best that a search found.
struct SearchResult {
  Candidate candidate;             ///< a sound one, or the walk as asked for
  Evaluation evaluation;           ///< of `candidate`
  std::optional<FailureCode> why;  ///< why the walk as asked for is refused, where it is
};

/// The walk as asked for; where it is refused, the first candidate of VariationsFor that is sound; and where its pace
/// may be lowered on level ground, the largest pace that has a sound plan. What is possible is found on the start of
/// the walk, and a whole walk is planned only where its start is sound.
SearchResult FindSound(const SearchProblem& problem, Evaluator& evaluator);

/// The largest pace below that asked for which has a sound plan, or one that may have: for a refusal to name. Gaits
/// that fly are looked at alone; those that fly by their speed are also tried at duty factors without flight. None
/// where FindSound lowered the pace already.
SlowerPace SlowerThatIsSound(const SearchProblem& problem, Evaluator& evaluator);

}  // namespace gaitwright
