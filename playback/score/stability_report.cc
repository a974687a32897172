// SPDX-License-Identifier: BSD-3-Clause
#include "playback/score/stability_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "kinematics/base/nearest_name.h"
#include "kinematics/base/result.h"
#include "playback/score/command_score_internal.h"
#include "playback/score/gates.h"
#include "playback/score/measurements.h"
#include "playback/score/reason.h"

namespace gaitwright {
namespace {

// if the support is a line or point for a larger share of the time, the ZMP margin is meaningless
constexpr double kLineShare = 0.05;

/// Reason for which the gate of this key does not apply to the motion; empty if it applies.
std::string NotApplied(const std::string& key, double share_without_area) {
  if (key == "zmp_margin_p05_m" && share_without_area > kLineShare) {
    return fmt::format(
        "the support is a line or a point for {:.0f} % of the time, so dcm_capture_margin_min_m is the gate",
        100.0 * share_without_area);
  }
  if (key == "dcm_capture_margin_min_m" && share_without_area <= kLineShare) {
    return "the support has area, so zmp_margin_p05_m is the gate";
  }
  return {};
}

Metric Gated(const MetricRule& rule, const Measurement& measured, const GateScale& scale, double share_without_area) {
  Metric metric;
  metric.key = rule.key;
  metric.unit = rule.unit;
  metric.value = measured.value;
  metric.planned = measured.planned;
  metric.at_s = measured.at_s;
  metric.not_applied = measured.value ? NotApplied(rule.key, share_without_area) : measured.missing;
  if (measured.value && scale.only_commands) metric.not_applied = GateNotOfCommands(rule.key);
  metric.bound = rule.bound;
  const auto limit = LimitOf(rule, scale);
  metric.applied = limit.has_value() && metric.not_applied.empty();
  if (!metric.applied) return metric;
  metric.limit = limit;
  metric.pass = Holds(rule.bound, *metric.value, *limit);
  return metric;
}

std::vector<Metric> GatedMetrics(const ScoreInputs& in, const GateScale& scale) {
  std::vector<Measurement> all;
  for (const auto& group :
       {ProgressMeasurements(in), ZmpMeasurements(in), BalanceMeasurements(in), ContactMeasurements(in),
        JointMeasurements(in), CommandMeasurements(in), EstimateMeasurements(in)}) {
    all.insert(all.end(), group.begin(), group.end());
  }
  if (scale.only_commands) KeepCommanded(all);
  const double share_without_area = ShareWithoutArea(in.series);
  std::vector<Metric> metrics;
  for (const MetricRule& rule : MetricRules()) {
    const auto found = std::find_if(all.begin(), all.end(), [&](const Measurement& m) { return m.key == rule.key; });
    if (found == all.end()) throw std::logic_error("Score: internal error: no measurement of '" + rule.key + "'");
    metrics.push_back(Gated(rule, *found, scale, share_without_area));
  }
  return metrics;
}

/// Removes samples after the fall; keeps at least one sample.
void CutAt(double time_s, MotionSeries& series) {
  std::size_t count = series.measured.size();
  while (count > 1 && series.measured[count - 1].time_s > time_s + 1e-9) --count;
  series.measured.resize(count);
  series.planned.resize(count);
  series.plan.resize(count);
}

std::vector<std::string> NotesOf(const RobotModel& model) {
  std::vector<std::string> efforts, speeds, notes;
  for (const Actuator& motor : ActuatorsOf(model)) {
    if (motor.shared() && !std::isfinite(motor.effort_limit)) efforts.push_back(motor.name);
    if (motor.shared() && !std::isfinite(motor.velocity_limit)) speeds.push_back(motor.name);
  }
  for (const Joint& joint : model.joints) {
    if (model.TransmissionOf(joint.dof) != nullptr) continue;
    if (joint.effort_limit_is_placeholder) efforts.push_back(joint.name);
    if (joint.velocity_limit_is_placeholder) speeds.push_back(joint.name);
  }
  if (!efforts.empty()) notes.push_back("torque limits are placeholders and are not checked: " + QuotedList(efforts));
  if (!speeds.empty()) notes.push_back("speed limits are placeholders and are not checked: " + QuotedList(speeds));
  return notes;
}

}  // namespace

const Metric& StabilityReport::At(const std::string& key) const {
  std::vector<std::string> keys;
  for (const Metric& metric : metrics) {
    if (metric.key == key) return metric;
    keys.push_back(metric.key);
  }
  throw InvalidArgument(fmt::format("StabilityReport: no metric '{}'{}", key, NearestHint(key, keys)));
}

StabilityReport Score(const RobotModel& model, const MotionPlan& plan, const PlaybackLog& log,
                      const ScoreOptions& options) {
  ScoreOptions checked = options;
  CheckOptions(checked.Fields());
  if (log.samples.empty()) throw InvalidArgument("Score: the log has no samples; one or more are needed");
  MotionSeries series = MakeMotionSeries(model, plan, log, options);
  if (series.measured.empty())
    throw InvalidArgument("Score: the log's first state is not finite; nothing can be measured");
  const Fall fall = FindFall(plan, log, series, options);
  if (fall.fell) CutAt(fall.time_s, series);
  const GateScale scale = ScaleOf(model, plan);
  const ScoreInputs in{model, plan, log, options, std::move(series), fall, scale.leg_length_m};

  StabilityReport report;
  report.robot = model.name;
  report.metrics = GatedMetrics(in, scale);
  report.pass = std::all_of(report.metrics.begin(), report.metrics.end(), [](const Metric& m) { return m.pass; });
  const double duration = plan.duration_s();
  const double share = duration > 0.0 ? (fall.time_s - log.start_s) / duration : 1.0;
  report.score = ScoreOf(report.metrics, scale, share);
  report.reason = ReasonOf(in, report.metrics);
  report.cause = CauseOf(in, report.metrics);
  report.notes = NotesOf(model);
  if (log.start_penetration)
    report.notes.push_back(fmt::format("in the first posture link '{}' is {:.1f} mm inside '{}' of the ground",
                                       log.start_penetration->link, 1e3 * log.start_penetration->depth_m,
                                       log.start_penetration->solid));
  return report;
}

StabilityReport Score(const RobotModel& model, const MotionPlan& plan, const PlaybackLog& log) {
  return Score(model, plan, log, ScoreOptionsOf(log));
}

}  // namespace gaitwright
