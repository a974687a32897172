// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "tests/kinematics/description/xacro_files.h"

namespace gaitwright {
namespace {

std::string XacroProp(const std::string& name, const std::string& value, const std::string& more = "") {
  return "<xacro:property name=\"" + name + "\" value=\"" + value + "\" " + more + "/>";
}

TEST(XacroProperty, TextsThatAreNumbersAreNumbers) {
  EXPECT_EQ(InnerXacro(XacroProp("m", "2") + "${m * 3}"), "6");
  EXPECT_EQ(InnerXacro(XacroProp("m", "0.50") + "${m}"), "0.5");
  EXPECT_EQ(InnerXacro(XacroProp("m", "1e-3") + "${m}"), "0.001");
  EXPECT_EQ(InnerXacro(XacroProp("m", " 7 ") + "${m + 1}"), "8");
  EXPECT_EQ(InnerXacro(XacroProp("m", "true") + "${not m}"), "False");
  EXPECT_EQ(InnerXacro(XacroProp("m", "'5'") + "${m + 'x'}"), "5x");
  EXPECT_EQ(InnerXacro(XacroProp("m", "1_2") + "${m + 'x'}"), "1_2x");
  EXPECT_EQ(InnerXacro(XacroProp("m", "0 0 1") + "<a xyz='${m}'/>"), "<a xyz=\"0 0 1\"/>");
}

TEST(XacroProperty, IsEvaluatedWhenItIsFirstUsed) {
  EXPECT_EQ(InnerXacro(XacroProp("a", "${2 * b}") + XacroProp("b", "3") + "${a}"), "6");
  EXPECT_EQ(InnerXacro(XacroProp("a", "${2 * b}") + XacroProp("b", "3") + "${a} " + XacroProp("b", "4") + "${a}"),
            "6 6");
  EXPECT_EQ(InnerXacro(XacroProp("never", "${1 / 0}") + "fine"), "fine");
  EXPECT_EQ(InnerXacro(XacroProp("n", "1") + XacroProp("n", "${n + 1}", "lazy_eval='false'") + "${n}"), "2");
}

TEST(XacroProperty, TheLastDefinitionCounts) {
  EXPECT_EQ(InnerXacro(XacroProp("a", "1") + "<x v='${a}'/>" + XacroProp("a", "2") + "<x v='${a}'/>"),
            "<x v=\"1\"/><x v=\"2\"/>");
}

TEST(XacroProperty, ADefaultCountsWhereThereIsNoValue) {
  const std::string with_default = "<xacro:property name='a' default='5'/>${a}";
  EXPECT_EQ(InnerXacro(with_default), "5");
  EXPECT_EQ(InnerXacro(XacroProp("a", "1") + with_default), "1");
}

TEST(XacroProperty, IsRemoved) {
  EXPECT_NE(InnerXacro(XacroProp("a", "1") + "<xacro:property name='a' remove='true'/>${a}").find("unknown_property"),
            std::string::npos);
}

TEST(XacroProperty, BelongsToItsMacroUnlessAScopeIsGiven) {
  const auto macro = [](const std::string& inside) {
    return "<xacro:macro name='m'>" + inside + "</xacro:macro><xacro:macro name='outer'><xacro:m/>${a};</xacro:macro>";
  };
  const std::string call = "<xacro:outer/>${a}";
  EXPECT_EQ(InnerXacro(XacroProp("a", "0") + macro(XacroProp("a", "1")) + call), "0;0");
  EXPECT_EQ(InnerXacro(XacroProp("a", "0") + macro(XacroProp("a", "${1}", "scope='parent'")) + call), "1;0");
  EXPECT_EQ(InnerXacro(XacroProp("a", "0") + macro(XacroProp("a", "${1}", "scope='global'")) + call), "1;1");
  const std::string wrong = InnerXacro(XacroProp("a", "0", "scope='glob'"));
  EXPECT_NE(wrong.find("xacro_scope: robot.xacro:1"), std::string::npos) << wrong;
}

TEST(XacroProperty, ABlockIsInsertedWhereItIsAskedFor) {
  const std::string block = "<xacro:property name='o'><origin xyz='${x} 0 0'/><axis/></xacro:property>";
  EXPECT_EQ(InnerXacro(block + XacroProp("x", "1") + "<j><xacro:insert_block name='o'/></j>" + XacroProp("x", "2") +
                       "<xacro:insert_block name='o'/>"),
            "<j><origin xyz=\"1 0 0\"/><axis/></j><origin xyz=\"2 0 0\"/><axis/>");
  const std::string unknown = InnerXacro(block + "<xacro:insert_block name='oo'/>");
  EXPECT_NE(unknown.find("unknown_block"), std::string::npos);
  EXPECT_NE(unknown.find("'o'"), std::string::npos);
}

TEST(XacroProperty, HoldsListsAndDictionaries) {
  EXPECT_EQ(InnerXacro(XacroProp("d", "${dict(mass=2, size=[1, 2])}") + "${d['mass'] * d.size[1]}"), "4");
}

TEST(XacroProperty, RefusesACircleAndNamesIt) {
  const std::string message = InnerXacro("\n" + XacroProp("a", "${b}") + "\n" + XacroProp("b", "${a + 1}") + "\n${a}");
  EXPECT_NE(message.find("xacro_recursion"), std::string::npos) << message;
  EXPECT_NE(message.find("'a', 'b'"), std::string::npos) << message;
  EXPECT_NE(message.find("robot.xacro:2"), std::string::npos) << message;
}

TEST(XacroProperty, AnUndefinedOneIsNamedWithTheNearestAndWhereItWasUsed) {
  const std::string message = InnerXacro("\n" + XacroProp("leg_length", "1") + "\n" +
                                         XacroProp("foot", "${leg_lenght}") + "\n<a b='${foot}'/>");
  for (const char* part : {"unknown_property: robot.xacro:4: <a>", "'leg_lenght': the property 'leg_lenght'",
                           "nearest is 'leg_length'", "'foot' is defined in robot.xacro:3"})
    EXPECT_NE(message.find(part), std::string::npos) << message;
}

TEST(XacroCondition, TakesTruthValuesAndWholeNumbers) {
  const auto kept = [](const std::string& value) {
    return InnerXacro("<xacro:if value=\"" + value + "\">y</xacro:if><xacro:unless value=\"" + value +
                      "\">n</xacro:unless>");
  };
  for (const char* value : {"true", "True", "1", "${1 &lt; 2}", "${0.5}", "${'a' == 'a'}", "2"})
    EXPECT_EQ(kept(value), "y");
  for (const char* value : {"false", "False", "0", "${0.0}", "${'a' == 'b'}", "${[]}"}) EXPECT_EQ(kept(value), "n");
  EXPECT_NE(kept("maybe").find("xacro_condition: robot.xacro:1: <xacro:if>"), std::string::npos);
  EXPECT_NE(kept("maybe").find("is 'maybe'"), std::string::npos);
}

TEST(XacroElement, ElementsAndAttributesAreMadeByName) {
  EXPECT_EQ(InnerXacro("<xacro:element xacro:name=\"${'li' + 'nk'}\" name='a'><b/></xacro:element>"),
            "<link name=\"a\"><b/></link>");
  EXPECT_EQ(InnerXacro("<a><xacro:attribute name='x' value='${1 + 1}'/><b/></a>"), "<a x=\"2\"><b/></a>");
  EXPECT_NE(InnerXacro("<xacro:element xacro:name='xacro:if'/>").find("bad_name"), std::string::npos);
  EXPECT_NE(InnerXacro("<xacro:element xacro:name='1a'/>").find("bad_name"), std::string::npos);
}

}  // namespace
}  // namespace gaitwright
