// SPDX-License-Identifier: BSD-3-Clause
#include "workflows/words/items.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "kinematics/base/text.h"
#include "workflows/words/lexicon.h"
#include "workflows/words/numbers.h"
#include "workflows/words/pieces.h"

namespace gaitwright::words {
namespace {

using M = Meaning;

/// Chinese for places that grounds have under English names.
const std::vector<std::pair<const char*, const char*>>& PlaceTranslations() {
  static const std::vector<std::pair<const char*, const char*>> table = {{"台阶", "step"},
                                                                         {"石头", "stone"},
                                                                         {"门", "door"},
                                                                         {"充电桩", "charging station"},
                                                                         {"红色标记", "red marker"},
                                                                         {"蓝色标记", "blue marker"},
                                                                         {"绿色标记", "green marker"},
                                                                         {"黄色标记", "yellow marker"},
                                                                         {"平衡木", "beam"},
                                                                         {"木块", "block"},
                                                                         {"平台", "landing"},
                                                                         {"坡", "slope"}};
  return table;
}

class ItemReader {
 public:
  ItemReader(const std::string& text, Language language, const std::vector<PlaceName>& places)
      : pieces_(PiecesOf(text)),
        words_(language == Language::kEnglish ? English() : Chinese()),
        units_(language == Language::kEnglish ? EnglishUnits() : ChineseUnits()) {
    for (const PlaceName& place : places) AddPlace(LowerCase(place.name), place.name);
    for (const auto& [chinese, english] : PlaceTranslations()) {
      const bool known =
          std::any_of(places.begin(), places.end(), [&](const PlaceName& place) { return place.name == english; });
      if (known) AddPlace(chinese, english);
    }
    numbered_ = IsEnumerated();
  }

  std::vector<Item> Read() {
    while (at_ < pieces_.size()) {
      if (!TakeEnumerator() && !TakeSign() && !TakeAmount() && !TakePlace() && !TakePhrase()) TakeUnknown();
    }
    JoinRates();
    MarkBefore();
    MarkAdverbs();
    JoinOrdinals();
    return std::move(items_);
  }

 private:
  void AddPlace(const std::string& phrase, const std::string& name) {
    Item item;
    item.meaning = M::kPlace;
    item.name = name;
    const std::vector<Piece> pieces = PiecesOf(phrase);
    places_.push_back({PhraseOf(pieces, 0, pieces.size()), pieces.size(), item});
  }

  void Push(Item item, std::size_t count) {
    item.begin = pieces_[at_].begin;
    item.end = pieces_[at_ + count - 1].end;
    items_.push_back(std::move(item));
    at_ += count;
  }
  void Push(M meaning, std::size_t count) {
    Item item;
    item.meaning = meaning;
    Push(item, count);
  }

  /// "a)" and so on.
  bool IsLetteredAt(std::size_t at, int number) const {
    return at + 1 < pieces_.size() && pieces_[at].text == std::string(1, static_cast<char>('a' + number - 1)) &&
           pieces_[at + 1].text == ")";
  }

  bool IsNumberedAt(std::size_t at, int number) const {
    if (number <= 26 && IsLetteredAt(at, number)) return true;
    return at + 1 < pieces_.size() && pieces_[at].kind == Piece::Kind::kNumber &&
           pieces_[at].text == std::to_string(number) && (pieces_[at + 1].text == "." || pieces_[at + 1].text == ")");
  }

  /// A list "1. ... 2. ...".
  bool IsEnumerated() const {
    int next = 1;
    for (std::size_t k = 0; k < pieces_.size(); ++k) next += IsNumberedAt(k, next) ? 1 : 0;
    return next > 2 && IsNumberedAt(0, 1);
  }

  bool TakeEnumerator() {
    if (!numbered_ || !IsNumberedAt(at_, next_number_)) return false;
    ++next_number_;
    Push(M::kThen, 2);
    return true;
  }

  bool TakeSign() {
    static const std::array<const char*, 14> kBreaks = {",", ";",  "!",  "?",  "。", "、", "…",
                                                        "—", "；", "，", "！", "？", "·",  "~"};
    const Piece& piece = pieces_[at_];
    if (piece.kind != Piece::Kind::kSign) return false;
    const bool ends =
        at_ + 1 == pieces_.size() || pieces_[at_ + 1].begin > piece.end || pieces_[at_ + 1].kind != Piece::Kind::kWord;
    const bool breaks =
        std::any_of(kBreaks.begin(), kBreaks.end(), [&](const char* sign) { return piece.text == sign; });
    if (breaks || (piece.text == "." && ends)) {
      Push(M::kBreak, 1);
    } else if (piece.text == ":" || piece.text == "'" || piece.text == "\"" || piece.text == "“" || piece.text == "”") {
      Push(M::kFiller, 1);
    } else {
      return false;
    }
    return true;
  }

  /// The longest phrase of a lexicon from a piece on, and how many pieces it has.
  std::pair<const Item*, std::size_t> Longest(const Lexicon& lexicon, std::size_t at) const {
    for (std::size_t count = std::min(lexicon.longest(), pieces_.size() - at); count > 0; --count) {
      if (const Item* item = lexicon.Find(PhraseOf(pieces_, at, count))) return {item, count};
    }
    return {nullptr, 0};
  }

  /// After "每秒" a length, which else would make a speed of the next "每秒".
  std::pair<const Item*, std::size_t> UnitAt(std::size_t at) const {
    if (at >= pieces_.size()) return {nullptr, 0};
    const bool rate = !items_.empty() && items_.back().Is(M::kUnit);
    const auto longest = Longest(units_, at);
    if (!rate || longest.first == nullptr || longest.first->name != "m/s") return longest;
    for (std::size_t count = longest.second; count-- > 1;) {
      const Item* item = units_.Find(PhraseOf(pieces_, at, count));
      if (item != nullptr && item->name == "m") return {item, count};
    }
    return longest;
  }

  bool TakeAmount() {
    const SpokenNumber number = NumberAt(pieces_, at_);
    if (number.pieces == 0) return false;
    const auto [phrase, phrase_pieces] = Longest(words_, at_);
    const std::size_t after = at_ + number.pieces;
    const auto [unit, unit_pieces] = UnitAt(after);
    if (unit == nullptr || (number.is_article && unit->name == "turns" && pieces_[at_].text == "a")) {
      if (phrase != nullptr && (phrase_pieces > number.pieces || number.is_article)) return false;
      const auto next = after < pieces_.size() ? Longest(words_, after).first : nullptr;
      if (pieces_[at_].text == "一" && number.pieces == 1 && next != nullptr && next->Is(M::kAction)) {  // 一走到就
        Push(M::kFiller, 1);
        return true;
      }
      if (number.is_article && pieces_[at_].kind == Piece::Kind::kWord) return false;
      Item item;
      item.meaning = M::kNumber;
      item.value = number.value;
      Push(item, number.pieces);
      return true;
    }
    if (phrase != nullptr && phrase_pieces > number.pieces + unit_pieces) return false;
    // 一下 and 一个 soften what is said, or count nothing.
    // "one foot" stands, "a foot" is as long.
    if (number.is_article && pieces_[at_].text == "one" && pieces_[after].text == "foot") return false;
    if (number.is_article && pieces_[after].text == "foot" && !items_.empty() && items_.back().Is(M::kRaise))
      return false;
    const bool softener = pieces_[at_].text == "一" && number.pieces == 1 &&
                          (pieces_[after].text == "下" || (unit->name == "count" && phrase != nullptr));
    if (softener) return false;
    std::size_t count = number.pieces + unit_pieces;
    double value = number.value;
    if (unit->name != "count" && unit->name != "times") {
      if (const SpokenNumber more = AfterUnit(pieces_, at_ + count); more.pieces > 0) {
        value += more.value;
        count += more.pieces;
      }
    }
    Item item;
    item.meaning = M::kAmount;
    item.name = unit->name;
    item.value = value * unit->value;
    Push(item, count);
    return true;
  }

  bool TakePlace() {
    const Item* found = nullptr;
    std::size_t most = 0;
    for (const auto& [phrase, count, item] : places_) {
      if (count <= most || at_ + count > pieces_.size() || PhraseOf(pieces_, at_, count) != phrase) continue;
      most = count;
      found = &item;
    }
    if (found == nullptr) return false;
    // A name that is another word too is a place after "to" or an ordinal, or before a number.
    if (words_.Find(PhraseOf(pieces_, at_, most)) != nullptr || units_.Find(PhraseOf(pieces_, at_, most)) != nullptr) {
      const std::size_t after = at_ + most < pieces_.size() && pieces_[at_ + most].text == "number" ? most + 1 : most;
      const bool numbered = at_ + after < pieces_.size() && NumberAt(pieces_, at_ + after).pieces > 0;
      if (!numbered && !FollowsToOrOrdinal()) return false;
    }
    Push(*found, most);
    return true;
  }

  bool FollowsToOrOrdinal() const {
    for (std::size_t k = items_.size(); k-- > 0;) {
      if (items_[k].Is(M::kTo) || items_[k].Is(M::kOrdinal)) return true;
      if (!items_[k].Is(M::kFiller)) return false;
    }
    return false;
  }

  bool TakePhrase() {
    const Piece& piece = pieces_[at_];
    if (piece.text == "第" && at_ + 1 < pieces_.size()) {
      if (const SpokenNumber number = NumberAt(pieces_, at_ + 1); number.pieces > 0) {
        Item item;
        item.meaning = M::kOrdinal;
        item.value = number.value;
        Push(item, 1 + number.pieces);
        return true;
      }
    }
    const auto [item, count] = Longest(words_, at_);
    if (item == nullptr) return false;
    Push(*item, count);
    return true;
  }

  /// An adverb such as "gracefully" says how, which is not asked for.
  bool IsAdverb(const std::string& word) const { return word.size() > 5 && word.ends_with("ly"); }

  void TakeUnknown() {
    if (IsAdverb(pieces_[at_].text)) return Push(M::kFiller, 1);
    const bool goes_on = !items_.empty() && items_.back().Is(M::kUnknown);
    if (!goes_on) return Push(M::kUnknown, 1);
    items_.back().end = pieces_[at_++].end;
  }

  /// "鞠躬前，先退一步".
  void MarkBefore() {
    for (std::size_t k = 1; k + 1 < items_.size(); ++k) {
      const bool before = items_[k].Is(M::kFiller) && items_[k].name == "前";
      if (before && items_[k - 1].Is(M::kAction) && (items_[k + 1].Is(M::kBreak) || items_[k + 1].Is(M::kThen)))
        items_[k].meaning = M::kBefore;
    }
  }

  /// "优雅地": what is not known before 地 says how.
  void MarkAdverbs() {
    for (std::size_t k = 0; k + 1 < items_.size(); ++k) {
      const bool adverb =
          items_[k].Is(M::kUnknown) && items_[k + 1].name == "地" && items_[k].end == items_[k + 1].begin;
      if (adverb) items_[k].meaning = M::kFiller;
    }
  }

  /// "每秒" before a length is a speed.
  void JoinRates() {
    for (std::size_t k = 0; k < items_.size(); ++k) {
      Item& rate = items_[k];
      if (!rate.Is(M::kUnit)) continue;
      std::size_t next = k + 1;
      while (next < items_.size() && items_[next].Is(M::kFiller)) ++next;
      if (next == items_.size() || !items_[next].Is(M::kAmount) || items_[next].name != "m") continue;
      rate.meaning = M::kAmount;
      rate.name = "m/s";
      rate.value *= items_[next].value;
      rate.end = items_[next].end;
      items_.erase(items_.begin() + static_cast<std::ptrdiff_t>(k) + 1,
                   items_.begin() + static_cast<std::ptrdiff_t>(next) + 1);
    }
  }

  /// "the second step", "stone four", "5号石头": places with their numbers. An ordinal of nothing goes on to the next.
  void JoinOrdinals() {
    for (std::size_t k = 0; k < items_.size(); ++k) {
      if (items_[k].Is(M::kPlace)) {
        std::size_t number = k + 1;
        while (number < items_.size() && items_[number].Is(M::kFiller)) ++number;
        if (number == items_.size() || !items_[number].Is(M::kNumber) || items_[k].value != 0.0) continue;
        items_[k].value = items_[number].value;
        items_[k].end = items_[number].end;
        items_.erase(items_.begin() + static_cast<std::ptrdiff_t>(k) + 1,
                     items_.begin() + static_cast<std::ptrdiff_t>(number) + 1);
        continue;
      }
      if (!items_[k].Is(M::kOrdinal) && !items_[k].Is(M::kNumber)) continue;
      std::size_t next = k + 1;
      while (next < items_.size() && items_[next].Is(M::kFiller)) ++next;
      if (next < items_.size() && items_[next].Is(M::kPlace)) {
        items_[next].value = items_[k].value;
        items_[next].begin = items_[k].begin;
        items_.erase(items_.begin() + static_cast<std::ptrdiff_t>(k),
                     items_.begin() + static_cast<std::ptrdiff_t>(next));
      } else if (items_[k].Is(M::kOrdinal)) {
        const bool last = k + 1 == items_.size() || items_[k + 1].Is(M::kBreak);
        items_[k].meaning = last && k > 0 && items_[k].value == 1.0 ? M::kFirst : M::kThen;
      }
    }
    for (std::size_t k = 1; k + 1 < items_.size(); ++k) {  // "the first and the second stone"
      const bool joins = items_[k].Is(M::kFiller) && items_[k].name == "and";
      if (joins && items_[k - 1].Is(M::kPlace) && items_[k + 1].Is(M::kPlace)) items_[k].meaning = M::kThen;
    }
  }

  struct KnownPlace {
    std::string phrase;
    std::size_t pieces;
    Item item;
  };

  const std::vector<Piece> pieces_;
  const Lexicon& words_;
  const Lexicon& units_;
  std::vector<KnownPlace> places_;
  std::vector<Item> items_;
  std::size_t at_ = 0;
  int next_number_ = 1;
  bool numbered_ = false;
};

}  // namespace

Language LanguageOf(const std::string& text) {
  for (const Piece& piece : PiecesOf(text)) {
    if (piece.kind == Piece::Kind::kCharacter) return Language::kChinese;
  }
  return Language::kEnglish;
}

std::vector<Item> ItemsOf(const std::string& text, Language language, const std::vector<PlaceName>& places) {
  return ItemReader(text, language, places).Read();
}

}  // namespace gaitwright::words
