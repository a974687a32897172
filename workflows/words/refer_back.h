// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "workflows/words/draft.h"

namespace gaitwright::words {

/// Completes a draft from the previous tasks: the arm of "lower it" and "the other one", the unit of "another five",
/// and the distance of the return.
/// @throws Refused `ambiguous` if no previous task has moved an arm.
void ReferBack(const std::string& text, const std::vector<Draft>& before, Draft& said);

}  // namespace gaitwright::words
