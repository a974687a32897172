// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <string>
#include <tuple>

#include "optimisation/search/evaluator.h"
#include "optimisation/search/gait_cycles.h"
#include "optimisation/search/plan_walk.h"

namespace gaitwright {

/// Plans and audits candidates of a walk, each once, and adds each to the trace. After `search.max_plans` of the
/// request, all other candidates are refused.
class WalkEvaluator : public Evaluator {
 public:
  /// Keeps references to all arguments. @param trace  may be null.
  WalkEvaluator(const RobotModel& model, const Terrain& terrain, const WalkRequest& request, SearchTrace* trace);

  Evaluation Evaluate(const Candidate& candidate, Effort effort) override;
  bool Flies(const Candidate& candidate) override;

  /// The command at the candidate's speed.
  WalkCommand CommandOf(const Candidate& candidate) const;
  /// The gait fitted to the candidate's speed and flight, and its other cycles.
  Result<GaitCycles> CyclesOf(const Candidate& candidate) const;
  /// The gait with the candidate's cycle and flight.
  Gait GaitOf(const Candidate& candidate, const GaitCycles& cycles) const;

 private:
  /// Flags of the speed, cycle, first duty factor, other footholds, whether the whole body is optimised, and heel-off.
  using Key = std::tuple<Effort, std::string, double, double, bool, bool, double>;

  Evaluation Made(const Candidate& candidate, Effort effort, const GaitCycles& cycles, const Gait& gait);
  Evaluation Look(const WalkRequest& request, const Gait& gait, const WalkCommand& command, bool whole) const;
  Result<PlannedWalk> Whole(const WalkRequest& request, const Gait& gait, const WalkCommand& command,
                            bool only_sound) const;
  Result<PlannedWalk> Start(const WalkRequest& request, const Gait& gait, double fitted_s,
                            const WalkCommand& command) const;
  void Trace(const Candidate& candidate, Effort effort, const Gait& gait, const Evaluation& evaluation);

  const RobotModel& model_;
  const Terrain& terrain_;
  const WalkRequest& request_;
  SearchTrace* trace_;
  const double asked_;                  // pace
  std::map<Key, Evaluation> known_;     // without their plans
  std::map<Key, double> com_height_m_;  // of starts that are sound
};

}  // namespace gaitwright
