// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "kinematics/base/failure_code.h"

namespace gaitwright {

/// A plan that the search for a sound plan evaluated.
struct TriedPlan {
  enum class Extent {
    kFirstLook,  ///< a few passes of a rigid body alone
    kStart,      ///< the start of the walk, planned coarsely and audited
    kWhole,      ///< the whole walk, planned and audited
  };
  Extent extent = Extent::kWhole;
  std::string pace;         ///< the flag of the command's pace, without dashes: `speed`
  double pace_value = 0.0;  ///< in `unit`
  std::string unit;
  double cycle_s = 0.0;
  std::optional<FailureCode> refused;  ///< nothing for a sound plan

  bool operator==(const TriedPlan&) const = default;
};

/// `first-look`, `start` or `whole`, as JSON has it.
const char* ExtentName(TriedPlan::Extent extent);

/// In the order in which they were tried.
using SearchTrace = std::vector<TriedPlan>;

/// "tried 2 plans:" and a line for each: extent, pace, cycle, and the code of its refusal or "sound".
std::string TraceText(const SearchTrace& trace);

}  // namespace gaitwright
