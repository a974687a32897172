// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "playback/score/measurements.h"

namespace gaitwright {

/// Time over which velocities are averaged before they are compared, because a base sways with its steps [s].
inline constexpr double kCommandWindow = 0.5;

/// How well the base follows commanded velocities. Both errors are means over time of the error of the velocity in the
/// axes of the base's heading, averaged over the last kCommandWindow. Only for a plan without contacts (PlansContacts);
/// other plans have no values, because their positions are compared.
std::vector<Measurement> CommandMeasurements(const ScoreInputs& in);

/// Removes from the measurements of a plan without contacts what compares with a plan: planned values, and metrics that
/// need a schedule or a planned posture.
void KeepCommanded(std::vector<Measurement>& rows);

/// Reason for which a gate does not apply to a plan without contacts, although it has a value; "" if it applies.
std::string GateNotOfCommands(const std::string& key);

/// Whether a metric is only for plans without contacts.
bool IsOfCommands(const std::string& key);

}  // namespace gaitwright
