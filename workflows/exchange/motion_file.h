// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace gaitwright {

/// Kind of a file with data on a motion.
enum class MotionFileKind {
  kPlan,        ///< plan.json
  kLog,         ///< log.json
  kReport,      ///< output of `walk --json` and `play --json`, or the report of one playback
  kTrials,      ///< result of `trials`
  kJson,        ///< JSON of another kind
  kTable,       ///< not JSON: columns of numbers, if anything
  kTrajectory,  ///< a JointTrajectory of ROS, as YAML or JSON
};

/// The kind of a text, by its content only: JSON by its first character, a plan and a log by their `format`, a report
/// by its `metrics` and `verdict`, a result of trials by `n`, `survived` and `survival`, a joint trajectory by its
/// `joint_names`. Nothing else is checked; the reader of the kind reports errors.
MotionFileKind KindOfText(const std::string& text);

/// The kind in words, for messages: "a plan", "JSON of another kind".
const char* NameOf(MotionFileKind kind);

}  // namespace gaitwright
