// SPDX-License-Identifier: BSD-3-Clause
// Reading of word lists, and refused lists.
#include "workflows/words/lexicon.h"

#include <gtest/gtest.h>

#include "kinematics/base/result.h"
#include "workflows/words/lexicon_internal.h"

namespace gaitwright::words {
namespace {

TEST(WordLists, HoldWhatTheFilesSay) {
  const Item* up = English().Find("climb");
  ASSERT_NE(up, nullptr);
  EXPECT_TRUE(up->Is(Meaning::kAction));
  EXPECT_EQ(up->name, "walk");
  EXPECT_EQ(up->value, kUpStairs);
  const Item* around = English().Find("turn around");
  ASSERT_NE(around, nullptr);
  EXPECT_EQ(std::get<std::string>(around->parameters.at("direction")), "left");
  EXPECT_EQ(std::get<double>(around->parameters.at("angle_deg")), 180.0);
  EXPECT_TRUE(English().Find("unless")->Is(Meaning::kUnknown));  // the last value of Meaning
  EXPECT_EQ(EnglishUnits().Find("km/h")->value, 1.0 / 3.6);
  EXPECT_EQ(English().Find("km/h"), nullptr);
  EXPECT_TRUE(Chinese().Find("挥手")->Is(Meaning::kAction));
  EXPECT_EQ(ChineseUnits().Find("尺")->value, 1.0 / 3.0);
  EXPECT_EQ(English().longest(), 7U);
  EXPECT_EQ(Chinese().longest(), 9U);
}

TEST(WordLists, AreRefusedWhereTheyAreWrong) {
  const auto read = [](const std::string& words) {
    return ReadVocabulary(R"({"language": "English", "units": [], "words": [)" + words + "]}");
  };
  EXPECT_NO_THROW(read(R"({"means": "to", "phrases": ["to", "towards"]})"));
  for (const char* wrong : {R"({"means": "too", "phrases": ["to"]})", R"({"means": "to", "phrases": ["to", "to"]})",
                            R"({"means": "to", "phrases": ["to"]}, {"means": "at", "phrases": ["to"]})",
                            R"({"means": "to", "phrases": [1]})", R"({"means": "to"})",
                            R"({"means": "to", "phrases": ["to"], "colour": "red"})",
                            R"({"means": "action", "says": "elsewhere", "phrases": ["go"]})",
                            R"({"means": "action", "parameters": {"pace": []}, "phrases": ["go"]})"})
    EXPECT_THROW(read(wrong), InvalidArgument) << wrong;
}

}  // namespace
}  // namespace gaitwright::words
