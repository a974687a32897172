// SPDX-License-Identifier: BSD-3-Clause
#include "workflows/words/forbidden.h"

#include <cmath>

#include "workflows/words/read_clause.h"

namespace gaitwright::words {
namespace {

/// Comparison of a forbidden task with a requested task.
struct Likeness {
  bool same_action = false;
  bool differs = false;    ///< a parameter differs in the task
  bool is_silent = false;  ///< the task does not have one of its parameters

  bool IsSame() const { return same_action && !differs && !is_silent; }
  bool IsUnclear() const { return same_action && !differs && is_silent; }
};

double NumberOf(const TaskValue& value) {
  if (const auto* number = std::get_if<double>(&value)) return *number;
  const auto* count = std::get_if<int>(&value);
  return count != nullptr ? *count : std::nan("");
}

void CompareValue(const std::string& key, const TaskValue& value, const Draft& task, Likeness& likeness) {
  const auto there = task.parameters.find(key);
  const TaskValue both = std::string("both"), same = std::string("same");
  if (there == task.parameters.end()) {
    // A task without a pace is not restricted by a forbidden pace.
    (key == "pace" ? likeness.differs : likeness.is_silent) = true;
  } else if (there->second == both && value != both) {
    likeness.is_silent = true;  // the left arm is included in both arms
  } else if (value != same && there->second != value) {
    likeness.differs = true;
  }
}

Likeness Compare(const Draft& what, const Draft& task) {
  Likeness likeness;
  likeness.same_action = what.action.empty() || what.action == task.action;
  if (!likeness.same_action) return likeness;
  for (const auto& [key, span] : what.said) CompareValue(key, what.parameters.at(key), task, likeness);
  if (what.side) CompareValue(task.parameters.contains("side") ? "side" : "direction", *what.side, task, likeness);
  if (what.bare) {
    const auto amount = task.parameters.find(task.last_key);
    const bool amounts = amount != task.parameters.end();
    likeness.is_silent = likeness.is_silent || !amounts;
    likeness.differs = likeness.differs || (amounts && NumberOf(amount->second) != what.bare->value * task.last_unit);
  }
  return likeness;
}

/// Calls a function for each task and each simultaneous gesture, the last first, until it returns true.
template <class Drafts, class Call>
bool AnyOf(Drafts& drafts, Call call) {
  for (auto draft = drafts.rbegin(); draft != drafts.rend(); ++draft) {
    if (AnyOf(draft->during, call) || call(drafts, std::next(draft).base())) return true;
  }
  return false;
}

template <class Drafts, class Which>
bool Has(Drafts& drafts, const Draft& what, Which which) {
  return AnyOf(drafts, [&](auto&, auto draft) { return which(Compare(what, *draft)); });
}

[[noreturn]] void Refuse(const std::string& text, const Draft& what, const std::string& why) {
  throw Refused{{FailureCode::kUnknown, TextOf(text, what.words), why, "", "only the requested actions"}};
}

}  // namespace

bool Forbidden::Add(const Clause& clause, std::vector<Draft>& drafts) {
  Draft what = ReadClause(text_, clause);
  SettleSide(text_, what);
  if (what.empty()) Refuse(text_, what, "does not say what is forbidden");
  const bool asked = Has(drafts, what, [](const Likeness& l) { return l.same_action && !l.differs; });
  if (clause.ends && asked) return true;
  if (clause.ends) Refuse(text_, what, "ends an action that was not requested");
  const bool taken_back = AnyOf(drafts, [&](auto& all, auto draft) {
    if (!Compare(what, *draft).IsSame()) return false;
    all.erase(draft);
    return true;
  });
  if (!taken_back) all_.push_back({what, clause.needless});
  return taken_back;
}

bool Forbidden::AddNot(const Clause& clause, const std::vector<Draft>& drafts) {
  Draft what = ReadClause(text_, clause);
  if (what.action.empty() && !drafts.empty()) what.action = drafts.back().action;
  SettleSide(text_, what);
  const Likeness last = drafts.empty() ? Likeness() : Compare(what, drafts.back());
  if (last.IsSame()) return true;
  if (last.same_action && last.is_silent) Refuse(text_, what, "has more detail than the request that it corrects");
  all_.push_back({what, true});
  return false;
}

void Forbidden::Check(const std::vector<Draft>& drafts) const {
  for (const One& one : all_) {
    if (Has(drafts, one.what, [](const Likeness& l) { return l.IsSame() || l.IsUnclear(); }))
      Refuse(text_, one.what, "forbids a requested action");
    if (!one.asked && !Has(drafts, one.what, [](const Likeness& l) { return l.same_action; }))
      Refuse(text_, one.what, "forbids something that was not requested");
  }
}

}  // namespace gaitwright::words
