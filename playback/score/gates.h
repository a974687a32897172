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
  double limit = 0.0;  ///< in the key's unit, for a leg of kReferenceLegLength where scaled
  bool scales_with_leg = false;
  double weight = 0.0;  ///< in the score; 0 if it is only reported
  double scale = 1.0;   ///< the value (lower is better) or half-width (higher is better) at quality one half
  std::string meaning;
};

/// Lengths marked as scaled are for a robot whose longest leg, hip to contact, is this long [m].
inline constexpr double kReferenceLegLength = 0.42;

/// Every metric of one playback, in the order of the report. The only place that holds gates; no row knows a robot's
/// name.
const std::vector<MetricRule>& MetricRules();

/// The row of that key. @throws InvalidArgument naming the nearest.
const MetricRule& RuleOf(const std::string& key);

/// What limits depend on.
struct GateScale {
  double leg_length_m = kReferenceLegLength;
  double commanded_distance_m = 0.0;
};

/// The scale of a robot and a plan: distance from the start of the plan's base to its goal.
GateScale ScaleOf(const RobotModel& model, const MotionPlan& plan);

/// The limit of a rule: `limit`, times leg over reference leg where scaled; `goal_error_m` has max(5 % of the commanded
/// distance, 2 cm). Nothing when the rule has no gate.
std::optional<double> LimitOf(const MetricRule& rule, const GateScale& scale);

/// Whether the value keeps the limit.
bool Holds(Bound bound, double value, double limit);

/// Quality of a value, in (0, 1], strictly falling as it gets worse; 1 where neither direction is better.
///   lower is better:   1 / (1 + max(value, 0) / s)        higher is better:   1 / (1 + exp(-value / s))
/// with s the rule's scale, times leg over reference leg for lengths that scale.
double QualityOf(const MetricRule& rule, double value, const GateScale& scale);

/// From 0 to 100, and never higher when any metric is worse:
///   50 (gates hold) + 50 (weighted mean of the qualities) while standing, so that 50 and more means a pass;
///   25 (share of the time before the fall) (weighted mean) after a fall.
/// A metric that the motion cannot have counts as 1 while standing and as 0 after a fall. Comparable only for the same
/// robot, terrain and command.
double ScoreOf(const std::vector<Metric>& metrics, const GateScale& scale, double share_before_fall);

}  // namespace gaitwright
