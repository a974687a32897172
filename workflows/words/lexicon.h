// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <unordered_map>

#include "workflows/words/item.h"

namespace gaitwright::words {

/// Words and groups of words of a language with their meanings. English ones are of small letters, their words parted
/// by single spaces; Chinese ones are as they are.
class Lexicon {
 public:
  /// @return false for a phrase that is there already, which keeps its meaning.
  bool Add(const std::string& phrase, const Item& meaning);
  /// The item of a phrase; null for none.
  const Item* Find(const std::string& phrase) const;
  /// The most pieces (words, characters of Chinese) that a phrase has.
  std::size_t longest() const { return longest_; }

 private:
  std::unordered_map<std::string, Item> items_;
  std::size_t longest_ = 1;
};

/// The words of English and of Chinese for all that can be said, numbers left out. Read at the first call, in
/// some three milliseconds.
const Lexicon& English();
const Lexicon& Chinese();

/// Units, which may be other words elsewhere: they count after a number only.
const Lexicon& EnglishUnits();
const Lexicon& ChineseUnits();

}  // namespace gaitwright::words
