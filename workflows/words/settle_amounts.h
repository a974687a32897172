// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "workflows/words/draft.h"

namespace gaitwright::words {

/// What amounts mean to the action of a draft: a turn that is done twice is one of twice the angle, a walk that is done
/// some times has so many steps, a length is a depth to a squat.
void SettleAmounts(Draft& draft);

}  // namespace gaitwright::words
