// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>
#include <limits>

#include "tests/kinematics/description/xacro_values.h"

namespace gaitwright {
namespace {

constexpr std::int64_t kLeastWhole = std::numeric_limits<std::int64_t>::min();
constexpr std::int64_t kMostWhole = std::numeric_limits<std::int64_t>::max();

XacroValue Joined(const XacroValue& a, const std::string& operation, const XacroValue& b) {
  XacroBudget budget;
  return XacroArithmetic(operation, a, b, budget);
}

bool Holds(const XacroValue& a, const std::string& operation, const XacroValue& b) {
  XacroBudget budget;
  return XacroCompared(operation, a, b, budget);
}

FailureCode CodeOfJoining(const XacroValue& a, const std::string& operation, const XacroValue& b) {
  return ProblemOf([&] { Joined(a, operation, b); }).code;
}

// In Python, a == (a // b) * b + a % b, and the remainder has the sign of b and is smaller than b.
TEST(XacroArithmetic, QuotientAndRemainderBelongTogether) {
  for (std::int64_t a = -7; a <= 7; ++a) {
    for (const std::int64_t b : {-3, -2, -1, 1, 2, 3}) {
      const std::int64_t quotient = *Joined(WholeValue(a), "//", WholeValue(b)).whole();
      const std::int64_t rest = *Joined(WholeValue(a), "%", WholeValue(b)).whole();
      EXPECT_EQ(quotient * b + rest, a);
      EXPECT_LT(std::abs(rest), std::abs(b));
      EXPECT_TRUE(rest == 0 || (rest < 0) == (b < 0));
      const double x = 0.5 * static_cast<double>(a), y = 0.5 * static_cast<double>(b);  // halves are exact
      EXPECT_EQ(XacroNumber(Joined(RealValue(x), "//", RealValue(y))), static_cast<double>(quotient));
      EXPECT_EQ(XacroNumber(Joined(RealValue(x), "%", RealValue(y))), 0.5 * static_cast<double>(rest));
    }
  }
  EXPECT_EQ(ReprOf(Joined(RealValue(1.0), "//", RealValue(0.1))), "9.0");
  EXPECT_EQ(ReprOf(Joined(RealValue(-0.0), "%", RealValue(1.0))), "0.0");
}

TEST(XacroArithmetic, WholeNumbersStayWholeButForDivision) {
  EXPECT_EQ(ReprOf(Joined(WholeValue(6), "/", WholeValue(3))), "2.0");
  EXPECT_EQ(ReprOf(Joined(WholeValue(6), "*", RealValue(1.0))), "6.0");
  EXPECT_EQ(ReprOf(Joined({true}, "+", {true})), "2");
  EXPECT_EQ(ReprOf(Joined(WholeValue(7), "%", WholeValue(-1))), "0");
  EXPECT_EQ(ReprOf(Joined(WholeValue(9007199254740993), "+", WholeValue(0))), "9007199254740993");
}

TEST(XacroArithmetic, PowersOfWholeNumbersAreExact) {
  EXPECT_EQ(ReprOf(Joined(WholeValue(3), "**", WholeValue(39))), "4052555153018976267");
  EXPECT_EQ(ReprOf(Joined(WholeValue(-2), "**", WholeValue(63))), "-9223372036854775808");
  EXPECT_EQ(ReprOf(Joined(WholeValue(0), "**", WholeValue(0))), "1");
  EXPECT_EQ(ReprOf(Joined(WholeValue(0), "**", WholeValue(kMostWhole))), "0");
  EXPECT_EQ(ReprOf(Joined(WholeValue(-1), "**", WholeValue(kMostWhole))), "-1");
  EXPECT_EQ(ReprOf(Joined(WholeValue(2), "**", WholeValue(-2))), "0.25");
  EXPECT_EQ(ReprOf(Joined(WholeValue(4), "**", RealValue(0.5))), "2.0");
}

TEST(XacroArithmetic, RefusesNumbersThatDoNotFitAndDivisionsByZero) {
  const XacroValue zero = WholeValue(0), one = WholeValue(1), most = WholeValue(kMostWhole),
                   least = WholeValue(kLeastWhole), minus = WholeValue(-1);
  EXPECT_EQ(CodeOfJoining(most, "+", one), FailureCode::kXacroNumber);
  EXPECT_EQ(CodeOfJoining(least, "-", one), FailureCode::kXacroNumber);
  EXPECT_EQ(CodeOfJoining(least, "*", minus), FailureCode::kXacroNumber);
  EXPECT_EQ(CodeOfJoining(least, "//", minus), FailureCode::kXacroNumber);
  EXPECT_EQ(CodeOfJoining(WholeValue(2), "**", WholeValue(63)), FailureCode::kXacroNumber);
  EXPECT_EQ(CodeOfJoining(zero, "**", minus), FailureCode::kXacroNumber);
  EXPECT_EQ(CodeOfJoining(RealValue(-8.0), "**", RealValue(0.5)), FailureCode::kXacroNumber);
  EXPECT_EQ(CodeOfJoining(RealValue(1e200), "**", WholeValue(2)), FailureCode::kXacroNumber);
  for (const char* operation : {"/", "//", "%"}) {
    EXPECT_EQ(CodeOfJoining(one, operation, zero), FailureCode::kXacroNumber) << operation;
    EXPECT_EQ(CodeOfJoining(one, operation, RealValue(0.0)), FailureCode::kXacroNumber) << operation;
  }
  EXPECT_EQ(ReprOf(Joined(least, "%", minus)), "0");
}

TEST(XacroArithmetic, TextsAndListsAreJoinedAndRepeated) {
  const XacroValue list = ListValue({WholeValue(1), TextValue("a")});
  EXPECT_EQ(ReprOf(Joined(list, "+", ListValue({{}}))), "[1, 'a', None]");
  EXPECT_EQ(ReprOf(Joined(WholeValue(2), "*", list)), "[1, 'a', 1, 'a']");
  EXPECT_EQ(ReprOf(Joined(TextValue("ab"), "*", WholeValue(-1))), "''");
  EXPECT_EQ(ReprOf(Joined(TextValue("ab"), "*", {true})), "'ab'");
  EXPECT_EQ(ReprOf(Joined(list, "*", WholeValue(0))), "[]");
  EXPECT_EQ(ReprOf(list), "[1, 'a']");
  EXPECT_EQ(CodeOfJoining(TextValue("ab"), "*", WholeValue(kMostWhole)), FailureCode::kXacroLimit);
  EXPECT_EQ(CodeOfJoining(TextValue(""), "*", RealValue(2.0)), FailureCode::kXacroType);
  EXPECT_EQ(CodeOfJoining(list, "+", TextValue("a")), FailureCode::kXacroType);
  EXPECT_EQ(CodeOfJoining({}, "+", WholeValue(1)), FailureCode::kXacroType);
}

TEST(XacroArithmetic, FormatsTakeTheirValuesInOrder) {
  const auto formatted = [](const std::string& format, const XacroValue& value) {
    return ReprOf(Joined(TextValue(format), "%", value));
  };
  EXPECT_EQ(formatted("%s-%s", ListValue({WholeValue(1), TextValue("a")})), "'1-a'");
  EXPECT_EQ(formatted("%03d|%-4s|%4s|", ListValue({WholeValue(7), TextValue("l"), TextValue("r")})),
            "'007|l   |   r|'");
  EXPECT_EQ(formatted("%+.2e", RealValue(1234.5)), "'+1.23e+03'");
  EXPECT_EQ(formatted("%d", RealValue(-2.7)), "'-2'");
  EXPECT_EQ(formatted("%.2s", TextValue("abc")), "'ab'");
  EXPECT_EQ(formatted("%x %X", ListValue({WholeValue(255), WholeValue(255)})), "'ff FF'");
  EXPECT_EQ(formatted("100%% of %g", RealValue(0.5)), "'100% of 0.5'");
  EXPECT_EQ(formatted("%s", {}), "'None'");
  for (const char* wrong : {"%d", "%f", "%c", "%", "%s %s", "none"})
    EXPECT_EQ(CodeOfJoining(TextValue(wrong), "%", TextValue("a")), FailureCode::kXacroType) << wrong;
  EXPECT_EQ(CodeOfJoining(TextValue("%100d"), "%", WholeValue(1)), FailureCode::kXacroLimit);
  EXPECT_EQ(CodeOfJoining(TextValue("%d"), "%", RealValue(1e300)), FailureCode::kXacroType);
  EXPECT_EQ(CodeOfJoining(TextValue("%x"), "%", WholeValue(-255)), FailureCode::kXacroType) << "no two's complement";
}

TEST(XacroCompared, OrdersNumbersTextsAndLists) {
  EXPECT_TRUE(Holds(WholeValue(9007199254740992), "<", WholeValue(9007199254740993)));
  EXPECT_TRUE(Holds({false}, "<", RealValue(0.5)));
  EXPECT_TRUE(Holds(TextValue("Z"), "<", TextValue("a")));
  EXPECT_TRUE(Holds(TextValue("a"), "<", TextValue("aa")));
  EXPECT_TRUE(Holds(ListValue({WholeValue(1), WholeValue(2)}), "<", ListValue({WholeValue(1), RealValue(2.5)})));
  EXPECT_TRUE(Holds(ListValue({WholeValue(1)}), "<", ListValue({WholeValue(1), {}})));
  EXPECT_FALSE(Holds(ListValue({}), ">", ListValue({})));
  EXPECT_TRUE(Holds(ListValue({}), ">=", ListValue({})));
}

TEST(XacroCompared, ExactlyOneOrderHoldsOfTwoNumbersAndNoneOfNan) {
  const std::vector<XacroValue> values = {WholeValue(-1), RealValue(0.5), {true}, WholeValue(3)};
  for (const XacroValue& a : values) {
    for (const XacroValue& b : values) {
      EXPECT_EQ(Holds(a, "<", b) + Holds(a, "==", b) + Holds(a, ">", b), 1);
      EXPECT_NE(Holds(a, "<=", b), Holds(a, ">", b));
      EXPECT_EQ(Holds(a, "<", b), Holds(b, ">", a));
    }
    for (const char* operation : {"<", "<=", ">", ">=", "=="})
      EXPECT_FALSE(Holds(a, operation, RealValue(std::nan("")))) << operation;
  }
}

TEST(XacroCompared, IsTellsKindsApartThatAreEqual) {
  EXPECT_TRUE(Holds({}, "is", {}));
  EXPECT_FALSE(Holds(WholeValue(1), "is", {true}));
  EXPECT_TRUE(Holds(WholeValue(0), "is not", {}));
  EXPECT_TRUE(Holds({true}, "is", {true}));
}

TEST(XacroCompared, InLooksIntoTextsListsAndKeys) {
  EXPECT_TRUE(Holds(TextValue(""), "in", TextValue("abc")));
  EXPECT_TRUE(Holds(RealValue(1.0), "in", ListValue({WholeValue(1)})));
  EXPECT_FALSE(Holds(TextValue("v"), "in", DictValue({{TextValue("k"), TextValue("v")}})));
  EXPECT_TRUE(Holds(TextValue("v"), "not in", DictValue({{TextValue("k"), TextValue("v")}})));
  EXPECT_EQ(ProblemOf([] { Holds(WholeValue(1), "in", TextValue("1")); }).code, FailureCode::kXacroType);
  EXPECT_EQ(ProblemOf([] { Holds(WholeValue(1), "in", {}); }).code, FailureCode::kXacroType);
}

TEST(XacroCompared, RefusesOrdersBetweenKinds) {
  for (const XacroValue& other : {TextValue("1"), ListValue({}), DictValue({}), XacroValue{}})
    EXPECT_EQ(ProblemOf([&, &b = other] { Holds(WholeValue(1), "<", b); }).code, FailureCode::kXacroType);
  EXPECT_EQ(ProblemOf([] { Holds({}, "<", {}); }).code, FailureCode::kXacroType);
}

}  // namespace
}  // namespace gaitwright
