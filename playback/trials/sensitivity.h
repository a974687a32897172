// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

namespace gaitwright {

/// How two groups of numbers differ in rank.
struct RankTest {
  double effect = 0.0;  ///< rank-biserial correlation 2 U / (n1 n2) - 1: 1 where every number of the first is larger
  double p = 1.0;       ///< two-sided
};

/// Mann and Whitney's test, for any distributions. The p-value is exact for small groups without ties, else by the
/// normal approximation with corrections for ties and continuity. Mann and Whitney, Annals of Mathematical Statistics
/// 18(1), 1947, doi:10.1214/aoms/1177730491; Kerby, Comprehensive Psychology 3, 2014, doi:10.2466/11.IT.3.1, for the
/// effect. An empty group gives no result.
RankTest CompareRanks(const std::vector<double>& first, const std::vector<double>& second);

/// Association of one sampled quantity with falls.
struct Sensitivity {
  std::string name = {}, unit = {};
  std::string how = {};    ///< "more", "less", "far off", "near", or "is WORD": what goes with falls
  bool of_a_word = false;  ///< the figure is a word, which has no median
  double effect = 0.0;     ///< rank-biserial correlation of falls with that, 0 to 1
  double p = 1.0;          ///< two-sided, times the number of ways that were tried for this figure
  double weight = 0.0;     ///< of all figures together: ridge logistic regression, odds per standard deviation, log
  double median_fell = 0.0, median_survived = 0.0;

  bool operator==(const Sensitivity&) const = default;
};

/// One figure over all trials. Words in place of values where `words` has any.
struct SampledColumn {
  std::string name = {}, unit = {};
  std::vector<double> values = {};
  std::vector<std::string> words = {};
};

/// Ranks quantities by how well they separate falls from survivals, the most significant first. Each is tried as it is
/// and by its distance from its own median over all trials (so that a shift to either side counts), words one by one;
/// p-values are multiplied by the number of ways. Figures that never differ are left out. Empty without falls or
/// without survivals.
/// @param fell  by trial. @throws InvalidArgument when a column has another length.
std::vector<Sensitivity> RankDisturbances(const std::vector<SampledColumn>& columns, const std::vector<char>& fell);

}  // namespace gaitwright
