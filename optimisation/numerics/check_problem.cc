// SPDX-License-Identifier: BSD-3-Clause
#include "optimisation/numerics/check_problem.h"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>
#include <string>

namespace gaitwright {
namespace {

/// @throws InvalidArgument unless both bounds have `size` entries, at least one, and no lower bound is above its upper
/// bound.
void CheckInterval(const std::string& what, const VectorX& lower, const VectorX& upper, Eigen::Index size) {
  if (size == 0 || lower.size() != size || upper.size() != size) {
    throw InvalidArgument(
        fmt::format("Solve: {}: {} lower and {} upper bounds; the numbers must be equal and at least 1", what,
                    lower.size(), upper.size()));
  }
  for (Eigen::Index i = 0; i < size; ++i) {
    if (!(lower[i] <= upper[i]))
      throw InvalidArgument(fmt::format(
          "Solve: {}: bounds {} are {} (lower) and {} (upper); the lower one must not be above the upper one", what, i,
          lower[i], upper[i]));
  }
}

}  // namespace

std::vector<int> CheckedVariables(const std::vector<int>& variables, int count) {
  std::vector<int> all(static_cast<std::size_t>(count));
  std::iota(all.begin(), all.end(), 0);
  if (variables.empty()) return all;
  std::vector<int> sorted = variables;
  std::sort(sorted.begin(), sorted.end());
  if (const auto twice = std::adjacent_find(sorted.begin(), sorted.end()); twice != sorted.end())
    throw InvalidArgument(fmt::format("Solve: a list of variables names {} twice", *twice));
  for (const int v : {sorted.front(), sorted.back()}) {
    if (v < 0 || v >= count)
      throw InvalidArgument(fmt::format("Solve: a list of variables names {}; accepted: 0 to {}", v, count - 1));
  }
  return variables;
}

void CheckConstrainedProblem(const ConstrainedProblem& problem) {
  if (problem.start.size() == 0 || !problem.start.allFinite())
    throw InvalidArgument("Solve: the start must be finite and not empty");
  if (problem.lower.size() + problem.upper.size() > 0)
    CheckInterval("the bounds", problem.lower, problem.upper, problem.start.size());
  const auto n = static_cast<int>(problem.start.size());
  for (const Constraint& c : problem.constraints)
    CheckInterval(fmt::format("constraint '{}'", c.name), c.lower, c.upper, c.lower.size());
  for (const Residual& r : problem.residuals) (void)CheckedVariables(r.variables, n);
  for (const Constraint& c : problem.constraints) (void)CheckedVariables(c.variables, n);
}

}  // namespace gaitwright
