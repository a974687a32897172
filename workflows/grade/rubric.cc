// SPDX-License-Identifier: BSD-3-Clause
#include "workflows/grade/rubric.h"

#include <algorithm>

namespace gaitwright {

const std::vector<std::string>& PartKindNames() {
  static const std::vector<std::string> names = {"function",   "answers", "plan",      "motion",
                                                 "parameters", "planner", "controller"};
  return names;
}

bool RunsCode(RubricPartKind kind) {
  return kind == RubricPartKind::kFunction || kind == RubricPartKind::kPlanner || kind == RubricPartKind::kController;
}

bool PlaysMotions(RubricPartKind kind) { return kind != RubricPartKind::kFunction && kind != RubricPartKind::kAnswers; }

const std::vector<std::string>& CommandKeys() {
  static const std::vector<std::string> keys = {
      "speed_m_s", "lateral_speed_m_s", "yaw_rate_rad_s", "distance_m", "duration_s",
      "steps",     "step_length_m",     "goal_x_m",       "goal_y_m",   "goal_yaw_rad"};
  return keys;
}

bool MayBeSet(const std::string& key, const std::vector<std::string>& allowed) {
  return std::any_of(allowed.begin(), allowed.end(), [&](const std::string& name) {
    return name.ends_with("*") ? key.starts_with(name.substr(0, name.size() - 1)) : key == name;
  });
}

double Check::PointsOf(double value) const {
  const double sign = higher_is_better ? 1.0 : -1.0;
  if (sign * (value - full_at) >= 0.0) return points;
  if (!none_at || sign * (value - *none_at) <= 0.0) return 0.0;
  return points * (value - *none_at) / (full_at - *none_at);
}

double Rubric::points() const {
  double sum = 0.0;
  for (const RubricPart& part : parts) sum += part.points;
  return sum;
}

}  // namespace gaitwright
