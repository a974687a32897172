// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "kinematics/base/result.h"

namespace gaitwright {

/// JSON text of the object that `--json` prints: {"code", "stage", "message", "hints", "suggestions"}, and "violation"
/// if a violated law is the reason. Hints are the texts of all suggestions; "suggestions" has {"what", "value",
/// "certainty"} of those that name an option.
std::string FailureJson(const Failure& failure);

}  // namespace gaitwright
