// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "kinematics/base/result.h"

namespace gaitwright {

/// JSON text of the object that `--json` prints: {"code", "stage", "message", "hints", "suggestions"}, and "violation"
/// if a failed check is the reason. "hints" holds the texts of all suggestions. "suggestions" holds {"what", "value",
/// "certainty"} of the suggestions that name an option.
std::string FailureJson(const Failure& failure);

}  // namespace gaitwright
