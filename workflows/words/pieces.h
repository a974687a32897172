// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace gaitwright::words {

/// The smallest part of a text with a meaning: a word of letters, a number of digits, a Chinese character, or any other
/// single character. Spaces separate words and are not pieces.
struct Piece {
  enum class Kind { kWord, kNumber, kCharacter, kSign };

  Kind kind = Kind::kWord;
  std::string text;                ///< in lower case; full-width letters, digits and signs as plain ones
  std::size_t begin = 0, end = 0;  ///< byte positions in the whole text
};

/// The pieces of a UTF-8 text, in order. A word may contain an apostrophe or a hyphen between letters, and a slash as
/// in "m/s". A number may contain a decimal point between digits and an exponent after them.
std::vector<Piece> PiecesOf(const std::string& text);

/// Pieces as a phrase: spaces between words, no spaces between other pieces.
std::string PhraseOf(const std::vector<Piece>& pieces, std::size_t first, std::size_t count);

}  // namespace gaitwright::words
