// SPDX-License-Identifier: BSD-3-Clause
#include "playback/score/gates.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "kinematics/base/nearest_name.h"
#include "kinematics/base/result.h"
#include "planning/plan/plans_contacts_internal.h"
#include "playback/score/command_score_internal.h"

namespace gaitwright {
namespace {

constexpr double kGoalShare = 0.05;    // of the commanded distance
constexpr double kGoalLeast = 0.02;    // [m]
constexpr double kCommandShare = 0.2;  // of the largest commanded velocity
constexpr double kCommandLeast = 0.1;  // [m/s], [rad/s]
constexpr auto kLower = Better::kLower;
constexpr auto kHigher = Better::kHigher;

/// A metric that is reported and scored, but has no gate.
MetricRule Reported(std::string key, std::string unit, Better better, double weight, double scale, bool scales,
                    std::string meaning) {
  MetricRule rule;
  rule.key = std::move(key);
  rule.unit = std::move(unit);
  rule.better = better;
  rule.weight = weight;
  rule.scale = scale;
  rule.scales_with_leg = scales;
  rule.meaning = std::move(meaning);
  return rule;
}

MetricRule Gated(MetricRule rule, Bound bound, double limit) {
  rule.bound = bound;
  rule.limit = limit;
  return rule;
}

// Columns: key, unit, better, weight in the score, value at quality one half, whether lengths scale with the leg,
// meaning.
std::vector<MetricRule> ProgressRules() {
  return {
      Gated(Reported("fell", "1", kLower, 0.0, 1.0, false,
                     "base tilt or height out of bounds relative to the plan, or a body link on the ground"),
            Bound::kAtMost, 0.0),
      Reported("time_to_fall_s", "s", kHigher, 0.0, 1.0, false, "time from the start of the playback to the fall"),
      Reported("distance_m", "m", Better::kNeither, 0.0, 1.0, false,
               "distance from the base's start to its end, in plan view"),
      Gated(
          Reported("goal_error_m", "m", kLower, 3.0, 0.03, false, "distance from the base's end to the command's goal"),
          Bound::kAtMost, kGoalLeast),
      Gated(Reported("heading_error_rad", "rad", kLower, 2.0, 0.05, false,
                     "difference between the base's yaw at the end and the goal's yaw"),
            Bound::kAtMost, 0.1),
  };
}

std::vector<MetricRule> BalanceRules() {
  return {
      Reported("zmp_margin_min_m", "m", kHigher, 1.0, 0.02, true,
               "smallest distance of the ZMP to the edge of the support"),
      Gated(Reported("zmp_margin_p05_m", "m", kHigher, 3.0, 0.02, true,
                     "distance of the ZMP to the edge of the support, 5th percentile"),
            Bound::kAbove, 0.0),
      Reported("zmp_outside_fraction", "1", kLower, 1.0, 0.1, false, "share of time with the ZMP outside the support"),
      Reported("zmp_error_mean_m", "m", kLower, 2.0, 0.01, true,
               "distance between measured and planned ZMP in the support's frame, mean"),
      Reported("zmp_error_rms_m", "m", kLower, 1.0, 0.01, true,
               "distance between measured and planned ZMP in the support's frame, root mean square"),
      Reported("zmp_error_max_m", "m", kLower, 0.5, 0.03, true,
               "distance between measured and planned ZMP in the support's frame, largest"),
      Reported("dcm_error_mean_m", "m", kLower, 2.0, 0.01, true,
               "distance between measured and planned DCM in the support's frame, mean"),
      Reported("dcm_error_max_m", "m", kLower, 0.5, 0.03, true,
               "distance between measured and planned DCM in the support's frame, largest"),
      Gated(Reported("dcm_capture_margin_min_m", "m", kHigher, 3.0, 0.03, true,
                     "smallest distance of the DCM at touch-down to the edge of the one-step capturable region"),
            Bound::kAbove, 0.0),
      Reported("static_margin_min_m", "m", kHigher, 0.5, 0.03, true,
               "smallest distance of the centre of mass, in plan view, to the edge of the support"),
      Reported("energy_margin_min_m", "m", kHigher, 0.5, 0.01, true,
               "smallest rise of the centre of mass needed to tip over an edge of the support"),
      Reported("tracking_joint_rms_rad", "rad", kLower, 1.0, 0.02, false,
               "root mean square difference between measured and planned joint positions"),
      Reported("tracking_base_rms_m", "m", kLower, 1.0, 0.02, true,
               "root mean square distance between measured and planned base position"),
      Reported("tracking_com_rms_m", "m", kLower, 1.0, 0.02, true,
               "root mean square distance between measured and planned centre of mass"),
  };
}

std::vector<MetricRule> ContactRules() {
  return {
      Reported("slip_total_m", "m", kLower, 1.0, 0.05, true, "total distance that all feet slid in contact"),
      Gated(Reported("slip_max_step_m", "m", kLower, 1.0, 0.01, true,
                     "largest distance that one foot slid in one stance"),
            Bound::kAtMost, 0.010),
      Gated(Reported("penetration_max_m", "m", kLower, 0.5, 0.002, false,
                     "largest penetration of a foot into the ground"),
            Bound::kAtMost, 0.002),
      Reported("clearance_min_m", "m", kHigher, 0.5, 0.02, true,
               "smallest height of a sole in the middle half of a swing"),
      Gated(Reported("scuffs", "1", kLower, 1.0, 1.0, false, "number of swings with contact during the swing"),
            Bound::kAtMost, 0.0),
      Reported("impact_max_n_per_mg", "1", kLower, 1.0, 2.0, false,
               "peak normal force of a foot divided by the weight"),
      Reported("touchdown_speed_max_m_s", "m/s", kLower, 0.5, 0.3, false,
               "largest speed of a foot just before contact"),
      Reported("friction_use_max", "1", kLower, 1.0, 0.6, false,
               "largest tangential force divided by friction times normal force"),
      Gated(Reported("contact_timing_error_max_s", "s", kLower, 1.0, 0.03, false,
                     "largest time difference of touch-down and lift-off to the schedule"),
            Bound::kAtMost, 0.040),
  };
}

std::vector<MetricRule> JointRules() {
  return {
      Reported("torque_use_max", "1", kLower, 1.0, 0.6, false,
               "largest joint torque divided by its limit at that time"),
      Gated(Reported("torque_saturated_fraction", "1", kLower, 1.0, 0.01, false,
                     "share of time at the torque limit, for the worst joint"),
            Bound::kAtMost, 0.01),
      Reported("joint_speed_use_max", "1", kLower, 0.5, 0.6, false, "largest joint speed divided by its limit"),
      Gated(Reported("joint_limit_margin_min_rad", "rad", kHigher, 0.5, 0.1, false,
                     "smallest distance of a moving joint to its position limit (in metres for prismatic joints)"),
            Bound::kAbove, 0.0),
      Reported("cost_of_transport", "1", kLower, 0.5, 1.0, false, "positive joint work divided by m g d"),
      Reported("smoothness_jerk_rms", "rad/s^3", kLower, 0.5, 1000.0, false, "root mean square jerk of the joints"),
      Reported("torque_step_use_max", "1", kLower, 0.5, 0.3, false,
               "largest step of a joint's torque at a contact switch, divided by its limit"),
  };
}

/// Errors of the velocities of a plan that is only a command; other plans have no values, and their scores do not
/// change.
std::vector<MetricRule> CommandRules() {
  return {
      Gated(Reported("command_velocity_error_m_s", "m/s", kLower, 3.0, 0.1, false,
                     "difference between the commanded and the measured velocity of the base in plan view, averaged "
                     "over 0.5 s, mean"),
            Bound::kAtMost, kCommandLeast),
      Gated(Reported("command_yaw_rate_error_rad_s", "rad/s", kLower, 2.0, 0.1, false,
                     "difference between the commanded and the measured yaw rate of the base, averaged over 0.5 s, "
                     "mean"),
            Bound::kAtMost, kCommandLeast),
  };
}

/// Errors of the controller's estimate of the base; they do not affect the score.
std::vector<MetricRule> EstimateRules() {
  return {
      Reported("estimate_drift_m", "m", kLower, 0.0, 0.1, false,
               "error of the estimated base position at the end, in plan view"),
      Reported("estimate_height_m", "m", kLower, 0.0, 0.02, false, "largest error of the estimated base height"),
      Reported("estimate_tilt_rad", "rad", kLower, 0.0, 0.03, false,
               "largest error of the estimated up direction of the base"),
      Reported("estimate_heading_rad", "rad", kLower, 0.0, 0.05, false,
               "largest error of the estimated heading of the base"),
      Reported("estimate_velocity_m_s", "m/s", kLower, 0.0, 0.03, false,
               "root mean square error of the estimated velocity in base axes"),
  };
}

double LegFactor(const MetricRule& rule, const GateScale& scale) {
  return rule.scales_with_leg ? scale.leg_length_m / kReferenceLegLength : 1.0;
}

}  // namespace

const std::vector<MetricRule>& MetricRules() {
  static const std::vector<MetricRule> rules = [] {
    std::vector<MetricRule> all = ProgressRules();
    for (const auto& part : {BalanceRules(), ContactRules(), JointRules(), CommandRules(), EstimateRules()})
      all.insert(all.end(), part.begin(), part.end());
    return all;
  }();
  return rules;
}

const MetricRule& RuleOf(const std::string& key) {
  std::vector<std::string> keys;
  for (const MetricRule& rule : MetricRules()) {
    if (rule.key == key) return rule;
    keys.push_back(rule.key);
  }
  throw InvalidArgument(
      fmt::format("unknown metric '{}'{}", key, NearestOrAll(key, keys, "docs/scores.md lists all metrics")));
}

GateScale ScaleOf(const RobotModel& model, const MotionPlan& plan) {
  GateScale scale;
  const double leg = model.legs.empty() ? 0.0 : model.leg_length_m();
  if (std::isfinite(leg) && leg > 0.0) scale.leg_length_m = leg;
  if (!plan.whole_body.q.empty()) {
    const Vector2 start = plan.whole_body.q.front().head<2>();
    scale.commanded_distance_m = (Vector2(plan.goal.x_m, plan.goal.y_m) - start).norm();
    scale.only_commands = !PlansContacts(plan);
  }
  for (const VectorX& v : plan.whole_body.v) {
    if (!scale.only_commands) break;
    scale.commanded_speed_m_s = std::max(scale.commanded_speed_m_s, v.head<2>().norm());
    scale.commanded_yaw_rate_rad_s = std::max(scale.commanded_yaw_rate_rad_s, std::abs(v[5]));
  }
  return scale;
}

std::optional<double> LimitOf(const MetricRule& rule, const GateScale& scale) {
  if (rule.bound == Bound::kNone) return std::nullopt;
  if (rule.key == "goal_error_m") return std::max(kGoalShare * scale.commanded_distance_m, kGoalLeast);
  if (IsOfCommands(rule.key)) {
    if (!scale.only_commands) return std::nullopt;
    const bool turns = rule.key == "command_yaw_rate_error_rad_s";
    const double largest = turns ? scale.commanded_yaw_rate_rad_s : scale.commanded_speed_m_s;
    return std::max(kCommandShare * largest, rule.limit);
  }
  return rule.limit * LegFactor(rule, scale);
}

bool Holds(Bound bound, double value, double limit) {
  constexpr double kRounding = 1e-7;  // [m, rad, s] of distances and times that may be as large as a limit
  switch (bound) {
    case Bound::kNone:
      return true;
    case Bound::kAtMost:
      return value <= limit + kRounding;
    case Bound::kAtLeast:
      return value >= limit - kRounding;
    case Bound::kAbove:
      return value > limit;
  }
  return false;
}

double QualityOf(const MetricRule& rule, double value, const GateScale& scale) {
  const double s = rule.scale * LegFactor(rule, scale);
  switch (rule.better) {
    case Better::kNeither:
      return 1.0;
    case Better::kLower:
      return 1.0 / (1.0 + std::max(value, 0.0) / s);
    case Better::kHigher:
      return 1.0 / (1.0 + std::exp(-value / s));
  }
  return 0.0;
}

double ScoreOf(const std::vector<Metric>& metrics, const GateScale& scale, double share_before_fall) {
  double weighted = 0.0, weights = 0.0;
  bool fell = false, pass = true;
  for (const Metric& metric : metrics) {
    if (metric.key == "fell") fell = metric.value.value_or(0.0) > 0.0;
    pass = pass && metric.pass;
  }
  for (const MetricRule& rule : MetricRules()) {
    const auto metric =
        std::find_if(metrics.begin(), metrics.end(), [&](const Metric& m) { return m.key == rule.key; });
    const bool known = metric != metrics.end() && metric->value.has_value();
    if (!known && !scale.only_commands && IsOfCommands(rule.key)) continue;
    const double quality = known ? QualityOf(rule, *metric->value, scale) : (fell ? 0.0 : 1.0);
    weighted += rule.weight * quality;
    weights += rule.weight;
  }
  const double mean = weighted / weights;
  if (fell) return 25.0 * std::clamp(share_before_fall, 0.0, 1.0) * mean;
  return (pass ? 50.0 : 0.0) + 50.0 * mean;
}

}  // namespace gaitwright
