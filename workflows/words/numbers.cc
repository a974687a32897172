// SPDX-License-Identifier: BSD-3-Clause
#include "workflows/words/numbers.h"

#include <cstdlib>
#include <map>
#include <string>

namespace gaitwright::words {
namespace {

using Table = std::map<std::string, double>;

const Table& Ones() {
  static const Table ones = {{"zero", 0},     {"one", 1},      {"two", 2},        {"three", 3},     {"four", 4},
                             {"five", 5},     {"six", 6},      {"seven", 7},      {"eight", 8},     {"nine", 9},
                             {"ten", 10},     {"eleven", 11},  {"twelve", 12},    {"thirteen", 13}, {"fourteen", 14},
                             {"fifteen", 15}, {"sixteen", 16}, {"seventeen", 17}, {"eighteen", 18}, {"nineteen", 19},
                             {"twenty", 20},  {"thirty", 30},  {"forty", 40},     {"fifty", 50},    {"sixty", 60},
                             {"seventy", 70}, {"eighty", 80},  {"ninety", 90}};
  return ones;
}

const Table& Multiples() {
  static const Table multiples = {
      {"hundred", 1e2}, {"thousand", 1e3}, {"million", 1e6}, {"billion", 1e9}, {"dozen", 12}};
  return multiples;
}

const Table& HanDigits() {
  static const Table digits = {{"零", 0}, {"〇", 0}, {"一", 1}, {"二", 2}, {"两", 2}, {"三", 3},
                               {"四", 4}, {"五", 5}, {"六", 6}, {"七", 7}, {"八", 8}, {"九", 9}};
  return digits;
}

const Table& HanMultiples() {
  static const Table multiples = {{"十", 1e1}, {"百", 1e2}, {"千", 1e3}, {"万", 1e4}, {"亿", 1e8}};
  return multiples;
}

class NumberReader {
 public:
  NumberReader(const std::vector<Piece>& pieces, std::size_t at) : pieces_(pieces), first_(at), at_(at) {}

  SpokenNumber Read() {
    double sign = 1.0;
    if (Takes("minus") || Takes("negative") || Takes("负") || (Is("-") && IsNumber(at_ + 1) && Takes("-"))) sign = -1.0;
    SpokenNumber number;
    const bool read = ReadDigits(number) || ReadHan(number) || ReadEnglish(number);
    if (!read) return {};
    number.value *= sign;
    number.pieces = at_ - first_;
    return number;
  }

 private:
  bool Has(std::size_t lookahead = 0) const { return at_ + lookahead < pieces_.size(); }
  const std::string& Text(std::size_t lookahead = 0) const { return pieces_[at_ + lookahead].text; }
  bool Is(const char* text, std::size_t lookahead = 0) const { return Has(lookahead) && Text(lookahead) == text; }
  bool IsNumber(std::size_t at) const { return at < pieces_.size() && pieces_[at].kind == Piece::Kind::kNumber; }
  bool Takes(const char* text) {
    if (!Is(text)) return false;
    ++at_;
    return true;
  }

  bool ReadDigits(SpokenNumber& number) {
    if (!IsNumber(at_)) return false;
    number.value = std::strtod(Text().c_str(), nullptr);
    ++at_;
    while (Has()) {  // "3 million", "5万"
      const auto word = Multiples().find(Text());
      const auto han = HanMultiples().find(Text());
      if (word == Multiples().end() && han == HanMultiples().end()) break;
      number.value *= word != Multiples().end() ? word->second : han->second;
      ++at_;
    }
    ReadAndAHalf(number);
    return true;
  }

  void ReadAndAHalf(SpokenNumber& number) {
    for (const auto& [words, share] : {std::pair("half", 0.5), std::pair("quarter", 0.25)}) {
      if (!Is("and") || !Is("a", 1) || !Is(words, 2)) continue;
      number.value += share;
      at_ += 3;
      return;
    }
  }

  /// Digits and multiples: 一千二百三十四万, 十五, 二十, and decimals after 点.
  bool ReadHan(SpokenNumber& number) {
    if (Takes("半")) {
      number.value = 0.5;
      return true;
    }
    if (Takes("几")) {
      number.value = 3.0;
      return true;
    }
    double whole = 0.0, section = 0.0, digit = 0.0;
    bool any = false, has_digit = false;
    for (; Has(); ++at_) {
      const auto d = HanDigits().find(Text());
      const auto m = HanMultiples().find(Text());
      if (d != HanDigits().end()) {
        digit = has_digit ? 10.0 * digit + d->second : d->second;  // 一二三 as read one by one
        has_digit = true;
      } else if (m != HanMultiples().end()) {
        if (m->second >= 1e4) {
          whole += (section + digit > 0.0 ? section + digit : 1.0) * m->second;
          section = 0.0;
        } else {
          section += (has_digit ? digit : 1.0) * m->second;
        }
        digit = 0.0;
        has_digit = false;
      } else {
        break;
      }
      any = true;
    }
    if (!any) return false;
    number.value = whole + section + digit;
    if (Is("分") && Is("之", 1) && Has(2) && number.value > 0.0) {  // 四分之三
      const std::size_t back = at_;
      at_ += 2;
      SpokenNumber share;
      if (ReadHan(share)) {
        number.value = share.value / number.value;
        return true;
      }
      at_ = back;
    }
    if (!Is("点") || !Has(1) || !HanDigits().contains(Text(1))) return true;
    ++at_;
    for (double place = 0.1; Has() && HanDigits().contains(Text()); place *= 0.1, ++at_)
      number.value += place * HanDigits().at(Text());
    return true;
  }

  bool ReadEnglish(SpokenNumber& number) {
    const std::size_t start = at_;
    const bool article = Takes("a") || Takes("an");
    if (Takes("couple")) {
      Takes("of");
      number.value = 2.0;
      return true;
    }
    if (Takes("few")) {
      number.value = 3.0;
      return true;
    }
    if (Takes("half")) {
      Takes("of");
      if (!Takes("a")) Takes("an");
      number.value = Takes("dozen") ? 6.0 : 0.5;
      return true;
    }
    if (Takes("quarter")) {
      Takes("of");
      Takes("a");
      number.value = 0.25;
      return true;
    }
    if (Is("three") && (Is("quarters", 1) || Is("quarter", 1))) {
      at_ += 2;
      Takes("of");
      Takes("a");
      number.value = 0.75;
      return true;
    }
    if (ReadWords(number, article)) return true;
    at_ = start;
    if (!article) return false;
    ++at_;
    number.value = 1.0;
    number.is_article = true;
    return true;
  }

  bool ReadWords(SpokenNumber& number, bool article) {
    const std::size_t start = at_;
    double total = 0.0, part = 0.0;
    bool any = false;
    for (; Has(); ++at_) {
      const std::string word = Text();
      const std::size_t hyphen = word.find('-');
      const auto one = Ones().find(word.substr(0, hyphen));
      const auto multiple = Multiples().find(word);
      if (one != Ones().end() && hyphen != std::string::npos && Ones().contains(word.substr(hyphen + 1))) {
        part += one->second + Ones().at(word.substr(hyphen + 1));
      } else if (one != Ones().end() && hyphen == std::string::npos) {
        if (any && part != 0.0 && !(static_cast<int>(part) % 100 >= 20 && one->second < 10) &&
            static_cast<int>(part) % 100 != 0)
          break;
        part += one->second;
      } else if (multiple != Multiples().end()) {
        const double count = part > 0.0 ? part : 1.0;
        if (!any && !article && word != "dozen") break;
        if (multiple->second == 1e2 || word == "dozen") {
          part = count * multiple->second;
        } else {
          total += count * multiple->second;
          part = 0.0;
        }
      } else if (!(any && word == "and" && Has(1) && Ones().contains(Text(1)) && part >= 100.0)) {
        break;
      }
      any = true;
    }
    if (!any) {
      at_ = start;
      return false;
    }
    number.value = total + part;
    if (Is("point") && Has(1)) {
      double place = 0.1;
      for (++at_; Has() && Ones().contains(Text()) && Ones().at(Text()) < 10.0; ++at_, place *= 0.1)
        number.value += place * Ones().at(Text());
    }
    number.is_article = at_ == start + 1 && pieces_[start].text == "one";
    const double whole = number.value;
    ReadAndAHalf(number);
    if (number.value != whole) number.is_article = false;
    return true;
  }

  const std::vector<Piece>& pieces_;
  const std::size_t first_;
  std::size_t at_;
};

}  // namespace

SpokenNumber NumberAt(const std::vector<Piece>& pieces, std::size_t at) { return NumberReader(pieces, at).Read(); }

SpokenNumber AfterUnit(const std::vector<Piece>& pieces, std::size_t at) {
  const auto is = [&](std::size_t lookahead, const char* text) {
    return at + lookahead < pieces.size() && pieces[at + lookahead].text == text;
  };
  if (is(0, "and") && is(1, "a") && is(2, "half")) return {0.5, 3};
  if (is(0, "and") && is(1, "a") && is(2, "quarter")) return {0.25, 3};
  if (is(0, "and") && is(1, "three") && is(2, "quarters")) return {0.75, 3};
  if (at < pieces.size() && pieces[at].kind == Piece::Kind::kWord && Ones().contains(pieces[at].text)) {
    const double hundredths = Ones().at(pieces[at].text);  // "one metre twenty"
    const bool alone = at + 1 == pieces.size() || pieces[at + 1].kind == Piece::Kind::kSign;
    if (hundredths >= 10.0 && alone) return {0.01 * hundredths, 1};
  }
  if (is(0, "半")) return {0.5, 1};
  const bool digit = at < pieces.size() && HanDigits().contains(pieces[at].text) && pieces[at].text != "两";
  if (!digit) return {};
  // "一米二" is 1.2 m, "一米二十" something else.
  const bool goes_on = at + 1 < pieces.size() && pieces[at + 1].kind != Piece::Kind::kSign &&
                       (HanDigits().contains(pieces[at + 1].text) || HanMultiples().contains(pieces[at + 1].text) ||
                        pieces[at + 1].text == "步" || pieces[at + 1].text == "秒" || pieces[at + 1].text == "次" ||
                        pieces[at + 1].text == "下" || pieces[at + 1].text == "边" || pieces[at + 1].text == "起");
  if (goes_on) return {};
  return {0.1 * HanDigits().at(pieces[at].text), 1};
}

}  // namespace gaitwright::words
