// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "kinematics/base/options.h"

namespace gaitwright {

/// What trials were played under beside their disturbances, of the options that their result holds. First, whatever
/// they are: `state`; `sensors`, by the ready-made set that they are nearest to ("not used" where the controller had
/// the true state), then each figure that is not that set's; and `command_delay_s`. Then every other option that is not
/// at its usual value. Seeds are left out, since each trial has its own. Of what the options do not say the value is
/// "not said"; of one that this program does not know the usual value is "".
/// @param disturbances  as the result has them, YAML: single figures of sensors that are drawn are left out too.
std::vector<OptionChange> TrialConditions(const OptionTexts& options, const std::string& disturbances = "");

/// The flags that give a playback those options, as a line of a shell: "--controller joint-pd --set state=estimated
/// --sensors hobby". Seeds are left out, and what has no effect.
/// @param drawn  options that disturbances draw, through which others may act.
std::string FlagsOf(const std::string& controller, const OptionTexts& options,
                    const std::vector<std::string>& drawn = {});

/// "play.friction 0.4 (usually 0)", or without the bracket where it is as usual.
std::string ConditionText(const OptionChange& condition);

}  // namespace gaitwright
