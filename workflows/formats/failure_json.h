// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "kinematics/base/result.h"

namespace gaitwright {

/// As `--json` prints it: {"code", "stage", "message", "hints", "suggestions"}, and "violation" where a law is the
/// reason. Hints are the texts of all suggestions; "suggestions" has {"what", "value", "certainty"} of those that name
/// an option.
nlohmann::ordered_json FailureToJson(const Failure& failure);

}  // namespace gaitwright
