// SPDX-License-Identifier: BSD-3-Clause
#include "tests/kinematics/description/xacro_values.h"

namespace gaitwright {
namespace {

class XacroTextTest : public testing::Test {
 protected:
  XacroTextTest() {
    context_.properties["n"] = WholeValue(2);
    context_.properties["name"] = TextValue("leg");
  }
  std::string Repr(const std::string& text) { return ReprOf(EvaluateXacroText(text, context_)); }
  XacroProblem Problem(const std::string& text) {
    return ProblemOf([&] { EvaluateXacroText(text, context_); });
  }
  MadeXacroContext context_;
};

TEST_F(XacroTextTest, OneExpressionAloneKeepsItsKind) {
  EXPECT_EQ(Repr("${n}"), "2");
  EXPECT_EQ(Repr("${[n]}"), "[2]");
  EXPECT_EQ(Repr("${None}"), "None");
  EXPECT_EQ(Repr(" ${n}"), "' 2'");
  EXPECT_EQ(Repr("${n}${n}"), "'22'");
  EXPECT_EQ(Repr("${name}_${n + 0.5} $(find x)"), "'leg_2.5 <find|x>'");
  EXPECT_EQ(Repr(""), "''");
}

TEST_F(XacroTextTest, BracketsAndQuotesInsideDoNotEndAnExpression) {
  EXPECT_EQ(Repr("${{'a': {'b': n}}['a']['b']}"), "2");
  EXPECT_EQ(Repr("${'}' + \"{\"}"), "'}{'");
  EXPECT_EQ(Repr("$(eval (n + (1)) * ')'.count(')'))!"),
            "'" + std::to_string(sizeof("(n + (1)) * ')'.count(')')") - 1) + "!'");
  EXPECT_EQ(context_.evaluated, std::vector<std::string>{"(n + (1)) * ')'.count(')')"});
}

TEST_F(XacroTextTest, SubstitutionsAreSplitIntoWords) {
  EXPECT_EQ(Repr("$(find  a\tb )/c"), "'<find|a|b>/c'");
  EXPECT_EQ(Repr("$(dirname)"), "'<dirname>'");
  EXPECT_EQ(Repr("$(arg it's)"), "\"<arg|it's>\"");
}

TEST_F(XacroTextTest, PiecesInsideArePutInBefore) {
  EXPECT_EQ(Repr("$(find ${name})"), "'<find|leg>'");
  EXPECT_EQ(Repr("$(find $(arg $(env x)))"), "'<find|<arg|<env|x>>>'");
  EXPECT_EQ(Repr("${'$(arg a)' + name}"), "'<arg|a>leg'");
  Repr("$(eval ${n} + 1)");
  EXPECT_EQ(context_.evaluated, std::vector<std::string>{"2 + 1"});
}

TEST_F(XacroTextTest, ADollarBeforeADollarMakesTheBracketALetter) {
  const std::vector<std::pair<std::string, std::string>> rows = {
      {"$${n}", "'${n}'"},  {"$$${n}", "'$${n}'"}, {"$$(arg a) ${n}", "'$(arg a) 2'"},
      {"$", "'$'"},         {"$$", "'$$'"},        {"5 $ ${n}", "'5 $ 2'"},
      {"$a{n}", "'$a{n}'"}, {"$ {n}", "'$ {n}'"},  {"$$x ${n}", "'$$x 2'"}};
  for (const auto& [text, repr] : rows) EXPECT_EQ(Repr(text), repr) << text;
}

TEST_F(XacroTextTest, RefusesPiecesThatDoNotEnd) {
  for (const char* open : {"${n", "a ${n} ${", "$(find x", "${{1}", "$(eval (1)"})
    EXPECT_EQ(Problem(open).code, FailureCode::kXacroSyntax) << open;
  EXPECT_EQ(Problem("$()").code, FailureCode::kUnknownSubstitution);
  EXPECT_EQ(Problem("$( )").code, FailureCode::kUnknownSubstitution);
  EXPECT_EQ(Problem("${}").code, FailureCode::kXacroSyntax);
  EXPECT_EQ(Problem("a ${nn} b").code, FailureCode::kUnknownProperty);
}

TEST_F(XacroTextTest, AnUnmatchedQuoteEndsAtTheNextBracket) {
  const XacroProblem problem = Problem("${'a} and ${n}");
  EXPECT_EQ(problem.code, FailureCode::kXacroSyntax);
  EXPECT_TRUE(problem.message.starts_with("''a': ")) << problem.message;
}

}  // namespace
}  // namespace gaitwright
