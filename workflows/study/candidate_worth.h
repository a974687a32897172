// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "kinematics/base/result.h"
#include "workflows/study/run_point.h"

namespace gaitwright {

/// Value of a tuning candidate over some trials. Invariant: a refused candidate has no trials.
struct CandidateWorth {
  std::string refusal;  ///< why it has no plan that passes its audit; empty if it has one
  std::vector<TrialWorth> trials = {};

  bool operator==(const CandidateWorth&) const = default;
};

/// Value of one trial in a tuning: its score, plus `survival_weight` if the robot survived to the end.
double ValueOf(const TrialWorth& trial, double survival_weight);

/// Mean value of the trials; nothing for a refused candidate.
std::optional<double> MeanValue(const CandidateWorth& worth, double survival_weight);

/// One line of JSON, which WorthFromLine reads back exactly.
std::string WorthToLine(const CandidateWorth& worth);
/// Failure kBadInput `journal_line` describes the error in the line.
Result<CandidateWorth> WorthFromLine(const std::string& line);

/// Difference of two candidates over the same trials.
struct PairedDifference {
  double before = 0.0, after = 0.0;          ///< means
  double mean = 0.0, low = 0.0, high = 0.0;  ///< after minus before: mean and 95 % interval

  bool better() const { return low > 0.0; }
  bool operator==(const PairedDifference&) const = default;
};

/// The mean of the pairs' differences and its 95 % interval by Student's t with n - 1 degrees of freedom (quantile by
/// Peizer and Pratt's series, Abramowitz and Stegun 26.7.5).
/// @throws InvalidArgument unless both have the same number of values, six or more.
PairedDifference DifferenceOf(const std::vector<double>& before, const std::vector<double>& after);

/// The difference of two proportions over the same trials (values 0 or 1), with its 95 % interval from the Wilson
/// intervals of both proportions and their correlation; the interval has a width even if all values are equal. R. G.
/// Newcombe, Stat. Med. 17(22), 1998, 2635-2650, method 10.
/// @throws InvalidArgument as DifferenceOf does, or if a value is neither 0 nor 1.
PairedDifference DifferenceOfShares(const std::vector<double>& before, const std::vector<double>& after);

}  // namespace gaitwright
