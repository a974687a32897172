// SPDX-License-Identifier: BSD-3-Clause
#include "workflows/words/clause.h"

#include <algorithm>
#include <functional>
#include <utility>

namespace gaitwright::words {
namespace {

using M = Meaning;

/// Splits an instruction into clauses: at conjunctions and punctuation, and before each further action.
class Splitter {
 public:
  Splitter(const std::string& text, const std::vector<Item>& items) : text_(text), items_(items) {}

  std::vector<Clause> Split() {
    for (std::size_t k = 0; k < items_.size(); ++k) {
      if (k != skipped_) Add(items_[k], k);
    }
    now_.denies = denied_ && now_.empty() && now_.corrects;
    Close();
    for (std::size_t k = 0; k + 1 < clauses_.size(); ++k) clauses_[k].refers = clauses_[k + 1].is_meanwhile;
    return std::move(clauses_);
  }

 private:
  bool HasVerb() const { return std::any_of(now_.items.begin(), now_.items.end(), std::mem_fn(&Item::IsVerb)); }

  /// "to the door" after a direction, or "往" before one, does not begin a clause.
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
        return AddNo(item, at);
      case M::kNot:
        return Join([&](Clause& next) {
          next.is_not = true;
          next.exclaims = item.name == "oh";
        });
      case M::kForbid:
        return AddForbid(item, at);
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
    if (IsStop(item, at)) return Forbid(item, true);
    if (DoesNoGesture() && IsWithLimb(at)) Join([](Clause& clause) { clause.is_meanwhile = true; });
    if (HasVerb() && (IsParticle(item) || IsTurnOfJump(item))) return;  // "走到门那里去"
    if (item.IsVerb() && HasVerb()) {
      // A direction before its verb belongs to this verb: "往前" in "举手往前走".
      std::vector<Item> lead;
      while (!now_.items.empty() && (LeadsOn(now_.items.back()) || LeadsWay(now_.items.back()) ||
                                     IsTurnsSide(now_.items.back(), item) || IsPutsLimb())) {
        lead.insert(lead.begin(), now_.items.back());
        now_.items.pop_back();
      }
      Close();
      now_.items = lead;
    }
    now_.items.push_back(item);
  }

  /// The next item with a meaning, up to the end or the next conjunction.
  const Item* SaidAfter(std::size_t at) const {
    for (std::size_t k = at + 1; k < items_.size(); ++k) {
      if (items_[k].Is(M::kBreak) || items_[k].Is(M::kThen) || items_[k].Is(M::kNo)) return nullptr;
      if (!items_[k].SaysNothing()) return &items_[k];
    }
    return nullptr;
  }

  bool IsGerund(const Item& item) const {
    const std::string word = TextOf(text_, {item.begin, item.end});
    return item.IsVerb() && word.substr(0, word.find(' ')).ends_with("ing");
  }

  /// "no walking" forbids, "no, walk" corrects.
  void AddNo(const Item& item, std::size_t at) {
    const Item* next = SaidAfter(at);
    if (item.name == "no" && next != nullptr && IsGerund(*next)) return Forbid(item, false);
    denied_ = item.name == "no";
    Join([](Clause& clause) { clause.corrects = true; });
  }

  void Forbid(const Item& word, bool ends) {
    Join([&](Clause& clause) {
      clause.forbids = true;
      clause.ends = ends;
      clause.needless = word.name == "needless";
      clause.items.push_back(word);
      clause.items.back().meaning = M::kForbid;
    });
  }

  /// "不要走" forbids, "不要，走" corrects, and "don't" alone cancels the last request.
  void AddForbid(const Item& item, std::size_t at) {
    if (SaidAfter(at) != nullptr) return Forbid(item, false);
    if (item.name == "no") return AddNo(item, at);
    AddDrop(item, at);
  }

  /// "stop waving", "stop the march", "停止挥手"
  bool IsStop(const Item& item, std::size_t at) const {
    const Item* next = SaidAfter(at);
    if (!item.Is(M::kAction) || item.name != "stand" || next == nullptr || !next->IsVerb()) return false;
    const std::string word = TextOf(text_, {item.begin, item.end});
    const bool stops = word.size() >= 4 && word.substr(1, 3) == "top" && word.find(' ') == std::string::npos;
    const bool noun = items_[at + 1].Is(M::kFiller) && items_[at + 1].name == "the";
    return (stops && (IsGerund(*next) || noun)) || word == "停止";
  }

  bool DoesNoGesture() const {
    const auto verb = std::find_if(now_.items.begin(), now_.items.end(), std::mem_fn(&Item::IsVerb));
    return verb != now_.items.end() && verb->Is(M::kAction) && !FindAction(verb->name)->is_gesture;
  }

  /// "with your hands up", "with both arms raised": a gesture at the same time as the task.
  bool IsWithLimb(std::size_t at) const {
    const std::string word = TextOf(text_, {items_[at].begin, items_[at].end});
    if (word != "with" && !word.starts_with("with ")) return false;
    bool arm = false;
    for (std::size_t k = at + 1; k < items_.size(); ++k) {
      const Item& item = items_[k];
      if (arm && (item.Is(M::kUp) || item.Is(M::kDown) || item.Is(M::kRaise) || item.Is(M::kLower))) return true;
      arm = arm || item.Is(M::kArm) || item.Is(M::kPlural);
      if (!item.SaysNothing() && !item.Is(M::kSide) && !item.Is(M::kBoth) && !arm) return false;
    }
    return false;
  }

  /// "never mind the bow" cancels the bow; "never mind" cancels the last request.
  void AddDrop(const Item& item, std::size_t at) {
    // "鞠躬就免了": the verb stands before.
    const bool bare = std::count_if(now_.items.begin(), now_.items.end(),
                                    [](const Item& i) { return !i.Is(M::kPolite) && !i.Is(M::kFiller); }) == 1;
    if (bare && now_.items.back().Is(M::kAction) && item.begin == now_.items.back().end &&
        (item.name.empty() || item.Is(M::kForbid))) {
      now_.drops = now_.is_not = true;
      now_.dropped = now_.items.back().name;
      return Close();
    }
    const Item* next = SaidAfter(at);
    if (item.name.empty() && next != nullptr && next->IsVerb()) return Forbid(item, false);
    if (next != nullptr && next->Is(M::kPlace)) skipped_ = static_cast<std::size_t>(next - items_.data());
    Join([&](Clause& clause) {
      clause.drops = true;
      clause.dropped = item.Is(M::kDrop) ? item.name : "";
    });
  }

  /// 去 after another verb has no meaning of its own here.
  bool IsParticle(const Item& item) const {
    return item.Is(M::kAction) && item.name == "walk" && item.value == 0.0 && item.parameters.empty() &&
           text_.substr(item.begin, item.end - item.begin) == "去";
  }

  /// "jump with a 90 degree turn": the noun after the angle is no other task.
  bool IsTurnOfJump(const Item& item) const {
    const auto verb = std::find_if(now_.items.begin(), now_.items.end(), std::mem_fn(&Item::IsVerb));
    const auto last = std::find_if_not(now_.items.rbegin(), now_.items.rend(), std::mem_fn(&Item::SaysNothing));
    return verb->Is(M::kAction) && verb->name == "jump" && item.Is(M::kAction) && item.name == "turn" &&
           last->Is(M::kAmount) && last->name == "deg" && item.parameters.empty();
  }

  /// A direction after an action without direction belongs to the next verb: "点着头往前走".
  bool LeadsWay(const Item& item) const {
    const auto verb = std::find_if(now_.items.begin(), now_.items.end(), std::mem_fn(&Item::IsVerb));
    const bool goes = verb->Is(M::kAction) && (verb->name == "walk" || verb->name == "turn");
    const std::size_t count = now_.items.size();
    const bool after_place = count > 1 && now_.items[count - 2].Is(M::kPlace) && item.Is(M::kSide);  // "走到门往左走"
    return after_place || (!goes && (item.Is(M::kDirection) || item.Is(M::kPace)));
  }

  /// "点完头把右手放下来": the limb is before the verb.
  bool IsPutsLimb() const {
    const std::size_t count = now_.items.size();
    const bool limb = now_.items.back().Is(M::kArm) || now_.items.back().Is(M::kFoot) || now_.items.back().Is(M::kBoth);
    return limb && count > 1 && now_.items[count - 2].Is(M::kPut);
  }

  /// "左转" right behind something else.
  static bool IsTurnsSide(const Item& side, const Item& verb) {
    return side.Is(M::kSide) && verb.Is(M::kAction) && verb.name == "turn" && side.end == verb.begin;
  }

  static bool LeadsOn(const Item& item) {
    return item.Is(M::kPolite) || item.Is(M::kFiller) || item.Is(M::kTo) || item.Is(M::kPut);
  }

  /// Whether "again" refers to the verb of this clause and not to the previous task.
  bool IsAgain(const Item& item) const {
    const std::string word = TextOf(text_, {item.begin, item.end});
    return word == "again" || word == "once more" || word == "one more time" || word == "once again";
  }

  /// "while" at the end of a clause makes this clause simultaneous; before a clause, that one.
  void AddWhile(std::size_t at) {
    std::size_t next = at + 1;
    while (next < items_.size() && items_[next].SaysNothing()) ++next;
    const bool trails = next == items_.size() || items_[next].Is(M::kBreak) || items_[next].Is(M::kThen);
    if (trails && !now_.empty() && !clauses_.empty()) {
      now_.is_meanwhile = true;
      return Close();
    }
    Join([&](Clause& clause) {
      clause.is_meanwhile = true;
      clause.since = items_[at].begin;
    });
  }

  template <class Mark>
  void Join(Mark mark) {
    if (!now_.empty()) Close();
    mark(now_);
  }

  void Close() {
    const bool said = !now_.empty() || now_.again || now_.drops || now_.denies;
    if (said) clauses_.push_back(std::exchange(now_, {}));
    now_.items.clear();
  }

  const std::string& text_;
  const std::vector<Item>& items_;
  std::vector<Clause> clauses_;
  Clause now_;
  std::size_t skipped_ = std::string::npos;  // an item that only repeats the cancelled action
  bool denied_ = false;                      // set by the last correcting word
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
