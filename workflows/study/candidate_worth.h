// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "kinematics/base/result.h"
#include "workflows/study/run_point.h"

namespace gaitwright {

/// What a candidate of a tuning was worth over some trials.
/// Always true: one that was refused has no trials.
struct CandidateWorth {
  std::string refusal;  ///< why it has no plan that passes its audit; empty when it has one
  std::vector<TrialWorth> trials = {};

  bool operator==(const CandidateWorth&) const = default;
};

/// What one trial counts in a tuning: its score, and `survival_weight` more where the robot stood to the end.
double ValueOf(const TrialWorth& trial, double survival_weight);

/// Mean of what the trials count; nothing for a candidate that was refused.
std::optional<double> MeanValue(const CandidateWorth& worth, double survival_weight);

/// One line of JSON, from which WorthFromLine reads exactly the same.
std::string WorthToLine(const CandidateWorth& worth);
/// Failure kBadInput `journal_line` says what is wrong with the line.
Result<CandidateWorth> WorthFromLine(const std::string& line);

/// How two candidates differ over the same trials.
struct PairedDifference {
  double before = 0.0, after = 0.0;          ///< means
  double mean = 0.0, low = 0.0, high = 0.0;  ///< of after less before, with its 95 % interval

  bool better() const { return low > 0.0; }
  bool operator==(const PairedDifference&) const = default;
};

/// The mean of the pairs' differences and its 95 % interval by Student's t with n - 1 degrees of freedom (quantile by
/// Peizer and Pratt's series, Abramowitz and Stegun 26.7.5).
/// @throws InvalidArgument unless there are as many of the one as of the other, six or more.
PairedDifference DifferenceOf(const std::vector<double>& before, const std::vector<double>& after);

/// The same where each value says whether something was so, 1 or 0: the difference of two shares of the same trials,
/// and its 95 % interval from those of Wilson of either share and their correlation, which has a width where all values
/// are equal too. R. G. Newcombe, Stat. Med. 17(22), 1998, 2635-2650, method 10.
/// @throws InvalidArgument as DifferenceOf does, or where a value is neither 0 nor 1.
PairedDifference DifferenceOfShares(const std::vector<double>& before, const std::vector<double>& after);

}  // namespace gaitwright
