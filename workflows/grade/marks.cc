// SPDX-License-Identifier: BSD-3-Clause
#include "workflows/grade/marks.h"

#include <fmt/format.h>

#include <cmath>

namespace gaitwright {
namespace {

std::string WhatWasLost(const Check& check, const std::optional<double>& value, double points) {
  const std::string lost = PointsText(check.points - points);
  if (!value) return fmt::format("{}: no measurement; {} points lost", check.measure, lost);
  return fmt::format("{} is {:.4g}; full points need {} {:.4g}{}; {} points lost", check.measure, *value,
                     check.higher_is_better ? "at least" : "at most", check.full_at,
                     check.none_at ? fmt::format(", zero points at {:.4g}", *check.none_at) : "", lost);
}

}  // namespace

PartMark NothingFor(const RubricPart& part, const std::string& reason) {
  PartMark mark{part.name, part.title, 0.0, part.points, {}, {reason}, {}};
  for (const Check& check : part.checks) mark.checks.push_back({check.measure, {}, 0.0, check.points});
  return mark;
}

PartMark MarkOf(const RubricPart& part, const std::vector<std::optional<double>>& values) {
  PartMark mark{part.name, part.title, 0.0, part.points, {}, {}, {}};
  for (std::size_t i = 0; i < part.checks.size(); ++i) {
    const Check& check = part.checks[i];
    const bool measured = values[i] && std::isfinite(*values[i]);
    const double points = measured ? check.PointsOf(*values[i]) : 0.0;
    mark.points += points;
    mark.checks.push_back({check.measure, measured ? values[i] : std::nullopt, points, check.points});
    if (points < check.points) mark.reasons.push_back(WhatWasLost(check, mark.checks.back().value, points));
  }
  return mark;
}

double StudentMarks::points() const {
  double sum = 0.0;
  for (const PartMark& part : parts) sum += part.points;
  return sum;
}

double StudentMarks::of() const {
  double sum = 0.0;
  for (const PartMark& part : parts) sum += part.of;
  return sum;
}

std::string PointsText(double points) { return fmt::format("{:g}", std::round(points * 100.0) / 100.0); }

}  // namespace gaitwright
