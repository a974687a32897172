// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string>

#include "workflows/words/clause.h"

namespace gaitwright::words {

/// A robot goes to places, and nowhere else that is said by them: "from the door", "左边" of one.
/// @throws Refused by the words for it where the place `at` of the clause's items stands in another relation.
void CheckGoesTo(const std::string& text, const Clause& clause, std::size_t at);

}  // namespace gaitwright::words
