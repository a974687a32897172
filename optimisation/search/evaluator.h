// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <optional>

#include "kinematics/base/result.h"
#include "optimisation/search/candidate.h"
#include "optimisation/search/plan_walk.h"

namespace gaitwright {

/// What is known of a candidate.
struct Evaluation {
  std::optional<Failure> refusal;        ///< nothing for a candidate that is sound
  bool at_every_pace = false;            ///< the refusal depends neither on the pace nor on the cycle
  bool by_ground = false;                ///< no limit of the robot refuses it, but friction or support
  double ease = 0.8;                     ///< share of the pace at which it may be sound, by how far limits are passed
  bool solved = true;                    ///< an optimisation problem was solved to know it
  std::shared_ptr<PlannedWalk> planned;  ///< with Effort::kWhole, where there is a plan, sound or not

  bool sound() const { return !refusal; }
};

/// Evaluates candidates of one walk. The search knows no more of plans than this.
class Evaluator {
 public:
  virtual ~Evaluator() = default;

  /// What is known of a candidate by an effort; the same at each call.
  virtual Evaluation Evaluate(const Candidate& candidate, Effort effort) = 0;

  /// Whether the candidate is planned as the motion of a rigid body, which takes much longer.
  virtual bool Flies(const Candidate& candidate) = 0;
};

}  // namespace gaitwright
