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
///   the tuned gait is no better on held-out trials    raise trials: the noise of few hides the difference
///   the best point lies at the end of a range         widen the range
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
         "Share of the variance between candidates that a surface must predict for auto to follow it."}};
  }
};

/// What a tuning varies, and how a candidate is judged.
struct TuneProblem {
  std::vector<StudyAxis> axes;  ///< ranges of numbers
  StudyPoint usual;             ///< the present values, also where they are out of the ranges
  /// What values are worth over trials `first` to `first` + `count` - 1: a pure function, called from any thread.
  std::function<CandidateWorth(const StudyPoint& values, int first, int count)> judge;
};

/// One candidate that was tried.
struct TuneCandidate {
  StudyPoint values;
  std::string found_by;  ///< "usual", "sample", "surface" or "cma-es"
  CandidateWorth worth;
  std::optional<double> value;  ///< over the trials of the search; nothing when it was refused
};

/// The proof on trials that the search never saw.
struct HeldOutProof {
  int trials = 0;
  PairedDifference value, score, survival;
  /// Why the usual values could not be tried, such as that they have no plan; "" where they were. Then there is nothing
  /// to compare with: of the differences `after` alone is told.
  std::string no_before = {};
};

/// What a tuning found.
/// Always true: candidate 0 is the usual one; `chosen` is 0 unless the difference in value on the held-out trials is
/// above zero with its whole 95 % interval, or the usual values have no plan at all.
struct TuneResult {
  std::vector<TuneCandidate> candidates;  ///< in the order in which they were tried
  std::vector<std::size_t> finalists;     ///< numbers of candidates, the best first
  std::size_t favourite = 0;              ///< what the search would choose
  std::size_t chosen = 0;
  std::optional<HeldOutProof> proof;     ///< nothing when the favourite is the usual one
  std::optional<FittedSurface> surface;  ///< last one fitted to all, over shares of the ranges

  bool better() const { return chosen != 0; }
};

/// Where a candidate lies in the ranges, each from 0 to 1; outside of it beyond them.
VectorX SharesOf(const std::vector<StudyAxis>& axes, const StudyPoint& values);

/// Looks for the values with the highest mean value over trials, with the same trials for every candidate:
///   1. the usual values, and points of a Halton sequence over a third of the evaluations;
///   2. while quadratic surfaces foretell the values (see `smooth_above`): rounds of four, where the surface is highest
///      in the whole of the ranges, and in boxes of a half, a quarter and an eighth of them about the best so far;
///   3. otherwise CMA-ES about the best so far; candidates that are refused rank last;
///   4. the finalists are tried on twice as many trials again, which with the first ones decide;
///   5. the favourite and the usual values are held against each other on held-out trials, pair by pair; where the
///      usual ones have no plan, the favourite is tried alone.
/// Trial numbers: the search has those below `trials`, the finalists the next 2 `trials`, the proof those after them.
/// Deterministic for a seed, for any number of threads and whether or not it was resumed.
/// @return a failure `interrupted` when it was stopped, which it heeds before each job, or `held_out` where the proof's
/// trials could not be played.
/// @throws InvalidArgument for options out of range, axes that are no ranges of numbers, or usual values for others.
Result<TuneResult> SearchTuning(const TuneProblem& problem, const TuneOptions& options, std::uint64_t seed,
                                JobJournal& journal, const JobOptions& jobs);

}  // namespace gaitwright
