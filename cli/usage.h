// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <CLI/CLI.hpp>

#include "kinematics/base/result.h"

namespace gaitwright::cli {

/// What is wrong with a command line, in one sentence that names the nearest verb or flag there is.
Failure UsageFailure(const CLI::App& app, const CLI::ParseError& error);

}  // namespace gaitwright::cli
