// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "workflows/words/clause.h"
#include "workflows/words/draft.h"

namespace gaitwright::words {

/// Name that stands for a place on stairs until SettleStairs.
inline constexpr char kStairs[] = "stairs";

/// The words of a clause about walking up or down stairs. "Climb" needs stairs; "go up" needs them too, unless the
/// clause has a distance or a destination.
class ClimbWords {
 public:
  /// Takes a verb that means up or down.
  void TakeVerb(const Item& verb);
  /// Takes "up" or "down" beside a verb.
  void TakeDirection(int direction, const Item& item);
  /// Takes "the stairs", the item `at` of the clause. @throws Refused for "to", "around" or "from" the stairs.
  void TakeStairs(const std::string& text, const Clause& clause, std::size_t at);
  void TakeTreads() { treads_ = true; }

  /// Whether the clause can only be about stairs.
  bool IsSure() const { return sure_; }

  /// Sets the draft's direction on stairs. @throws Refused for amounts that do not apply to stairs, and without a
  /// direction.
  void Settle(const std::string& text, Draft& draft) const;

 private:
  void CheckAmounts(const std::string& text, const Draft& draft) const;

  int direction_ = 0;
  bool sure_ = false, treads_ = false;
  std::optional<Item> verb_, stairs_;
};

/// "up the stairs and back down": "up" or "down" alone after a walk on stairs is another walk on them.
void GoOnStairs(const Draft& last, Draft& said);

/// Sets the final place of each walk on stairs, starting from the end of the previous walk. @throws Refused if the
/// ground has no stairs or not enough steps, and if a given place is not above or below the start as requested.
void SettleStairs(const std::string& text, const std::vector<PlaceName>& places, std::vector<Draft>& drafts);

}  // namespace gaitwright::words
