// SPDX-License-Identifier: BSD-3-Clause
// Instructions that are planned on flat ground with two places.
#pragma once

#include <gtest/gtest.h>

#include "kinematics/model/load_robot.h"
#include "tests/workflows/words/done_in_words.h"
#include "workflows/words/places.h"
#include "workflows/words/understand.h"

namespace gaitwright::tasks_in_words {

inline Terrain WithMarkers() {
  Terrain terrain = FlatTerrain();
  terrain.markers = {{"red marker", {0.5, 0.0}}, {"door", {0.4, 0.5}}};
  return terrain;
}

inline Result<PlannedTasks> Planned(const std::string& robot, const std::string& text, const Terrain& terrain) {
  return PlannedInWords(LoadNamedRobot(robot).value(), text, terrain);
}

inline Done Do(const std::string& robot, const std::string& text) {
  return DoneInWords(LoadNamedRobot(robot).value(), text, WithMarkers());
}

/// Two instructions that mean the same, so that it is enough to plan and play one of them.
inline void ExpectSameTasks(const RobotModel& model, const Terrain& terrain, const std::string& one,
                            const std::string& other) {
  TaskScope scope = ScopeOf(model);
  scope.places = PlacesOf(terrain);
  const auto tasks = [&](const std::string& text) {
    std::vector<Task> read = words::UnderstandWords(text, scope).value().tasks;
    for (Task& task : read) task.words.clear();
    return read;
  };
  EXPECT_FALSE(tasks(one).empty());
  EXPECT_TRUE(tasks(one) == tasks(other)) << one << ' ' << other;
}

}  // namespace gaitwright::tasks_in_words
