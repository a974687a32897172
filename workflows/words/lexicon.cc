// SPDX-License-Identifier: BSD-3-Clause
#include "workflows/words/lexicon.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "planning/plan/json_part_internal.h"
#include "workflows/words/lexicon_internal.h"
#include "workflows/words/pieces.h"

namespace gaitwright::words {
namespace {

/// Names in the order of Meaning.
const std::vector<std::string> kMeaningNames = {
    "action", "raise",  "lower", "put",     "direction", "side",   "sideways",  "both",   "arm",
    "foot",   "plural", "part",  "up",      "down",      "number", "amount",    "unit",   "ordinal",
    "place",  "stairs", "to",    "at",      "pace",      "gait",   "low",       "each",   "hold",
    "then",   "break",  "while", "before",  "after",     "no",     "not",       "forbid", "drop",
    "first",  "again",  "aside", "subject", "polite",    "filler", "elsewhere", "unknown"};

/// Names and values of the additional meanings of actions.
const std::vector<std::pair<std::string, double>> kSaid = {
    {"to_place", kToPlace},       {"beside", kBeside},   {"returns", kReturns},    {"up_stairs", kUpStairs},
    {"down_stairs", kDownStairs}, {"upwards", kUpwards}, {"downwards", kDownwards}};

double ReadSaid(const JsonPart& part) {
  std::vector<std::string> names;
  for (const auto& [name, value] : kSaid) names.push_back(name);
  return kSaid[static_cast<std::size_t>(part.Choice(names))].second;
}

Item ReadMeaning(const JsonPart& entry) {
  entry.Object({"means", "phrases"}, {"name", "value", "says", "parameters"});
  Item item;
  item.meaning = static_cast<Meaning>(entry.At("means").Choice(kMeaningNames));
  if (entry.Has("name")) item.name = entry.At("name").Text();
  if (entry.Has("value")) item.value = entry.At("value").Number();
  if (entry.Has("says")) item.value = ReadSaid(entry.At("says"));
  if (entry.Has("parameters")) {
    const JsonPart parameters = entry.At("parameters");
    for (const auto& [key, value] : parameters.json().items()) {
      if (value.is_number())
        item.parameters[key] = parameters.At(key).Number();
      else
        item.parameters[key] = parameters.At(key).Text();
    }
  }
  return item;
}

Lexicon ReadLexicon(const JsonPart& entries) {
  Lexicon lexicon;
  for (const JsonPart& entry : entries.List()) {
    const Item meaning = ReadMeaning(entry);
    const JsonPart phrases = entry.At("phrases");
    for (const JsonPart::Json& phrase : phrases.json()) {  // not by List, which makes a name for each of thousands
      if (!phrase.is_string()) phrases.Refuse("has an entry that is not a text");
      const auto& text = phrase.get_ref<const std::string&>();
      if (!lexicon.Add(text, meaning)) phrases.Refuse("has '" + text + "', which already has a meaning");
    }
  }
  return lexicon;
}

const Vocabulary& EnglishVocabulary() {
  static const Vocabulary vocabulary = ReadVocabulary(EnglishWordList());
  return vocabulary;
}

const Vocabulary& ChineseVocabulary() {
  static const Vocabulary vocabulary = ReadVocabulary(ChineseWordList());
  return vocabulary;
}

}  // namespace

bool Lexicon::Add(const std::string& phrase, const Item& meaning) {
  longest_ = std::max(longest_, PiecesOf(phrase).size());
  return items_.try_emplace(phrase, meaning).second;
}

const Item* Lexicon::Find(const std::string& phrase) const {
  const auto found = items_.find(phrase);
  return found == items_.end() ? nullptr : &found->second;
}

Vocabulary ReadVocabulary(std::string_view json) {
  const JsonPart::Json parsed = JsonPart::Json::parse(json);
  const JsonPart whole(parsed);
  whole.Object({"language", "words", "units"});
  return {ReadLexicon(whole.At("words")), ReadLexicon(whole.At("units"))};
}

const Lexicon& English() { return EnglishVocabulary().words; }
const Lexicon& Chinese() { return ChineseVocabulary().words; }
const Lexicon& EnglishUnits() { return EnglishVocabulary().units; }
const Lexicon& ChineseUnits() { return ChineseVocabulary().units; }

}  // namespace gaitwright::words
