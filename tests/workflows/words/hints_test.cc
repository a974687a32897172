// SPDX-License-Identifier: BSD-3-Clause
// Suggestions of other words in refusals.
#include "workflows/words/hints.h"

#include <gtest/gtest.h>

#include "tests/workflows/words/corpus.h"

namespace gaitwright::words {
namespace {

using Hints = std::vector<std::string>;

Hints TextsOf(const std::vector<Suggestion>& suggestions) {
  Hints texts;
  for (const Suggestion& suggestion : suggestions) texts.push_back(suggestion.text);
  return texts;
}

Suggestion Flag(const std::string& flag, double value) { return {flag, value, Certainty::kPlanned, "--" + flag}; }

TEST(Hints, FlagsBecomeWords) {
  const auto said = [](const std::vector<Suggestion>& suggestions, int footfalls = 1) {
    return TextsOf(SuggestionsInWords(suggestions, footfalls));
  };
  EXPECT_EQ(said({Flag("speed", 0.4), "another gait"}), (Hints{"say 'at 0.4 m/s' or slower", "another gait"}));
  EXPECT_EQ(said({Flag("lateral-speed", -0.2)}), Hints{"say 'at 0.2 m/s' or slower"});
  EXPECT_EQ(said({Flag("step-length", 0.05)}), Hints{"say 'steps of 0.05 m' or shorter"});
  EXPECT_EQ(said({Flag("step-length", -0.05)}, 4), Hints{"say 'steps of 0.2 m' or shorter"});
  EXPECT_EQ(said({Flag("yaw-rate", 0.5)}), Hints{});  // no words set the yaw rate
  const Suggestion option{"pipeline.allow_limits", "true", Certainty::kUntried, "--set pipeline.allow_limits=true"};
  EXPECT_EQ(said({option}), Hints{option.text});
}

TEST(Hints, ThePlacesThatThereAreAreNamed) {
  TaskScope scope = CorpusScope("nao");
  scope.places = {{"door", 0}, {"step", 3}};
  const Refusal refusal{FailureCode::kPlace, "kitchen", "is not a known place", ""};
  EXPECT_EQ(TextsOf(FailureOf(refusal, scope).suggestions), Hints{"a place of this ground: 'door', 'step' (1 to 3)"});
  scope.places.clear();
  EXPECT_NE(FailureOf(refusal, scope).suggestions.at(0).text.find("--terrain"), std::string::npos);
}

TEST(Hints, WhatIsSaidInsteadComesAlone) {
  Refusal refusal{FailureCode::kAmbiguous, "turn", "does not give the direction", "", "left or right"};
  EXPECT_EQ(TextsOf(FailureOf(refusal, CorpusScope("nao")).suggestions), Hints{"left or right"});
  EXPECT_EQ(FailureOf(refusal, CorpusScope("nao")).message, "'turn' does not give the direction");
  refusal.is_sentence = true;
  EXPECT_EQ(FailureOf(refusal, CorpusScope("nao")).message, "'turn': does not give the direction");
}

}  // namespace
}  // namespace gaitwright::words
