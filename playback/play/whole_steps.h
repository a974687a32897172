// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace gaitwright {

/// Number of time steps in one period of a rate, within a relative error of 1e-4, for rates rounded to six digits.
/// @throws InvalidArgument naming the option `key` and the nearest accepted rate if the period is not a whole number of
/// steps.
long WholeSteps(const std::string& key, double rate_hz, double step_s);

}  // namespace gaitwright
