// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "kinematics/base/failure_code.h"
#include "optimisation/search/candidate.h"

namespace gaitwright {

/// A plan that was evaluated in the search for a sound plan.
struct TriedPlan {
  Effort effort = Effort::kWhole;
  std::string pace;         ///< flag that sets the speed, without dashes: `speed`
  double pace_value = 0.0;  ///< in `unit`
  std::string unit;
  double cycle_s = 0.0;
  std::optional<FailureCode> refused;  ///< nothing for a sound plan
  bool free_footholds = false;         ///< on ground that is not flat
  bool whole_body = false;             ///< the whole body was optimised at any rate
  double heel_off_rad = 0.0;           ///< pitch of soles at lift-off; 0: flat

  bool operator==(const TriedPlan&) const = default;
};

/// Name in JSON: `start-look`, `first-look`, `start` or `whole`.
const char* EffortName(Effort effort);

/// The plans in the order in which they were tried.
using SearchTrace = std::vector<TriedPlan>;

/// "tried 2 plans:" and one line per plan: effort, speed, cycle, and the code of its refusal or "sound".
std::string TraceText(const SearchTrace& trace);

}  // namespace gaitwright
