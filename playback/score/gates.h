// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "kinematics/model/robot_model.h"
#include "planning/plan/motion_plan.h"
#include "playback/score/metric.h"

namespace gaitwright {

/// One row of the table of metrics: meaning of a key, its gate, and its weight in the score.
struct MetricRule {
  std::string key, unit;
  Better better = Better::kNeither;
  Bound bound = Bound::kNone;
  double limit = 0.0;  ///< in the key's unit; if scaled, for a leg of kReferenceLegLength
  bool scales_with_leg = false;
  double weight = 0.0;  ///< in the score; 0 if it is only reported
  double scale = 1.0;   ///< the value (lower is better) or half-width (higher is better) at quality one half
  std::string meaning;
};

/// Scaled lengths apply to a robot whose longest leg, hip to contact, has this length [m].
inline constexpr double kReferenceLegLength = 0.42;

/// All metrics of one playback, in the order of the report. All gates are defined here and nowhere else; no row depends
/// on a robot's name.
const std::vector<MetricRule>& MetricRules();

/// The row of a key. @throws InvalidArgument naming the nearest key.
const MetricRule& RuleOf(const std::string& key);

/// Quantities that scale the limits.
struct GateScale {
  double leg_length_m = kReferenceLegLength;
  double commanded_distance_m = 0.0;
  bool only_commands = false;  ///< the plan has no contacts (PlansContacts); only then are there gates of commands
  double commanded_speed_m_s = 0.0, commanded_yaw_rate_rad_s = 0.0;  ///< the largest ones
};

/// The scale of a robot and a plan: distance from the start of the plan's base to its goal, and the largest commanded
/// velocities of a plan without contacts.
GateScale ScaleOf(const RobotModel& model, const MotionPlan& plan);

/// The limit of a rule: `limit`, times leg length over reference leg length if scaled. For `goal_error_m` it is max(5 %
/// of the commanded distance, 2 cm); for errors of commanded velocities max(20 % of the largest command, 0.1 m/s or
/// rad/s). Nothing if the rule has no gate.
std::optional<double> LimitOf(const MetricRule& rule, const GateScale& scale);

/// Whether the value is within the limit.
bool Holds(Bound bound, double value, double limit);

/// Quality of a value, in (0, 1], strictly decreasing as the value gets worse; 1 if neither direction is better.
///   lower is better:   1 / (1 + max(value, 0) / s)        higher is better:   1 / (1 + exp(-value / s))
/// with s the rule's scale, times leg length over reference leg length for scaled lengths.
double QualityOf(const MetricRule& rule, double value, const GateScale& scale);

/// From 0 to 100; never increases when any metric gets worse:
///   50 (gates hold) + 50 (weighted mean of the qualities) without a fall, so that 50 or more means a pass;
///   25 (share of the time before the fall) (weighted mean) after a fall.
/// A metric without a value counts as 1 without a fall and as 0 after a fall. Scores are comparable only for the same
/// robot, terrain and command.
double ScoreOf(const std::vector<Metric>& metrics, const GateScale& scale, double share_before_fall);

}  // namespace gaitwright
