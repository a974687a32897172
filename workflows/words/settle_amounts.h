// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "workflows/words/draft.h"

namespace gaitwright::words {

/// Interprets amounts by the action of a draft: two turns are one turn of twice the angle, a count of a walk is its
/// number of steps, a length is the depth of a squat.
void SettleAmounts(Draft& draft);

/// A value of an amount, without the rounding errors of units: five significant digits after the first.
double RoundedAmount(double value);

}  // namespace gaitwright::words
