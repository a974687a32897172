// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <string>
#include <utility>

#include "optimisation/search/first_look.h"
#include "optimisation/search/plan_walk.h"

namespace gaitwright {

/// Plans and audits the candidates of a search, each a gait with its cycle and a command, and adds each to the trace.
class WalkEvaluator {
 public:
  /// All are kept by reference. @param trace  may be null.
  WalkEvaluator(const RobotModel& model, const Terrain& terrain, const WalkRequest& request, SearchTrace* trace)
      : model_(model), terrain_(terrain), request_(request), trace_(trace) {}

  /// LookAt.
  FirstLook Look(const Gait& gait, const WalkCommand& command, bool whole);

  /// The whole walk. @param only_passing  a plan past limits is not audited.
  Result<PlannedWalk> Whole(const Gait& gait, const WalkCommand& command, bool only_passing);

  /// The whole walk with the centre of mass at a height or, where it is past limits there, at heights of its own.
  Result<PlannedWalk> WholeAt(double height_m, const Gait& gait, const WalkCommand& command);

  /// Whether the start of a walk has a sound plan: the height of its centre of mass [m], or 0. Planned once for each
  /// command and cycle, on a grid twice as coarse where a cycle of `fitted_s` has steps enough.
  double Start(const Gait& gait, double fitted_s, const WalkCommand& command);

 private:
  Result<PlannedWalk> PlanAndAudit(TriedPlan::Extent extent, const WalkRequest& request, const Gait& gait,
                                   const WalkCommand& command, const AuditOptions& options, bool only_passing);
  void Add(TriedPlan::Extent extent, const Gait& gait, const WalkCommand& command, std::optional<FailureCode> refused);

  const RobotModel& model_;
  const Terrain& terrain_;
  const WalkRequest& request_;
  SearchTrace* trace_;
  std::map<std::pair<std::string, double>, double> starts_;  // by flags of the pace and cycle: answers so far
};

}  // namespace gaitwright
