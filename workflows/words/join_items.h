// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "workflows/words/item.h"

namespace gaitwright::words {

/// Joins items that have one meaning together, and items whose meaning depends on their neighbours: speeds ("每秒" and
/// a length), places with their numbers, "前" after an action that is done later, and adverbs.
void JoinItems(std::vector<Item>& items);

}  // namespace gaitwright::words
