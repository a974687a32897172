// SPDX-License-Identifier: BSD-3-Clause
#include "workflows/words/understand.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "kinematics/base/text.h"
#include "workflows/words/asides.h"
#include "workflows/words/check_draft.h"
#include "workflows/words/clause.h"
#include "workflows/words/climb.h"
#include "workflows/words/forbidden.h"
#include "workflows/words/hints.h"
#include "workflows/words/items.h"
#include "workflows/words/jump_words_internal.h"
#include "workflows/words/read_clause.h"
#include "workflows/words/refer_back.h"
#include "workflows/words/says_more.h"

namespace gaitwright::words {
namespace {

using M = Meaning;

bool IsGesture(const std::string& action) {
  const ActionRule* rule = FindAction(action);
  return rule != nullptr && rule->is_gesture;
}

constexpr int kMostTimes = 50;  // largest number of repetitions of a walk or a turn

/// Builds tasks from clauses.
class Assembler {
 public:
  Assembler(const std::string& text, const TaskScope& scope) : text_(text), scope_(scope), forbidden_(text) {}

  void Add(const Clause& clause) {
    if (clause.denies)
      throw Refused{{FailureCode::kAmbiguous, text_, "is taken back without a replacement", "", "what to do instead"}};
    if (clause.forbids) return Forbid(clause);
    const bool in_doubt = std::exchange(after_forbidden_, false) && !clause.follows_break && !clause.corrects;
    if (in_doubt)
      throw Refused{{FailureCode::kAmbiguous, Text(clause.Words()), "is unclear: it may be forbidden or requested", "",
                     "a comma before the requested part, or only the requested part"}};
    if (clause.drops) Drop(clause);
    if (clause.drops && clause.is_not) return;
    if (clause.again) return Repeat();
    if (clause.empty()) return;
    if (clause.is_not && !IsMeant(clause)) {
      ForgetWaiting();
      after_not_ = forbidden_.AddNot(clause, drafts_);
      return;
    }
    Draft said = ReadClause(text_, clause);
    const bool corrects = (clause.corrects && !clause.drops) || after_not_ || clause.is_not;
    after_not_ = false;
    if (corrects) ForgetWaiting();
    GiveAction(clause, corrects, said);
    const bool held = clause.holds && !drafts_.empty() && said.action == drafts_.back().action;
    if (said.action.empty() || held) return AddTo(clause, corrects, said);
    if (corrects && OnlyTurnsRound(said, drafts_)) return Merge(text_, Sided(said), true, drafts_.back());
    if (clause.refers && !drafts_.empty() && said.action == drafts_.back().action && said.said.empty() && !said.side)
      return;
    SettleSide(text_, said);
    const bool once = said.parameters.contains("times") && said.parameters["times"] == TaskValue(1);
    if (once && clause.follows_then && !drafts_.empty() && drafts_.back().action == said.action) {  // "再鞠一次"
      said.parameters.erase("times");
      said.said.erase("times");
    }
    if (!corrects && JoinsJump(text_, clause, said, drafts_)) return;
    ReferBack(text_, drafts_, said);
    Complete(said);
    if (corrects && !drafts_.empty()) drafts_.pop_back();
    Place(clause, corrects, std::move(said));
  }

  TaskPlan Finish() {
    if (drafts_.empty() && manner_ && !waiting_) {  // "trot gait"
      Draft walk = *std::exchange(manner_, std::nullopt);
      walk.action = "walk";
      walk.parameters.try_emplace("direction", std::string("forward"));
      drafts_.push_back(std::move(walk));
    }
    if (manner_ && !drafts_.empty() && drafts_.back().action == "walk")  // "walk two metres, then slowly"
      throw Refused{{FailureCode::kAmbiguous, Text(manner_->words), "says how to walk, but not how far", "",
                     "'walk two metres slowly', or another distance"}};
    if (!drafts_.empty() || !waiting_) Flush();
    if (waiting_ && !before_ && !drafts_.empty() && !IsGesture(waiting_->action)) RefuseAtOnce(*waiting_);
    if (waiting_) drafts_.push_back(*waiting_);
    TaskPlan plan;
    plan.text = text_;
    plan.language = LanguageOf(text_) == Language::kEnglish ? "en" : "zh";
    forbidden_.Check(drafts_);
    SettleStairs(text_, scope_.places, drafts_);
    for (const Draft& draft : drafts_) plan.tasks.push_back(TaskOf(draft));
    if (plan.tasks.empty()) throw Refused{{FailureCode::kEmpty, "", "contains no instruction", ""}};
    for (std::size_t k = 0; k < plan.tasks.size(); ++k) CheckDraft(text_, scope_, plan.tasks[k], drafts_[k]);
    if (const auto failure = ReasonNotPlanned(plan, scope_))
      throw Refused{{failure->code, text_, failure->message, "", "", true}};
    return plan;
  }

 private:
  std::string Text(const Span& span) const { return TextOf(text_, span); }

  void Forbid(const Clause& clause) {
    if (clause.corrects) ForgetWaiting();
    after_forbidden_ = !forbidden_.Add(clause, drafts_);
  }

  /// Removes a cancelled task. @throws Refused if it was not requested.
  void Drop(const Clause& clause) {
    const bool any = clause.dropped.empty();
    const auto dropped = std::find_if(drafts_.rbegin(), drafts_.rend(),
                                      [&](const Draft& draft) { return any || draft.action == clause.dropped; });
    if (dropped != drafts_.rend()) {
      drafts_.erase(std::next(dropped).base());
    } else if (clause.is_not) {
      throw Refused{{FailureCode::kUnknown, Text(clause.Words()), "forbids something that was not requested", ""}};
    }
  }

  /// "举左手，啊不是右手": the words after "oh, not" are the correct ones if they were not requested before.
  bool IsMeant(const Clause& clause) const {
    if (drafts_.empty() || !clause.exclaims) return false;
    const bool unknown = std::any_of(clause.items.begin(), clause.items.end(),
                                     [](const Item& item) { return item.Is(M::kUnknown) || item.Is(M::kElsewhere); });
    if (unknown) return false;
    const Draft said = ReadClause(text_, clause);
    const auto side = drafts_.back().parameters.find("side");
    return said.action.empty() && said.side && side != drafts_.back().parameters.end() &&
           side->second != TaskValue(*said.side);
  }

  /// "wait, make that three": the wait is not a task.
  void ForgetWaiting() {
    if (drafts_.size() < 2 || drafts_.back().action != "stand" || !drafts_.back().parameters.empty()) return;
    drafts_.pop_back();
  }

  /// Refuses tasks that cannot be done at the same time.
  [[noreturn]] void RefuseAtOnce(const Draft& said) const {
    throw Refused{{FailureCode::kCannot, Text(said.words), "cannot be done at the same time as the other task", ""}};
  }

  void Repeat() {
    if (drafts_.empty()) throw Refused{{FailureCode::kAmbiguous, text_, "repeats a request, but there was none", ""}};
    const Draft last = drafts_.back();
    drafts_.push_back(last);
  }

  /// Finds the action of a clause that does not name one: walking for steps, or the previous action.
  void GiveAction(const Clause& clause, bool corrects, Draft& said) {
    if (!said.action.empty()) return;
    if (clause.holds && said.parameters.contains("duration_s") && !drafts_.empty()) return;
    const bool steps = said.said.contains("steps"), gait = said.said.contains("distance_m");
    const bool direction = said.said.contains("direction") || said.said.contains("to");
    const std::string last = drafts_.empty() ? "" : drafts_.back().action;
    if (corrects && !last.empty()) return;
    if (!drafts_.empty()) GoOnStairs(drafts_.back(), said);
    if (!said.action.empty()) return;
    const bool far = !drafts_.empty() && SaysHowFar(drafts_.back()) && SaysHowFar(said);
    const bool joins = last == "walk" && !clause.follows_then && !far;
    if (said.said.contains("angle_deg") && said.side && last != "bow") {  // "R 90 degrees"
      said.action = "turn";
      return;
    }
    if ((steps || direction || gait) && !joins && !(last == "squat" && !steps && !direction)) {
      said.action = "walk";
    } else if (clause.follows_then && !last.empty() && (said.side || said.said.contains("angle_deg"))) {
      said.action = last;
    }
  }

  Draft Sided(Draft said) const {
    SettleSide(text_, said);
    return said;
  }

  void AddTo(const Clause& clause, bool corrects, const Draft& said) {
    const bool lasts = said.parameters.size() == 1 && said.parameters.contains("duration_s");
    if (drafts_.empty() || (SaysOnlyHow(said) && !lasts)) {
      const auto walk =
          std::find_if(drafts_.rbegin(), drafts_.rend(), [](const Draft& d) { return d.action == "walk"; });
      const bool speed_only = said.parameters.contains("speed_m_s") && walk != drafts_.rend();
      const bool after_walk = !drafts_.empty() && drafts_.back().action == "walk" && !clause.follows_then;
      if (after_walk) return Merge(text_, said, corrects, drafts_.back());
      if (speed_only && !walk->said.contains("speed_m_s")) return Merge(text_, said, corrects, *walk);
      if (!SaysOnlyHow(said)) throw Refused{{FailureCode::kUnknown, Text(said.words), "does not say what to do", ""}};
      manner_ = said;
      return;
    }
    Draft& last = drafts_.back();
    if (!corrects && RepeatsMotion(said)) return;
    if (clause.holds && !Takes(last.action, "duration_s") && said.parameters.contains("duration_s")) {
      Draft stay;  // with the arm in its present posture
      stay.action = "stand";
      stay.words = said.words;
      Merge(text_, said, false, stay);
      drafts_.push_back(stay);
      return;
    }
    // "turn left, right": a second turn.
    const auto side = last.parameters.find("side");
    const bool same_side = said.side && side != last.parameters.end() && side->second == TaskValue(*said.side);
    if (same_side && said.parameters.empty() && !said.bare) return;
    const bool other_side = said.side && !corrects && (last.said.contains("direction") || last.said.contains("side"));
    if (other_side && clause.is_meanwhile && !IsGesture(last.action)) RefuseAtOnce(said);
    if (other_side) {
      Draft more;
      more.action = last.action;
      more.words = said.words;
      Merge(text_, said, false, more);
      drafts_.push_back(more);
      return;
    }
    Draft taken = said;
    if (last.action != "walk") {
      taken.parameters.erase("pace");
      taken.said.erase("pace");
    }
    Merge(text_, taken, corrects, last);
  }

  /// "turn left, twice": repeats walks and turns.
  bool RepeatsMotion(const Draft& said) {
    const bool moves = drafts_.back().action == "walk" || drafts_.back().action == "turn";
    const bool often = said.parameters.size() == 1 && said.parameters.contains("times") && !said.bare && !said.side;
    if (!moves || !often) return false;
    const Draft again = drafts_.back();
    for (int k = 1; k < std::min(std::get<int>(said.parameters.at("times")), kMostTimes); ++k) drafts_.push_back(again);
    return true;
  }

  /// Sets implied parameters.
  void Complete(Draft& said) {
    const auto otherwise = [&](const char* key, const char* value) {
      if (said.parameters.contains(key)) return;
      said.parameters[key] = std::string(value);
    };
    if (said.action == "walk") otherwise("direction", "forward");
    if (said.action == "wave" || said.action == "raise_arm" || said.action == "lower_arm") otherwise("side", "right");
    if (said.action == "balance") otherwise("side", "left");
    const bool lasts = manner_ && manner_->parameters.contains("duration_s");
    if (manner_ && (said.action == "walk" || (lasts && Takes(said.action, "duration_s")))) {
      const Span words = said.words;
      Merge(text_, *manner_, false, said);
      said.words = words;
    }
    manner_.reset();
    if (said.action == "walk") return;
    for (const char* key : {"pace", "height"}) {
      said.parameters.erase(key);
      said.said.erase(key);
    }
  }

  /// Puts a task after the others, or at the same time as one of them.
  void Place(const Clause& clause, bool corrects, Draft said) {
    const bool gesture = IsGesture(said.action);
    if (waiting_) {
      Draft first = std::move(*waiting_);
      waiting_.reset();
      if (before_) {
        before_ = false;
        drafts_.push_back(std::move(said));
        drafts_.push_back(std::move(first));
        return;
      }
      if (gesture && IsGesture(first.action)) {  // "一边点头一边挥手，往前走"
        held_.push_back(std::move(first));
        held_.push_back(std::move(said));
        return;
      }
      const bool first_is_main = gesture || !IsGesture(first.action);
      Draft &main = first_is_main ? first : said, &beside = first_is_main ? said : first;
      main.words = {std::min({waiting_from_, main.words.begin, beside.words.begin}),
                    std::max(main.words.end, beside.words.end)};
      main.during.push_back(beside);
      drafts_.push_back(main);
      return;
    }
    const bool alone = clause.is_meanwhile || clause.is_after || clause.is_before || clause.follows_then;
    if (said.holding && gesture && !alone && !corrects) {
      held_.push_back(std::move(said));  // "举着左手往后退": done at the same time as the next task
      return;
    }
    if (!held_.empty() && !gesture && !clause.follows_then) {
      said.during.insert(said.during.end(), held_.begin(), held_.end());
      held_.clear();
      drafts_.push_back(std::move(said));
      return;
    }
    Flush();
    if (clause.is_before && Begins(clause) && LanguageOf(text_) == Language::kEnglish) {
      before_ = true;
      waiting_ = std::move(said);
      return;
    }
    if (clause.is_before && LanguageOf(text_) == Language::kChinese && !drafts_.empty()) {
      drafts_.insert(drafts_.end() - 1, std::move(said));
      return;
    }
    if ((clause.is_after && !Begins(clause)) || (clause.is_first && !drafts_.empty())) {
      drafts_.insert(drafts_.end() - 1, std::move(said));
      return;
    }
    if (clause.is_meanwhile) return PlaceBeside(clause, std::move(said));
    if (!drafts_.empty() && SaysMore(text_, clause, said, drafts_.back())) return;
    said.joined = clause.follows_then && !clause.follows_break;
    drafts_.push_back(std::move(said));
  }

  bool Begins(const Clause& clause) const { return drafts_.empty() || clause.follows_break || clause.follows_then; }

  void PlaceBeside(const Clause& clause, Draft said) {
    const bool gesture = IsGesture(said.action);
    const bool first = drafts_.empty() || (!gesture && Begins(clause) && LanguageOf(text_) == Language::kEnglish) ||
                       (!gesture && LanguageOf(text_) == Language::kChinese);
    if (first && !(gesture && !drafts_.empty())) {
      waiting_from_ = clause.since;
      waiting_ = std::move(said);
      return;
    }
    Draft& last = drafts_.back();
    if (!gesture && !IsGesture(last.action)) RefuseAtOnce(said);
    if (!gesture && IsGesture(last.action)) {  // "nod and wave as you walk"
      const bool again = drafts_.size() > 1 && said.action == drafts_[drafts_.size() - 2].action && said.said.empty();
      if (again) {  // "walk three steps and wave while you walk"
        drafts_[drafts_.size() - 2].during.push_back(drafts_.back());
        drafts_.pop_back();
        return;
      }
      do {
        said.during.insert(said.during.begin(), drafts_.back());
        said.words.begin = std::min(said.words.begin, drafts_.back().words.begin);
        const bool more = drafts_.back().joined;
        drafts_.pop_back();
        if (!more) break;
      } while (!drafts_.empty() && IsGesture(drafts_.back().action));
      drafts_.push_back(std::move(said));
      return;
    }
    last.words.end = std::max(last.words.end, said.words.end);
    last.during.push_back(std::move(said));
  }

  void Flush() {
    drafts_.insert(drafts_.end(), held_.begin(), held_.end());
    held_.clear();
  }

  Task TaskOf(const Draft& draft) const {
    Task task;
    task.action = draft.action;
    task.parameters = draft.parameters;
    task.words = Text(draft.words);
    for (const Draft& gesture : draft.during) task.during.push_back(TaskOf(gesture));
    return task;
  }

  const std::string& text_;
  const TaskScope& scope_;
  std::vector<Draft> drafts_;
  std::optional<Draft> waiting_;  // waits for the clause to which it is joined
  std::size_t waiting_from_ = 0;  // start of that, including its "while"
  std::vector<Draft> held_;       // gestures at the same time as the next task
  std::optional<Draft> manner_;   // a manner that was given before its action
  Forbidden forbidden_;
  bool before_ = false, after_not_ = false, after_forbidden_ = false;
};

}  // namespace

std::variant<TaskPlan, Refusal> Understand(const std::string& text, const TaskScope& scope) {
  constexpr std::size_t kLongest = 2000;
  if (text.size() > kLongest) return Refusal{FailureCode::kRange, Shortened(text), "is over 2000 bytes long", ""};
  if (!IsPlainText(text)) return Refusal{FailureCode::kUnknown, "", "is not plain text", ""};
  if (text.find_first_of("{}") != std::string::npos)
    return Refusal{FailureCode::kUnknown, Trimmed(text), "is not an instruction", ""};
  try {
    Assembler assembler(text, scope);
    const std::vector<Item> items = WithoutAsides(ItemsOf(text, LanguageOf(text), scope.places));
    for (const Clause& clause : ClausesOf(text, items)) assembler.Add(clause);
    return assembler.Finish();
  } catch (const Refused& refused) {
    return refused.refusal;
  }
}

Result<TaskPlan> UnderstandWords(const std::string& text, const TaskScope& scope) {
  const auto understood = Understand(text, scope);
  if (const auto* plan = std::get_if<TaskPlan>(&understood)) return *plan;
  return FailureOf(std::get<Refusal>(understood), scope);
}

}  // namespace gaitwright::words
