// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace gaitwright::words {

/// The smallest parts of a text that have a meaning: a word of letters, a number of digits, a Chinese character, or any
/// other single character. Spaces part words and are none.
struct Piece {
  enum class Kind { kWord, kNumber, kCharacter, kSign };

  Kind kind = Kind::kWord;
  std::string text;                ///< in small letters; full-width letters, digits and signs as their usual ones
  std::size_t begin = 0, end = 0;  ///< bytes of the whole text
};

/// The pieces of a UTF-8 text, in order. A word may hold an apostrophe or a hyphen between letters, and a slash as in
/// "m/s"; a number a point between digits and an exponent behind them.
std::vector<Piece> PiecesOf(const std::string& text);

/// Some pieces as a phrase: words parted by spaces, all else put together.
std::string PhraseOf(const std::vector<Piece>& pieces, std::size_t first, std::size_t count);

}  // namespace gaitwright::words
