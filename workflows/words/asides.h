// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "workflows/words/item.h"

namespace gaitwright::words {

/// The items of an instruction without what is told beside it and asks for nothing: reasons and purposes ("because the
/// floor is wet", "好让大家看见"), what says more of a thing that was named ("the door, which is open"), and what
/// somebody else does ("the nurse has to pass", "妈妈接个电话"), up to the next comma or the next thing to do.
/// Conditions ("if", "until") are none: they stay, and are refused.
std::vector<Item> WithoutAsides(const std::vector<Item>& items);

}  // namespace gaitwright::words
