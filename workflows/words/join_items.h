// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "workflows/words/item.h"

namespace gaitwright::words {

/// Puts items together that mean one thing, and settles those that mean something only beside others: speeds ("每秒"
/// and a length), places with their numbers, "前" after what is done later, and adverbs.
void JoinItems(std::vector<Item>& items);

}  // namespace gaitwright::words
