// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

#include "workflows/words/pieces.h"

namespace gaitwright::words {

/// Number of pieces of an English lead-in to a request that begins at a piece: "I should be obliged if you would", "we
/// need you to", "would you mind"; 0 if there is none. A lead-in has the robot ("you") and a wish, and nothing else.
std::size_t LeadInAt(const std::vector<Piece>& pieces, std::size_t at);

}  // namespace gaitwright::words
