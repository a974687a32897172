// SPDX-License-Identifier: BSD-3-Clause
#include "workflows/words/climb.h"

#include "kinematics/base/text.h"

namespace gaitwright::words {
namespace {

using M = Meaning;

bool IsRelation(const Item& item) { return item.Is(M::kFiller) && item.name == "relation"; }

/// Sets a destination that is not known yet.
void GoTo(const Span& words, Draft& draft) {
  draft.parameters["to"] = PlaceName{kStairs, 0};
  draft.said["to"] = words;
}

}  // namespace

void ClimbWords::TakeVerb(const Item& verb) {
  direction_ = verb.value == kUpStairs || verb.value == kUpwards ? 1 : -1;
  sure_ = verb.value == kUpStairs || verb.value == kDownStairs;
  verb_ = verb;
}

void ClimbWords::TakeDirection(int direction, const Item& item) {
  if (direction_ != 0) return;
  direction_ = direction;
  if (!verb_) verb_ = item;
}

void ClimbWords::TakeStairs(const std::string& text, const Clause& clause, std::size_t at) {
  const Item& stairs = clause.items[at];
  const std::string words = TextOf(text, {stairs.begin, stairs.end});
  const Item* before = nullptr;
  std::size_t begin = at;
  while (before == nullptr && begin > 0) {
    const Item& item = clause.items[--begin];
    if (!item.SaysNothing() || IsRelation(item)) before = &item;
  }
  const bool to = before != nullptr && (before->Is(M::kTo) || (before->Is(M::kAction) && before->value == kToPlace));
  if (to && stairs.value != 2.0) throw Refused{{FailureCode::kPlace, words, "is not a known place", ""}};
  while (before != nullptr && IsRelation(*before) && begin > 0 && clause.items[begin - 1].Is(M::kFiller)) --begin;
  if (before != nullptr && IsRelation(*before))
    throw Refused{{FailureCode::kUnknown, TextOf(text, {clause.items[begin].begin, stairs.end}),
                   "is not possible: stairs can only be walked up or down", ""}};
  if (stairs.value != 0.0) direction_ = static_cast<int>(stairs.value);
  stairs_ = stairs;
}

/// Refuses amounts that do not apply to stairs.
void ClimbWords::CheckAmounts(const std::string& text, const Draft& draft) const {
  for (const char* key : {"distance_m", "duration_s", "times"}) {
    const auto said = draft.said.find(key);
    if (said == draft.said.end()) continue;
    throw Refused{{FailureCode::kUnknown, TextOf(text, said->second),
                   "does not apply to stairs: they are walked by a number of steps, or to their end", "",
                   "'two steps', or 'to the second step'"}};
  }
}

void ClimbWords::Settle(const std::string& text, Draft& draft) const {
  const bool named = stairs_ || treads_;
  if (direction_ == 0 && !named) return;
  const bool walks = draft.action.empty() || draft.action == "walk";
  const Span words = stairs_ ? Span{stairs_->begin, stairs_->end} : draft.words;
  if (!walks && named)
    throw Refused{{FailureCode::kUnknown, TextOf(text, words), "cannot be used with '" + draft.action + "'", ""}};
  if (!walks) return;
  if (draft.parameters.contains("to")) {
    draft.stairs = direction_;
    return;
  }
  if (direction_ == 0)
    throw Refused{{FailureCode::kUnknown, TextOf(text, words), "need a direction: up or down", "",
                   "'climb the stairs', or 'go down the stairs'"}};
  if (sure_ || named) CheckAmounts(text, draft);
  draft.stairs = direction_;
  const bool steps = draft.said.contains("steps"),
             far = draft.said.contains("distance_m") || draft.said.contains("duration_s");
  if (far && !steps) draft.stairs = 0;
  const bool alone = draft.action.empty() && !steps && !named;
  if (alone && !draft.empty()) draft.stairs = 0;
  if (draft.stairs == 0 || alone) return;
  draft.action = "walk";
  if (steps) return;
  const std::string verb = verb_ ? LowerCase(TextOf(text, {verb_->begin, verb_->end})) : "";
  const bool one = (!stairs_ && (verb == "step up" || verb == "step down")) || direction_ == 2;
  if (one) {
    draft.parameters["steps"] = 1;
    draft.said["steps"] = words;
  } else {
    GoTo(words, draft);
  }
}

void GoOnStairs(const Draft& last, Draft& said) {
  if (said.stairs == 0 || last.stairs == 0 || !said.empty()) return;
  said.action = "walk";
  GoTo(said.words, said);
}

}  // namespace gaitwright::words
