// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "workflows/words/clause.h"
#include "workflows/words/draft.h"

namespace gaitwright::words {

/// The name of the place that stands for one on stairs until SettleStairs.
inline constexpr char kStairs[] = "stairs";

/// What a clause says of going up or down stairs. "Climb" needs stairs; "go up" needs them too, unless it says how far
/// or where to.
class ClimbWords {
 public:
  /// A verb that says up or down.
  void TakeVerb(const Item& verb);
  /// "up", "down", beside a verb.
  void TakeWay(int way, const Item& item);
  /// "the stairs", the item `at` of the clause. @throws Refused where they are gone to, round or from.
  void TakeStairs(const std::string& text, const Clause& clause, std::size_t at);
  void TakeTreads() { treads_ = true; }

  /// Whether the clause can be about nothing but stairs.
  bool IsSure() const { return sure_; }

  /// Gives the draft its way on stairs. @throws Refused for amounts that are none of stairs, and for no way.
  void Settle(const std::string& text, Draft& draft) const;

 private:
  void CheckAmounts(const std::string& text, const Draft& draft) const;

  int way_ = 0;
  bool sure_ = false, treads_ = false;
  std::optional<Item> verb_, stairs_;
};

/// "up the stairs and back down": what only says up or down after stairs were gone is one more walk on them.
void GoOnStairs(const Draft& last, Draft& said);

/// Gives each walk on stairs the place that it ends on, from where the one before it ends. @throws Refused where the
/// ground has no stairs, or they do not go so far, and where a place that is said is not up or down from there.
void SettleStairs(const std::string& text, const std::vector<PlaceName>& places, std::vector<Draft>& drafts);

}  // namespace gaitwright::words
