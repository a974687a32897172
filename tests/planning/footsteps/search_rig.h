// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <gtest/gtest.h>

#include <vector>

#include "planning/footsteps/explain_blockage.h"
#include "planning/footsteps/footstep_graph.h"
#include "planning/gait/find_gait.h"

namespace gaitwright {

/// All parts of a search for footholds straight forward, accessible one by one. The feet stand at the start.
struct SearchRig {
  SearchRig(const RobotModel& robot, const Terrain& terrain, const char* gait, double length_m,
            const FootstepSearchOptions& search_options = {}, double speed_m_s = 0.3)
      : model(robot),
        query{FindGait(robot, gait, speed_m_s, {}).value(), RouteAlong({length_m, 0.0, 0.0}, 0.2), 0.0},
        options(search_options),
        ground(terrain, 0.5 * robot.leg_length_m()),
        checker(robot, ground, {}),
        table(robot, checker, WithStride(speed_m_s), options),
        stances(robot, ground, query, {}, options),
        graph(robot, query, table, stances, ground, options),
        start(robot.feet.size(), -1) {
    for (int foot = 0; foot < static_cast<int>(start.size()); ++foot)
      EXPECT_TRUE(table.Start(foot, start[static_cast<std::size_t>(foot)]).ok()) << "foot " << foot;
  }
  SearchRig(const SearchRig&) = delete;
  SearchRig& operator=(const SearchRig&) = delete;

  SearchScene Scene() const { return {model, ground, query, checker, options}; }

  const RobotModel& model;
  FootstepQuery query;
  FootstepSearchOptions options;
  GroundIndex ground;
  FootholdChecker checker;
  FootholdTable table;
  StanceChecker stances;
  FootstepGraph graph;
  std::vector<int> start;  ///< footholds by foot

 private:
  const FootstepQuery& WithStride(double speed_m_s) {
    query.stride_m = speed_m_s * query.gait.cycle_s;
    return query;
  }
};

}  // namespace gaitwright
