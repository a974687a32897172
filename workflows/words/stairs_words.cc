// SPDX-License-Identifier: BSD-3-Clause
#include "workflows/words/stairs_words.h"

#include <algorithm>

#include "workflows/words/numbers.h"
#include "workflows/words/places.h"

namespace gaitwright::words {
namespace {

using M = Meaning;

/// Whether a place should follow: "to", "走到".
bool LeadsTo(const std::vector<Item>& before) {
  const auto last =
      std::find_if_not(before.rbegin(), before.rend(), [](const Item& item) { return item.SaysNothing(); });
  return last != before.rend() && (last->Is(M::kTo) || (last->Is(M::kAction) && last->value == kToPlace));
}

/// Whether the next task has no words yet.
bool Begins(const std::vector<Item>& before) {
  const auto last =
      std::find_if_not(before.rbegin(), before.rend(), [](const Item& item) { return item.SaysNothing(); });
  return last == before.rend() || last->Is(M::kBreak) || last->Is(M::kThen);
}

bool Is(const std::vector<Piece>& pieces, std::size_t at, const std::string& text) {
  return at < pieces.size() && pieces[at].text == text;
}

/// "级", "阶": measure words for steps of stairs.
bool IsMeasure(const std::vector<Piece>& pieces, std::size_t at) {
  return Is(pieces, at, "级") || Is(pieces, at, "阶") || Is(pieces, at, "节");
}

Item Verb(double value) {
  Item item;
  item.meaning = M::kAction;
  item.name = "walk";
  item.value = value;
  return item;
}

Item Treads(double number) {
  Item item;
  item.meaning = M::kAmount;
  item.name = "treads";
  item.value = number;
  return item;
}

Item UpOrDown(Meaning meaning) {
  Item item;
  item.meaning = meaning;
  item.name = "way";
  return item;
}

Item StairsOfRise(double value) {
  Item item;
  item.meaning = M::kStairs;
  item.value = value;
  return item;
}

/// Whether the item `at` belongs to a verb that goes up or down.
bool FollowsWay(const std::vector<Item>& items, std::size_t at) {
  const auto verb = std::find_if(items.rend() - static_cast<std::ptrdiff_t>(at), items.rend(), [](const Item& item) {
    return item.IsVerb() || item.name == "way" || item.Is(M::kBreak);
  });
  return verb != items.rend() && (verb->GoesUpOrDown() || verb->name == "way");
}

}  // namespace

bool IsStep(const std::string& name) { return name == "step" || name == "stair" || name == "台阶"; }

std::vector<std::pair<std::string, PlaceName>> StairsPlaces(const std::vector<PlaceName>& places) {
  std::vector<std::pair<std::string, PlaceName>> named;
  for (const PlaceName& place : places) {
    if (place.name == "step") named.push_back({"stair", {place.name, 0}});
    if (place.name == "step" || place.name == "stair") {
      for (const char* top :
           {"landing", "the top", "the very top", "the top of the stairs", "the top of the staircase",
            "the top of the steps", "top of the stairs", "top of the staircase", "top of the steps", "top step",
            "highest step", "topmost step", "the top step", "the highest step", "the topmost step"})
        named.push_back({top, {place.name, -1}});
    }
    if (IsStep(place.name)) {
      for (const char* top : {"平台", "楼梯顶", "楼梯顶上", "楼梯顶部", "楼梯顶端", "台阶顶上", "最高一级台阶",
                              "最上面一级台阶", "最上面的台阶", "最高的台阶"})
        named.push_back({top, {place.name, -1}});
    }
    if (place.name == kEndOfStairs) {
      for (const char* end : {"other side of the stairs", "far side of the stairs", "楼梯另一边", "楼梯那边"})
        named.push_back({end, {place.name, 0}});
    }
    if (place.name == kStartOfStairs) {
      for (const char* foot : {"foot of the stairs", "bottom of the stairs", "楼梯口", "楼梯底下"})
        named.push_back({foot, {place.name, 0}});
    }
  }
  // Names of places of the ground have priority.
  std::erase_if(named, [&](const auto& one) {
    return std::any_of(places.begin(), places.end(), [&](const PlaceName& place) { return place.name == one.first; });
  });
  return named;
}

std::pair<Item, std::size_t> StairsWordAt(const std::vector<Piece>& pieces, std::size_t at,
                                          const std::vector<Item>& before) {
  if (Is(pieces, at, "next") && (Is(pieces, at + 1, "step") || Is(pieces, at + 1, "stair")) && LeadsTo(before))
    return {StairsOfRise(2.0), 2};
  if (Is(pieces, at, "下") && Is(pieces, at + 1, "一") && IsMeasure(pieces, at + 2) && LeadsTo(before)) {
    const bool noun = Is(pieces, at + 3, "台") && Is(pieces, at + 4, "阶");
    return {StairsOfRise(2.0), noun ? 5 : 3};
  }
  const bool ends = at + 1 == pieces.size() || pieces[at + 1].kind == Piece::Kind::kSign;
  if (Is(pieces, at, "one") && ends && !before.empty() && before.back().GoesUpOrDown()) return {Treads(1.0), 1};
  if ((Is(pieces, at, "上") || Is(pieces, at, "下")) && Is(pieces, at + 1, "去") && Begins(before))
    return {Verb(pieces[at].text == "上" ? kUpwards : kDownwards), 2};
  if (Is(pieces, at, "上") || Is(pieces, at, "下")) {
    const std::size_t number = NumberAt(pieces, at + 1).pieces;
    const bool up = pieces[at].text == "上", after_verb = !before.empty() && before.back().IsVerb();  // "走下两级"
    if (number > 0 && IsMeasure(pieces, at + 1 + number))
      return {after_verb ? UpOrDown(up ? M::kUp : M::kDown) : Verb(up ? kUpStairs : kDownStairs), 1};
  }
  if (Is(pieces, at, "台") && Is(pieces, at + 1, "阶")) return {StairsOfRise(0.0), 2};
  return {{}, 0};
}

void JoinStairs(std::vector<Item>& items) {
  for (std::size_t k = 0; k + 1 < items.size(); ++k) {  // "climb the first two steps"
    const bool steps = items[k + 1].Is(M::kAmount) && (items[k + 1].name == "steps" || items[k + 1].name == "treads");
    if (!items[k].Is(M::kOrdinal) || !steps || !FollowsWay(items, k)) continue;
    items[k].meaning = items[k].value == 1.0 ? M::kFiller : M::kUnknown;
  }
  for (std::size_t k = 1; k + 1 < items.size(); ++k) {
    if (!items[k].Is(M::kNumber) || items[k + 1].name != "级") continue;
    if (!FollowsWay(items, k)) continue;
    const bool noun = k + 2 < items.size() && (items[k + 2].Is(M::kStairs) || IsStep(items[k + 2].name));
    const std::size_t last = noun ? k + 2 : k + 1;
    items[k].meaning = M::kAmount;
    items[k].name = "treads";
    items[k].end = items[last].end;
    items.erase(items.begin() + static_cast<std::ptrdiff_t>(k) + 1,
                items.begin() + static_cast<std::ptrdiff_t>(last) + 1);
  }
}

}  // namespace gaitwright::words
