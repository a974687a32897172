// SPDX-License-Identifier: BSD-3-Clause
#include "workflows/words/asides.h"

#include <algorithm>

namespace gaitwright::words {
namespace {

using M = Meaning;

bool IsVerb(const Item& item) { return item.IsVerb() || item.Is(M::kPut); }

/// Removes asides from the items between two breaks.
class AsideReader {
 public:
  AsideReader(const std::vector<Item>& items, std::vector<Item>& kept) : items_(items), kept_(kept) {}

  void Read(std::size_t begin, std::size_t end) {
    stretch_ = kept_.size();
    end_ = end;
    bool starts = true;
    for (std::size_t k = begin; k < end;) {
      const Item& item = items_[k];
      const bool place = k > begin && items_[k - 1].Is(M::kTo);  // "to where the chair is"
      const bool aside = (item.Is(M::kAside) && !place) || (starts && TellsOfOthers(k)) || IsWhenOthersAct(k);
      if (item.Is(M::kBefore) && OnlyTells(stretch_)) {  // "在他来之前"
        kept_.resize(stretch_);
        ++k;
        continue;
      }
      if (aside) {
        k = EndOfAside(k);
        continue;
      }
      const bool starts_before = starts;
      starts = item.Is(M::kThen) || (starts && item.SaysNothing());
      kept_.push_back(item);
      if (item.Is(M::kSubject)) kept_.back().meaning = IsNarrated(k, starts_before) ? M::kUnknown : M::kFiller;
      if (IsCondition(k)) kept_.back().meaning = M::kUnknown;
      if (item.Is(M::kAside)) kept_.back().meaning = M::kUnknown;
      ++k;
    }
  }

 private:
  std::size_t NextOf(std::size_t k) const {
    while (k < end_ && items_[k].SaysNothing()) ++k;
    return k;
  }

  /// An aside ends at the next break or at the next requested action.
  std::size_t EndOfAside(std::size_t k) const {
    for (++k; k < end_; ++k) {
      if (items_[k].Is(M::kDrop)) return k;
      if (!items_[k].Is(M::kThen)) continue;
      const std::size_t next = NextOf(k + 1);
      if (next < end_ && (IsVerb(items_[next]) || items_[next].Is(M::kDirection))) return k;
    }
    return end_;
  }

  /// "the nurse", "妈妈" with an action that the robot does not do.
  bool TellsOfOthers(std::size_t k) const {
    std::size_t subject = k;
    while (subject < end_ && items_[subject].SaysNothing() && items_[subject].name != "finite") ++subject;
    if (subject >= end_) return false;
    if (IsNarrated(subject, true)) return false;
    const std::size_t last = EndOfAside(subject);
    const auto finite = [](const Item& item) { return item.name == "finite"; };
    const bool named = std::any_of(At(k), At(subject + 1), [](const Item& item) { return item.name == "the"; });
    const bool states = named && std::any_of(At(k), At(last), finite);
    return (items_[subject].Is(M::kSubject) || states) && Tells(k, last);
  }

  /// "he walked to the door": the action of another person is not requested.
  bool IsNarrated(std::size_t k, bool starts) const {
    return starts && items_[k].name == "third" && std::any_of(At(k), At(end_), IsVerb);
  }

  /// "until I say so", "等我回来": conditions that the robot cannot observe. "等我两秒" is a request.
  bool IsCondition(std::size_t k) const {
    const bool waits = items_[k].Is(M::kTo) || (items_[k].Is(M::kAction) && items_[k].name == "stand");
    if (!waits || k + 1 >= end_ || !items_[k + 1].Is(M::kSubject) || items_[k].end == items_[k].begin) return false;
    const std::size_t next = NextOf(k + 2);
    const bool amount = next < end_ && (items_[next].Is(M::kAmount) || items_[next].Is(M::kNumber));
    return next < end_ && !amount && (items_[next].Is(M::kUnknown) || IsVerb(items_[next]));
  }

  std::vector<Item>::const_iterator At(std::size_t k) const { return items_.begin() + static_cast<std::ptrdiff_t>(k); }

  bool Tells(std::size_t begin, std::size_t end) const {
    const bool unknown = std::any_of(At(begin), At(end), [](const Item& item) { return item.Is(M::kUnknown); });
    return unknown && std::none_of(At(begin), At(end), IsVerb);
  }

  /// "before the visitors arrive", "while I take a picture".
  bool IsWhenOthersAct(std::size_t k) const {
    const bool others =
        items_[k].Is(M::kBefore) || (items_[k].Is(M::kWhile) && k + 1 < end_ && items_[k + 1].Is(M::kSubject));
    return others && Tells(k, EndOfAside(k));
  }

  /// Whether the items kept from there on are about another person.
  bool OnlyTells(std::size_t from) const {
    const auto first = kept_.begin() + static_cast<std::ptrdiff_t>(from);
    const bool unknown = std::any_of(first, kept_.end(), [](const Item& item) { return item.Is(M::kUnknown); });
    return unknown && std::none_of(first, kept_.end(), IsVerb);
  }

  const std::vector<Item>& items_;
  std::vector<Item>& kept_;
  std::size_t stretch_ = 0, end_ = 0;
};

}  // namespace

std::vector<Item> WithoutAsides(const std::vector<Item>& items) {
  std::vector<Item> kept;
  AsideReader reader(items, kept);
  for (std::size_t begin = 0; begin < items.size();) {
    std::size_t end = begin;
    while (end < items.size() && !items[end].Is(M::kBreak)) ++end;
    reader.Read(begin, end);
    if (end < items.size()) kept.push_back(items[end]);
    begin = end + 1;
  }
  return kept;
}

}  // namespace gaitwright::words
