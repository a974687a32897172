// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "workflows/words/clause.h"
#include "workflows/words/draft.h"

namespace gaitwright::words {

/// What a clause says, without what it takes from others. @throws Refused for what is not understood (of the whole
/// clause, or of what follows a number), for a place that is not known and for what contradicts itself.
Draft ReadClause(const std::string& text, const Clause& clause);

}  // namespace gaitwright::words
