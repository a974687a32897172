// SPDX-License-Identifier: BSD-3-Clause
#include "kinematics/description/xacro_syntax_internal.h"
#include "tests/kinematics/description/xacro_values.h"

namespace gaitwright {
namespace {

using NodeKind = XacroNodeKind;

/// The tree as text: (KIND children), with the operators between the children they join.
std::string TreeText(const XacroNode& node) {
  static const char* const kKinds[] = {"const", "name", "list", "dict",   "unary", "chain", "power", "compare",
                                       "and",   "or",   "if",   "member", "index", "slice", "call",  "for"};
  if (node.kind == NodeKind::kConstant) return ReprOf(node.value);
  if (node.kind == NodeKind::kName) return node.text;
  std::string text = "(" + std::string(kKinds[static_cast<std::size_t>(node.kind)]);
  if (!node.text.empty()) text += " ." + node.text;
  if (node.kind == NodeKind::kUnary) text += " " + node.operators[0];
  for (std::size_t i = 0; i < node.children.size(); ++i) {
    const bool joined = node.kind == NodeKind::kChain || node.kind == NodeKind::kCompare;
    if (joined && i > 0) text += " " + node.operators[i - 1];
    text += " ";
    if (node.kind == NodeKind::kCall && i > 0 && !node.operators[i - 1].empty()) text += node.operators[i - 1] + "=";
    text += TreeText(node.children[i]);
  }
  return text + ")";
}

void ExpectTrees(const std::vector<std::pair<std::string, std::string>>& rows) {
  for (const auto& [expression, tree] : rows) EXPECT_EQ(TreeText(ParseXacroExpression(expression)), tree);
}

TEST(XacroSyntax, OperatorsBindAsInPython) {
  ExpectTrees({{"1 + 2 * 3", "(chain 1 + (chain 2 * 3))"},
               {"(1 + 2) * 3", "(chain (chain 1 + 2) * 3)"},
               {"1 - 2 - 3", "(chain 1 - 2 - 3)"},
               {"-a ** 2", "(unary - (power a 2))"},
               {"2 ** -1", "(power 2 (unary - 1))"},
               {"2 ** 3 ** 4", "(power 2 (power 3 4))"},
               {"-a * b", "(chain (unary - a) * b)"},
               {"not a == b", "(unary not (compare a == b))"},
               {"not a and b or c", "(or (and (unary not a) b) c)"},
               {"a or b and c", "(or a (and b c))"},
               {"a + 1 < b", "(compare (chain a + 1) < b)"},
               {"a < b <= c", "(compare a < b <= c)"},
               {"a is not b", "(compare a is not b)"},
               {"a not in b in c", "(compare a not in b in c)"}});
}

TEST(XacroSyntax, AChoiceHoldsItsConditionFirstAndIsReadFromTheRight) {
  ExpectTrees({{"a if b else c", "(if b a c)"},
               {"a if b else c if d else e", "(if b a (if d c e))"},
               {"a or b if c else d", "(if c (or a b) d)"}});
}

TEST(XacroSyntax, SuffixesAreReadFromTheLeft) {
  ExpectTrees({{"a.b[1].c", "(member .c (index (member .b a) 1))"},
               {"a[1:2]", "(slice a 1 2)"},
               {"a[:]", "(slice a None None)"},
               {"a[1:]", "(slice a 1 None)"},
               {"a[:-1]", "(slice a None (unary - 1))"},
               {"f()", "(call f)"},
               {"f(1, x=2, )", "(call f 1 x=2)"},
               {"a.b(1)(2)", "(call (call (member .b a) 1) 2)"},
               {"-a.b ** 2", "(unary - (power (member .b a) 2))"}});
}

TEST(XacroSyntax, BracketsMakeListsTuplesAndDictionaries) {
  ExpectTrees({{"[]", "(list)"},
               {"()", "(list)"},
               {"(1)", "1"},
               {"(1,)", "(list 1)"},
               {"[1]", "(list 1)"},
               {"[1, 2,]", "(list 1 2)"},
               {"1, 2", "(list 1 2)"},
               {"1,", "(list 1)"},
               {"{}", "(dict)"},
               {"{'a': 1, 2: b,}", "(dict 'a' 1 2 b)"},
               {"'a' \"b\" 'c'", "'abc'"}});
}

TEST(XacroSyntax, AComprehensionIsAListWithItsConditionLast) {
  ExpectTrees({{"[i for i in l]", "(for .i i l True)"},
               {"[i * 2 for i in l if i > 1]", "(for .i (chain i * 2) l (compare i > 1))"},
               {"sum(i for i in l)", "(call sum (for .i i l True))"},
               {"([i for i in l])", "(for .i i l True)"},
               {"[[i for i in l]]", "(list (for .i i l True))"},
               {"[([i for i in l])]", "(list (for .i i l True))"},
               {"[[i for i in l],]", "(list (for .i i l True))"},
               {"[[j for j in i] for i in l]", "(for .i (for .j j i True) l True)"}});
}

TEST(XacroSyntax, WordsOfPythonAreNoNames) {
  ExpectTrees({{"True", "True"}, {"None", "None"}, {"true", "true"}, {"notable", "notable"}, {"in_", "in_"}});
  for (const char* word : {"if", "else", "and", "or", "not", "in", "is", "for", "lambda"}) {
    const XacroProblem problem = ProblemOf([&] { ParseXacroExpression(std::string("1 + ") + word + " 2"); });
    EXPECT_EQ(problem.code, FailureCode::kXacroSyntax) << word;
  }
}

TEST(XacroSyntax, RefusesAtTheCharacterOfTheFirstWrongToken) {
  const std::vector<std::pair<std::string, std::string>> rows = {
      {"", "ends too early"},         {"1 +", "ends too early"},      {"(1", "')' is needed"},
      {"1 2", "'2' at character 3"},  {"1 'a'", "text 'a'"},          {"[1 2]", "'2' at character 4"},
      {"a.1", "'.1' at character 2"}, {"a.'b'", "name of a member"},  {"{1}", "':' is needed"},
      {"a if b", "'else' is needed"}, {"a not b", "'in' is needed"},  {"[i for 1 in l]", "name of a variable"},
      {"a[1:2:3]", "']' is needed"},  {"f(,)", "',' at character 3"}, {"1 = 2", "'=' at character 3"}};
  for (const auto& [expression, part] : rows) {
    const XacroProblem problem = ProblemOf([&, &text = expression] { ParseXacroExpression(text); });
    EXPECT_EQ(problem.code, FailureCode::kXacroSyntax) << expression;
    EXPECT_NE(problem.message.find(part), std::string::npos) << expression << ": " << problem.message;
  }
}

}  // namespace
}  // namespace gaitwright
