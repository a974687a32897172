// SPDX-License-Identifier: BSD-3-Clause
#include "workflows/words/numbers.h"

#include <gtest/gtest.h>

#include <array>
#include <string>

namespace gaitwright::words {
namespace {

/// The number in a text, the number of its pieces, and whether it is only an article.
struct Spoken {
  std::string text;
  double value;
  std::size_t pieces;
  bool is_article = false;
};

void ExpectSpoken(const Spoken& spoken, const SpokenNumber& number) {
  EXPECT_EQ(number.pieces, spoken.pieces) << spoken.text;
  EXPECT_NEAR(number.value, spoken.value, 1e-12) << spoken.text;
  EXPECT_EQ(number.is_article, spoken.is_article) << spoken.text;
}

class NumbersInWords : public testing::TestWithParam<Spoken> {};

TEST_P(NumbersInWords, AreReadUpToWhereTheyEnd) { ExpectSpoken(GetParam(), NumberAt(PiecesOf(GetParam().text), 0)); }

INSTANTIATE_TEST_SUITE_P(Digits, NumbersInWords,
                         testing::Values(Spoken{"3 steps", 3, 1}, Spoken{"0.25", 0.25, 1}, Spoken{"1.5e3", 1500, 1},
                                         Spoken{"3 million", 3e6, 2}, Spoken{"5万", 5e4, 2},
                                         Spoken{"2 hundred thousand", 2e5, 3}, Spoken{"-2", -2, 2},
                                         Spoken{"minus 2", -2, 2}, Spoken{"2 and a half metres", 2.5, 4},
                                         Spoken{"2 and a quarter", 2.25, 4}, Spoken{"2 and turn", 2, 1},
                                         Spoken{"-walk", 0, 0}));
INSTANTIATE_TEST_SUITE_P(
    English, NumbersInWords,
    testing::Values(Spoken{"zero", 0, 1}, Spoken{"seventeen steps", 17, 1}, Spoken{"twenty-five", 25, 1},
                    Spoken{"twenty five", 25, 2}, Spoken{"two three", 2, 1}, Spoken{"twenty ten", 20, 1},
                    Spoken{"one hundred and five", 105, 4}, Spoken{"two thousand three hundred", 2300, 4},
                    Spoken{"a hundred", 100, 2}, Spoken{"hundred", 0, 0}, Spoken{"dozen", 12, 1},
                    Spoken{"two dozen", 24, 2}, Spoken{"half a dozen", 6, 3}, Spoken{"three point one four", 3.14, 4},
                    Spoken{"minus two and a half", -2.5, 5}, Spoken{"negative ten", -10, 2},
                    Spoken{"a couple of steps", 2, 3}, Spoken{"couple", 2, 1}, Spoken{"a few", 3, 2},
                    Spoken{"half a metre", 0.5, 2}, Spoken{"a half", 0.5, 2}, Spoken{"a quarter of a", 0.25, 4},
                    Spoken{"three quarters of a", 0.75, 4}, Spoken{"steps", 0, 0}, Spoken{"and", 0, 0}));
INSTANTIATE_TEST_SUITE_P(Articles, NumbersInWords,
                         testing::Values(Spoken{"a metre", 1, 1, true}, Spoken{"an hour", 1, 1, true},
                                         Spoken{"one metre", 1, 1, true}, Spoken{"one and a half", 1.5, 4, false},
                                         Spoken{"one hundred", 100, 2, false}));
INSTANTIATE_TEST_SUITE_P(Chinese, NumbersInWords,
                         testing::Values(Spoken{"三步", 3, 1}, Spoken{"十五", 15, 2}, Spoken{"二十", 20, 2},
                                         Spoken{"两百零五", 205, 4}, Spoken{"一千二百三十四万", 12340000, 8},
                                         Spoken{"一亿零三万", 100030000, 5}, Spoken{"一二三", 123, 3},
                                         Spoken{"万", 1e4, 1}, Spoken{"负三百二十", -320, 5}, Spoken{"一点五", 1.5, 3},
                                         Spoken{"三点一四", 3.14, 4}, Spoken{"一点头", 1, 1}, Spoken{"半米", 0.5, 1},
                                         Spoken{"几步", 3, 1}, Spoken{"四分之三", 0.75, 4}, Spoken{"三分钟", 3, 1},
                                         Spoken{"走", 0, 0}));

TEST(Numbers, AreReadFromAnyPieceAndNoneBehindTheLast) {
  const std::vector<Piece> pieces = PiecesOf("walk three steps");
  EXPECT_EQ(NumberAt(pieces, 0).pieces, 0U);
  EXPECT_EQ(NumberAt(pieces, 1).value, 3.0);
  EXPECT_EQ(NumberAt(pieces, 3).pieces, 0U);
  EXPECT_EQ(NumberAt({}, 0).pieces, 0U);
  EXPECT_EQ(AfterUnit(pieces, 3).pieces, 0U);
}

/// Digits and the words of both languages give the same whole numbers.
TEST(Numbers, DigitsEnglishAndChineseAgreeUpToNinetyNine) {
  const std::array<const char*, 10> ones = {"", "one", "two", "three", "four", "five", "six", "seven", "eight", "nine"};
  const std::array<const char*, 10> tens = {"",      "",      "twenty",  "thirty", "forty",
                                            "fifty", "sixty", "seventy", "eighty", "ninety"};
  const std::array<const char*, 10> han = {"", "一", "二", "三", "四", "五", "六", "七", "八", "九"};
  for (std::size_t n = 20; n < 100; ++n) {
    const std::size_t ten = n / 10, one = n % 10;
    const std::string english = one == 0 ? tens[ten] : std::string(tens[ten]) + "-" + ones[one];
    const std::string chinese = std::string(han[ten]) + "十" + han[one];
    for (const std::string& text : {english, chinese, std::to_string(n)}) {
      const std::vector<Piece> pieces = PiecesOf(text);
      EXPECT_EQ(NumberAt(pieces, 0).value, static_cast<double>(n)) << text;
      EXPECT_EQ(NumberAt(pieces, 0).pieces, pieces.size()) << text;
    }
  }
}

class SharesAfterAUnit : public testing::TestWithParam<Spoken> {};

TEST_P(SharesAfterAUnit, AddToTheNumberBefore) { ExpectSpoken(GetParam(), AfterUnit(PiecesOf(GetParam().text), 1)); }

INSTANTIATE_TEST_SUITE_P(Words, SharesAfterAUnit,
                         testing::Values(Spoken{"metre and a half", 0.5, 3}, Spoken{"metre and a quarter", 0.25, 3},
                                         Spoken{"metre and three quarters", 0.75, 3}, Spoken{"metre and turn", 0, 0},
                                         Spoken{"metre twenty", 0.2, 1}, Spoken{"metre twenty, turn", 0.2, 1},
                                         Spoken{"metre twenty degrees", 0, 0}, Spoken{"metre five", 0, 0},
                                         Spoken{"metre", 0, 0}, Spoken{"米半", 0.5, 1}, Spoken{"米二", 0.2, 1},
                                         Spoken{"米二，转", 0.2, 1}, Spoken{"米二十", 0, 0}, Spoken{"米三步", 0, 0},
                                         Spoken{"米两", 0, 0}));

}  // namespace
}  // namespace gaitwright::words
