// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "kinematics/base/suggestion.h"
#include "optimisation/search/pace.h"

namespace gaitwright {

/// A pace that is slower than the one asked for, and what is known of it.
struct SlowerPace {
  enum class Known {
    kLargest,  ///< its plan passes, and none of a faster one was found to
    kServes,   ///< its plan passes
    kMay,      ///< what was looked at of it has nothing against it
  };
  double value = 0.0;  ///< 0 for none
  Known known = Known::kLargest;

  /// What is known of it, for people, of a command at that pace.
  std::string Text(const WalkCommand& at_pace, const std::string& gait) const;
  /// To ask for the command at that pace; what else moves goes on in proportion.
  Suggestion AsSuggestion(const WalkCommand& at_pace) const;
};

}  // namespace gaitwright
