// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include "optimisation/centroidal/plan_over_terrain.h"
#include "planning/audit/audit_report.h"
#include "workflows/study/centroidal_bench.h"

namespace gaitwright::solved_case {

/// A case of the set with its motion.
struct Solved {
  Terrain ground;
  PlanOverPatches plan;
};

inline Solved Solve(const std::string& name, const RigidBodyOptions& options = {}) {
  const Result<CentroidalProblemSet> set = LoadCentroidalProblems(CentroidalProblemsPath());
  const CentroidalCase one = CasesOf(*set, name).at(0);
  const CentroidalRobot& robot = set->robots[one.robot].second;
  Solved solved;
  solved.ground = WithFriction(set->grounds[one.ground], set->friction);
  const CentroidalTask task{set->distance_m, set->duration_s, set->friction};
  (void)PlanOverTerrain(solved.ground, CentroidalProblem(robot, robot.schedules[one.schedule], solved.ground, task), {},
                        options, {}, &solved.plan);
  return solved;
}

/// The checks that a report names.
inline std::vector<Law> LawsOf(const AuditReport& report) {
  std::vector<Law> laws;
  for (const Violation& v : report.violations) laws.push_back(v.law);
  return laws;
}

inline bool Names(const AuditReport& report, Law law) {
  const std::vector<Law> laws = LawsOf(report);
  return std::find(laws.begin(), laws.end(), law) != laws.end();
}

}  // namespace gaitwright::solved_case
