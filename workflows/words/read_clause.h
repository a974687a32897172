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
  bool corrects = false, is_not = false, drops = false, again = false, holds = false;
  std::string dropped;  ///< the action that is not to be done; "" for whichever was said last

  /// From the first word that is not only polite to the last.
  Span Words() const;
  bool empty() const;  ///< nothing that says anything
};

/// What a clause says, without what it takes from others. @throws Refused for what is not understood (of the whole
/// clause, or of what follows a number), for a place that is not known and for what contradicts itself.
Draft ReadClause(const std::string& text, const Clause& clause);

/// Puts what is said into a draft that has its action. `over` takes the place of what is there; else what is said twice
/// is refused.
void Merge(const std::string& text, const Draft& said, bool over, Draft& into);

/// Gives a side to a draft by its action: where to, or which limb. @throws Refused
void SettleSide(const std::string& text, Draft& draft);

}  // namespace gaitwright::words
