// SPDX-License-Identifier: BSD-3-Clause
#include "workflows/words/says_more.h"

#include <algorithm>
#include <array>

#include "workflows/words/items.h"

namespace gaitwright::words {
namespace {

/// Removes implied parameters, such as the right hand, which add nothing.
Draft WithoutTaken(Draft said) {
  std::erase_if(said.parameters, [&](const auto& parameter) { return !said.said.contains(parameter.first); });
  return said;
}

Draft WithoutDirection(Draft said) {
  said.parameters.erase("direction");
  return said;
}

template <class Which>
bool SaysOnly(const Draft& draft, Which which) {
  return std::all_of(draft.said.begin(), draft.said.end(), [&](const auto& one) { return which(one.first); });
}

bool SaysOnlyDirection(const Draft& draft) {
  return SaysOnly(draft, [](const std::string& key) { return key == "direction"; });
}

bool IsAmount(const std::string& key) {
  static const std::array<const char*, 3> kAmounts = {"times", "duration_s", "depth_m"};
  return std::find(kAmounts.begin(), kAmounts.end(), key) != kAmounts.end();
}

/// Compares a clause with the previous task.
class Comparison {
 public:
  Comparison(const std::string& text, const Clause& clause, const Draft& said, Draft& last)
      : text_(text),
        clause_(clause),
        said_(said),
        last_(last),
        same_action_(said.action == last.action),
        marked_(clause.follows_break || clause.corrects || clause.holds) {}

  bool Run() {
    if (Balances()) return Add(WithoutTaken(said_));
    if (IsDone()) return true;
    if (clause_.follows_then) return false;
    if (same_action_ && said_.action == "walk") return Walks();
    if (Stays()) return Add(said_);
    return same_action_ && IsRepeated() && Add(WithoutTaken(said_));
  }

 private:
  bool Add(const Draft& more) {
    Merge(text_, more, false, last_);
    return true;
  }

  std::string Words() const { return TextOf(text_, said_.words); }

  /// "lift your left foot and balance", "右脚站稳，左脚抬起来七秒"
  bool Balances() const {
    const bool both = last_.action == "balance" && same_action_ && !last_.said.contains("duration_s") &&
                      !clause_.corrects && !clause_.is_meanwhile;
    return both && (!said_.said.contains("side") || said_.parameters.at("side") == last_.parameters.at("side"));
  }

  /// "点点头，点完头..."
  bool IsDone() const { return same_action_ && said_.said.empty() && Words().find("完") != std::string::npos; }

  /// "用右脚站着，站五秒"
  bool Stays() const {
    const bool stays = last_.action == "balance" || (last_.action == "sit" && !clause_.follows_break);
    return said_.action == "stand" && said_.said.size() == 1 && said_.said.contains("duration_s") && stays &&
           !last_.parameters.contains("duration_s");
  }

  bool Walks() {
    if (IsRestated()) return true;
    if (SaysHowFar(last_)) return false;
    const bool same_direction = last_.parameters.at("direction") == said_.parameters.at("direction");
    const bool direction_said = said_.said.contains("direction"),
               only_direction = SaysOnlyDirection(last_) && last_.during.empty();
    if (same_direction && only_direction && SaysOnlyDirection(said_)) return Add(said_);  // "走吧，往前走"
    const bool chinese = LanguageOf(text_) == Language::kChinese;
    const bool how_far = SaysHowFar(said_) && !said_.bare && only_direction && chinese;  // "往右边挪挪，挪三步"
    if (!direction_said && (how_far || !marked_)) return Add(WithoutDirection(said_));  // "倒退着走两步", "go and trot"
    return same_direction && SaysHowFar(said_) && Add(said_);
  }

  /// "run to the door, run", "go there"
  bool IsRestated() const {
    const bool goes = last_.parameters.contains("to") || !clause_.follows_break || Words() == "走";
    const auto same_pace = [&](const std::string& key) {
      const auto there = last_.parameters.find(key);
      return key == "pace" && there != last_.parameters.end() && there->second == said_.parameters.at(key);
    };
    return goes && !said_.bare && said_.during.empty() && SaysOnly(said_, same_pace);
  }

  /// "挥手挥十秒钟", "坐下，坐二十秒": the same action again adds to it: directly after it any new parameter, after a
  /// comma only a duration or a count.
  bool IsRepeated() const {
    const bool again = !clause_.corrects && !clause_.holds && clause_.items.front().begin != last_.words.begin;
    const auto is_new = [&](const std::string& key) { return !last_.said.contains(key); };
    if (!again || !SaysOnly(said_, is_new)) return false;
    const bool amounts_before =
        std::any_of(last_.said.begin(), last_.said.end(), [](const auto& one) { return IsAmount(one.first); });
    const bool amounts = !said_.said.empty() && SaysOnly(said_, IsAmount) && !amounts_before;
    const bool first_word =
        !said_.said.empty() && last_.said.empty() && !said_.said.contains("direction") && !said_.said.contains("side");
    return amounts || !marked_ || first_word;
  }

  const std::string& text_;
  const Clause& clause_;
  const Draft& said_;
  Draft& last_;
  const bool same_action_, marked_;
};

}  // namespace

bool SaysHowFar(const Draft& draft) {
  return std::any_of(ExtentKeys().begin(), ExtentKeys().end(),
                     [&](const std::string& key) { return draft.parameters.contains(key); });
}

bool SaysOnlyHow(const Draft& said) {
  const auto how = [](const auto& parameter) {
    return parameter.first == "pace" || parameter.first == "height" || parameter.first == "speed_m_s" ||
           parameter.first == "gait" || parameter.first == "duration_s";
  };
  return !said.parameters.empty() && !said.bare && !said.side &&
         std::all_of(said.parameters.begin(), said.parameters.end(), how);
}

bool OnlyTurnsRound(const Draft& said, const std::vector<Draft>& drafts) {
  if (drafts.empty() || drafts.back().action != said.action || said.action != "turn" || said.bare) return false;
  return SaysOnlyDirection(said);
}

bool SaysMore(const std::string& text, const Clause& clause, const Draft& said, Draft& last) {
  return Comparison(text, clause, said, last).Run();
}

}  // namespace gaitwright::words
