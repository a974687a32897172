// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "tests/kinematics/description/xacro_files.h"

namespace gaitwright {
namespace {

std::string MacroText(const std::string& name, const std::string& params, const std::string& body) {
  return "<xacro:macro name=\"" + name + "\" params=\"" + params + "\">" + body + "</xacro:macro>";
}

void ExpectRefusal(const std::string& inside, const std::vector<std::string>& parts) {
  const std::string message = InnerXacro(inside);
  for (const std::string& part : parts)
    EXPECT_NE(message.find(part), std::string::npos) << message << "\nlacks " << part;
}

TEST(XacroMacro, TakesParametersByName) {
  const std::string leg = MacroText("leg", "prefix reflect", "<link name='${prefix}_leg' y='${reflect * 0.1}'/>");
  EXPECT_EQ(InnerXacro(leg + "<xacro:leg reflect='-1' prefix='FR'/>"), "<link name=\"FR_leg\" y=\"-0.1\"/>");
}

TEST(XacroMacro, DefaultsAreEvaluatedWhereItIsCalled) {
  const std::string x = "<xacro:property name='x' value='7'/>";
  EXPECT_EQ(InnerXacro(MacroText("m", "a b:=1 c:=${x + 1}", "${a} ${b} ${c}") + x + "<xacro:m a='0'/>"), "0 1 8");
  EXPECT_EQ(InnerXacro(MacroText("m", "a=5", "${a}") + "<xacro:m/>"), "5");
  EXPECT_EQ(InnerXacro(MacroText("m", "prefix:='' xyz:='0 0 1' rest", "[${prefix}][${xyz}][${rest}]") +
                       "<xacro:m rest='r'/>"),
            "[][0 0 1][r]");
  EXPECT_EQ(InnerXacro(MacroText("m", "a:=${1 + 1}\n   b:=${ 'p q' }", "${a} ${b}") + "<xacro:m/>"), "2 p q");
}

TEST(XacroMacro, ForwardsPropertiesOfTheCaller) {
  const std::string m = MacroText("m", "d:=^ f:=^|9", "${d} ${f}");
  EXPECT_EQ(InnerXacro(m + "<xacro:property name='d' value='1'/><xacro:m/>"), "1 9");
  EXPECT_EQ(InnerXacro(m + "<xacro:property name='d' value='1'/><xacro:property name='f' value='2'/><xacro:m/>"),
            "1 2");
  EXPECT_EQ(InnerXacro(m + "<xacro:m d='5' f='6'/>"), "5 6");
  ExpectRefusal(m + "<xacro:m/>", {"macro_parameter", "its parameter 'd'"});
}

TEST(XacroMacro, InsertsBlocks) {
  const std::string m = MacroText("m", "name *origin **content",
                                  "<j n='${name}'><xacro:insert_block name='origin'/>"
                                  "<xacro:insert_block name='content'/><xacro:insert_block name='content'/></j>");
  EXPECT_EQ(InnerXacro(m + "<xacro:m name='a'><origin xyz='${1 + 1} 0 0'/><c><x/>t<y/></c></xacro:m>"),
            "<j n=\"a\"><origin xyz=\"2 0 0\"/><x/>t<y/><x/>t<y/></j>");
}

TEST(XacroMacro, BlocksAreExpandedWhereTheMacroIsCalled) {
  const std::string m = MacroText("m", "x *b", "<xacro:insert_block name='b'/>");
  EXPECT_EQ(InnerXacro("<xacro:property name='x' value='outer'/>" + m + "<xacro:m x='inner'><o v='${x}'/></xacro:m>"),
            "<o v=\"outer\"/>");
  const std::string made = MacroText("origin_of", "z", "<origin xyz='0 0 ${z}'/>");
  EXPECT_EQ(InnerXacro(made + m + "<xacro:m x='1'><xacro:origin_of z='3'/></xacro:m>"), "<origin xyz=\"0 0 3\"/>");
  const std::string through = MacroText("n", "*b", "<xacro:m x='1'><xacro:insert_block name='b'/></xacro:m>");
  EXPECT_EQ(InnerXacro(m + through + "<xacro:n><deep v='${2}'/></xacro:n>"), "<deep v=\"2\"/>");
  EXPECT_EQ(InnerXacro(m + through + "<xacro:n><deep v='$${2}'/></xacro:n>"), "<deep v=\"${2}\"/>");
}

TEST(XacroMacro, MacrosCallMacrosAndThemselves) {
  const std::string chain = MacroText("chain", "n",
                                      "<link name='l${n}'/><xacro:if value='${n > 0}'><xacro:chain n='${n - 1}'/>"
                                      "</xacro:if>");
  EXPECT_EQ(InnerXacro(chain + "<xacro:chain n='2'/>"), "<link name=\"l2\"/><link name=\"l1\"/><link name=\"l0\"/>");
  const std::string deep = InnerXacro(chain + "<xacro:chain n='98'/>");
  EXPECT_NE(deep.find("\"l0\""), std::string::npos) << deep;
  const std::string inner = MacroText("outer", "", MacroText("inner", "", "<i/>") + "<xacro:inner/>");
  EXPECT_EQ(InnerXacro(inner + "<xacro:outer/>"), "<i/>");
  ExpectRefusal(inner + "<xacro:outer/><xacro:inner/>", {"unknown_macro", "'inner'"});
}

TEST(XacroMacro, GoesOverAListByTakingItsItems) {
  const std::string loop = MacroText("loop", "items:=^",
                                     "<xacro:if value='${items}'><xacro:property name='item' value='${items.pop(0)}'/>"
                                     "<i v='${item}'/><xacro:loop/></xacro:if>");
  EXPECT_EQ(InnerXacro(loop + "<xacro:property name='items' value=\"${[1, 'a', 2.5]}\"/><xacro:loop/>"),
            "<i v=\"1\"/><i v=\"a\"/><i v=\"2.5\"/>");
}

TEST(XacroMacro, SeesThePropertiesOfItsCaller) {
  const std::string m = MacroText("m", "", "${x}") + MacroText("n", "x", "<xacro:m/>");
  EXPECT_EQ(InnerXacro(m + "<xacro:n x='4'/>"), "4");
}

TEST(XacroMacro, IsCalledByAComputedName) {
  const std::string m = MacroText("left_leg", "n", "<l n='${n}'/>");
  EXPECT_EQ(InnerXacro(m + "<xacro:call macro=\"${'left' + '_leg'}\" n='1'/>"), "<l n=\"1\"/>");
}

TEST(XacroMacro, TheLastDefinitionCounts) {
  EXPECT_EQ(InnerXacro(MacroText("m", "", "1") + MacroText("xacro:m", "", "2") + "<xacro:m/>"), "2");
}

TEST(XacroMacro, RefusesWrongCallsByName) {
  const std::string leg = "\n" + MacroText("leg", "prefix reflect *origin", "<a/>") + "\n";
  ExpectRefusal(leg + "<xacro:leg prefix='a'><o/></xacro:leg>",
                {"macro_parameter: robot.xacro:3: <xacro:leg>", "'leg' (robot.xacro:2)", "its parameter 'reflect'"});
  ExpectRefusal(leg + "<xacro:leg><o/></xacro:leg>", {"its parameters 'prefix', 'reflect'"});
  ExpectRefusal(leg + "<xacro:leg prefix='a' refelct='1'><o/></xacro:leg>",
                {"macro_parameter", "no parameter 'refelct'", "nearest is 'reflect'"});
  ExpectRefusal(leg + "<xacro:leg prefix='a' reflect='1'/>", {"macro_parameter", "block '*origin'", "none"});
  ExpectRefusal(leg + "<xacro:leg prefix='a' reflect='1'><o/><p/></xacro:leg>", {"macro_parameter", "<p>"});
  ExpectRefusal(leg + "<xacro:legg prefix='a'/>", {"unknown_macro: robot.xacro:3: <xacro:legg>", "nearest is 'leg'"});
  ExpectRefusal(MacroText("m", "a a", ""), {"xacro_syntax", "'a' appears twice"});
  ExpectRefusal(MacroText("m", "a:1", ""), {"xacro_syntax", "'a:=VALUE'"});
  ExpectRefusal(MacroText("m", "*b:=1", ""), {"xacro_syntax", "block 'b' cannot have a default"});
  ExpectRefusal(MacroText("if", "", ""), {"bad_name", "'if'"});
}

TEST(XacroMacro, AFailureInsideTellsWhichMacrosWereCalled) {
  const std::string text = "<r>\n" + MacroText("foot", "", "\n<a b='${nothing}'/>") + "\n" +
                           MacroText("leg", "", "\n<xacro:foot/>") + "\n<xacro:leg/></r>";
  const Result<std::string> expanded = ExpandXacroText(text, "robot.xacro", {}, SourcesWith({}));
  ASSERT_FALSE(expanded.ok());
  EXPECT_EQ(expanded.failure().code, FailureCode::kUnknownProperty);
  EXPECT_EQ(expanded.failure().message.find("robot.xacro:3: <a>: 'nothing': the property 'nothing' is not defined"), 0U)
      << expanded.failure().message;
  ASSERT_EQ(expanded.failure().suggestions.size(), 2U);
  EXPECT_EQ(expanded.failure().suggestions[0].text, "called by <xacro:foot> in robot.xacro:5");
  EXPECT_EQ(expanded.failure().suggestions[1].text, "called by <xacro:leg> in robot.xacro:6");
}

TEST(XacroMacro, FilesFromBeforeJadeNeedNoPrefix) {
  const std::string old =
      "<property name='m' value='2'/><macro name='leg' params='n *o'><link name='${n}' m='${m}'/>"
      "<insert_block name='o'/></macro><leg n='a'><origin/></leg><gazebo><property name='kept'/></gazebo>"
      "<if value='0'><x/></if>";
  EXPECT_EQ(InnerXacro(old), "<link name=\"a\" m=\"2\"/><origin/><gazebo><property name=\"kept\"/></gazebo>");
  const Result<std::string> plain = ExpandXacroText("<r><property name='m' value='2'/></r>", "f", {}, SourcesWith({}));
  ASSERT_TRUE(plain.ok());
  EXPECT_NE(plain->find("<property name=\"m\" value=\"2\"/>"), std::string::npos) << *plain;
}

}  // namespace
}  // namespace gaitwright
