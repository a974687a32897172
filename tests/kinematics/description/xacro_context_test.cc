// SPDX-License-Identifier: BSD-3-Clause
#include "tests/kinematics/description/xacro_files.h"

namespace gaitwright {
namespace {

std::string Arg(const std::string& name, const std::string& value) {
  return "<xacro:arg name='" + name + "' default='" + value + "'/>";
}

std::string PropertyText(const std::string& name, const std::string& value) {
  return "<xacro:property name='" + name + "' value=\"" + value + "\"/>";
}

std::string CodeOfContext(const std::string& inside, const TextFiles& files = {}) {
  const std::string text = InnerXacro(inside, files);
  return text.substr(0, text.find(':'));
}

TEST(XacroContext, ArgumentsAreTextsInExpressionsAndNumbersInEval) {
  EXPECT_EQ(InnerXacro(Arg("n", "3") + "$(arg n)${xacro.arg('n') * 2}"), "333");
  EXPECT_EQ(InnerXacro(Arg("n", "3") + "$(eval arg('n') * 2) $(eval n * 2)"), "6 6");
  EXPECT_EQ(InnerXacro(Arg("n", "3") + PropertyText("n", "4") + "${n} $(eval n)"), "4 3")
      << "in eval an argument comes before a property";
  EXPECT_EQ(InnerXacro(PropertyText("p", "4") + "$(eval p + 1)"), "5");
  EXPECT_EQ(InnerXacro(Arg("on", "false") + "$(eval not on)"), "True");
}

TEST(XacroContext, AnArgumentThatEvalReadsIsUsed) {
  const std::string text = "<xacro:if value='$(eval n == 2)'>two</xacro:if>";
  EXPECT_EQ(InnerXacro(text, {}, {{"n", "2"}}), "two");
  EXPECT_EQ(InnerXacro("a", {}, {{"n", "2"}}).substr(0, 16), "unknown_argument");
}

TEST(XacroContext, FunctionsStandForSubstitutions) {
  EXPECT_EQ(InnerXacro("${xacro.find('bot')} ${find('bot')} $(find bot)"), "/packages/bot /packages/bot /packages/bot");
  EXPECT_EQ(InnerXacro("${env('ROBOT')} ${optenv('NONE', 'x')} [${optenv('NONE')}] ${dirname()}"), "bot x [] .");
  EXPECT_EQ(InnerXacro("[${xacro.message('a')}${xacro.warning('b', 1)}${xacro.error()}]"), "[]");
}

TEST(XacroContext, PathsAreBesideTheFileThatNamesThem) {
  const TextFiles files = {{"parts/leg.xacro",
                            "<robot xmlns:xacro='x'><a p=\"${xacro.abs_filename('m.stl')}\" d='$(dirname)' "
                            "y=\"${xacro.load_yaml('s.yaml')['k']}\"/></robot>"},
                           {"parts/s.yaml", "k: 7"},
                           {"s.yaml", "k: 8"}};
  EXPECT_EQ(InnerXacro("<xacro:include filename='parts/leg.xacro'/>", files),
            "<a p=\"parts/m.stl\" d=\"parts\" y=\"7\"/>");
  EXPECT_EQ(InnerXacro("${load_yaml('s.yaml').k} ${abs_filename('../m.stl')}", files), "8 ../m.stl");
}

TEST(XacroContext, APropertyIsEvaluatedInTheFileThatDefinesIt) {
  const TextFiles files = {
      {"parts/leg.xacro", "<robot xmlns:xacro='x'><xacro:property name='where' value='$(dirname)'/></robot>"}};
  EXPECT_EQ(InnerXacro("<xacro:include filename='parts/leg.xacro'/>${where} $(dirname)", files), "parts .");
}

TEST(XacroContext, EachReadingOfAFileIsAListOfItsOwn) {
  const TextFiles files = {{"l.yaml", "[1, 2]"}};
  EXPECT_EQ(InnerXacro(PropertyText("a", "${load_yaml('l.yaml')}") + PropertyText("b", "${load_yaml('l.yaml')}") +
                           "${a.pop()} ${len(a)} ${len(b)}",
                       files),
            "2 1 2");
}

TEST(XacroContext, ACircleOfPropertiesIsNamedFromItsBeginning) {
  const std::string text = PropertyText("start", "${a}") + PropertyText("a", "${b}") + PropertyText("b", "${a}");
  const std::string message = InnerXacro(text + "${start}");
  EXPECT_TRUE(message.starts_with("xacro_recursion")) << message;
  EXPECT_NE(message.find("'a' depends on itself, through 'a', 'b'"), std::string::npos) << message;
  EXPECT_EQ(message.find("'start', 'a'"), std::string::npos) << message;
}

TEST(XacroContext, TheThreePropertiesNearestToAFaultAreNamed) {
  std::string text = PropertyText("p0", "${missing}");
  for (int i = 1; i < 8; ++i) text += PropertyText("p" + std::to_string(i), "${p" + std::to_string(i - 1) + "}");
  const std::string message = InnerXacro(text + "${p7}");
  std::size_t named = 0;
  for (std::size_t at = message.find("is defined in"); at != std::string::npos;
       at = message.find("is defined in", at + 1))
    ++named;
  EXPECT_EQ(named, 3U) << message;
  for (const char* near : {"'p0'", "'p1'", "'p2'"}) EXPECT_NE(message.find(near), std::string::npos) << message;
}

TEST(XacroContext, RefusesByCode) {
  const std::vector<std::pair<std::string, std::string>> rows = {{"$(arg)", "unknown_substitution"},
                                                                 {"$(arg a b)", "unknown_substitution"},
                                                                 {"$(dirname x)", "unknown_substitution"},
                                                                 {"$(find)", "unknown_substitution"},
                                                                 {"$(env)", "unknown_substitution"},
                                                                 {"$(env A B)", "unknown_substitution"},
                                                                 {"$(anon a)", "unknown_substitution"},
                                                                 {"$(find nothing)", "no_package"},
                                                                 {"$(env NONE)", "no_variable"},
                                                                 {"$(arg none)", "xacro_argument"},
                                                                 {"${arg('none')}", "xacro_argument"},
                                                                 {"${env(1)}", "xacro_type"},
                                                                 {"${env()}", "xacro_type"},
                                                                 {"${dirname('x')}", "xacro_type"},
                                                                 {"${load_yaml('none.yaml')}", "xacro_yaml"},
                                                                 {"${xacro.fatal('stop')}", "xacro_fatal"},
                                                                 {"${xacro.nothing()}", "unknown_function"}};
  for (const auto& [inside, code] : rows) EXPECT_EQ(CodeOfContext(inside), code) << inside;
}

}  // namespace
}  // namespace gaitwright
