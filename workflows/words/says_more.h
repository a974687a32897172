// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "workflows/words/clause.h"
#include "workflows/words/draft.h"

namespace gaitwright::words {

/// Whether it says how far or how long a walk goes.
bool SaysHowFar(const Draft& draft);

/// Whether a clause with an action of its own only says more of the task before, or says it again ("走吧，往前走",
/// "坐下，坐二十秒", "run to the door, run"); what it says more is then in `last`.
bool SaysMore(const std::string& text, const Clause& clause, const Draft& said, Draft& last);

/// Whether it says only how to walk, which may be said before it is said to.
bool SaysOnlyHow(const Draft& said);

/// "turn left 60 degrees, no, turn right": whether a turn after a turn says the way alone, so that all else stays.
bool OnlyTurnsRound(const Draft& said, const std::vector<Draft>& drafts);

}  // namespace gaitwright::words
