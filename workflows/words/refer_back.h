// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "workflows/words/draft.h"

namespace gaitwright::words {

/// Puts into a draft what its words leave to the tasks before it: the arm of "lower it" and "the other one", the unit
/// of "another five", and how far it is back.
/// @throws Refused `ambiguous` for an arm that no task before it has moved.
void ReferBack(const std::string& text, const std::vector<Draft>& before, Draft& said);

}  // namespace gaitwright::words
