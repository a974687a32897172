// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "workflows/words/clause.h"
#include "workflows/words/draft.h"

namespace gaitwright::words {

/// Interprets directions, turns and levels of a draft whose action is a jump or a flip. A side beside an angle is the
/// side of the turn: "jump forward 30 cm with a quarter turn to the left"; any other side is the direction. Marks a
/// turn that is made in the air. @throws Refused for what the jump cannot have: a height, an obstacle to jump over.
void SettleJump(const std::string& text, const Clause& clause, Draft& draft);

/// Adds a turn in the air, or during the jump, to a jump before it: "jump and turn left in the air". Returns false if
/// the draft is another task. @throws Refused for a turn in the air without a jump.
bool JoinsJump(const std::string& text, const Clause& clause, const Draft& said, std::vector<Draft>& drafts);

}  // namespace gaitwright::words
