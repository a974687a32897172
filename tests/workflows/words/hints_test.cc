// SPDX-License-Identifier: BSD-3-Clause
// What a refusal tells a person to say instead.
#include "workflows/words/hints.h"

#include <gtest/gtest.h>

#include "tests/workflows/words/corpus.h"

namespace gaitwright::words {
namespace {

using Hints = std::vector<std::string>;

TEST(Hints, FlagsBecomeWords) {
  EXPECT_EQ(HintsInWords({"--speed 0.4", "another gait"}, 1), (Hints{"say 'at 0.4 m/s' or slower", "another gait"}));
  EXPECT_EQ(HintsInWords({"--lateral-speed -0.2"}, 1), Hints{"say 'at 0.2 m/s' or slower"});
  EXPECT_EQ(HintsInWords({"--step-length 0.05"}, 1), Hints{"say 'steps of 0.05 m' or shorter"});
  EXPECT_EQ(HintsInWords({"--step-length -0.05"}, 4), Hints{"say 'steps of 0.2 m' or shorter"});
  EXPECT_EQ(HintsInWords({"--yaw-rate 0.5"}, 1), Hints{});  // nothing says how fast to turn
  EXPECT_EQ(HintsInWords({"--set pipeline.allow_limits=true gives the plan all the same"}, 1).size(), 1U);
}

TEST(Hints, ThePlacesThatThereAreAreNamed) {
  TaskScope scope = CorpusScope("nao");
  scope.places = {{"door", 0}, {"step", 3}};
  const Refusal refusal{"place", "kitchen", "is no place that is known here", ""};
  EXPECT_EQ(FailureOf(refusal, scope).hints, Hints{"a place of this ground: 'door', 'step' (1 to 3)"});
  scope.places.clear();
  EXPECT_NE(FailureOf(refusal, scope).hints.at(0).find("--terrain"), std::string::npos);
}

TEST(Hints, WhatIsSaidInsteadComesAlone) {
  const Refusal refusal{"ambiguous", "turn", "does not say the direction", "", "left or right"};
  EXPECT_EQ(FailureOf(refusal, CorpusScope("nao")).hints, Hints{"left or right"});
  EXPECT_EQ(FailureOf(refusal, CorpusScope("nao")).message, "'turn' does not say the direction");
}

}  // namespace
}  // namespace gaitwright::words
