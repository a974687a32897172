// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

#include "workflows/words/pieces.h"

namespace gaitwright::words {

/// How many pieces from one on are an English lead-in to what is wanted of the robot: "I should be obliged if you
/// would", "we need you to", "would you mind". 0 where there is none. It names the robot ("you") and a wish, and
/// nothing else.
std::size_t LeadInAt(const std::vector<Piece>& pieces, std::size_t at);

}  // namespace gaitwright::words
