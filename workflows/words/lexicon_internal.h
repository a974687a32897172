// SPDX-License-Identifier: BSD-3-Clause
// The word lists data/english.json and data/chinese.json, embedded in the program.
#pragma once

#include <string>
#include <string_view>

#include "workflows/words/lexicon.h"

namespace gaitwright::words {

/// The texts of the files, which the build embeds.
std::string_view EnglishWordList();
std::string_view ChineseWordList();

/// The words of a language, except numbers, and its units. Units count only after a number, since they may be other
/// words elsewhere.
struct Vocabulary {
  Lexicon words, units;
};

/// Reads a list of words: an object with `language`, `words` and `units`. An entry of `words` and `units` has:
/// - `means`: the name of a Meaning, such as "action" for kAction.
/// - `phrases`: the phrases with this meaning. A phrase may occur only once in `words`, and only once in `units`.
/// - `name`, `value`: of the item; default "" and 0.
/// - `says`: of an action, instead of `value`: to_place, beside, returns, up_stairs, down_stairs, upwards, downwards.
/// - `parameters`: of an action, numbers and words.
/// @throws InvalidArgument or the exception of the JSON library for any other text.
Vocabulary ReadVocabulary(std::string_view json);

}  // namespace gaitwright::words
