// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "workflows/words/draft.h"
#include "workflows/words/item.h"

namespace gaitwright::words {

/// The words of one task, or of an addition to one.
struct Clause {
  std::vector<Item> items;
  bool follows_then = false, follows_break = false, is_meanwhile = false, is_before = false, is_after = false;
  std::size_t since = 0;  ///< start of the "while" before it
  bool is_first = false;  ///< to be done before the previous request
  bool refers = false;    ///< only repeats a previous action: "while it turns"
  bool corrects = false, is_not = false, drops = false, again = false, holds = false;
  bool forbids = false;   ///< forbids the action
  bool needless = false;  ///< forbids an action that need not have been requested
  bool ends = false;      ///< ends an action: "stop waving"
  bool exclaims = false;  ///< "oh, not": the words after it may be the correct ones
  bool denies = false;    ///< "no" without further words
  std::string dropped;    ///< the cancelled action; "" for the last one

  /// From the first to the last word that is not only polite.
  Span Words() const;
  bool empty() const;  ///< without an item that has a meaning
};

/// Splits the items of an instruction into clauses: at conjunctions and punctuation, and before each further action.
std::vector<Clause> ClausesOf(const std::string& text, const std::vector<Item>& items);

}  // namespace gaitwright::words
