// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>

#include "workflows/words/plan_tasks.h"

namespace gaitwright {

/// Measured scores of a task plan.
struct TaskScores {
  int done = 0, asked = 0;            ///< completion: tasks that ended before a fall
  std::string stability_key;          ///< the stability metric that applies: of the ZMP, otherwise of the DCM
  std::optional<double> stability_m;  ///< its value [m]
  std::optional<double> jerk_rad_s3;  ///< smoothness: root mean square of the joints' jerk
  double energy_j = 0.0;              ///< positive work of the motors
};

/// The scores of a playback of a plan. The ends of tasks are on the plan's clock, a fall is on the log's clock.
TaskScores ScoreTasks(const PlannedTasks& planned, const PlayedWalk& played);

/// The scores as text: "5 of 5 tasks done; ...".
std::string TaskScoresText(const TaskScores& scores);

/// JSON: {"completion": {"done", "of"}, "stability": {"metric", "value_m"}, "smoothness": {"jerk_rms_rad_s3"},
/// "energy": {"work_j"}}
std::string TaskScoresJson(const TaskScores& scores);

}  // namespace gaitwright
