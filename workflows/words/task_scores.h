// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>

#include "workflows/words/plan_tasks.h"

namespace gaitwright {

/// How well tasks were done, as measured.
struct TaskScores {
  int done = 0, asked = 0;            ///< completion: tasks that ended before a fall
  std::string stability_key;          ///< the metric of stability that applies: of the ZMP, or else of the DCM
  std::optional<double> stability_m;  ///< its value [m]
  std::optional<double> jerk_rad_s3;  ///< smoothness: root mean square of the joints' jerk
  double energy_j = 0.0;              ///< positive work of the motors
};

/// The scores of a playback of that plan. Tasks are counted by the plan's clock, a fall by that of the log.
TaskScores ScoreTasks(const PlannedTasks& planned, const PlayedWalk& played);

/// "5 of 5 tasks done; ...", for people.
std::string TaskScoresText(const TaskScores& scores);

/// {"completion": {"done", "of"}, "stability": {"metric", "value_m"}, "smoothness": {"jerk_rms_rad_s3"}, "energy":
/// {"work_j"}}
std::string TaskScoresJson(const TaskScores& scores);

}  // namespace gaitwright
