// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>

#include "kinematics/base/text.h"
#include "workflows/words/jump_words_internal.h"

namespace gaitwright::words {
namespace {

using M = Meaning;

Span SpanOfItem(const Item& item) { return {item.begin, item.end}; }

bool IsOnAxisOfPitch(const TaskValue& direction) {
  return direction == TaskValue(std::string("forward")) || direction == TaskValue(std::string("backward"));
}

class JumpWords {
 public:
  JumpWords(const std::string& text, const Clause& clause, Draft& draft)
      : text_(text), items_(clause.items), draft_(draft) {}

  void SettleJump() {
    RefuseWhatIsJumpedOver();
    SettleSides();
    SettleTurn();
    SettleLevel();
    if (draft_.parameters.contains("step_length_m") && !draft_.parameters.contains("distance_m"))
      Rename("step_length_m", "distance_m");  // "jump three times, 20 cm each"
  }

  /// A backflip has its direction, a barrel roll its axis.
  void SettleFlip() {
    if (draft_.side) Set("direction", *draft_.side, draft_.side_said.value_or(draft_.words));
    draft_.side.reset();
    const auto verb = std::find_if(items_.begin(), items_.end(), [](const Item& item) { return item.Is(M::kAction); });
    if (verb == items_.end() || !verb->parameters.contains("direction")) return;
    const TaskValue &own = verb->parameters.at("direction"), &said = draft_.parameters["direction"];
    if (own == said || (!IsOnAxisOfPitch(own) && !IsOnAxisOfPitch(said))) return;
    Refuse(FailureCode::kAmbiguous, SpanOf(draft_, "direction"), "is another direction than that of this flip",
           "'backflip' or 'barrel roll to the left'");
  }

  /// Whether the draft is a turn "in the air" or "with a turn".
  bool IsAloft() const {
    const auto first = std::find_if(items_.begin(), items_.end(), [](const Item& i) { return !i.Is(M::kPolite); });
    if (first != items_.end() && Word(*first).starts_with("with")) return true;
    return std::any_of(items_.begin(), items_.end(), [](const Item& i) { return i.Is(M::kUp) && i.name == "air"; });
  }

 private:
  std::string Word(const Item& item) const { return LowerCase(TextOf(text_, SpanOfItem(item))); }

  [[noreturn]] void Refuse(FailureCode code, const Span& part, const std::string& why, const std::string& say) const {
    throw Refused{{code, TextOf(text_, part), why, "", say}};
  }

  void Set(const std::string& key, const TaskValue& value, const Span& said) {
    draft_.parameters[key] = value;
    draft_.said[key] = said;
  }

  void Rename(const std::string& from, const std::string& to) {
    Set(to, draft_.parameters[from], draft_.said[from]);
    draft_.parameters.erase(from);
    draft_.said.erase(from);
  }

  void RefuseWhatIsJumpedOver() const {
    for (const Item& item : items_) {
      if (Word(item) == "over")
        Refuse(FailureCode::kUnknown, {item.begin, draft_.words.end},
               "is not possible: the robot can only jump by a distance or to a place", "'jump forward 40 cm'");
    }
  }

  static bool IsAngle(const Item& item) { return item.Is(M::kAmount) && (item.name == "deg" || item.name == "turns"); }

  /// Whether the side `at` belongs to an angle: it follows the angle, or stands right before it.
  bool IsSideOfTurn(std::size_t at) const {
    for (std::size_t k = at; k-- > 0;) {
      if (items_[k].Is(M::kAmount)) return IsAngle(items_[k]);
    }
    for (std::size_t k = at + 1; k < items_.size(); ++k) {
      if (IsAngle(items_[k])) return true;
      if (!items_[k].SaysNothing() || Word(items_[k]).starts_with("with")) return false;
    }
    return false;
  }

  void SettleSides() {
    for (std::size_t k = 0; k < items_.size(); ++k) {
      if (!items_[k].Is(M::kSide)) continue;
      const std::string key = IsSideOfTurn(k) ? "turn" : "direction";
      const auto said = draft_.said.find(key);
      if (said != draft_.said.end() && draft_.parameters[key] != TaskValue(items_[k].name))
        Refuse(FailureCode::kAmbiguous, {said->second.begin, items_[k].end}, "gives two directions at once", "");
      Set(key, items_[k].name, SpanOfItem(items_[k]));
    }
    draft_.side.reset();
  }

  void SettleTurn() {
    constexpr double kHalf = 180.0;
    const auto angle = draft_.parameters.find("angle_deg");
    if (angle == draft_.parameters.end() || draft_.parameters.contains("turn")) return;
    if (std::fmod(std::get<double>(angle->second), kHalf) != 0.0)
      Refuse(FailureCode::kAmbiguous, SpanOf(draft_, "angle_deg"), "does not give the side of the turn",
             "'to the left' or 'to the right' after the angle");
    draft_.parameters["turn"] = std::string("left");
  }

  void SettleLevel() {
    for (const Item& item : items_) {
      const bool high = item.Is(M::kUp) && (Word(item) == "high" || Word(item) == "高");
      const bool far = draft_.said.contains("distance_m") && !draft_.said.contains("direction");
      if (high || (item.Is(M::kUp) && far))
        Refuse(FailureCode::kUnknown, SpanOfItem(item),
               "cannot be used with 'jump': the height of a jump cannot be set",
               "a distance with a direction, such as 'jump forward 30 cm'");
      if (item.Is(M::kDown)) Set("level", std::string("down"), SpanOfItem(item));
    }
  }

  const std::string& text_;
  const std::vector<Item>& items_;
  Draft& draft_;
};

}  // namespace

void SettleJump(const std::string& text, const Clause& clause, Draft& draft) {
  JumpWords words(text, clause, draft);
  if (draft.action == "jump") words.SettleJump();
  if (draft.action == "flip") words.SettleFlip();
  if (draft.action == "turn") draft.aloft = words.IsAloft();
}

bool JoinsJump(const std::string& text, const Clause& clause, const Draft& said, std::vector<Draft>& drafts) {
  const bool after_jump = !drafts.empty() && drafts.back().action == "jump";
  const bool during = said.aloft || (after_jump && (clause.is_meanwhile || said.holding));
  if (said.action != "turn" || !during) return false;
  if (!after_jump)
    throw Refused{{FailureCode::kUnknown, TextOf(text, said.words), "is possible only during a jump", "",
                   "'jump with a quarter turn to the left'"}};
  Draft turn = said;
  turn.action.clear();
  turn.part.clear();
  const auto direction = turn.parameters.find("direction");
  if (direction == turn.parameters.end())
    throw Refused{
        {FailureCode::kAmbiguous, TextOf(text, said.words), "does not give the side of the turn", "", "left or right"}};
  turn.parameters["turn"] = direction->second;
  turn.said["turn"] = SpanOf(said, "direction");
  turn.parameters.erase("direction");
  turn.said.erase("direction");
  Merge(text, turn, false, drafts.back());
  return true;
}

}  // namespace gaitwright::words
