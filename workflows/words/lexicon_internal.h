// SPDX-License-Identifier: BSD-3-Clause
// The lists of words, which are data/english.json and data/chinese.json, as they stand in the program.
#pragma once

#include <string>
#include <string_view>

#include "workflows/words/lexicon.h"

namespace gaitwright::words {

/// The texts of the files, which the build puts into the program.
std::string_view EnglishWordList();
std::string_view ChineseWordList();

/// A language's words: those for all that can be said but numbers, and units. A unit may be another word elsewhere, so
/// units count after a number only.
struct Vocabulary {
  Lexicon words, units;
};

/// Reads a list of words: an object with `language`, `words` and `units`. An entry of `words` and `units` has:
/// - `means`: the name of a Meaning, such as "action" for kAction.
/// - `phrases`: those that mean it. No phrase may stand twice in `words`, or twice in `units`.
/// - `name`, `value`: of the item; "" and 0 where they are left out.
/// - `says`: of an action, in place of `value`: to_place, beside, returns, up_stairs, down_stairs, upwards, downwards.
/// - `parameters`: of an action, numbers and words.
/// @throws InvalidArgument or the exception of the JSON library for any other text.
Vocabulary ReadVocabulary(std::string_view json);

}  // namespace gaitwright::words
