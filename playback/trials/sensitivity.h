// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

namespace gaitwright {

/// Difference in rank between two groups of numbers.
struct RankTest {
  double effect = 0.0;  ///< rank-biserial correlation 2 U / (n1 n2) - 1: 1 if every number of the first is larger
  double p = 1.0;       ///< two-sided
};

/// Mann and Whitney's test, for any distributions. The p-value is exact for small groups without ties, otherwise from
/// the normal approximation with corrections for ties and continuity. Mann and Whitney, Annals of Mathematical
/// Statistics 18(1), 1947, doi:10.1214/aoms/1177730491; for the effect: Kerby, Comprehensive Psychology 3, 2014,
/// doi:10.2466/11.IT.3.1. An empty group gives no result.
RankTest CompareRanks(const std::vector<double>& first, const std::vector<double>& second);

/// Association of one sampled quantity with falls.
struct Sensitivity {
  std::string name = {}, unit = {};
  std::string how = {};    ///< "more", "less", "far off", "near", or "is WORD": the values that occur with falls
  bool of_a_word = false;  ///< the quantity is a word, which has no median
  double effect = 0.0;     ///< rank-biserial correlation of `how` with falls, 0 to 1
  double p = 1.0;          ///< two-sided, times the number of transforms that were tried for this quantity
  double weight = 0.0;     ///< ridge logistic regression on all quantities together: log odds per standard deviation
  double median_fell = 0.0, median_survived = 0.0;

  bool operator==(const Sensitivity&) const = default;
};

/// One quantity over all trials. If `words` is not empty, it replaces the values.
struct SampledColumn {
  std::string name = {}, unit = {};
  std::vector<double> values = {};
  std::vector<std::string> words = {};
};

/// Ranks quantities by how well they separate falls from survivals, the most significant first. Each number is tried
/// itself and as the distance from its median over all trials (so that a shift to either side counts), words one by
/// one. p-values are multiplied by the number of transforms. Constant quantities are omitted. Empty without falls or
/// without survivals.
/// @param fell  by trial. @throws InvalidArgument if a column has another length.
std::vector<Sensitivity> RankDisturbances(const std::vector<SampledColumn>& columns, const std::vector<char>& fell);

}  // namespace gaitwright
