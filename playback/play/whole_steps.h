// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace gaitwright {

/// Time steps in one period of a rate, to a ten-thousandth of them, as a rate of six digits has it.
/// @throws InvalidArgument naming the option `key` and the nearest rate that does where the period is no whole number
/// of steps.
long WholeSteps(const std::string& key, double rate_hz, double step_s);

}  // namespace gaitwright
