// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "planning/tasks/task_plan.h"
#include "workflows/words/item.h"

namespace gaitwright::words {

/// Languages that instructions may be in.
enum class Language { kEnglish, kChinese };

/// Chinese where there is a Chinese character.
Language LanguageOf(const std::string& text);

/// What the words of an instruction mean, in order: the longest phrases of the lexicon, numbers with their units, and
/// the places that are known. What has no meaning stands as unknown, several pieces as one.
std::vector<Item> ItemsOf(const std::string& text, Language language, const std::vector<PlaceName>& places);

}  // namespace gaitwright::words
