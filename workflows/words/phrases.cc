// SPDX-License-Identifier: BSD-3-Clause
#include "workflows/words/phrases.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "kinematics/base/text.h"
#include "workflows/words/draft.h"

namespace gaitwright::words {

bool IsGreeting(const std::string& action) { return action == "wave" || action == "bow" || action == "nod"; }

bool IsCounted(const std::string& action) {
  static const std::array<const char*, 6> kCounted = {"squat", "bow", "nod", "wave", "jump", "flip"};
  return std::any_of(kCounted.begin(), kCounted.end(), [&](const char* name) { return action == name; });
}

bool IsAngle(double number) {
  constexpr double kLeast = 10.0, kMost = 720.0;
  return number >= kLeast && number <= kMost && std::fmod(number, 5.0) == 0.0;
}

std::string Other(const std::string& side) { return side == "left" ? "right" : side == "right" ? "left" : side; }

bool Greets(const std::string& text, const Item& verb) {
  static const std::array<const char*, 6> kGreets = {"gree", "Gree", "salu", "Salu", "say ", "Say "};
  const std::string word = TextOf(text, {verb.begin, verb.end});
  const bool chinese = static_cast<unsigned char>(word.front()) >= 128;
  return verb.Is(Meaning::kAction) && (chinese || std::any_of(kGreets.begin(), kGreets.end(), [&](const char* start) {
                                         return word.starts_with(start);
                                       }));
}

bool IsAddressed(const std::string& text, const Clause& clause, std::size_t at) {
  for (std::size_t k = at; k-- > 0 && clause.items[k].SaysNothing();) {
    const std::string word = TextOf(text, {clause.items[k].begin, clause.items[k].end});
    if (word == "for" || word == "for the" || word == "for our" || word == "for my") return true;
  }
  return false;
}

bool SaysWhereTo(const std::string& side) {
  static const std::array<const char*, 7> kTowards = {"to ", "toward", "off to", "over to", "向", "往", "朝"};
  const std::string said = LowerCase(side);
  return std::any_of(kTowards.begin(), kTowards.end(), [&](const char* start) { return said.starts_with(start); });
}

bool IsMeans(const std::string& text, const Clause& clause, std::size_t first_begin, std::size_t at) {
  if (SaysWhereTo(TextOf(text, {clause.items[at].begin, clause.items[at].end}))) return true;
  for (std::size_t k = at; k-- > 0 && clause.items[k].begin > first_begin;) {
    const Item& item = clause.items[k];
    if (item.IsVerb() || LowerCase(TextOf(text, {item.begin, item.end})).starts_with("with")) return true;
  }
  return false;
}

bool IsOfSteps(const std::string& text, const Clause& clause, std::size_t at) {
  if (at < 2) return false;
  const Item &of = clause.items[at - 1], &steps = clause.items[at - 2];
  return TextOf(text, {of.begin, of.end}) == "of" && steps.Is(Meaning::kAmount) && steps.name == "steps";
}

bool GoesBack(const std::string& word) {
  static const std::array<const char*, 7> kBack = {"go back",   "walk back", "come back", "move back",
                                                   "head back", "get back",  "step back"};
  return std::any_of(kBack.begin(), kBack.end(), [&](const char* back) {
    return word.size() == std::char_traits<char>::length(back) && (word.substr(1) == std::string(back).substr(1));
  });
}

bool NodsInVain(const std::string& text, const Clause& clause) {
  bool alone = false, head = false;
  for (const Item& item : clause.items) {
    const std::string word = TextOf(text, {item.begin, item.end});
    alone = alone || word == "点";
    head = head || word.find("头") != std::string::npos;
  }
  return alone && !head;
}

}  // namespace gaitwright::words
