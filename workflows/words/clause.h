// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "workflows/words/draft.h"
#include "workflows/words/item.h"

namespace gaitwright::words {

/// The words of one task, or of what is added to one.
struct Clause {
  std::vector<Item> items;
  bool follows_then = false, follows_break = false, is_meanwhile = false, is_before = false, is_after = false;
  std::size_t since = 0;  ///< where the "while" begins that it follows
  bool is_first = false;  ///< to be done before what was said before it
  bool refers = false;    ///< only names again what was said before: "while it turns"
  bool corrects = false, is_not = false, drops = false, again = false, holds = false;
  bool forbids = false;   ///< what is said is not to be done
  bool needless = false;  ///< and need not have been asked for
  bool ends = false;      ///< what is said is done no longer: "stop waving"
  bool exclaims = false;  ///< "oh, not": what comes after it may be what is meant
  bool denies = false;    ///< "no" and nothing after it
  std::string dropped;    ///< the action that is not to be done; "" for whichever was said last

  /// From the first word that is not only polite to the last.
  Span Words() const;
  bool empty() const;  ///< nothing that says anything
};

/// Parts the items of an instruction into clauses: at words and signs that join, and before each further action.
std::vector<Clause> ClausesOf(const std::string& text, const std::vector<Item>& items);

}  // namespace gaitwright::words
