// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "kinematics/base/result.h"

namespace gaitwright {

/// The path of the first of these programs that is on PATH, in their order; "" where none is.
std::string FindProgram(const std::vector<std::string>& names);

/// Runs a program, without a shell, until it ends. @return what it wrote to its standard error. Failure: it cannot be
/// started, or ended with another status than 0; the message has the end of what it wrote.
Result<std::string> RunProgram(const std::string& program, const std::vector<std::string>& arguments);

}  // namespace gaitwright
