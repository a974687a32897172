// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string>

#include "workflows/words/clause.h"

namespace gaitwright::words {

/// Checks that a robot is to walk to a place, and not "from the door" or to the "左边" of one.
/// @throws Refused with the words of another relation to the place, the item `at` of the clause.
void CheckGoesTo(const std::string& text, const Clause& clause, std::size_t at);

}  // namespace gaitwright::words
