// SPDX-License-Identifier: BSD-3-Clause
#include "optimisation/centroidal/cost_by_durations.h"

#include <optional>
#include <utility>

#include "optimisation/centroidal/rigid_body_rows.h"

namespace gaitwright {
namespace {

/// Sum of the multipliers times (row - its active bound).
double Held(const ConstrainedProblem& rows, const RigidBodyNumbers& numbers) {
  double sum = 0.0;
  VectorX value;
  Eigen::Index row = 0;
  for (const Constraint& c : rows.constraints) {
    const Eigen::Index count = c.lower.size();
    value.setZero(count);
    c.function(numbers.x(c.variables), value, nullptr);
    for (Eigen::Index i = 0; i < count; ++i) {
      const double multiplier = numbers.multipliers[row + i];
      if (multiplier != 0.0) sum += multiplier * (value[i] - (multiplier > 0.0 ? c.upper[i] : c.lower[i]));
    }
    row += count;
  }
  return sum;
}

Eigen::Index CountOf(const ConstrainedProblem& rows) {
  Eigen::Index count = 0;
  for (const Constraint& c : rows.constraints) count += c.lower.size();
  return count;
}

/// Nothing for numbers that do not fit the problem.
std::optional<double> Lagrangian(const RigidBodyProblem& problem, const RigidBodyOptions& options,
                                 const RigidBodyNumbers& numbers) {
  const RigidBodyUnknowns unknowns(problem, numbers.nodes_s);
  const ConstrainedProblem rows = RigidBodyRows(problem, unknowns, options, numbers.missed);
  if (numbers.x.size() != unknowns.size() || numbers.multipliers.size() != CountOf(rows)) return std::nullopt;
  double sum = Held(rows, numbers);
  VectorX value;
  for (const Residual& r : rows.residuals) {
    value.setZero();
    r.function(numbers.x(r.variables), value, nullptr);
    sum += value.squaredNorm();
  }
  return sum;
}

}  // namespace

RigidBodyNumbers Retimed(RigidBodyNumbers numbers, const TimeMap& map) {
  for (double& t : numbers.nodes_s) t = map.At(t);
  for (MissedReach& missed : numbers.missed) missed.time_s = map.At(missed.time_s);
  return numbers;
}

VectorX CostByDurations(const RigidBodyProblem& problem, const RigidBodyOptions& options,
                        const RigidBodyNumbers& numbers) {
  constexpr double kStep = 1e-7;
  const std::optional<double> here = Lagrangian(problem, options, numbers);
  if (!IsRetimable(problem) || !here) throw InvalidArgument("CostByDurations: the variables belong to another problem");
  const std::vector<double> switches = SwitchTimes(problem);
  VectorX slope(static_cast<Eigen::Index>(switches.size()) - 1);
  for (std::size_t phase = 0; phase + 1 < switches.size(); ++phase) {
    const auto moved_by = [&](double step) {
      std::vector<double> moved = switches;
      for (std::size_t k = phase + 1; k < moved.size(); ++k) moved[k] += step;
      const TimeMap map(switches, moved);
      return Lagrangian(Retimed(problem, map), options, Retimed(numbers, map));
    };
    // At a duration of exactly swing_lead_s, the number of rows differs between the two sides.
    double step = kStep;
    std::optional<double> there = moved_by(step);
    if (!there) there = moved_by(step = -kStep);
    slope[static_cast<Eigen::Index>(phase)] = (there.value_or(*here) - *here) / step;
  }
  return slope;
}

}  // namespace gaitwright
