// SPDX-License-Identifier: BSD-3-Clause
#include "tests/workflows/words/done_in_words.h"

#include <gtest/gtest.h>

#include "playback/score/motion_series.h"
#include "workflows/words/places.h"
#include "workflows/words/understand.h"

namespace gaitwright {

Result<PlannedTasks> PlannedInWords(const RobotModel& model, const std::string& text, const Terrain& terrain) {
  TaskScope scope = ScopeOf(model);
  scope.places = PlacesOf(terrain);
  const Result<TaskPlan> tasks = words::UnderstandWords(text, scope);
  if (!tasks) return tasks.failure();
  return PlanTasks(model, terrain, *tasks, {});
}

Done DoneInWords(const RobotModel& model, const std::string& text, const Terrain& terrain) {
  SCOPED_TRACE(model.name + ": " + text);
  Result<PlannedTasks> planned = PlannedInWords(model, text, terrain);
  EXPECT_TRUE(planned.ok()) << (planned ? "" : planned.failure().message);
  if (!planned) return {};
  EXPECT_TRUE(planned->audit.pass()) << AuditText(planned->audit);
  const PlayRequest request;
  const Result<PlayedWalk> played = PlayWalk(planned->robot, planned->plan, request);
  EXPECT_TRUE(played.ok()) << (played ? "" : played.failure().message);
  if (!played) return {};
  EXPECT_TRUE(played->report.pass) << played->report.reason;
  return {std::move(*planned), *played};
}

double ZmpErrorAtEnd(const Done& done) {
  const MotionSeries series = MakeMotionSeries(done.planned.robot, done.planned.plan, done.played.log, {});
  return (series.measured.back().p_WZ - done.planned.plan.centroidal.p_WZ.back()).norm();
}

}  // namespace gaitwright
