// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

#include "workflows/words/pieces.h"

namespace gaitwright::words {

/// A number and its pieces.
struct SpokenNumber {
  double value = 0.0;
  std::size_t pieces = 0;   ///< number of its pieces; 0 if there is no number
  bool is_article = false;  ///< "a", "one": a number before a unit only
};

/// The number that begins at a piece, in digits or in words of English ("minus two and a half", "a couple of",
/// "half a", "a dozen") or of Chinese ("负三百二十", "一点五", "半", "几"). A few and 几 are three.
SpokenNumber NumberAt(const std::vector<Piece>& pieces, std::size_t at);

/// The part of a number after its unit, as a fraction of the unit: "metre and a half", "米半", "米二". Zero pieces if
/// there is none.
SpokenNumber AfterUnit(const std::vector<Piece>& pieces, std::size_t at);

}  // namespace gaitwright::words
