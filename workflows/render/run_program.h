// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "kinematics/base/result.h"

namespace gaitwright {

/// The path of the first of these programs on PATH, in this order; "" if there is none.
std::string FindProgram(const std::vector<std::string>& names);

/// Runs a program without a shell until it ends. @return its standard error output. Failure: it cannot be started, or
/// it ended with a status other than 0; the message contains the end of its output.
Result<std::string> RunProgram(const std::string& program, const std::vector<std::string>& arguments);

}  // namespace gaitwright
