// SPDX-License-Identifier: BSD-3-Clause
#include "kinematics/description/xacro_syntax_internal.h"
#include "tests/kinematics/description/xacro_values.h"

namespace gaitwright {
namespace {

using TokenKind = XacroToken::Kind;

/// The tokens without the end, joined by blanks: n: for a name, # for a number, t: for a text.
std::string TokensOf(const std::string& expression) {
  std::string all;
  for (const XacroToken& token : XacroTokens(expression)) {
    if (token.kind == TokenKind::kEnd) break;
    all += all.empty() ? "" : " ";
    if (token.kind == TokenKind::kName) all += "n:" + token.text;
    if (token.kind == TokenKind::kNumber) all += "#" + ReprOf(token.value);
    if (token.kind == TokenKind::kText) all += "t:" + token.text;
    if (token.kind == TokenKind::kOperator) all += token.text;
  }
  return all;
}

TEST(XacroTokens, TheLongestOperatorIsTaken) {
  EXPECT_EQ(TokensOf("a**b*c//d/e"), "n:a ** n:b * n:c // n:d / n:e");
  EXPECT_EQ(TokensOf("a<=b<c>=d>e==f=g!=h"), "n:a <= n:b < n:c >= n:d > n:e == n:f = n:g != n:h");
  EXPECT_EQ(TokensOf("***"), "** *");
}

TEST(XacroTokens, NumbersKeepWholeAndRealApart) {
  const std::vector<std::pair<std::string, std::string>> rows = {{"12", "#12"},
                                                                 {"12.", "#12.0"},
                                                                 {".5", "#0.5"},
                                                                 {"1e3", "#1000.0"},
                                                                 {"1E+3", "#1000.0"},
                                                                 {"2.5e-1", "#0.25"},
                                                                 {"1_000_000", "#1000000"},
                                                                 {"0x1f", "#31"},
                                                                 {"0XFF", "#255"},
                                                                 {"9223372036854775807", "#9223372036854775807"},
                                                                 {"9223372036854775808", "#9.223372036854776e+18"}};
  for (const auto& [text, tokens] : rows) EXPECT_EQ(TokensOf(text), tokens) << text;
}

TEST(XacroTokens, ASignBelongsToTheExponentOnlyBehindItsLetter) {
  EXPECT_EQ(TokensOf("1-2"), "#1 - #2");
  EXPECT_EQ(TokensOf("1e5-3"), "#100000.0 - #3");
  EXPECT_EQ(TokensOf("1e-5-3"), "#1e-05 - #3");
  EXPECT_EQ(TokensOf("a.b"), "n:a . n:b");
  EXPECT_EQ(TokensOf("x1.5"), "n:x1 #0.5");
}

TEST(XacroTokens, TextsMeanTheirEscapes) {
  EXPECT_EQ(TokensOf(R"('it\'s' "a\"b" 'a\\b')"), "t:it's t:a\"b t:a\\b");
  EXPECT_EQ(TokensOf(R"('a\nb\tc')"), "t:a\nb\tc");
  EXPECT_EQ(TokensOf(R"('\d\z')"), R"(t:\d\z)");
  EXPECT_EQ(TokensOf("'a\"b' \"c'd\""), "t:a\"b t:c'd");
  EXPECT_EQ(TokensOf("'f\xC3\xBC\xC3\x9F'"), "t:f\xC3\xBC\xC3\x9F");
}

TEST(XacroTokens, EachKnowsItsPlace) {
  const std::vector<XacroToken> tokens = XacroTokens(" ab\t+ 'c'\n12 ");
  ASSERT_EQ(tokens.size(), 5U);
  const std::vector<std::size_t> places = {1, 4, 6, 10, 13};
  for (std::size_t i = 0; i < places.size(); ++i) EXPECT_EQ(tokens[i].at, places[i]) << i;
  EXPECT_EQ(tokens.back().kind, TokenKind::kEnd);
}

TEST(XacroTokens, RefusesWhatIsNoTokenAtItsCharacter) {
  const std::vector<std::pair<std::string, std::string>> rows = {
      {"a && b", "'&&' at character 3"},   {"a || b", "'||' at character 3"},
      {"1 << 2", "'<<' at character 3"},   {"a := b", "':=' at character 3"},
      {"!a", "'!' at character 1"},        {"2 ^ 3", "'^' at character 3"},
      {"a $ b", "'$' at character 3"},     {"1a", "'1a' at character 1"},
      {"1.2.3", "'1.2.3' at character 1"}, {"2e", "'2e' at character 1"},
      {"0x", "'0x' at character 1"},       {"0xg", "'0xg' at character 1"},
      {"0x-5", "'0x-' at character 1"},    {" 'ab", "begins at character 2"},
      {"'ab\\'", "begins at character 1"}, {"\xC3\xA4 + 1", "'\xC3\xA4' at character 1"}};
  for (const auto& [expression, part] : rows) {
    const XacroProblem problem = ProblemOf([&, &text = expression] { XacroTokens(text); });
    EXPECT_EQ(problem.code, FailureCode::kXacroSyntax) << expression;
    EXPECT_NE(problem.message.find(part), std::string::npos) << problem.message;
  }
}

}  // namespace
}  // namespace gaitwright
