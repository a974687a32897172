// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "planning/tasks/task_plan.h"
#include "workflows/words/item.h"

namespace gaitwright::words {

/// Languages of instructions.
enum class Language { kEnglish, kChinese };

/// Chinese if the text has a Chinese character.
Language LanguageOf(const std::string& text);

/// The meanings of the words of an instruction, in order: the longest phrases of the lexicon, numbers with their units,
/// and known places. Consecutive pieces without a meaning become one unknown item.
std::vector<Item> ItemsOf(const std::string& text, Language language, const std::vector<PlaceName>& places);

}  // namespace gaitwright::words
