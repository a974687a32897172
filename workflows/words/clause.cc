// SPDX-License-Identifier: BSD-3-Clause
#include "workflows/words/clause.h"

#include <algorithm>
#include <functional>
#include <utility>

namespace gaitwright::words {
namespace {

using M = Meaning;

/// Parts an instruction into clauses: at words and signs that join, and before each further action.
class Splitter {
 public:
  Splitter(const std::string& text, const std::vector<Item>& items) : text_(text), items_(items) {}

  std::vector<Clause> Split() {
    for (std::size_t k = 0; k < items_.size(); ++k) {
      if (k != skipped_) Add(items_[k], k);
    }
    Close();
    for (std::size_t k = 0; k + 1 < clauses_.size(); ++k) clauses_[k].refers = clauses_[k + 1].is_meanwhile;
    return std::move(clauses_);
  }

 private:
  bool HasVerb() const { return std::any_of(now_.items.begin(), now_.items.end(), std::mem_fn(&Item::IsVerb)); }

  /// "to the door" after a direction, or "往" before one, begins nothing.
  void Add(const Item& item, std::size_t at) {
    switch (item.meaning) {
      case M::kThen:
        return Join([](Clause& next) { next.follows_then = true; });
      case M::kBreak:
        if (now_.empty() && now_.is_not && !now_.drops) {  // "no, not that, ..."
          now_.is_not = false;
          now_.corrects = true;
        }
        return Join([](Clause& next) { next.follows_break = true; });
      case M::kBefore:
        return Join([](Clause& next) { next.is_before = true; });
      case M::kAfter:
        return Join([](Clause& next) { next.is_after = true; });
      case M::kNo:
        return Join([](Clause& next) { next.corrects = true; });
      case M::kNot:
        return Join([](Clause& next) { next.is_not = true; });
      case M::kDrop:
        return AddDrop(item, at);
      case M::kHold:
        return Join([](Clause& next) { next.holds = true; });
      case M::kWhile:
        return AddWhile(at);
      case M::kFirst:
        now_.is_first = true;
        return;
      case M::kAgain:
        if (HasVerb() && IsAgain(item)) return;  // "nod again"
        Close();
        now_.again = true;
        return Close();
      default:
        break;
    }
    if (HasVerb() && IsParticle(item)) return;  // "走到门那里去"
    if (item.IsVerb() && HasVerb()) {
      // What is said of the way before its verb belongs to it: "往前" in "举手往前走".
      std::vector<Item> lead;
      while (!now_.items.empty() &&
             (LeadsOn(now_.items.back()) || LeadsWay(now_.items.back()) || IsTurnsSide(now_.items.back(), item))) {
        lead.insert(lead.begin(), now_.items.back());
        now_.items.pop_back();
      }
      Close();
      now_.items = lead;
    }
    now_.items.push_back(item);
  }

  /// "don't walk" is not to be done; "never mind" is what was said before.
  void AddDrop(const Item& item, std::size_t at) {
    // "鞠躬就免了": the verb stands before.
    const bool bare = std::count_if(now_.items.begin(), now_.items.end(),
                                    [](const Item& i) { return !i.Is(M::kPolite) && !i.Is(M::kFiller); }) == 1;
    if (bare && now_.items.back().Is(M::kAction) && item.begin == now_.items.back().end && item.name.empty()) {
      now_.drops = now_.is_not = true;
      now_.dropped = now_.items.back().name;
      return Close();
    }
    std::size_t next = at + 1;
    while (next < items_.size() && (items_[next].Is(M::kPolite) || items_[next].Is(M::kFiller))) ++next;
    const bool names = item.name.empty() && next < items_.size() && items_[next].Is(M::kAction);
    if (next < items_.size() && items_[next].Is(M::kPlace)) skipped_ = next;  // "never mind the door"
    const std::string dropped = names ? items_[next].name : item.name;
    Join([&](Clause& clause) {
      clause.drops = true;
      clause.dropped = dropped;
      clause.is_not = names;
      clause.needless = item.value == 1.0;
    });
  }

  /// 去 after another verb only says that it is gone.
  bool IsParticle(const Item& item) const {
    return item.Is(M::kAction) && item.name == "walk" && item.value == 0.0 && item.parameters.empty() &&
           text_.substr(item.begin, item.end - item.begin) == "去";
  }

  /// A way that is said after what goes no way leads to the next verb: "点着头往前走".
  bool LeadsWay(const Item& item) const {
    const auto verb = std::find_if(now_.items.begin(), now_.items.end(), std::mem_fn(&Item::IsVerb));
    const bool goes = verb->Is(M::kAction) && (verb->name == "walk" || verb->name == "turn");
    return !goes && (item.Is(M::kDirection) || item.Is(M::kPace));
  }

  /// "左转" right behind something else.
  static bool IsTurnsSide(const Item& side, const Item& verb) {
    return side.Is(M::kSide) && verb.Is(M::kAction) && verb.name == "turn" && side.end == verb.begin;
  }

  static bool LeadsOn(const Item& item) {
    return item.Is(M::kPolite) || item.Is(M::kFiller) || item.Is(M::kTo) || item.Is(M::kPut);
  }

  /// Once more the verb that is said, rather than the task before.
  bool IsAgain(const Item& item) const {
    const std::string word = TextOf(text_, {item.begin, item.end});
    return word == "again" || word == "once more" || word == "one more time" || word == "once again";
  }

  /// At the end of a clause it says that this one is done meanwhile, before one that that one is.
  void AddWhile(std::size_t at) {
    std::size_t next = at + 1;
    while (next < items_.size() && (items_[next].Is(M::kPolite) || items_[next].Is(M::kFiller))) ++next;
    const bool trails = next == items_.size() || items_[next].Is(M::kBreak) || items_[next].Is(M::kThen);
    if (trails && !now_.empty() && !clauses_.empty()) {
      now_.is_meanwhile = true;
      return Close();
    }
    Join([](Clause& clause) { clause.is_meanwhile = true; });
  }

  template <class Mark>
  void Join(Mark mark) {
    if (!now_.empty()) Close();
    mark(now_);
  }

  void Close() {
    const bool said = !now_.empty() || now_.again || now_.drops;
    if (said) clauses_.push_back(std::exchange(now_, {}));
    now_.items.clear();
  }

  const std::string& text_;
  const std::vector<Item>& items_;
  std::vector<Clause> clauses_;
  Clause now_;
  std::size_t skipped_ = std::string::npos;  // an item that only names again what is dropped
};

}  // namespace

Span Clause::Words() const {
  const auto says = [](const Item& item) { return !item.Is(M::kPolite); };
  const auto first = std::find_if(items.begin(), items.end(), says);
  if (first == items.end()) return {};
  return {first->begin, std::find_if(items.rbegin(), items.rend(), says)->end};
}

bool Clause::empty() const {
  return std::all_of(items.begin(), items.end(),
                     [](const Item& item) { return item.Is(M::kPolite) || item.Is(M::kFiller) || item.Is(M::kAt); });
}

std::vector<Clause> ClausesOf(const std::string& text, const std::vector<Item>& items) {
  return Splitter(text, items).Split();
}

}  // namespace gaitwright::words
