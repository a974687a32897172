// SPDX-License-Identifier: BSD-3-Clause
#include "workflows/words/task_scores.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "planning/plan/json_part_internal.h"
#include "playback/score/measurements.h"

namespace gaitwright {
namespace {

std::optional<double> ValueOf(const StabilityReport& report, const std::string& key) {
  const auto metric =
      std::find_if(report.metrics.begin(), report.metrics.end(), [&](const Metric& m) { return m.key == key; });
  return metric == report.metrics.end() ? std::nullopt : metric->value;
}

}  // namespace

TaskScores ScoreTasks(const PlannedTasks& planned, const PlayedWalk& played) {
  constexpr double kSlack = 1e-6;  // [s]
  TaskScores scores;
  scores.asked = static_cast<int>(planned.task_ends_s.size());
  const std::optional<double> fell_s = ValueOf(played.report, "time_to_fall_s");
  scores.done = static_cast<int>(std::count_if(planned.task_ends_s.begin(), planned.task_ends_s.end(),
                                               [&](double end_s) { return !fell_s || end_s < *fell_s - kSlack; }));
  for (const char* key : {"zmp_margin_p05_m", "dcm_capture_margin_min_m"}) {
    if (scores.stability_m) break;
    scores.stability_m = ValueOf(played.report, key);
    scores.stability_key = key;
  }
  scores.jerk_rad_s3 = ValueOf(played.report, "smoothness_jerk_rms");
  scores.energy_j = PositiveWork(played.log, played.log.samples.size());
  return scores;
}

std::string TaskScoresText(const TaskScores& s) {
  std::string text = fmt::format("{} of {} tasks done", s.done, s.asked);
  if (s.stability_m) text += fmt::format("; stability {:.0f} mm ({})", 1e3 * *s.stability_m, s.stability_key);
  if (s.jerk_rad_s3) text += fmt::format("; smoothness {:.0f} rad/s^3 of jerk", *s.jerk_rad_s3);
  return text + fmt::format("; energy {:.1f} J", s.energy_j);
}

std::string TaskScoresJson(const TaskScores& s) {
  const nlohmann::ordered_json json = {
      {"completion", {{"done", s.done}, {"of", s.asked}}},
      {"stability", {{"metric", s.stability_key}, {"value_m", JsonOrNull(s.stability_m)}}},
      {"smoothness", {{"jerk_rms_rad_s3", JsonOrNull(s.jerk_rad_s3)}}},
      {"energy", {{"work_j", s.energy_j}}}};
  return json.dump();
}

}  // namespace gaitwright
