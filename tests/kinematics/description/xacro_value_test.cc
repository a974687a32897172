// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>
#include <limits>

#include "tests/kinematics/description/xacro_values.h"

namespace gaitwright {
namespace {

std::string PrintedAlone(const XacroValue& value) {
  XacroBudget budget;
  return XacroPrinted(value, budget);
}

TEST(XacroValue, PrintsAsPythonsStr) {
  EXPECT_EQ(PrintedAlone({}), "None");
  EXPECT_EQ(PrintedAlone({true}), "True");
  EXPECT_EQ(PrintedAlone(WholeValue(std::numeric_limits<std::int64_t>::min())), "-9223372036854775808");
  EXPECT_EQ(PrintedAlone(TextValue("it's")), "it's");
  EXPECT_EQ(PrintedAlone(ListValue({})), "[]");
  EXPECT_EQ(PrintedAlone(DictValue({})), "{}");
  EXPECT_EQ(PrintedAlone(DictValue({{TextValue("k"), ListValue({{}, TextValue("v")})}})), "{'k': [None, 'v']}");
}

TEST(XacroValue, RealNumbersChangeTheirFormWherePythonDoes) {
  const std::vector<std::pair<double, std::string>> rows = {{0.0001, "0.0001"},
                                                            {0.00009999, "9.999e-05"},
                                                            {9999999999999998.0, "9999999999999998.0"},
                                                            {1e16, "1e+16"},
                                                            {-0.0, "-0.0"},
                                                            {1e100, "1e+100"},
                                                            {std::numeric_limits<double>::infinity(), "inf"},
                                                            {-std::numeric_limits<double>::infinity(), "-inf"},
                                                            {std::nan(""), "nan"}};
  for (const auto& [number, printed] : rows) EXPECT_EQ(PrintedAlone(RealValue(number)), printed);
}

TEST(XacroValue, TextsInListsHaveTheQuotesOfRepr) {
  EXPECT_EQ(ReprOf(TextValue("a")), "'a'");
  EXPECT_EQ(ReprOf(TextValue("it's")), "\"it's\"");
  EXPECT_EQ(ReprOf(TextValue("'\"")), "'\\'\"'");
  EXPECT_EQ(ReprOf(TextValue("a\\b\nc")), "'a\\\\b\\nc'");
  EXPECT_EQ(ReprOf(TextValue("\t\r")), "'\\t\\r'");
}

TEST(XacroValue, EqualityGoesByValueAndKeepsTextsApart) {
  XacroBudget budget;
  const std::vector<XacroValue> ones = {WholeValue(1), RealValue(1.0), {true}};
  for (const XacroValue& a : ones) {
    for (const XacroValue& b : ones) EXPECT_TRUE(XacroEqual(a, b, budget));
    EXPECT_FALSE(XacroEqual(a, TextValue("1"), budget));
    EXPECT_FALSE(XacroEqual(a, ListValue({a}), budget));
    EXPECT_FALSE(XacroEqual(a, {}, budget));
  }
  EXPECT_TRUE(XacroEqual({}, {}, budget));
  // As doubles these two are the same.
  EXPECT_FALSE(XacroEqual(WholeValue(9007199254740993), WholeValue(9007199254740992), budget));
}

TEST(XacroValue, DictionariesAreEqualInAnyOrder) {
  XacroBudget budget;
  const XacroValue a = DictValue({{TextValue("x"), WholeValue(1)}, {TextValue("y"), WholeValue(2)}});
  const XacroValue b = DictValue({{TextValue("y"), RealValue(2.0)}, {TextValue("x"), WholeValue(1)}});
  const XacroValue c = DictValue({{TextValue("x"), WholeValue(1)}, {TextValue("z"), WholeValue(2)}});
  const XacroValue d = DictValue({{TextValue("x"), WholeValue(1)}});
  EXPECT_TRUE(XacroEqual(a, b, budget));
  EXPECT_FALSE(XacroEqual(a, c, budget));
  EXPECT_FALSE(XacroEqual(a, d, budget));
  EXPECT_FALSE(XacroEqual(d, a, budget));
}

TEST(XacroValue, AKeyThatAppearsTwiceKeepsItsPlaceAndTakesTheLastValue) {
  const XacroValue dict = DictValue({{WholeValue(1), TextValue("a")}, {TextValue("k"), {}}, {{true}, TextValue("b")}});
  EXPECT_EQ(PrintedAlone(dict), "{1: 'b', 'k': None}");
  XacroBudget budget;
  ASSERT_NE(dict.dict()->Find(RealValue(1.0), budget), nullptr);
  EXPECT_EQ(dict.dict()->Find(TextValue("1"), budget), nullptr);
}

TEST(XacroValue, AListIsNoKey) {
  const XacroProblem problem = ProblemOf([] { DictValue({{ListValue({}), {}}}); });
  EXPECT_EQ(problem.code, FailureCode::kXacroType);
  EXPECT_NE(problem.message.find("list"), std::string::npos);
}

TEST(XacroValue, EmptyValuesAndZerosAreFalse) {
  for (const XacroValue& value :
       {XacroValue{}, XacroValue{false}, WholeValue(0), RealValue(-0.0), TextValue(""), ListValue({}), DictValue({})})
    EXPECT_FALSE(XacroTruth(value)) << PrintedAlone(value);
  for (const XacroValue& value : {WholeValue(-1), RealValue(std::nan("")), TextValue("0"), TextValue(" "),
                                  ListValue({{}}), DictValue({{{}, {}}})})
    EXPECT_TRUE(XacroTruth(value)) << PrintedAlone(value);
}

TEST(XacroValue, ReadsNumbersOfTextsAsPythonDoes) {
  EXPECT_EQ(XacroWholeOf(" +12\n"), 12);
  EXPECT_EQ(XacroWholeOf("-9223372036854775808"), std::numeric_limits<std::int64_t>::min());
  for (const char* text : {"", " ", "+", "+-1", "++1", "1.0", "1e3", "0x10", "1 2", "9223372036854775808", "1a"})
    EXPECT_EQ(XacroWholeOf(text), std::nullopt) << text;
  EXPECT_EQ(XacroRealOf(" 1e3 "), 1000.0);
  EXPECT_EQ(XacroRealOf("+.5"), 0.5);
  EXPECT_EQ(XacroRealOf("-inf"), -std::numeric_limits<double>::infinity());
  EXPECT_TRUE(std::isnan(XacroRealOf("nan").value_or(0.0)));
  for (const char* text : {"", "+", "+-1", "1e", "1.2.3", "0x1p3", "nan(1)", "1,5", "1 m"})
    EXPECT_EQ(XacroRealOf(text), std::nullopt) << text;
}

TEST(XacroValue, NumbersBeyondTheRangeOfDoublesAreInfiniteOrZero) {
  constexpr double kInfinite = std::numeric_limits<double>::infinity();
  EXPECT_EQ(XacroRealOf("1e400"), kInfinite);
  EXPECT_EQ(XacroRealOf("-1E+400"), -kInfinite);
  EXPECT_EQ(XacroRealOf("1e-400"), 0.0);
  EXPECT_EQ(XacroRealOf(std::string(350, '9')), kInfinite);
  EXPECT_EQ(XacroRealOf("0." + std::string(350, '0') + "1"), 0.0);
  EXPECT_EQ(XacroRealOf(std::string(350, '9') + ".5e-2"), kInfinite);
  EXPECT_EQ(XacroRealOf("0." + std::string(350, '0') + "1e2"), 0.0);
  EXPECT_TRUE(std::signbit(XacroRealOf("-1e-400").value_or(1.0)));
}

TEST(XacroValue, ALiteralIsTheNumberTruthValueOrTextThatItsTextStandsFor) {
  const std::vector<std::pair<std::string, std::string>> rows = {{"2", "2"},
                                                                 {"2.0", "2.0"},
                                                                 {" 2 ", "2"},
                                                                 {"True", "True"},
                                                                 {"false", "False"},
                                                                 {"TRUE", "'TRUE'"},
                                                                 {"'2'", "'2'"},
                                                                 {"''", "''"},
                                                                 {"'", "\"'\""},
                                                                 {"1 2", "'1 2'"},
                                                                 {"", "''"},
                                                                 {"None", "'None'"},
                                                                 {"'a' 'b'", "\"a' 'b\""}};
  for (const auto& [text, repr] : rows) EXPECT_EQ(ReprOf(XacroLiteral(text)), repr) << text;
}

TEST(XacroBudget, EachBoundIsItsOwnAndTheLastUnitIsAllowed) {
  XacroBudget budget;
  budget.Spend(5000000);
  EXPECT_EQ(ProblemOf([&] { budget.Spend(1); }).code, FailureCode::kXacroLimit);
  budget.Write(std::size_t{64} << 20);
  EXPECT_EQ(ProblemOf([&] { budget.Write(1); }).code, FailureCode::kXacroLimit);
  for (int i = 0; i < 1000000; ++i) budget.Visit();
  EXPECT_EQ(ProblemOf([&] { budget.Visit(); }).code, FailureCode::kXacroLimit);
}

TEST(XacroBudget, ALevelThatEndsIsGivenBack) {
  XacroBudget budget;
  for (int i = 0; i < 1000; ++i) const XacroBudget::Level level(budget);
  std::vector<std::unique_ptr<XacroBudget::Level>> levels;
  for (int i = 0; i < 400; ++i) levels.push_back(std::make_unique<XacroBudget::Level>(budget));
  EXPECT_EQ(ProblemOf([&] { const XacroBudget::Level one_more(budget); }).code, FailureCode::kXacroLimit);
  levels.pop_back();
  EXPECT_NO_THROW(const XacroBudget::Level again(budget));
}

TEST(XacroBudget, NestedListsAreBoundedByTheirDepth) {
  XacroValue nested = WholeValue(1);
  for (int i = 0; i < kDeepestXacroValue; ++i) nested = ListValue({nested});
  EXPECT_EQ(nested.list()->depth, kDeepestXacroValue);
  EXPECT_EQ(ProblemOf([&] { ListValue({nested}); }).code, FailureCode::kXacroLimit);
  EXPECT_EQ(ProblemOf([&] { DictValue({{WholeValue(1), nested}}); }).code, FailureCode::kXacroLimit);
  EXPECT_EQ(ProblemOf([] { XacroText(std::string(kLongestXacroText + 1, 'a')); }).code, FailureCode::kXacroLimit);
}

}  // namespace
}  // namespace gaitwright
