// SPDX-License-Identifier: BSD-3-Clause
#include "tests/kinematics/description/xacro_files.h"

namespace gaitwright {
namespace {

std::string Defined(const std::string& params, const std::string& body, const std::string& name = "m") {
  return "<xacro:macro name='" + name + "' params=\"" + params + "\">" + body + "</xacro:macro>";
}

std::string CodeOfMacroCall(const std::string& inside) {
  const std::string text = InnerXacro(inside);
  return text.substr(0, text.find(':'));
}

TEST(XacroCall, ParametersHaveTheNumbersOfTheirTexts) {
  const std::string m = Defined("a", "${a * 2}|");
  EXPECT_EQ(InnerXacro(m + "<xacro:m a='3'/><xacro:m a='${1.5}'/><xacro:m a='true'/>"), "6|3.0|2|");
  EXPECT_EQ(InnerXacro(m + "<xacro:m a=\"'3'\"/><xacro:m a='x'/>"), "33|xx|");
  EXPECT_EQ(InnerXacro(m + "<xacro:m a='${[1]}'/>"), "[1, 1]|");
}

TEST(XacroCall, ParametersAreEvaluatedInTheScopeOfTheCaller) {
  const std::string text =
      "<xacro:property name='a' value='1'/>" + Defined("a b", "${a} ${b}") + "<xacro:m a='5' b='${a}'/>";
  EXPECT_EQ(InnerXacro(text), "5 1");
}

TEST(XacroCall, DefaultsSeeTheCallerAndNotOtherParameters) {
  const std::string x = "<xacro:property name='x' value='1'/>";
  EXPECT_EQ(InnerXacro(x + Defined("x b:=${x}", "${x} ${b}") + "<xacro:m x='7'/>"), "7 1");
  EXPECT_EQ(CodeOfMacroCall(Defined("x b:=${x}", "${b}") + "<xacro:m x='7'/>"), "unknown_property");
}

TEST(XacroCall, APropertyOfTheBodyEndsWithTheCall) {
  const std::string m = Defined("", "<xacro:property name='p' value='1'/>${p}");
  EXPECT_EQ(InnerXacro("<xacro:property name='p' value='0'/>" + m + "<xacro:m/>${p}"), "10");
  EXPECT_EQ(CodeOfMacroCall(m + "<xacro:m/>${p}"), "unknown_property");
}

TEST(XacroCall, AForwardedPropertyIsThatOfTheCallerThenTheDefault) {
  const std::string inner = Defined("v:=^|9", "${v}", "inner"), outer = Defined("v", "<xacro:inner/>", "outer");
  EXPECT_EQ(InnerXacro(inner + outer + "<xacro:outer v='4'/><xacro:inner/><xacro:inner v='2'/>"), "492");
}

TEST(XacroCall, BlocksAreTheElementsOfTheCallInTheirOrder) {
  const std::string m = Defined("*a *b", "<xacro:insert_block name='b'/><xacro:insert_block name='a'/>");
  EXPECT_EQ(InnerXacro(m + "<xacro:m>text<x/><!-- no --><y/></xacro:m>"), "<y/><x/>");
  EXPECT_EQ(InnerXacro(m + Defined("", "<x/><y/>", "two") + "<xacro:m><xacro:two/></xacro:m>"), "<y/><x/>")
      << "elements that a macro makes are blocks too";
  EXPECT_EQ(InnerXacro(m + "<xacro:m><xacro:if value='0'><z/></xacro:if><x/><y/></xacro:m>"), "<y/><x/>");
}

TEST(XacroCall, TheContentOfABlockIsItsChildren) {
  EXPECT_EQ(InnerXacro(Defined("**c", "<o><xacro:insert_block name='c'/></o>") + "<xacro:m><b k='1'/></xacro:m>"),
            "<o/>");
  EXPECT_EQ(InnerXacro(Defined("**c", "<o><xacro:insert_block name='c'/></o>") + "<xacro:m><b>t<d/></b></xacro:m>"),
            "<o>t<d/></o>");
}

TEST(XacroCall, ACalledNameMayHaveThePrefixAndItsAttributeIsNoParameter) {
  const std::string m = Defined("macro:=0 n", "${macro} ${n}");
  EXPECT_EQ(InnerXacro(m + "<xacro:call macro='m' n='1'/>|<xacro:call macro='xacro:m' n='2'/>"), "0 1|0 2");
  EXPECT_EQ(InnerXacro(m + "<xacro:m macro='5' n='1'/>"), "5 1");
}

TEST(XacroCall, AMacroOfAMacroSeesWhatIsThereWhenItIsCalled) {
  const std::string make = Defined("v", "<xacro:macro name='made'>${v}</xacro:macro><xacro:made/>", "make");
  EXPECT_EQ(InnerXacro(make + "<xacro:make v='1'/><xacro:make v='2'/>"), "12");
}

TEST(XacroCall, RefusesByCode) {
  const std::vector<std::pair<std::string, std::string>> rows = {
      {Defined("a", "") + "<xacro:m/>", "macro_parameter"},
      {Defined("a", "") + "<xacro:m a='1' b='2'/>", "macro_parameter"},
      {Defined("*a", "") + "<xacro:m a='1'><x/></xacro:m>", "macro_parameter"},
      {Defined("*a", "") + "<xacro:m/>", "macro_parameter"},
      {Defined("*a", "") + "<xacro:m>text</xacro:m>", "macro_parameter"},
      {Defined("*a", "") + "<xacro:m><x/><y/></xacro:m>", "macro_parameter"},
      {Defined("", "") + "<xacro:m><x/></xacro:m>", "macro_parameter"},
      {"<xacro:m/>" + Defined("", ""), "unknown_macro"},
      {Defined("", "<xacro:m/>") + "<xacro:m/>", "xacro_limit"}};
  for (const auto& [inside, code] : rows) EXPECT_EQ(CodeOfMacroCall(inside), code) << inside;
}

}  // namespace
}  // namespace gaitwright
