// SPDX-License-Identifier: BSD-3-Clause
#include "tests/workflows/study/made_up_sweep.h"

namespace gaitwright {
namespace {

PointOutcome OutcomeAt(std::size_t point, double speed, int trials) {
  PointOutcome o;
  o.point = point;
  o.reason = "nothing is near its limit";
  o.status = speed < 0.35   ? PointStatus::kPass
             : speed < 0.45 ? PointStatus::kGateMissed
             : speed < 0.55 ? PointStatus::kFell
             : speed < 0.65 ? PointStatus::kAuditFailed
                            : PointStatus::kRefused;
  if (o.status == PointStatus::kRefused) {
    o.code = "joint_torque";
    o.reason = "the knee, \"FL_calf\", needs too much";
    return o;
  }
  o.score = 100.0 - 100.0 * speed;
  o.metrics = {0.01, std::nullopt};
  if (o.status == PointStatus::kGateMissed) o.code = "goal_error_m";
  if (o.status == PointStatus::kAuditFailed) o.code = "zmp_support";
  if (o.status == PointStatus::kFell) {
    o.code = "fell";
    o.fell_at_s = 1.5;
  }
  if (trials > 0 && o.audit_pass()) o.survival = SurvivalOf(trials, speed < 0.35 ? trials : 1, 0.5 * *o.score);
  return o;
}

}  // namespace

MadeUpSweep MakeUpSweep(const std::vector<std::string>& over, int trials, int samples) {
  MadeUpSweep sweep;
  sweep.study.model.name = "a<1>";
  sweep.study.axes = ParseAxes(over, samples > 0 ? StudyLayout::kSamples : StudyLayout::kGrid);
  sweep.study.points = samples > 0 ? SampledPoints(sweep.study.axes, static_cast<std::size_t>(samples), 0)
                                   : GridPoints(sweep.study.axes);
  sweep.study.metrics = {"goal_error_m", "zmp_margin_p05_m"};
  sweep.study.trials = trials;
  for (std::size_t point = 0; point < sweep.study.points.size(); ++point)
    sweep.outcomes.push_back(OutcomeAt(point, std::stod(sweep.study.points[point][0]), trials));
  return sweep;
}

int CountOf(const std::string& text, const std::string& part) {
  int count = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + part.size())) ++count;
  return count;
}

}  // namespace gaitwright
