// SPDX-License-Identifier: BSD-3-Clause
#include "playback/trials/sensitivity.h"

#include <fmt/format.h>

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "kinematics/base/result.h"
#include "kinematics/spatial/dense_solvers.h"

namespace gaitwright {
namespace {

constexpr double kMostExactWork = 2e7;  // maximum number of additions for an exact p-value

double Median(std::vector<double> values) {
  if (values.empty()) return 0.0;
  std::sort(values.begin(), values.end());
  const std::size_t half = values.size() / 2;
  return values.size() % 2 != 0 ? values[half] : 0.5 * (values[half - 1] + values[half]);
}

/// Ranks from 1, with mean ranks for ties; and the sum of t^3 - t over groups of t ties.
struct Ranks {
  std::vector<double> rank;
  double ties = 0.0;
};

Ranks RanksOf(const std::vector<double>& values) {
  std::vector<std::size_t> order(values.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return values[a] < values[b]; });
  Ranks ranks;
  ranks.rank.resize(values.size());
  for (std::size_t i = 0; i < order.size();) {
    std::size_t end = i + 1;
    while (end < order.size() && values[order[end]] == values[order[i]]) ++end;
    const double count = static_cast<double>(end - i);
    for (std::size_t k = i; k < end; ++k) ranks.rank[order[k]] = 0.5 * static_cast<double>(i + 1 + end);
    ranks.ties += count * count * count - count;
    i = end;
  }
  return ranks;
}

/// P(U <= u) without ties, by the number of subsets of n1 ranks with each sum; doubles suffice, as only ratios matter.
double ExactBelow(std::size_t n1, std::size_t n2, std::size_t u) {
  std::vector<std::vector<double>> counts(n1 + 1, std::vector<double>(n1 * n2 + 1, 0.0));
  counts[0][0] = 1.0;  // counts[k][s]: k of the ranks seen so far, with U = s
  for (std::size_t rank = 1; rank <= n1 + n2; ++rank) {
    for (std::size_t k = std::min(rank, n1); k >= 1; --k) {
      const std::size_t adds = rank - k;  // members of the other group below it
      if (adds > n2) continue;
      for (std::size_t s = n1 * n2; s + 1 > adds; --s) counts[k][s] += counts[k - 1][s - adds];
    }
  }
  const std::vector<double>& all = counts[n1];
  const auto end = all.begin() + static_cast<std::ptrdiff_t>(std::min(u, n1 * n2) + 1);
  return std::accumulate(all.begin(), end, 0.0) / std::accumulate(all.begin(), all.end(), 0.0);
}

double NormalP(double u, double n1, double n2, double ties) {
  const double n = n1 + n2;
  const double variance = n1 * n2 / 12.0 * (n + 1.0 - ties / (n * (n - 1.0)));
  if (!(variance > 0.0)) return 1.0;
  const double off = std::max(0.0, std::abs(u - 0.5 * n1 * n2) - 0.5);
  return std::erfc(off / std::sqrt(2.0 * variance));
}

/// A transform of a quantity, and the names of its two ends.
struct Look {
  std::vector<double> values;
  std::string more, less;
};

std::vector<Look> LooksOf(const SampledColumn& column) {
  std::vector<Look> looks;
  if (column.words.empty()) {
    looks.push_back({column.values, "more", "less"});
    const double middle = Median(column.values);
    looks.push_back({column.values, "far off", "near"});
    for (double& value : looks.back().values) value = std::abs(value - middle);
    return looks;
  }
  std::vector<std::string> kinds = column.words;
  std::sort(kinds.begin(), kinds.end());
  kinds.erase(std::unique(kinds.begin(), kinds.end()), kinds.end());
  for (const std::string& kind : kinds) {
    Look look{{}, "is " + kind, "is not " + kind};
    for (const std::string& word : column.words) look.values.push_back(word == kind ? 1.0 : 0.0);
    looks.push_back(std::move(look));
  }
  return looks;
}

bool Differs(const std::vector<double>& values) {
  return std::any_of(values.begin(), values.end(), [&](double v) { return v != values.front(); });
}

struct Halves {
  std::vector<double> fell, stood;
};

Halves Split(const std::vector<double>& values, const std::vector<char>& fell) {
  Halves halves;
  for (std::size_t i = 0; i < values.size(); ++i) (fell[i] != 0 ? halves.fell : halves.stood).push_back(values[i]);
  return halves;
}

/// Log odds of a fall per standard deviation of each column: penalised likelihood by Newton's method. The penalty, one
/// half of each squared weight, keeps the weights finite even if one quantity separates all falls. le Cessie and van
/// Houwelingen, Applied Statistics 41(1), 1992, doi:10.2307/2347628.
Eigen::VectorXd LogisticWeights(const Eigen::MatrixXd& standardised, const std::vector<char>& fell) {
  const Eigen::Index n = standardised.rows(), m = standardised.cols() + 1;
  Eigen::MatrixXd X(n, m);
  X << Eigen::VectorXd::Ones(n), standardised;
  Eigen::VectorXd w = Eigen::VectorXd::Zero(m), penalty = Eigen::VectorXd::Ones(m);
  penalty[0] = 1e-6;
  constexpr int kSteps = 25;
  for (int step = 0; step < kSteps; ++step) {
    Eigen::VectorXd gradient = -penalty.cwiseProduct(w);
    Eigen::MatrixXd hessian = penalty.asDiagonal();
    for (Eigen::Index i = 0; i < n; ++i) {
      const double chance = 1.0 / (1.0 + std::exp(-X.row(i).dot(w)));
      gradient += (static_cast<double>(fell[static_cast<std::size_t>(i)] != 0) - chance) * X.row(i).transpose();
      hessian += chance * (1.0 - chance) * X.row(i).transpose() * X.row(i);
    }
    const Eigen::VectorXd change = SolveSymmetric(hessian, gradient);
    w += change;
    if (change.norm() < 1e-9) break;
  }
  return w.tail(m - 1);
}

Eigen::VectorXd Standardised(const std::vector<double>& values) {
  Eigen::VectorXd v = Eigen::Map<const Eigen::VectorXd>(values.data(), static_cast<Eigen::Index>(values.size()));
  v.array() -= v.mean();
  const double spread = std::sqrt(v.squaredNorm() / static_cast<double>(v.size()));
  return spread > 0.0 ? Eigen::VectorXd(v / spread) : v;
}

}  // namespace

RankTest CompareRanks(const std::vector<double>& first, const std::vector<double>& second) {
  if (first.empty() || second.empty()) return {};
  std::vector<double> all = first;
  all.insert(all.end(), second.begin(), second.end());
  const Ranks ranks = RanksOf(all);
  const double n1 = static_cast<double>(first.size()), n2 = static_cast<double>(second.size());
  const double sum = std::accumulate(ranks.rank.begin(), ranks.rank.begin() + static_cast<std::ptrdiff_t>(n1), 0.0);
  const double u = sum - 0.5 * n1 * (n1 + 1.0);
  RankTest test;
  test.effect = 2.0 * u / (n1 * n2) - 1.0;
  const double smaller = std::min(n1, n2);
  if (ranks.ties > 0.0 || (n1 + n2) * smaller * n1 * n2 > kMostExactWork) {
    test.p = NormalP(u, n1, n2, ranks.ties);
  } else {
    const auto tail = static_cast<std::size_t>(std::lround(std::min(u, n1 * n2 - u)));
    const std::size_t few = std::min(first.size(), second.size()), many = std::max(first.size(), second.size());
    test.p = std::min(1.0, 2.0 * ExactBelow(few, many, tail));
  }
  return test;
}

std::vector<Sensitivity> RankDisturbances(const std::vector<SampledColumn>& columns, const std::vector<char>& fell) {
  const auto falls = std::count_if(fell.begin(), fell.end(), [](char f) { return f != 0; });
  if (falls == 0 || falls == static_cast<std::ptrdiff_t>(fell.size())) return {};
  std::vector<Sensitivity> ranking;
  std::vector<Eigen::VectorXd> chosen;
  for (const SampledColumn& column : columns) {
    const std::size_t rows = column.words.empty() ? column.values.size() : column.words.size();
    if (rows != fell.size())
      throw InvalidArgument(fmt::format("'{}' has {} values for {} trials", column.name, rows, fell.size()));
    const std::vector<Look> looks = LooksOf(column);
    if (std::none_of(looks.begin(), looks.end(), [](const Look& look) { return Differs(look.values); })) continue;
    Sensitivity best{column.name, column.unit};
    best.of_a_word = !column.words.empty();
    std::vector<double> values;
    for (const Look& look : looks) {
      const Halves halves = Split(look.values, fell);
      const RankTest test = CompareRanks(halves.fell, halves.stood);
      const double p = std::min(1.0, test.p * static_cast<double>(looks.size()));
      if (!values.empty() && p >= best.p) continue;
      best.how = test.effect < 0.0 ? look.less : look.more;
      best.effect = std::abs(test.effect);
      best.p = p;
      values = look.values;
    }
    if (column.words.empty()) {
      const Halves halves = Split(column.values, fell);
      best.median_fell = Median(halves.fell);
      best.median_survived = Median(halves.stood);
    }
    ranking.push_back(best);
    chosen.push_back(Standardised(values));
  }
  Eigen::MatrixXd table(static_cast<Eigen::Index>(fell.size()), static_cast<Eigen::Index>(chosen.size()));
  for (std::size_t i = 0; i < chosen.size(); ++i) table.col(static_cast<Eigen::Index>(i)) = chosen[i];
  const Eigen::VectorXd weights = LogisticWeights(table, fell);
  for (std::size_t i = 0; i < ranking.size(); ++i) ranking[i].weight = weights[static_cast<Eigen::Index>(i)];
  std::stable_sort(ranking.begin(), ranking.end(), [](const Sensitivity& a, const Sensitivity& b) {
    return a.p != b.p ? a.p < b.p : a.effect > b.effect;
  });
  return ranking;
}

}  // namespace gaitwright
