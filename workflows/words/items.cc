// SPDX-License-Identifier: BSD-3-Clause
#include "workflows/words/items.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "kinematics/base/text.h"
#include "workflows/words/join_items.h"
#include "workflows/words/lead_in.h"
#include "workflows/words/lexicon.h"
#include "workflows/words/numbers.h"
#include "workflows/words/pieces.h"
#include "workflows/words/stairs_words.h"

namespace gaitwright::words {
namespace {

using M = Meaning;

/// Chinese names of places that have English names in grounds.
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
    for (const PlaceName& place : places) {
      AddPlace(LowerCase(place.name), place.name);
      const std::string colour = "色";  // "红标记" is 红色标记
      const std::size_t at = place.name.find(colour);
      if (at != std::string::npos && at > 0) AddPlace(std::string(place.name).erase(at, colour.size()), place.name);
    }
    for (const auto& [phrase, place] : StairsPlaces(places)) AddPlace(phrase, place.name, place.number);
    for (const auto& translation : PlaceTranslations()) {
      const bool known = std::any_of(places.begin(), places.end(),
                                     [&](const PlaceName& place) { return place.name == translation.second; });
      if (known) AddPlace(translation.first, translation.second);
    }
    numbered_ = IsEnumerated();
  }

  std::vector<Item> Read() {
    while (at_ < pieces_.size()) {
      if (IsGap()) PushBreak();
      if (!TakeEnumerator() && !TakeLeadIn() && !TakeSign() && !TakeStairs(true) && !TakeAmount() && !TakePlace() &&
          !TakePhrase() && !TakeStairs(false))
        TakeUnknown();
    }
    JoinItems(items_);
    return std::move(items_);
  }

 private:
  void AddPlace(const std::string& phrase, const std::string& name, int number = 0) {
    Item item;
    item.meaning = M::kPlace;
    item.name = name;
    item.value = number;
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

  /// A space between Chinese words counts as a comma.
  bool IsGap() const {
    return at_ > 0 && pieces_[at_].begin > pieces_[at_ - 1].end && IsCharacter(at_) && IsCharacter(at_ - 1) &&
           !items_.empty() && !items_.back().Is(M::kBreak);
  }
  bool IsCharacter(std::size_t at) const { return pieces_[at].kind == Piece::Kind::kCharacter; }

  void PushBreak() {
    Item item;
    item.meaning = M::kBreak;
    item.begin = item.end = pieces_[at_].begin;
    items_.push_back(item);
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

  /// Whether the present part begins with unknown words.
  bool OpensUnknown() const {
    std::size_t begin = items_.size();
    while (begin > 0 && !items_[begin - 1].Is(M::kBreak)) --begin;
    while (begin < items_.size() && items_[begin].Is(M::kPolite)) ++begin;
    return begin < items_.size() && (items_[begin].Is(M::kUnknown) || items_[begin].Is(M::kElsewhere));
  }

  static bool IsTitle(const std::string& word) {
    return word == "mr" || word == "mrs" || word == "ms" || word == "dr" || word == "prof" || word == "st";
  }

  /// The verb of a drawn-out command.
  bool IsDrill(std::size_t at) const {
    return pieces_[at].text == "转" || pieces_[at].text == "走" || pieces_[at].text == "定";
  }

  bool TakeLeadIn() {
    const bool begins =
        items_.empty() || items_.back().Is(M::kBreak) || items_.back().Is(M::kThen) || items_.back().Is(M::kPolite);
    const std::size_t count = begins ? LeadInAt(pieces_, at_) : 0;
    if (count == 0 || count < Longest(words_, at_).second) return false;
    Push(M::kPolite, count);
    return true;
  }

  bool TakeSign() {
    static const std::array<const char*, 17> kBreaks = {",", ";", "!",  "?",  "。", "、", "…", "(", ")",
                                                        "|", "—", "；", "，", "！", "？", "·", "~"};
    const Piece& piece = pieces_[at_];
    if (piece.kind != Piece::Kind::kSign) return false;
    const bool ends =
        at_ + 1 == pieces_.size() || pieces_[at_ + 1].begin > piece.end || pieces_[at_ + 1].kind != Piece::Kind::kWord;
    const bool breaks =
        std::any_of(kBreaks.begin(), kBreaks.end(), [&](const char* sign) { return piece.text == sign; });
    const std::size_t next = at_ + 1;
    if (piece.text == "." && at_ > 0 && IsTitle(pieces_[at_ - 1].text)) {
      Push(M::kFiller, 1);
      return true;
    }
    const bool drawn = piece.text == "—" && next < pieces_.size() && (pieces_[next].text == "—" || IsDrill(next));
    const bool quotes = piece.text == "'" || piece.text == "\"" || piece.text == "“" || piece.text == "”";
    const bool opens = piece.text == ":" && OpensUnknown();            // "the test is this: ..."
    const bool fills = opens || quotes || (drawn && !items_.empty());  // "向后——转"
    if (!fills && !breaks && piece.text != ":" && !(piece.text == "." && ends)) return false;
    Push(fills ? M::kFiller : M::kBreak, 1);
    return true;
  }

  /// The longest phrase of a lexicon that begins at a piece, and its number of pieces.
  std::pair<const Item*, std::size_t> Longest(const Lexicon& lexicon, std::size_t at) const {
    for (std::size_t count = std::min(lexicon.longest(), pieces_.size() - at); count > 0; --count) {
      if (const Item* item = lexicon.Find(PhraseOf(pieces_, at, count))) return {item, count};
    }
    return {nullptr, 0};
  }

  /// A length after "每秒"; otherwise the next "每秒" would make it a speed.
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

  /// "x2"
  bool TakeTimes() {
    if (pieces_[at_].text != "x" || at_ + 1 == pieces_.size() || pieces_[at_ + 1].kind != Piece::Kind::kNumber)
      return false;
    Item item;
    item.meaning = M::kAmount;
    item.name = "times";
    item.value = NumberAt(pieces_, at_ + 1).value;
    Push(item, 2);
    return true;
  }

  bool TakeAmount() {
    if (TakeTimes()) return true;
    const SpokenNumber number = NumberAt(pieces_, at_);
    if (number.pieces == 0) return false;
    const auto [phrase, phrase_pieces] = Longest(words_, at_);
    std::size_t after = at_ + number.pieces;
    const bool hyphen = after + 1 < pieces_.size() && pieces_[after].text == "-" && UnitAt(after + 1).first != nullptr;
    if (hyphen) ++after;  // "twenty-degree"
    const auto [unit, unit_pieces] = UnitAt(after);
    if (unit == nullptr || (number.is_article && unit->name == "turns" && pieces_[at_].text == "a")) {
      if (phrase != nullptr && (phrase_pieces > number.pieces || number.is_article)) return false;
      const auto next = after < pieces_.size() ? Longest(words_, after).first : nullptr;
      if (pieces_[at_].text == "一" && number.pieces == 1 && next != nullptr && next->Is(M::kAction)) {  // 一走到就
        Push(M::kFiller, 1);
        return true;
      }
      if (number.is_article && pieces_[at_].kind == Piece::Kind::kWord) return false;
      if (pieces_[at_].kind != Piece::Kind::kCharacter && TakeParted(number)) return true;
      Item item;
      item.meaning = M::kNumber;
      item.value = number.value;
      Push(item, number.pieces);
      return true;
    }
    if (phrase != nullptr && phrase_pieces > number.pieces + unit_pieces) return false;
    // 一下 and 一个 only soften the request.
    // "one foot" is a limb, "a foot" is a length.
    if (number.is_article && pieces_[at_].text == "one" && pieces_[after].text == "foot" && !Walks()) return false;
    if (number.is_article && pieces_[after].text == "foot" && !items_.empty() && items_.back().Is(M::kRaise))
      return false;
    const bool softener = pieces_[at_].text == "一" && number.pieces == 1 &&
                          (pieces_[after].text == "下" || (unit->name == "count" && phrase != nullptr));
    if (softener) return false;
    std::size_t count = after - at_ + unit_pieces;
    double value = number.value;
    if (unit->name != "count" && unit->name != "times" && unit->name != "m/step") {
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

  /// Whether the last action is to walk.
  bool Walks() const {
    for (auto item = items_.rbegin(); item != items_.rend() && !item->Is(M::kBreak); ++item) {
      if (item->Is(M::kAction)) return item->name == "walk";
    }
    return false;
  }

  /// "three sideways steps", "ten more feet": the unit comes one word later.
  bool TakeParted(const SpokenNumber& number) {
    const std::size_t after = at_ + number.pieces;
    const Item* between = after < pieces_.size() ? words_.Find(pieces_[after].text) : nullptr;
    const bool fits =
        between != nullptr && (between->Is(M::kFiller) || between->Is(M::kDirection) || between->Is(M::kPace) ||
                               between->Is(M::kSide) || between->Is(M::kSideways) || between->Is(M::kPolite));
    if (!fits || number.is_article) return false;
    const auto [unit, unit_pieces] = UnitAt(after + 1);
    if (unit == nullptr || (unit->name != "steps" && unit->name != "m")) return false;
    Item item;
    item.meaning = M::kAmount;
    item.name = unit->name;
    item.value = number.value * unit->value;
    Push(item, number.pieces);
    Push(*between, 1);
    items_.back().end = pieces_[at_ + unit_pieces - 1].end;
    at_ += unit_pieces;
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
    // A name that is also another word is a place after "to" or an ordinal, or before a number.
    if (words_.Find(PhraseOf(pieces_, at_, most)) != nullptr || units_.Find(PhraseOf(pieces_, at_, most)) != nullptr) {
      const std::size_t after = at_ + most < pieces_.size() && pieces_[at_ + most].text == "number" ? most + 1 : most;
      const bool numbered = at_ + after < pieces_.size() && NumberAt(pieces_, at_ + after).pieces > 0;
      if (!numbered && !FollowsToOrOrdinal()) return false;
    }
    Push(*found, most);
    const std::size_t one = at_ < pieces_.size() && pieces_[at_].text == "number" ? at_ + 1 : at_;
    if (one < pieces_.size() && pieces_[one].text == "one") {  // "stone one"
      items_.back().value = 1.0;
      items_.back().end = pieces_[one].end;
      at_ = one + 1;
    }
    return true;
  }

  /// @param first  true: before phrases are tried; false: only the word for steps, after them.
  bool TakeStairs(bool first) {
    const auto [item, count] = StairsWordAt(pieces_, at_, items_);
    if (count == 0 || first == (item.Is(M::kStairs) && item.value == 0.0)) return false;
    if (item.Is(M::kAction) && Longest(words_, at_).second > count) return false;
    Push(item, count);
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
      const SpokenNumber number = NumberAt(pieces_, at_ + 1);
      if (number.pieces > 0 && Longest(words_, at_).second <= 1 + number.pieces) {
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

  /// An adverb such as "gracefully" describes the manner and is ignored.
  bool IsAdverb(const std::string& word) const { return word.size() > 5 && word.ends_with("ly"); }

  void TakeUnknown() {
    if (IsAdverb(pieces_[at_].text)) return Push(M::kFiller, 1);
    const bool goes_on = !items_.empty() && items_.back().Is(M::kUnknown);
    if (!goes_on) return Push(M::kUnknown, 1);
    items_.back().end = pieces_[at_++].end;
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
