// SPDX-License-Identifier: BSD-3-Clause
// The parts that the lexicons are made of.
#pragma once

#include "workflows/words/lexicon.h"

namespace gaitwright::words {

void AddEnglishAsides(Lexicon& x);
void AddChineseAsides(Lexicon& x);
void AddEnglishStairs(Lexicon& x);
void AddChineseStairs(Lexicon& x);
void AddEnglishWalking(Lexicon& x);
void AddEnglishActions(Lexicon& x);
void AddChineseWalking(Lexicon& x);
void AddChineseActions(Lexicon& x);

}  // namespace gaitwright::words
