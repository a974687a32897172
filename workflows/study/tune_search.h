// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "optimisation/numerics/response_surface.h"
#include "workflows/study/candidate_worth.h"
#include "workflows/study/job_journal.h"
#include "workflows/study/study_jobs.h"

namespace gaitwright {

/// Tuning
///   the tuned gait is no better on held-out trials    raise trials: with few trials, noise hides the difference
///   the best point is at the end of a range           widen the range
struct TuneOptions {
  int evaluations = 90;
  int trials = 10;
  int finalists = 4;
  int held_out = 150;
  double survival_weight = 50.0;
  std::string method = "auto";
  double smooth_above = 0.5;

  OptionFields Fields() {
    return {
        {"evaluations", &evaluations, "1", 2.0, 100000.0,
         "Number of candidates that are tried, including the present values."},
        {"trials", &trials, "1", 1.0, 100000.0, "Trials of each candidate; all candidates get the same trials."},
        {"finalists", &finalists, "1", 1.0, 100.0,
         "Number of best candidates that get twice as many further trials before one is chosen."},
        {"held_out", &held_out, "1", 6.0, 100000.0,
         "Number of held-out trials, which the search never uses and which test the result."},
        {"survival_weight", &survival_weight, "1", 0.0, 1000.0,
         "Value added to a trial's score (0 to 100) if the robot survives to the end."},
        {"method",
         &method,
         "",
         0.0,
         0.0,
         "Search method: response surfaces, CMA-ES, or auto, which uses surfaces while they predict points that were "
         "not fitted.",
         {"auto", "surface", "cma-es"}},
        {"smooth_above", &smooth_above, "1", -1.0, 1.0,
         "Smallest share of the variance between candidates that a surface must predict; below it, method auto uses "
         "CMA-ES."}};
  }
};

/// The axes of a tuning and the evaluation of a candidate.
struct TuneProblem {
  std::vector<StudyAxis> axes;  ///< ranges of numbers
  StudyPoint usual;             ///< the present values, even if outside the ranges
  /// Value of option values over trials `first` to `first` + `count` - 1: a pure function, called from any thread.
  std::function<CandidateWorth(const StudyPoint& values, int first, int count)> judge;
};

/// One candidate that was tried.
struct TuneCandidate {
  StudyPoint values;
  std::string found_by;  ///< "usual", "sample", "surface" or "cma-es"
  CandidateWorth worth;
  std::optional<double> value;  ///< value over the trials of the search; nothing if it was refused
};

/// The test on held-out trials, which the search never used.
struct HeldOutProof {
  int trials = 0;
  PairedDifference value, score, survival;
  /// Why the present values could not be tried, for example without a plan; "" if they were. Then there is no
  /// comparison, and only `after` of the differences is set.
  std::string no_before = {};
};

/// Result of a tuning. Invariant: candidate 0 has the present values; `chosen` is 0 unless the whole 95 % interval of
/// the difference on the held-out trials is above zero, or the present values have no plan.
struct TuneResult {
  std::vector<TuneCandidate> candidates;  ///< in order of evaluation
  std::vector<std::size_t> finalists;     ///< numbers of candidates, the best first
  std::size_t favourite = 0;              ///< best candidate of the search
  std::size_t chosen = 0;
  std::optional<HeldOutProof> proof;     ///< nothing if the present values are the best
  std::optional<FittedSurface> surface;  ///< last surface fitted to all points, over ranges scaled to 0 to 1

  bool better() const { return chosen != 0; }
};

/// Position of a candidate in the ranges, each scaled to 0 to 1; outside 0 to 1 beyond them.
VectorX SharesOf(const std::vector<StudyAxis>& axes, const StudyPoint& values);

/// Searches the option values with the highest mean value over trials; all candidates get the same trials:
///   1. the present values, and points of a Halton sequence for a third of the evaluations;
///   2. while quadratic surfaces predict the values (see `smooth_above`): rounds of four candidates, at the maximum of
///      the surface in the whole ranges and in boxes of a half, a quarter and an eighth of them around the best so far;
///   3. otherwise CMA-ES around the best so far; refused candidates rank last;
///   4. the finalists get twice as many further trials; all their trials decide;
///   5. the favourite and the present values are compared on held-out trials, in pairs; if the present values have no
///      plan, only the favourite is tested.
/// Trial numbers: the search uses those below `trials`, the finalists the next 2 `trials`, the held-out test those
/// after them. The result is deterministic for a seed, for any number of threads and for resumed runs.
/// @return a failure `interrupted` if it was stopped (checked before each job), or `held_out` if held-out trials could
/// not be played.
/// @throws InvalidArgument for options out of range, axes that are not ranges of numbers, or present values that do not
/// fit the axes.
Result<TuneResult> SearchTuning(const TuneProblem& problem, const TuneOptions& options, std::uint64_t seed,
                                JobJournal& journal, const JobOptions& jobs);

}  // namespace gaitwright
