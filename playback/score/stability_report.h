// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "kinematics/model/robot_model.h"
#include "planning/plan/motion_plan.h"
#include "playback/log/playback_log.h"
#include "playback/score/metric.h"
#include "playback/score/score_options.h"

namespace gaitwright {

/// Verdict and metrics of a playback. Always true: the verdict is a pass exactly when every applied gate holds; metrics
/// stand in the order of MetricRules().
struct StabilityReport {
  std::string robot;
  bool pass = false;
  double score = 0.0;  ///< see ScoreOf
  std::string reason;  ///< why it fell or failed, or which gate is tightest; one plain sentence
  std::string cause;   ///< the reason in a few words without numbers, for counts; empty for a pass, see CauseOf
  std::vector<Metric> metrics;
  std::vector<std::string> notes;  ///< placeholder limits and the like

  /// The metric of that key. @throws InvalidArgument naming the nearest.
  const Metric& At(const std::string& key) const;

  bool operator==(const StabilityReport&) const = default;
};

/// Judges what was measured against the plan and the table of gates.h. A pure function: no state, no files, no clock.
/// After a fall only what came before it is measured.
/// @throws InvalidArgument when the options are out of range, the plan has no rows, the log no samples, or either does
/// not fit the robot.
StabilityReport Score(const RobotModel& model, const MotionPlan& plan, const PlaybackLog& log,
                      const ScoreOptions& options);

/// The score as after the playback: with the log's options, if it has them.
StabilityReport Score(const RobotModel& model, const MotionPlan& plan, const PlaybackLog& log);

}  // namespace gaitwright
