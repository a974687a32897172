// SPDX-License-Identifier: BSD-3-Clause
#include "workflows/study/run_sweep.h"

#include <fmt/format.h>

#include "kinematics/base/hash.h"
#include "kinematics/base/version.h"
#include "workflows/walk/walk_files.h"

namespace gaitwright {
namespace {

std::string CommandText(const WalkCommand& c) {
  return fmt::format("{} {} {} {} {} {} {} {} {} {} {}", static_cast<int>(c.extent), c.speed_m_s, c.lateral_speed_m_s,
                     c.yaw_rate_rad_s, c.distance_m, c.duration_s, c.goal_x_m, c.goal_y_m, c.goal_yaw_rad, c.steps,
                     c.step_length_m);
}

}  // namespace

std::string StudyIdentity(const Study& study, const std::string& trials) {
  WalkRequest walk = study.walk;
  PlayRequest play = study.play;
  std::string text = fmt::format("{}\n{}\n{}\n{}\n{}\n{}\n{}\n{}\n{}\n{}\n", Version(), study.model.hash, walk.gait,
                                 walk.terrain, walk.sequence, ContentsHash(walk), walk.seed, CommandText(walk.command),
                                 play.controller, study.trials);
  for (const auto& [key, value] : TextsOf(StudyFields(walk, play))) text += key + "=" + value + "\n";
  for (const StudyPoint& point : study.points) text += PointText(study.axes, point) + "\n";
  for (const std::string& key : study.metrics) text += key + "\n";
  return HexHash(text + trials);
}

Result<std::vector<PointOutcome>> RunSweep(const Study& study, JobJournal& journal, const JobOptions& options,
                                           const std::vector<PointRunner>& elsewhere) {
  std::vector<PointOutcome> outcomes(study.points.size());
  std::vector<std::size_t> pending;
  for (std::size_t point = 0; point < study.points.size(); ++point) {
    const std::optional<std::string> line = journal.Find(point);
    if (!line) {
      pending.push_back(point);
      continue;
    }
    Result<PointOutcome> outcome = PointFromLine(*line);
    if (!outcome) return outcome.failure();
    outcomes[point] = std::move(*outcome);
  }
  StudyPlans plans(study, pending);
  const auto run = [&](std::size_t point) {
    outcomes[point] = RunPoint(study, point, plans);
    journal.Add(point, PointToLine(outcomes[point]));
  };
  std::vector<JobRunner> others;
  for (const PointRunner& runner : elsewhere) {
    others.emplace_back([&](std::size_t point) {
      const std::string line = runner(point);
      outcomes[point] = PointFromLine(line).value();
      journal.Add(point, line);
    });
  }
  if (!RunJobs(OrderByPlan(study, pending), run, options, others)) return Interrupted("RunSweep");
  return outcomes;
}

}  // namespace gaitwright
