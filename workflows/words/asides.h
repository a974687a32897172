// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "workflows/words/item.h"

namespace gaitwright::words {

/// The items of an instruction without asides, which request nothing: reasons and purposes ("because the floor is wet",
/// "好让大家看见"), descriptions of a named thing ("the door, which is open"), and actions of other people ("the nurse
/// has to pass", "妈妈接个电话"), up to the next comma or the next action. Conditions ("if", "until") are not asides:
/// they stay and are refused.
std::vector<Item> WithoutAsides(const std::vector<Item>& items);

}  // namespace gaitwright::words
