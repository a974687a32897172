// SPDX-License-Identifier: BSD-3-Clause
#include "kinematics/base/nearest_name.h"

#include <gtest/gtest.h>

namespace gaitwright {
namespace {

/// The time for the distance of two words is proportional to the product of their lengths: with a million letters each,
/// it would take hours.
TEST(NearestName, OfWordsOfAnyLengthIsFoundAtOnce) {
  const std::string long_word(1000000, 'a');
  EXPECT_EQ(NearestName(long_word, {"b", long_word + "c", "d"}), long_word + "c");
  EXPECT_EQ(NearestName("lenght", {"width", "length", "height"}), "length");
  EXPECT_EQ(NearestName("word", {}), "");
}

TEST(NearestName, BeginsWithTheWordWhereOneDoes) {
  EXPECT_EQ(NearestName("rise", {"wise", "rise_m", "rising"}), "rise_m") << "'wise' is fewer letters away";
  EXPECT_EQ(NearestName("cycle", {"cyclic", "gait.cycle_s"}), "gait.cycle_s") << "behind the group's name too";
  EXPECT_EQ(NearestName("jerk", {"jerk_rad_s3", "jerk_m_s3"}), "jerk_m_s3") << "the one with less behind it";
}

TEST(NearestName, IsNoneWhereMoreThanHalfOfTheLettersDiffer) {
  EXPECT_EQ(NearestName("com-method", {"speed", "duration", "gait"}), "");
  EXPECT_EQ(NearestName("out", {"set", "log"}), "");
  EXPECT_EQ(NearestName("abcd", {"abxy"}), "abxy");
  EXPECT_EQ(NearestName("abcd", {"axyz"}), "");
  EXPECT_EQ(NearestName("", {"speed"}), "");
}

TEST(NearestName, LettersThatChangePlacesAreOneSlip) {
  EXPECT_EQ(NearestName("cvs", {"svg", "csv"}), "csv");
  EXPECT_EQ(NearestName("lgo", {"set", "log"}), "log");
}

TEST(NearestHint, GoesOnWithASentenceOrNotAtAll) {
  EXPECT_EQ(NearestHint("sped", {"speed", "steps"}), "; the nearest is 'speed'");
  EXPECT_EQ(NearestHint("jerk", {"jerk_rad_s3", "friction_nm", "jerk_m_s3"}),
            "; the nearest are 'jerk_rad_s3', 'jerk_m_s3'");
  EXPECT_EQ(NearestHint("kne", {"knee_side", "knee"}), "; the nearest is 'knee'") << "a slip";
  EXPECT_EQ(NearestHint("a", {"a1", "a2", "a3", "a4", "a5"}), "; the nearest is 'a1'") << "of many one is named";
  EXPECT_EQ(NearestHint("com-method", {"speed"}), "");
}

TEST(NearestHint, WhereNoneIsNearAllAreNamedOrWhatNamesThem) {
  EXPECT_EQ(NearestOrAll("sped", {"speed", "jerk"}, "see the list"), "; the nearest is 'speed'");
  EXPECT_EQ(NearestOrAll("xyz", {"speed", "jerk"}, "see the list"), "; accepted: 'speed', 'jerk'");
  EXPECT_EQ(NearestOrAll("xyz", {"speed"}), "; accepted: 'speed'");
  EXPECT_EQ(NearestOrAll("xyz", {}), "");
  const std::vector<std::string> many(17, "speed");
  EXPECT_EQ(NearestOrAll("xyz", many, "see the list"), "; see the list");
  EXPECT_EQ(NearestOrAll("xyz", many), "");
}

}  // namespace
}  // namespace gaitwright
