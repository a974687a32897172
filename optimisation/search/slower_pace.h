// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "kinematics/base/suggestion.h"
#include "optimisation/search/pace.h"

namespace gaitwright {

/// A speed below the requested one, and how well its feasibility is known.
struct SlowerPace {
  enum class Known {
    kLargest,   ///< its plan passes, and no faster plan was found that does
    kFeasible,  ///< its plan passes
    kMay,       ///< the cheap evaluation found no reason against it
  };
  double value = 0.0;  ///< 0 if no such speed is known
  Known known = Known::kLargest;

  /// Text for messages, for a command at this speed.
  std::string Text(const WalkCommand& at_pace, const std::string& gait) const;
  /// Suggestion to request this speed, with all other speeds in proportion.
  Suggestion AsSuggestion(const WalkCommand& at_pace) const;
};

}  // namespace gaitwright
