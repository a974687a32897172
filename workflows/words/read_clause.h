// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "workflows/words/clause.h"
#include "workflows/words/draft.h"

namespace gaitwright::words {

/// Reads a clause, without the parts that it takes from other clauses. @throws Refused for words that are not
/// understood (the whole clause, or the words after a number), for an unknown place and for contradictions.
Draft ReadClause(const std::string& text, const Clause& clause);

}  // namespace gaitwright::words
