// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace gaitwright {

/// What a file is that says something of a motion.
enum class MotionFileKind {
  kPlan,        ///< plan.json
  kLog,         ///< log.json
  kReport,      ///< what `walk --json` and `play --json` print, or the report of one playback alone
  kTrials,      ///< what `trials` writes
  kJson,        ///< JSON that is none of these
  kTable,       ///< no JSON: columns of numbers, if anything
  kTrajectory,  ///< a JointTrajectory of ROS, as YAML or JSON
};

/// What a text is, by its content alone: JSON by its first character, a plan and a log by their `format`, a report by
/// its `metrics` and `verdict`, a result of trials by `n`, `survived` and `survival`, a joint trajectory by its
/// `joint_names`. The rest is not looked at: its reader says what is wrong there.
MotionFileKind KindOfText(const std::string& text);

/// In words, for messages: "a plan", "JSON of another kind".
const char* NameOf(MotionFileKind kind);

}  // namespace gaitwright
