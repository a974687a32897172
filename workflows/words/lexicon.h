// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <unordered_map>

#include "workflows/words/item.h"

namespace gaitwright::words {

/// Words and phrases of a language with their meanings. English phrases are in lower case with single spaces between
/// words; Chinese phrases are unchanged.
class Lexicon {
 public:
  /// @return false for a phrase that already exists, which keeps its meaning.
  bool Add(const std::string& phrase, const Item& meaning);
  /// The item of a phrase, or null.
  const Item* Find(const std::string& phrase) const;
  /// Number of pieces (words, Chinese characters) of the longest phrase.
  std::size_t longest() const { return longest_; }

 private:
  std::unordered_map<std::string, Item> items_;
  std::size_t longest_ = 1;
};

/// The English and the Chinese words of all instructions, except numbers. Read at the first call, in about three
/// milliseconds.
const Lexicon& English();
const Lexicon& Chinese();

/// Units, which count only after a number, since they may be other words elsewhere.
const Lexicon& EnglishUnits();
const Lexicon& ChineseUnits();

}  // namespace gaitwright::words
