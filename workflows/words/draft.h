// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "planning/tasks/task_rules.h"
#include "workflows/words/item.h"

namespace gaitwright::words {

/// A stretch of the text.
struct Span {
  std::size_t begin = 0, end = 0;
};

/// A task that is being made out of words.
struct Draft {
  std::string action;  ///< "" while nothing says it
  std::map<std::string, TaskValue> parameters;
  std::map<std::string, Span> said;  ///< where each parameter is
  std::string last_key;              ///< of the parameter that was an amount last
  double last_unit = 1.0;            ///< what a number is multiplied with to be such an amount
  std::optional<Item> bare;          ///< a number without a unit
  std::optional<std::string> side;   ///< of a way or of a limb, as long as there is no action
  std::optional<Span> side_said;
  std::optional<Span> sideways;  ///< where it says so
  std::string part;              ///< arm or foot, where one is named
  bool plural = false;           ///< limbs, both unless a side says which
  bool joined = false;           ///< to the one before, by "and" alone
  bool holding = false;          ///< done while the next one is
  bool returns = false;          ///< as far back as the walk before went
  bool to_nowhere = false;       ///< ends with a "to"
  int stairs = 0;                ///< 1 up them, -1 down them, 2 on to the next step: by its steps, or the whole way
  Span words;                    ///< all of it
  std::vector<Draft> during;

  bool empty() const { return action.empty() && parameters.empty() && !bare && !side && !plural; }
};

/// Thrown where a part is not accepted.
struct Refused {
  Refusal refusal;
};

/// The part of a text.
std::string TextOf(const std::string& text, const Span& span);

/// Where a parameter is said; all of the draft's words where it is only meant.
Span SpanOf(const Draft& draft, const std::string& key);

/// Puts what is said into a draft that has its action. `over` takes the place of what is there; else what is said twice
/// is refused.
void Merge(const std::string& text, const Draft& said, bool over, Draft& into);

/// Whether an action is done with that part of the body: arm, foot, head, body, legs, belly. Of an arm or a foot alone
/// no action need be said.
bool IsDoneWith(const std::string& action, const std::string& part);

/// Gives a side to a draft by its action: where to, or which limb. @throws Refused
void SettleSide(const std::string& text, Draft& draft);

}  // namespace gaitwright::words
