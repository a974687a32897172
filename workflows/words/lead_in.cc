// SPDX-License-Identifier: BSD-3-Clause
#include "workflows/words/lead_in.h"

#include <set>
#include <string>

namespace gaitwright::words {
namespace {

using Words = std::set<std::string>;

const Words& Wishes() {
  static const Words words = {
      "grateful",  "delighted", "obliged",   "appreciate", "love",     "like",     "glad",     "happy",   "pleased",
      "thankful",  "wonder",    "wondering", "hope",       "hoping",   "wish",     "want",     "wants",   "need",
      "needs",     "ask",       "asking",    "asked",      "beg",      "request",  "must",     "should",  "expect",
      "supposed",  "kind",      "good",      "mind",       "possible", "helpful",  "lovely",   "great",   "nice",
      "wonderful", "trouble",   "could",     "would",      "might",    "can",      "will",     "prefer",  "order",
      "command",   "instruct",  "recommend", "suggest",    "require",  "requires", "honoured", "honored", "fantastic",
      "brilliant", "super",     "awesome",   "perfect",    "best",     "better",   "invite",   "urge",    "tell",
      "telling",   "shall",     "i'd",       "we'd",       "you'd",    "please",   "i'll"};
  return words;
}

const Words& Around() {
  static const Words words = {
      "i",         "we",       "it",    "it'd", "it's",  "i'm",   "we're",  "we'll",   "a",      "be",
      "am",        "are",      "is",    "was",  "all",   "most",  "very",   "so",      "really", "ever",
      "if",        "whether",  "that",  "to",   "for",   "of",    "me",     "us",      "my",     "kindly",
      "just",      "perhaps",  "maybe", "now",  "have",  "do",    "does",   "too",     "much",   "quite",
      "here",      "what",     "then",  "next", "also",  "and",   "rather", "greatly", "truly",  "everyone",
      "everybody", "the",      "he",    "she",  "they",  "time",  "thing",  "only",    "simply", "well",
      "first",     "would've", "bit",   "dear", "robot", "today", "again",  "get",     "see",    "think"};
  return words;
}

/// Words that may follow "you".
const Words& After() {
  static const Words words = {"would",  "could", "might", "can",  "will", "should", "to",     "please", "just",
                              "kindly", "all",   "now",   "must", "may",  "also",   "simply", "go",     "first",
                              "then",   "shall", "ought", "need", "have", "mind",   "try",    "are",    "supposed"};
  return words;
}

}  // namespace

std::size_t LeadInAt(const std::vector<Piece>& pieces, std::size_t at) {
  constexpr std::size_t kLongest = 16;
  bool wishes = false;
  std::size_t end = at;
  for (std::size_t k = at; k < pieces.size() && k < at + kLongest; ++k) {
    const std::string& word = pieces[k].text;
    if (word == "you" && (wishes || (k > at && pieces[k - 1].text == "that"))) {
      end = k + 1;
      while (end < pieces.size() && After().contains(pieces[end].text)) ++end;
      // "you have three seconds", "are you to go", "you go": these words do not belong to the lead-in.
      while (end > k + 1 &&
             (pieces[end - 1].text == "have" || pieces[end - 1].text == "go" || pieces[end - 1].text == "are"))
        --end;
      k = end - 1;
      continue;
    }
    wishes = wishes || Wishes().contains(word);
    if (word != "you" && !Wishes().contains(word) && !Around().contains(word)) break;
  }
  return end - at;
}

}  // namespace gaitwright::words
