// SPDX-License-Identifier: BSD-3-Clause
#include "tests/kinematics/description/xacro_values.h"

namespace gaitwright {
namespace {

class XacroEvaluateTest : public testing::Test {
 protected:
  std::string Repr(const std::string& expression) { return ReprOf(EvaluateXacro(expression, context_)); }
  XacroProblem Problem(const std::string& expression) {
    return ProblemOf([&] { EvaluateXacro(expression, context_); });
  }
  MadeXacroContext context_;
};

TEST_F(XacroEvaluateTest, AVariableHidesAPropertyAndAPropertyAConstant) {
  EXPECT_EQ(Repr("e > 2.7"), "True");
  context_.properties["e"] = WholeValue(7);
  EXPECT_EQ(Repr("e"), "7");
  EXPECT_EQ(Repr("math.e > 2.7"), "True");
  EXPECT_EQ(Repr("[e for e in 'ab']"), "['a', 'b']");
  EXPECT_EQ(Repr("[[e for e in 'x'][0] + e for e in 'ab']"), "['xa', 'xb']");
  EXPECT_EQ(Repr("e"), "7");
  EXPECT_EQ(Repr("tau == 2 * pi and inf > 1e308 and nan != nan"), "True");
}

TEST_F(XacroEvaluateTest, TheSourceOfAComprehensionDoesNotSeeItsVariable) {
  context_.properties["x"] = ListValue({WholeValue(1), WholeValue(2)});
  EXPECT_EQ(Repr("[x * 10 for x in x]"), "[10, 20]");
  EXPECT_EQ(Problem("[i for j in x]").code, FailureCode::kUnknownProperty);
  EXPECT_EQ(Problem("[1 for i in x] + [i]").code, FailureCode::kUnknownProperty);
}

TEST_F(XacroEvaluateTest, ListsOfListsKeepTheirBrackets) {
  EXPECT_EQ(Repr("[[i for i in range(3)]]"), "[[0, 1, 2]]");
  EXPECT_EQ(Repr("[[i for i in range(2)], 5]"), "[[0, 1], 5]");
  EXPECT_EQ(Repr("[[j for j in range(i)] for i in range(3)]"), "[[], [0], [0, 1]]");
}

TEST_F(XacroEvaluateTest, AndAndOrGiveTheOperandThatDecidesAndStopThere) {
  EXPECT_EQ(Repr("0 or '' or []"), "[]");
  EXPECT_EQ(Repr("0 or 3 or missing"), "3");
  EXPECT_EQ(Repr("1 and 'a' and 2.5"), "2.5");
  EXPECT_EQ(Repr("1 and '' and missing"), "''");
  EXPECT_EQ(Repr("1 < 0 < missing"), "False");
  EXPECT_EQ(Repr("missing if 0 else 1"), "1");
  EXPECT_EQ(Problem("1 or 2 and missing + (").code, FailureCode::kXacroSyntax);
}

TEST_F(XacroEvaluateTest, SignsKeepTheKindOfNumber) {
  EXPECT_EQ(Repr("-True"), "-1");
  EXPECT_EQ(Repr("+True"), "1");
  EXPECT_EQ(Repr("-0.0"), "-0.0");
  EXPECT_EQ(Repr("--2"), "2");
  EXPECT_EQ(Repr("not not 'a'"), "True");
  EXPECT_EQ(Problem("-[1]").code, FailureCode::kXacroType);
  EXPECT_EQ(Problem("-(0 - 9223372036854775807 - 1)").code, FailureCode::kXacroNumber);
}

TEST_F(XacroEvaluateTest, IndicesCountFromBothEndsAndSlicesAreCut) {
  context_.properties["l"] = ListValue({WholeValue(1), WholeValue(2), WholeValue(3)});
  EXPECT_EQ(Repr("[l[0], l[-1], l[-3], 'abc'[-2]]"), "[1, 3, 1, 'b']");
  EXPECT_EQ(Repr("[l[1:], l[:-1], l[-2:2], l[2:1], l[5:], l[-9:9]]"), "[[2, 3], [1, 2], [2], [], [], [1, 2, 3]]");
  EXPECT_EQ(Repr("'abc'[1:] + 'abc'[:1]"), "'bca'");
  for (const char* beyond : {"l[3]", "l[-4]", "''[0]"})
    EXPECT_EQ(Problem(beyond).code, FailureCode::kXacroIndex) << beyond;
  for (const char* wrong : {"l[1.0]", "l['a']", "l['a':]", "1[0]", "{}[:]", "None[0]"})
    EXPECT_EQ(Problem(wrong).code, FailureCode::kXacroType) << wrong;
}

TEST_F(XacroEvaluateTest, ADottedNameIsANamespacesPropertyOrAnEntry) {
  context_.properties["arm.mass"] = WholeValue(4);
  context_.properties["leg"] = DictValue({{TextValue("mass"), WholeValue(5)}, {WholeValue(1), TextValue("one")}});
  EXPECT_EQ(Repr("arm.mass"), "4");
  EXPECT_EQ(Repr("leg.mass"), "5");
  EXPECT_EQ(Repr("leg['mass'] + leg.get('mass')"), "10");
  EXPECT_EQ(Repr("leg[1.0]"), "'one'");
  context_.properties["arm"] = DictValue({{TextValue("mass"), WholeValue(6)}});
  EXPECT_EQ(Repr("arm.mass"), "6") << "a property that is there comes before a namespace";
  const XacroProblem unknown = Problem("leg.mas");
  EXPECT_EQ(unknown.code, FailureCode::kUnknownKey);
  EXPECT_NE(unknown.message.find("'mass'"), std::string::npos) << unknown.message;
  EXPECT_EQ(Problem("foot.mass").code, FailureCode::kUnknownProperty);
  EXPECT_EQ(Problem("leg.mass.x").code, FailureCode::kXacroType);
}

TEST_F(XacroEvaluateTest, FunctionsOfTheContextAndOfModulesAreCalled) {
  EXPECT_EQ(Repr("given(1, 'a')"), "[1, 'a']");
  EXPECT_EQ(Repr("xacro.given(2)"), "[2]");
  EXPECT_EQ(Repr("math.floor(2.5) + python.int('1')"), "3");
  context_.properties["math"] = DictValue({{TextValue("pi"), WholeValue(3)}});
  EXPECT_EQ(Repr("math.pi"), "3") << "a property may have the name of a module";
  EXPECT_EQ(Problem("giver(1)").code, FailureCode::kUnknownFunction);
  EXPECT_EQ(Problem("'a'(1)").code, FailureCode::kXacroType);
  EXPECT_EQ(Problem("given(a=1)").code, FailureCode::kXacroSyntax);
}

TEST_F(XacroEvaluateTest, DictTakesNamesDictionariesAndPairs) {
  EXPECT_EQ(Repr("dict()"), "{}");
  EXPECT_EQ(Repr("dict({'a': 1, 'b': 2}, b=3, c=4)"), "{'a': 1, 'b': 3, 'c': 4}");
  EXPECT_EQ(Repr("dict([['a', 1], (2, 'b')])"), "{'a': 1, 2: 'b'}");
  EXPECT_EQ(Repr("dict(enumerate('xy'))"), "{0: 'x', 1: 'y'}");
  EXPECT_EQ(Problem("dict([1])").code, FailureCode::kXacroType);
  EXPECT_EQ(Problem("dict('ab')").code, FailureCode::kXacroType);
  EXPECT_EQ(Problem("{[1]: 2}").code, FailureCode::kXacroType);
}

TEST_F(XacroEvaluateTest, APoppedItemIsGoneFromTheProperty) {
  context_.properties["l"] = ListValue({WholeValue(1), WholeValue(2)});
  EXPECT_EQ(Repr("[l.pop(0), l, l[:]]"), "[1, [2], [2]]");
  EXPECT_EQ(Repr("l"), "[2]");
}

TEST_F(XacroEvaluateTest, AProblemBeginsWithTheExpressionOnce) {
  const XacroProblem problem = Problem("  1 + lenght ");
  EXPECT_TRUE(problem.shows_expression);
  EXPECT_TRUE(problem.message.starts_with("'1 + lenght': ")) << problem.message;
  EXPECT_EQ(problem.message.find("'1 + lenght'", 1), std::string::npos) << problem.message;
}

}  // namespace
}  // namespace gaitwright
