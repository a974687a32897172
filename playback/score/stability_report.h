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

/// Verdict and metrics of a playback. Invariant: the verdict is a pass exactly if every applied gate holds. Metrics are
/// in the order of MetricRules().
struct StabilityReport {
  std::string robot;
  bool pass = false;
  double score = 0.0;  ///< see ScoreOf
  std::string reason;  ///< cause of the fall or failure, or the tightest gate (ReasonOf); one plain sentence
  std::string cause;   ///< the reason in a few words without numbers, for counts; empty for a pass, see CauseOf
  std::vector<Metric> metrics;
  std::vector<std::string> notes;  ///< placeholder limits and similar facts

  /// The metric of a key. @throws InvalidArgument naming the nearest key.
  const Metric& At(const std::string& key) const;

  bool operator==(const StabilityReport&) const = default;
};

/// Compares the measurements with the plan and the gates of gates.h. A pure function: no state, no files, no clock.
/// After a fall only the time before it is measured.
/// @throws InvalidArgument if an option is out of range, the plan has no rows, the log has no samples, or plan or log
/// do not fit the robot.
StabilityReport Score(const RobotModel& model, const MotionPlan& plan, const PlaybackLog& log,
                      const ScoreOptions& options);

/// The score with the options of the playback, if the log contains them.
StabilityReport Score(const RobotModel& model, const MotionPlan& plan, const PlaybackLog& log);

}  // namespace gaitwright
