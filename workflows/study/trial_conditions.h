// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "kinematics/base/options.h"

namespace gaitwright {

/// Playback conditions of trials in addition to their disturbances, from the options in their result. First, always:
/// `state`; `sensors`, as the nearest predefined set ("not used" if the controller had the true state), then each value
/// that differs from this set; and `command_delay_s`. Then every other option that is not at its default. Seeds are
/// left out, because each trial has its own. Missing options have the value "not said"; an option unknown to this
/// program has the default "".
/// @param disturbances  YAML text of the result; sampled sensor values are also left out.
std::vector<OptionChange> TrialConditions(const OptionTexts& options, const std::string& disturbances = "");

/// The flags that give a playback these options, as a shell command line: "--controller joint-pd --set state=estimated
/// --sensors hobby". Seeds and options without effect are left out.
/// @param drawn  options that disturbances sample, which may give other options an effect.
std::string FlagsOf(const std::string& controller, const OptionTexts& options,
                    const std::vector<std::string>& drawn = {});

/// "play.friction 0.4 (default 0)"; without the brackets at the default value.
std::string ConditionText(const OptionChange& condition);

}  // namespace gaitwright
