// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "planning/tasks/task_rules.h"
#include "workflows/words/item.h"

namespace gaitwright::words {

/// A part of the text, in bytes.
struct Span {
  std::size_t begin = 0, end = 0;
};

/// A task that is being built from words.
struct Draft {
  std::string action;  ///< "" while unknown
  std::map<std::string, TaskValue> parameters;
  std::map<std::string, Span> said;  ///< position of each parameter in the text
  std::string last_key;              ///< key of the last parameter that is an amount
  double last_unit = 1.0;            ///< factor from a number to this amount
  std::optional<Item> bare;          ///< a number without a unit
  std::optional<std::string> side;   ///< side of a direction or of a limb, while the action is unknown
  std::optional<Span> side_said;
  std::optional<Span> sideways;  ///< position of the word for "sideways"
  std::string part;              ///< arm or foot, if one is named
  bool plural = false;           ///< limbs in the plural: both, unless a side is given
  bool joined = false;           ///< joined to the previous clause only by "and"
  bool holding = false;          ///< done at the same time as the next task
  bool returns = false;          ///< goes back by the distance of the previous walk
  bool aloft = false;            ///< of a turn: it is made in the air
  bool to_nowhere = false;       ///< ends with "to", without a destination
  int stairs = 0;                ///< 1 up, -1 down, 2 to the next step: by a number of steps, or to the end
  Span words;                    ///< all its words
  std::vector<Draft> during;

  bool empty() const { return action.empty() && parameters.empty() && !bare && !side && !plural; }
};

/// Thrown if a part is not accepted.
struct Refused {
  Refusal refusal;
};

/// The text of a span.
std::string TextOf(const std::string& text, const Span& span);

/// Position of a parameter in the text; all words of the draft if it is only implied.
Span SpanOf(const Draft& draft, const std::string& key);

/// Merges parameters into a draft that has its action. With `over` they replace present ones; otherwise a contradiction
/// is refused.
void Merge(const std::string& text, const Draft& said, bool over, Draft& into);

/// Whether an action uses a part of the body: arm, foot, head, body, legs, belly. An arm or a foot may be named without
/// an action.
bool IsDoneWith(const std::string& action, const std::string& part);

/// Interprets the side of a draft by its action: as a direction or as a limb. @throws Refused
void SettleSide(const std::string& text, Draft& draft);

}  // namespace gaitwright::words
