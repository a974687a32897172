// SPDX-License-Identifier: BSD-3-Clause
#include "workflows/words/read_clause.h"

#include <algorithm>
#include <cmath>

#include "workflows/words/climb.h"
#include "workflows/words/jump_words_internal.h"
#include "workflows/words/phrases.h"
#include "workflows/words/place_relation.h"
#include "workflows/words/settle_amounts.h"

namespace gaitwright::words {
namespace {

using M = Meaning;

[[noreturn]] void Refuse(FailureCode code, const std::string& part, const std::string& why,
                         const std::string& nearest = "") {
  throw Refused{{code, part, why, nearest}};
}

/// Reads the items of one clause.
class ClauseReader {
 public:
  ClauseReader(const std::string& text, const Clause& clause) : text_(text), clause_(clause) {
    draft_.words = clause.Words();
  }

  Draft Read() {
    const auto is_greeting = [](const Item& item) { return item.Is(M::kAction) && IsGreeting(item.name); };
    greets_ = std::any_of(clause_.items.begin(), clause_.items.end(), is_greeting);
    RefuseUnknownStart();
    for (at_ = 0; at_ < clause_.items.size(); ++at_) Take(clause_.items[at_]);
    draft_.to_nowhere = EndsWithTo();
    SettleAction();
    return std::move(draft_);
  }

 private:
  [[noreturn]] void RefuseAll() const {
    std::string nearest = climb_.IsSure() ? "walk" : "";
    for (const Item& item : clause_.items) {
      if (item.Is(M::kElsewhere)) nearest = item.name;
    }
    if (nearest == "recover")
      throw Refused{{FailureCode::kUnknown, TextOf(text_, clause_.Words()),
                     "is done by the controller and needs no instruction", "",
                     "'stand' with --controller recovering and --push, or 'brace'"}};
    Refuse(FailureCode::kUnknown, TextOf(text_, clause_.Words()), "is not an instruction for a robot", nearest);
  }

  /// Refuses the whole clause if it begins with unknown words.
  void RefuseUnknownStart() const {
    for (const Item& item : clause_.items) {
      if (item.SaysNothing()) continue;
      const bool likened = &item != &clause_.items.front() && (&item)[-1].name == "like";
      if (likened && item.Is(M::kUnknown)) continue;
      if (item.Is(M::kElsewhere) || (item.Is(M::kUnknown) && !greets_)) RefuseAll();
      return;
    }
  }

  /// "walk to the"
  bool EndsWithTo() const {
    const auto is_article = [](const Item& item) { return item.Is(M::kFiller) && item.name == "the"; };
    const auto last = std::find_if_not(clause_.items.rbegin(), clause_.items.rend(), is_article);
    return last != clause_.items.rend() && last->Is(M::kTo);
  }

  void Take(const Item& item) {
    switch (item.meaning) {
      case M::kAction:
        return TakeAction(item);
      case M::kDirection:
        return Say("direction", item.name, item);
      case M::kSide:
        return TakeSide(item.name, item);
      case M::kSideways:
        draft_.sideways = Span{item.begin, item.end};
        return;
      case M::kBoth:
        return TakeSide("both", item);
      case M::kArm:
        arm_ = item;
        if (!item.name.empty()) TakeSide(item.name, item);
        return;
      case M::kPlural:
        arm_ = item;
        draft_.plural = true;
        return;
      case M::kPart:
        parts_.push_back(item);
        return;
      case M::kFoot:
        foot_ = item;
        if (item.name == "left" || item.name == "right") TakeSide(item.name, item);
        return;
      case M::kRaise:
        raises_ = true;
        if (item.name == "both") arm_ = item;
        draft_.plural = draft_.plural || item.name == "both";
        draft_.holding = draft_.holding || TextOf(text_, {item.begin, item.end}).find("着") != std::string::npos ||
                         TextOf(text_, {item.begin, item.end}).find("ing") != std::string::npos ||
                         TextOf(text_, {item.begin, item.end}) == "raised";
        return;
      case M::kLower:
        lowers_ = true;
        return;
      case M::kUp:
        up_ = true;
        if (item.name == "way") climb_.TakeDirection(1, item);
        return;
      case M::kDown:
        down_ = true;
        if (item.name == "way") climb_.TakeDirection(-1, item);
        return;
      case M::kStairs:
        return climb_.TakeStairs(text_, clause_, at_);
      case M::kPut:
        puts_ = true;
        return;
      case M::kNumber:
        return TakeNumber(item);
      case M::kAmount:
        return TakeAmount(item);
      case M::kEach:
        each_ = true;
        return;
      case M::kPlace:
        CheckGoesTo(text_, clause_, at_);
        return Say("to", PlaceName{item.name, static_cast<int>(std::lround(item.value))}, item);
      case M::kPace:
        return SaySoftly("pace", item.name, item);
      case M::kGait:
        return Say("gait", item.name, item);
      case M::kLow:
        return SaySoftly("height", std::string("low"), item);
      case M::kFiller:
        if (item.name == "relation") TakeRound(item);
        return;
      case M::kUnknown:
      case M::kElsewhere:
        return TakeUnknown(item);
      default:
        return;
    }
  }

  void TakeAction(const Item& item) {
    if (!draft_.action.empty()) return;  // the clause would have been split
    draft_.action = item.name;
    if (item.GoesUpOrDown()) climb_.TakeVerb(item);
    draft_.holding = draft_.holding || item.value == kBeside || IsGerund(item);
    draft_.returns = item.value == kReturns;
    for (const auto& [key, value] : item.parameters) {
      implied_[key] = value;
      implied_said_ = {item.begin, item.end};
    }
  }

  /// "waving, walk on".
  bool IsGerund(const Item& item) const {
    const std::string word = TextOf(text_, {item.begin, item.end});
    return word.substr(0, word.find(' ')).ends_with("ing");
  }

  void Say(const std::string& key, const TaskValue& value, const Item& item) {
    const auto said = draft_.said.find(key);
    if (said != draft_.said.end() && draft_.parameters[key] != value)
      Refuse(FailureCode::kAmbiguous, TextOf(text_, {said->second.begin, item.end}), "gives two instructions at once");
    draft_.parameters[key] = value;
    draft_.said[key] = {item.begin, item.end};
  }

  /// Sets a parameter that may be given again; the last value counts.
  void SaySoftly(const std::string& key, const TaskValue& value, const Item& item) {
    draft_.parameters[key] = value;
    draft_.said[key] = {item.begin, item.end};
  }

  void TakeSide(const std::string& side, const Item& item) {
    if (draft_.side && *draft_.side != side) {
      const bool both =
          (arm_ && !IsMeans(text_, clause_, draft_.side_said->begin, at_)) || *draft_.side == "both" || side == "both";
      if (!both)
        Refuse(FailureCode::kAmbiguous, TextOf(text_, {draft_.side_said->begin, item.end}), "gives two sides at once");
      draft_.side = "both";
      return;
    }
    if (!draft_.side) draft_.side_said = Span{item.begin, item.end};
    draft_.side = side;
  }

  void TakeNumber(const Item& item) {
    // "two squats": a number of repetitions.
    const bool counts = at_ + 1 < clause_.items.size() && NextIsCounted();
    if (counts) return SayAmount("times", item.value, 1.0, item);
    if (draft_.bare)
      Refuse(FailureCode::kAmbiguous, TextOf(text_, {draft_.bare->begin, item.end}), "are two numbers without units");
    draft_.bare = item;
  }

  bool NextIsCounted() const {
    for (std::size_t k = at_ + 1; k < clause_.items.size(); ++k) {
      const Item& next = clause_.items[k];
      if (next.SaysNothing()) continue;
      return next.Is(M::kAction) && IsCounted(next.name);
    }
    return false;
  }

  void SayAmount(const std::string& key, double value, double unit, const Item& item) {
    const auto* rule = FindParameter(key);
    if (rule->kind == ParameterRule::Kind::kCount) {
      constexpr double kMost = 1e9;
      if (value != std::round(value) && key == "steps")
        Refuse(FailureCode::kRange, TextOf(text_, {item.begin, item.end}), "is not a whole number of steps");
      Say(key, static_cast<int>(std::lround(std::clamp(value, -kMost, kMost))), item);
    } else {
      Say(key, RoundedAmount(value), item);
    }
    draft_.last_key = key;
    draft_.last_unit = unit;
    draft_.bare.reset();
  }

  void TakeAmount(const Item& item) {
    if (item.name == "m/step") return SayAmount("step_length_m", item.value, 1.0, item);
    if (item.name == "m" && (each_ || NextIsEach() || IsOfSteps(text_, clause_, at_)))
      return SayAmount("step_length_m", item.value, 1.0, item);
    if (item.name == "m") return SayAmount("distance_m", item.value, 1.0, item);
    if (item.name == "s") return SayAmount("duration_s", item.value, 1.0, item);
    if (item.name == "deg" || item.name == "turns") {
      turns_ = turns_ || item.name == "turns";
      return SayAmount("angle_deg", item.value, item.name == "turns" ? 360.0 : 1.0, item);
    }
    if (item.name == "treads") climb_.TakeTreads();
    if (item.name == "steps" || item.name == "treads") return SayAmount("steps", item.value, 1.0, item);
    if (item.name == "m/s") return SayAmount("speed_m_s", item.value, 1.0, item);
    const bool counted = item.name == "times" || NextIsCounted() || IsCounted(draft_.action);
    if (counted) return SayAmount("times", item.value, 1.0, item);
    draft_.bare = item;  // number of repetitions of the next action
  }

  /// "walk around" has no destination; "around two metres" is an amount.
  void TakeRound(const Item& item) const {
    const std::string word = TextOf(text_, {item.begin, item.end});
    const bool round = word == "around" || word == "about" || word == "round";
    const bool amount = at_ + 1 < clause_.items.size() &&
                        (clause_.items[at_ + 1].Is(M::kAmount) || clause_.items[at_ + 1].Is(M::kNumber));
    const bool place =
        std::any_of(clause_.items.begin(), clause_.items.end(), [](const Item& other) { return other.Is(M::kPlace); });
    if (round && draft_.action == "walk" && !amount && !place)
      Refuse(FailureCode::kUnknown, word, "gives neither a distance nor a destination");
  }

  bool NextIsEach() const {
    for (std::size_t k = at_ + 1; k < clause_.items.size(); ++k) {
      if (clause_.items[k].Is(M::kEach)) return true;
      if (!clause_.items[k].SaysNothing()) return false;
    }
    return false;
  }

  void TakeUnknown(const Item& item) {
    for (std::size_t k = at_; k-- > 0 && clause_.items[k].SaysNothing();) {
      if (clause_.items[k].name == "like") return;  // "like a stork"
    }
    const bool first = at_ == 0;
    const Item* before = nullptr;
    for (std::size_t k = at_; k-- > 0 && before == nullptr;) {
      if (!clause_.items[k].SaysNothing()) before = &clause_.items[k];
    }
    if (greets_ && IsAddressed(text_, clause_, at_)) return;
    if (greets_ && (first || before == nullptr || before->Is(M::kAt) || before->Is(M::kTo) || Greets(text_, *before)))
      return;  // the person to wave to
    std::size_t end = item.end;
    for (std::size_t k = at_ + 1; k < clause_.items.size(); ++k) {
      if (!clause_.items[k].SaysNothing() && !clause_.items[k].Is(M::kUnknown)) break;
      end = clause_.items[k].end;
    }
    if (draft_.bare) {
      const bool walks = draft_.action.empty() || draft_.action == "walk";
      Refuse(FailureCode::kUnknown, TextOf(text_, {draft_.bare->begin, end}), "is not an amount", walks ? "walk" : "");
    }
    const bool to = before != nullptr && (before->Is(M::kTo) || (before->Is(M::kAction) && before->value == kToPlace));
    if (to && (draft_.action.empty() || draft_.action == "walk" || draft_.action == "jump"))
      Refuse(FailureCode::kPlace, TextOf(text_, {item.begin, item.end}), "is not a known place");
    if (draft_.action.empty() || climb_.IsSure()) RefuseAll();
    Refuse(FailureCode::kUnknown, TextOf(text_, {item.begin, item.end}), "is not understood");
  }

  /// Finds an action that is given by several words, and applies the parameters that an action word implies.
  void SettleAction() {
    const bool limb = arm_ || foot_;
    // "pop both arms up"
    const bool moves_arms = draft_.action == "walk" && arm_ && (up_ || down_) && draft_.said.empty();
    if (moves_arms) {
      draft_.action.clear();
      puts_ = true;
    }
    const bool raise = raises_ || (puts_ && up_) || (draft_.action.empty() && limb && up_);
    const bool lower = lowers_ || (puts_ && down_) || (draft_.action.empty() && limb && down_);
    const bool stays = draft_.action == "balance" || draft_.action == "stand";
    if (stays && !foot_ && draft_.parameters.contains("to")) draft_.action = "walk";
    if (draft_.action == "stand" && foot_) draft_.action = "balance";
    if (draft_.action.empty() && raise && foot_) {
      draft_.action = "balance";
      if (draft_.side) draft_.side = Other(*draft_.side);
    } else if (draft_.action.empty() && foot_ && down_ && !lowers_ && !puts_) {
      draft_.action = "balance";  // "left foot down"
    } else if (draft_.action.empty() && raise && (arm_ || draft_.side)) {
      draft_.action = "raise_arm";
    } else if (draft_.action.empty() && (lower || raise)) {
      draft_.action = "lower_arm";
      if (raise) RefuseAll();
      if (!arm_ && !draft_.side) draft_.side = "same";
    }
    const bool with =
        !clause_.items.empty() && TextOf(text_, {clause_.items[0].begin, clause_.items[0].end}).substr(1, 3) == "ith";
    draft_.holding = draft_.holding || (with && draft_.action == "raise_arm");
    if (draft_.action == "nod" && NodsInVain(text_, clause_)) RefuseAll();
    for (const auto& [key, value] : implied_) {
      if (key == "direction" && draft_.side) continue;
      if (value == TaskValue(std::string("sideways"))) {
        if (!draft_.parameters.contains("to")) draft_.sideways = implied_said_;
        continue;
      }
      if (key == "direction" && draft_.parameters.contains("to") && GoesBack(TextOf(text_, implied_said_)))
        continue;  // "go back to the door"
      if (draft_.parameters.contains(key)) continue;
      draft_.parameters[key] = value;
      draft_.said[key] = implied_said_;
    }
    SettleTurn();
    SettleGait();
    if (!limb && !raises_ && !lowers_ && !puts_) climb_.Settle(text_, draft_);
    SettleAmounts(draft_);
    SettleJump(text_, clause_, draft_);
    if (puts_ && draft_.empty()) RefuseAll();
    CheckParts();
  }

  /// "shake your head", "walk on your hands": refuses parts of the body that the action does not use.
  void CheckParts() {
    const auto check = [&](const std::string& part, const Item& item) {
      if (IsDoneWith(draft_.action, part)) return;
      const std::string why = draft_.action.empty() ? "is not a part that can be moved alone"
                                                    : "is not a part of the robot's body for '" + draft_.action + "'";
      Refuse(FailureCode::kUnknown, TextOf(text_, {item.begin, item.end}), why);
    };
    if (arm_) check("arm", *arm_);
    if (foot_) check("foot", *foot_);
    draft_.part = foot_ ? "foot" : arm_ ? "arm" : "";
    for (const Item& part : parts_) check(part.name, part);
  }

  void SettleTurn() {
    const bool sided = draft_.action.empty() && draft_.side && !arm_ && !foot_ && !raises_ && draft_.parameters.empty();
    if (draft_.bare && IsAngle(draft_.bare->value) && (draft_.action == "turn" || sided)) {
      SayAmount("angle_deg", draft_.bare->value, 1.0, Item(*draft_.bare));
    }
    const bool angled = draft_.action.empty() && draft_.side && !arm_ && !foot_ && draft_.said.contains("angle_deg");
    if ((draft_.action.empty() && turns_) || angled) draft_.action = "turn";
  }

  /// "walk 两步": here the name of a gait is the verb.
  void SettleGait() {
    const auto gait = draft_.said.find("gait");
    if (gait == draft_.said.end() || !draft_.action.empty() || TextOf(text_, gait->second) != "walk") return;
    if (!draft_.said.contains("steps") && !draft_.said.contains("distance_m")) return;
    draft_.action = "walk";
    draft_.parameters.erase("gait");
    draft_.said.erase("gait");
  }

  const std::string& text_;
  const Clause& clause_;
  std::size_t at_ = 0;
  Draft draft_;
  std::map<std::string, TaskValue> implied_;
  Span implied_said_;
  ClimbWords climb_;
  std::optional<Item> arm_, foot_;
  std::vector<Item> parts_;
  bool greets_ = false, raises_ = false, lowers_ = false, puts_ = false, up_ = false;
  bool down_ = false, each_ = false, turns_ = false;
};

}  // namespace

Draft ReadClause(const std::string& text, const Clause& clause) { return ClauseReader(text, clause).Read(); }

}  // namespace gaitwright::words
