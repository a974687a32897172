// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "workflows/words/clause.h"
#include "workflows/words/draft.h"

namespace gaitwright::words {

/// Whether it has the distance or the duration of a walk.
bool SaysHowFar(const Draft& draft);

/// Whether a clause with an action only adds to the previous task or repeats it ("走吧，往前走", "坐下，坐二十秒", "run
/// to the door, run"); the additions are then in `last`.
bool SaysMore(const std::string& text, const Clause& clause, const Draft& said, Draft& last);

/// Whether it has only the manner of walking, which may come before the request to walk.
bool SaysOnlyHow(const Draft& said);

/// "turn left 60 degrees, no, turn right": whether a turn after a turn has only a direction, so that the other
/// parameters stay.
bool OnlyTurnsRound(const Draft& said, const std::vector<Draft>& drafts);

}  // namespace gaitwright::words
