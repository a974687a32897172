// SPDX-License-Identifier: BSD-3-Clause
#include "workflows/words/place_relation.h"

#include <algorithm>
#include <functional>
#include <set>

#include "kinematics/base/text.h"
#include "workflows/words/draft.h"
#include "workflows/words/stairs_words.h"

namespace gaitwright::words {
namespace {

using M = Meaning;

/// Words without a further meaning after a place.
bool FollowsPlace(const std::string& word) {
  static const std::set<std::string> words = {
      "那儿", "那里", "那裡", "那边", "那邊", "这儿", "这里", "这边",   "嗰度", "嗰边",   "处", "口",
      "旁",   "旁边", "旁邊", "边上", "附近", "跟前", "面前", "前面的", "位置", "的位置", "的", "上",
      "去",   "过去", "来",   "先",   "都",   "也",   "“",    "”",      "时",   "前"};
  return words.contains(word);
}

/// "左边", "后面": a position. "往左边" is a direction.
bool IsPosition(const std::string& word) {
  const bool noun = word.ends_with("面") || word.ends_with("边") || word.ends_with("侧") || word.ends_with("方");
  const bool direction =
      word.starts_with("往") || word.starts_with("向") || word.starts_with("朝") || word.starts_with("靠");
  return noun && !direction;
}

class Relation {
 public:
  Relation(const std::string& text, const Clause& clause, std::size_t at)
      : text_(text), items_(clause.items), clause_(clause), at_(at) {}

  void Check() const {
    const bool reached =
        std::any_of(items_.begin(), items_.end(), [](const Item& item) { return item.IsVerb() || item.Is(M::kTo); });
    if ((clause_.is_before || clause_.is_after) && !reached) Refuse(items_.front().begin, items_[at_].end);
    CheckBefore();
    if (static_cast<unsigned char>(text_[items_[at_].begin]) >= 0x80) CheckBehind();
  }

 private:
  std::string Word(std::size_t k) const { return LowerCase(TextOf(text_, {items_[k].begin, items_[k].end})); }

  [[noreturn]] void Refuse(std::size_t begin, std::size_t end) const {
    throw Refused{{FailureCode::kUnknown, TextOf(text_, {begin, end}),
                   "is not possible: the robot can only walk or jump to a place", "", Instead()}};
  }

  /// "jump off the block"
  std::string Instead() const {
    const bool jumps = std::any_of(items_.begin(), items_.end(),
                                   [](const Item& item) { return item.Is(M::kAction) && item.name == "jump"; });
    return jumps ? "'jump down', from a raised place, or 'jump onto' a place" : "";
  }

  void CheckBefore() const {
    for (std::size_t k = at_; k-- > 0;) {
      if (items_[k].SaysNothing() && items_[k].name != "relation") continue;
      if (items_[k].name != "relation" && !Passes(k)) return;
      std::size_t begin = k;
      while (begin > 0 && (items_[begin - 1].Is(M::kSide) || items_[begin - 1].Is(M::kDirection) ||
                           items_[begin - 1].Is(M::kSideways) || items_[begin - 1].Is(M::kFiller)))
        --begin;
      Refuse(items_[begin].begin, items_[at_].end);
    }
  }

  /// "cross the marker", "walk through the door": verbs without "to".
  bool Passes(std::size_t verb) const {
    const bool up = items_[verb].value == kUpStairs || items_[verb].value == kUpwards;
    const bool climbs = up && IsStep(items_[at_].name);  // "climb the second step"
    const bool walks =
        items_[verb].Is(M::kAction) && items_[verb].name == "walk" && items_[verb].value != kToPlace && !climbs;
    const std::string next = Word(verb + 1);
    const bool english = static_cast<unsigned char>(text_[items_[verb].begin]) < 0x80;
    return walks && english && next != "for" && next != "for the" && next != "on";
  }

  void CheckBehind() const {
    for (std::size_t k = at_ + 1; k < items_.size(); ++k) {
      const bool where = (items_[k].Is(M::kSide) || items_[k].Is(M::kDirection)) && IsPosition(Word(k));
      const bool forward = where && items_[k].name == "forward";  // "before" a place means the place itself
      if (items_[k].Is(M::kPolite) || forward || (items_[k].Is(M::kFiller) && FollowsPlace(Word(k)))) continue;
      if (where || items_[k].Is(M::kFiller)) Refuse(items_[at_].begin, items_[k].end);
      return;
    }
  }

  const std::string& text_;
  const std::vector<Item>& items_;
  const Clause& clause_;
  std::size_t at_;
};

}  // namespace

void CheckGoesTo(const std::string& text, const Clause& clause, std::size_t at) { Relation(text, clause, at).Check(); }

}  // namespace gaitwright::words
