// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>

#include "optimisation/pipeline/plan_motion.h"

namespace gaitwright::cli {

/// How the whole-body optimisation finished a plan, as in the output of `plan` and `bench whole-body`; null without it.
nlohmann::ordered_json FinishJson(const std::optional<FinishReport>& finished);

}  // namespace gaitwright::cli
