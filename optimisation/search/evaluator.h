// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <optional>

#include "kinematics/base/result.h"
#include "optimisation/search/audited_plan.h"
#include "optimisation/search/candidate.h"
#include "optimisation/search/plan_walk.h"

namespace gaitwright {

/// Result for a candidate.
struct Evaluation {
  std::optional<Failure> refusal;  ///< nothing for a sound candidate
  bool at_every_pace = false;      ///< the refusal does not depend on the speed or the cycle
  bool by_ground = false;          ///< friction or support refuses it, not a limit of the robot
  bool no_footholds = false;       ///< no footsteps were found
  double ease = 0.8;         ///< factor of the speed at which it may be sound, estimated from the limit violations
  Room room = Room::kAmple;  ///< of the plan, for corrections by a controller
  bool solved = true;        ///< the evaluation solved an optimisation problem
  std::shared_ptr<PlannedWalk> planned;  ///< for Effort::kWhole: the plan if there is one, sound or not

  bool sound() const { return !refusal; }
};

/// Evaluates candidates of one walk. The search knows plans only through this interface.
class Evaluator {
 public:
  virtual ~Evaluator() = default;

  /// Evaluates a candidate with a given effort; repeated calls give equal results.
  virtual Evaluation Evaluate(const Candidate& candidate, Effort effort) = 0;

  /// Whether the candidate is planned as the motion of a rigid body, which takes much longer.
  virtual bool Flies(const Candidate& candidate) = 0;
};

}  // namespace gaitwright
