// SPDX-License-Identifier: BSD-3-Clause
#include "cli/numbers.h"

#include <gtest/gtest.h>

#include "cli/word_list.h"
#include "kinematics/base/result.h"

namespace gaitwright::cli {
namespace {

using NumberWords = std::vector<std::string>;

TEST(CliNumbers, FiniteNumbersAreAcceptedInEveryUsualSpelling) {
  for (const char* text : {"0", "-1.5", "+2", "1e-3", "1E5", ".5", "5.", "-0"}) EXPECT_EQ(NotANumber(text), "") << text;
}

TEST(CliNumbers, WhatIsNoFiniteNumberIsQuoted) {
  for (const std::string text :
       {"", "fast", "1m", "1,5", "nan", "inf", "-inf", "1e999", "+-1", " 1", "1 ", "0x10", "--1"})
    EXPECT_EQ(NotANumber(text), "'" + text + "' is not a finite number");
}

TEST(CliNumbers, WholeNumbersHaveBothLimits) {
  EXPECT_EQ(NotAWholeNumber("3", 1, 5), "");
  EXPECT_EQ(NotAWholeNumber("1", 1, 5), "");
  EXPECT_EQ(NotAWholeNumber("5", 1, 5), "");
  EXPECT_EQ(NotAWholeNumber("+5", 1, 5), "");
  EXPECT_EQ(NotAWholeNumber("0", 1, 5), "0 is too small; accepted: 1 or more");
  EXPECT_EQ(NotAWholeNumber("6", 1, 5), "6 is too large; accepted: 1 to 5");
  for (const std::string text : {"2.0", "1e3", "", "two", "3x"})
    EXPECT_EQ(NotAWholeNumber(text, 1, 5), "'" + text + "' is not a whole number");
}

TEST(CliNumbers, NumbersBeyondTheMachinesAreTooLargeOrTooSmall) {
  const std::string huge = "99999999999999999999";
  EXPECT_EQ(NotAWholeNumber(huge, 0), huge + " is too large; accepted: 0 to 9223372036854775807");
  EXPECT_EQ(NotAWholeNumber("-" + huge, 0), "-" + huge + " is too small; accepted: 0 or more");
  EXPECT_EQ(NotAWholeNumber("9223372036854775807", 0), "");
}

std::string RefusalOfNumbers(const std::string& text, std::size_t count) {
  try {
    ParseNumbers("--push", text, count);
  } catch (const InvalidArgument& error) {
    return error.what();
  }
  return "nothing was refused";
}

TEST(CliNumbers, ListsHaveAsManyNumbersAsAreNeeded) {
  EXPECT_EQ(ParseNumbers("--push", "1,-2.5,1e2", 3), (std::vector<double>{1.0, -2.5, 100.0}));
  EXPECT_EQ(ParseNumbers("--push", "7", 1), std::vector<double>{7.0});
  EXPECT_EQ(RefusalOfNumbers("1,2", 3), "--push: expects 3 numbers separated by commas; '1,2' has 2");
  EXPECT_EQ(RefusalOfNumbers("1,2,3,", 3), "--push: expects 3 numbers separated by commas; '1,2,3,' has 3");
  EXPECT_EQ(RefusalOfNumbers("1,,3", 3), "--push: '' is not a finite number");
  EXPECT_EQ(RefusalOfNumbers("1,x,3", 3), "--push: 'x' is not a finite number");
  EXPECT_EQ(RefusalOfNumbers("", 2), "--push: expects 2 numbers separated by commas; '' has 0");
}

TEST(CliNumbers, PartsBetweenCommasAreThoseThatWereJoined) {
  EXPECT_EQ(SplitAtCommas("a,b,c"), (NumberWords{"a", "b", "c"}));
  EXPECT_EQ(SplitAtCommas("a,,c"), (NumberWords{"a", "", "c"}));
  EXPECT_EQ(SplitAtCommas("a,"), NumberWords{"a"}) << "no part begins with the last comma";
  EXPECT_EQ(SplitAtCommas(""), NumberWords{});
  for (const NumberWords& words : {NumberWords{"a"}, NumberWords{"a", "b c", "d"}, NumberWords{}})
    EXPECT_EQ(SplitAtCommas(JoinWords(words, ",")), words);
  EXPECT_EQ(JoinWords({"x", "x"}, " or "), "x or x");
}

}  // namespace
}  // namespace gaitwright::cli
