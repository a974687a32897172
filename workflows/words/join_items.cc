// SPDX-License-Identifier: BSD-3-Clause
#include "workflows/words/join_items.h"

#include <cstddef>

#include "workflows/words/stairs_words.h"

namespace gaitwright::words {
namespace {

using M = Meaning;

/// "鞠躬前，先退一步".
void MarkBefore(std::vector<Item>& items) {
  for (std::size_t k = 1; k + 1 < items.size(); ++k) {
    const bool before = items[k].Is(M::kFiller) && items[k].name == "前";
    if (before && items[k - 1].Is(M::kAction) && (items[k + 1].Is(M::kBreak) || items[k + 1].Is(M::kThen)))
      items[k].meaning = M::kBefore;
  }
}

/// "优雅地": an unknown word before 地 describes the manner.
void MarkAdverbs(std::vector<Item>& items) {
  for (std::size_t k = 0; k + 1 < items.size(); ++k) {
    const bool adverb = items[k].Is(M::kUnknown) && items[k + 1].name == "地" && items[k].end == items[k + 1].begin;
    if (adverb) items[k].meaning = M::kFiller;
  }
}

const Item* PlaceBefore(const std::vector<Item>& items, std::size_t k) {
  while (k-- > 0) {
    if (items[k].Is(M::kPlace)) return &items[k];
  }
  return nullptr;
}

/// "每秒" before a length is a speed.
void JoinRates(std::vector<Item>& items) {
  for (std::size_t k = 0; k < items.size(); ++k) {
    Item& rate = items[k];
    if (!rate.Is(M::kUnit)) continue;
    std::size_t next = k + 1;
    while (next < items.size() && items[next].Is(M::kFiller)) ++next;
    if (next == items.size() || !items[next].Is(M::kAmount) || items[next].name != "m") continue;
    rate.meaning = M::kAmount;
    rate.name = "m/s";
    rate.value *= items[next].value;
    rate.end = items[next].end;
    items.erase(items.begin() + static_cast<std::ptrdiff_t>(k) + 1,
                items.begin() + static_cast<std::ptrdiff_t>(next) + 1);
  }
}

/// The previous item with a meaning, if there is one.
const Item* SaidBefore(const std::vector<Item>& items, std::size_t k) {
  while (k-- > 0) {
    if (!items[k].Is(M::kFiller)) return &items[k];
  }
  return nullptr;
}

/// "to the second step" and "to the step" without a place of this name: the place is unknown.
void MarkNoPlaces(std::vector<Item>& items) {
  for (std::size_t k = 0; k + 1 < items.size(); ++k) {
    const Item* before = SaidBefore(items, k);
    if (before == nullptr || !before->Is(M::kTo)) continue;
    const Item& next = items[k + 1];
    const bool ordered = items[k].Is(M::kOrdinal),
               other = next.Is(M::kAction) || next.Is(M::kUnit) || (next.Is(M::kStairs) && next.value == 0.0);
    if (!(ordered && (other || next.Is(M::kUnknown))) && !(items[k].name == "the" && other)) continue;
    items[k].meaning = M::kUnknown;
    items[k].end = next.end;
    items.erase(items.begin() + static_cast<std::ptrdiff_t>(k) + 1);
  }
}

/// "the second step", "stone four", "5号石头": places with their numbers. An ordinal without a noun uses the next noun.
void JoinOrdinals(std::vector<Item>& items) {
  for (std::size_t k = 0; k < items.size(); ++k) {
    if (items[k].Is(M::kPlace)) {
      std::size_t number = k + 1;
      while (number < items.size() && items[number].Is(M::kFiller)) ++number;
      if (number == items.size() || !items[number].Is(M::kNumber) || items[k].value != 0.0) continue;
      items[k].value = items[number].value;
      items[k].end = items[number].end;
      items.erase(items.begin() + static_cast<std::ptrdiff_t>(k) + 1,
                  items.begin() + static_cast<std::ptrdiff_t>(number) + 1);
      continue;
    }
    if (!items[k].Is(M::kOrdinal) && !items[k].Is(M::kNumber)) continue;
    std::size_t next = k + 1;
    while (next < items.size() && items[next].Is(M::kFiller)) ++next;
    if (next < items.size() && items[next].Is(M::kPlace)) {
      items[next].value = items[k].value;
      items[next].begin = items[k].begin;
      items.erase(items.begin() + static_cast<std::ptrdiff_t>(k), items.begin() + static_cast<std::ptrdiff_t>(next));
    } else if (const Item* before = PlaceBefore(items, k);
               before != nullptr && k + 1 < items.size() && items[k + 1].name == "one" && items[k].Is(M::kOrdinal)) {
      const double number = items[k].value;  // "the second one"
      items[k].meaning = M::kPlace;
      items[k].name = before->name;
      items[k].value = number;
    } else if (items[k].Is(M::kOrdinal)) {
      const bool last = k + 1 == items.size() || items[k + 1].Is(M::kBreak);
      items[k].meaning = last && k > 0 && items[k].value == 1.0 ? M::kFirst : M::kThen;
    }
  }
  for (std::size_t k = 1; k + 1 < items.size(); ++k) {  // "the first and the second stone"
    const bool joins = items[k].Is(M::kFiller) && items[k].name == "and";
    if (joins && items[k - 1].Is(M::kPlace) && items[k + 1].Is(M::kPlace)) items[k].meaning = M::kThen;
  }
}

}  // namespace

void JoinItems(std::vector<Item>& items) {
  JoinRates(items);
  JoinStairs(items);
  MarkBefore(items);
  MarkAdverbs(items);
  MarkNoPlaces(items);
  JoinOrdinals(items);
}

}  // namespace gaitwright::words
