// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <CLI/CLI.hpp>

#include "kinematics/base/result.h"

namespace gaitwright::cli {

/// What is wrong with a command line, in one sentence that names the nearest verb or flag there is.
Failure UsageFailure(const CLI::App& app, const CLI::ParseError& error);

/// Lays the help of a verb and of those below it out in columns, with the descriptions in lines of readable length.
void LayOutHelp(CLI::App& app);

}  // namespace gaitwright::cli
