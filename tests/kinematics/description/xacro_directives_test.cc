// SPDX-License-Identifier: BSD-3-Clause
#include "kinematics/description/xacro_expander_internal.h"
#include "tests/kinematics/description/xacro_files.h"
#include "tests/kinematics/description/xacro_values.h"

namespace gaitwright {
namespace {

/// The name of the failure code of a refused description; "" if it is expanded.
std::string CodeOfInner(const std::string& inside) {
  const Result<std::string> expanded =
      ExpandXacroText("<r xmlns:xacro='x'>" + inside + "</r>", "robot.xacro", {}, SourcesWith({}));
  return expanded.ok() ? "" : FailureCodeName(expanded.failure().code);
}

TEST(XacroDirectives, TruthOfATextIsAWordOrAWholeNumber) {
  for (const char* word : {"true", "True", " 1 ", "-1", "2"}) EXPECT_TRUE(XacroTruthOfText({std::string(word)}, "it"));
  for (const char* word : {"false", "False", "0"}) EXPECT_FALSE(XacroTruthOfText({std::string(word)}, "it"));
  EXPECT_TRUE(XacroTruthOfText(RealValue(0.5), "it"));
  EXPECT_FALSE(XacroTruthOfText({}, "it"));
  for (const char* word : {"", "TRUE", "yes", "0.5", "1 2"}) {
    const XacroProblem problem = ProblemOf([&] { XacroTruthOfText({std::string(word)}, "the condition"); });
    EXPECT_EQ(problem.code, FailureCode::kXacroCondition) << word;
    EXPECT_TRUE(problem.message.starts_with("the condition is '" + std::string(word) + "'")) << problem.message;
  }
}

TEST(XacroDirectives, IfAndUnlessAreOpposites) {
  for (const char* value : {"1", "0", "${3 > 2}", "${[]}", "${[0]}"}) {
    const std::string condition = "value=\"" + std::string(value) + "\"";
    const std::string kept =
        InnerXacro("<xacro:if " + condition + "><a/></xacro:if><xacro:unless " + condition + "><b/></xacro:unless>");
    EXPECT_TRUE(kept == "<a/>" || kept == "<b/>") << value << ": " << kept;
  }
}

TEST(XacroDirectives, WhatIsNotTakenIsNotRead) {
  EXPECT_EQ(
      InnerXacro("<xacro:if value='0'><xacro:nothing/>${missing}<xacro:property name='p' value='1'/></xacro:if>a"),
      "a");
  EXPECT_EQ(CodeOfInner("<xacro:if value='0'><xacro:property name='p' value='1'/></xacro:if>${p}"), "unknown_property");
}

TEST(XacroDirectives, RefuseMissingAndUnknownAttributes) {
  const std::vector<std::pair<std::string, std::string>> rows = {
      {"<xacro:if/>", "xacro_missing"},
      {"<xacro:if value='1' vlaue='2'/>", "unknown_attribute"},
      {"<xacro:property value='1'/>", "xacro_missing"},
      {"<xacro:property name='a' valeu='1'/>", "unknown_attribute"},
      {"<xacro:property name='a b' value='1'/>", "bad_name"},
      {"<xacro:property name='' value='1'/>", "bad_name"},
      {"<xacro:property name='a' value='1' remove='perhaps'/>", "xacro_condition"},
      {"<xacro:property name='a' value='1' scope='here'/>", "xacro_scope"},
      {"<xacro:arg default='1'/>", "xacro_missing"},
      {"<xacro:macro params='a'/>", "xacro_missing"},
      {"<xacro:macro name='include'/>", "bad_name"},
      {"<xacro:macro name='xacro:unless'/>", "bad_name"},
      {"<xacro:insert_block/>", "xacro_missing"},
      {"<xacro:insert_block name='o'/>", "unknown_block"},
      {"<xacro:element name='a'/>", "xacro_missing"},
      {"<xacro:element xacro:name='a b'/>", "bad_name"},
      {"<xacro:attribute name='a'/>", "xacro_missing"},
      {"<xacro:attribute name='-a' value='1'/>", "bad_name"},
      {"<xacro:attribute name='xacro:a' value='1'/>", "bad_name"},
      {"<xacro:call/>", "xacro_missing"},
      {"<xacro:call macro='m'/>", "unknown_macro"}};
  for (const auto& [inside, code] : rows) EXPECT_EQ(CodeOfInner(inside), code) << inside;
}

TEST(XacroDirectives, APropertyIsReadWhereItIsDefinedIfItIsNotLazy) {
  const auto with = [](const std::string& how) {
    return InnerXacro("<xacro:property name='b' value='1'/><xacro:property name='a' value='${b}' " + how +
                      "/><xacro:property name='b' value='2'/>${a}");
  };
  EXPECT_EQ(with(""), "2");
  EXPECT_EQ(with("lazy_eval='true'"), "2");
  EXPECT_EQ(with("lazy_eval='false'"), "1");
  EXPECT_EQ(with("scope='global'"), "1");
}

TEST(XacroDirectives, AnElementTakesTheAttributesThatAreMadeForIt) {
  EXPECT_EQ(InnerXacro("<a x='1'><xacro:attribute name='x' value='2'/><xacro:attribute name='y.z-1' value='3'/></a>"),
            "<a x=\"2\" y.z-1=\"3\"/>");
  EXPECT_EQ(InnerXacro("<xacro:macro name='m'><xacro:attribute name='n' value='1'/></xacro:macro><a><xacro:m/></a>"),
            "<a n=\"1\"/>");
  EXPECT_EQ(InnerXacro("<xacro:element xacro:name='_a' b='1'>t</xacro:element>"), "<_a b=\"1\">t</_a>");
}

TEST(XacroDirectives, ARemovedPropertyOrBlockIsGone) {
  const std::string block = "<xacro:property name='o'><a/></xacro:property>";
  const std::string remove = "<xacro:property name='o' remove='true'/>";
  EXPECT_EQ(InnerXacro(block + "<xacro:insert_block name='o'/>"), "<a/>");
  EXPECT_EQ(CodeOfInner(block + remove + "<xacro:insert_block name='o'/>"), "unknown_block");
  EXPECT_EQ(InnerXacro(remove + "a"), "a") << "what is not there may be removed";
}

TEST(XacroDirectives, AnArgumentKeepsItsFirstDefault) {
  EXPECT_EQ(InnerXacro("<xacro:arg name='n' default='1'/><xacro:arg name='n' default='2'/>$(arg n)"), "1");
  EXPECT_EQ(InnerXacro("<xacro:arg name='n'/><xacro:arg name='n' default='2'/>$(arg n)"), "2");
  EXPECT_EQ(CodeOfInner("<xacro:arg name='n'/>$(arg n)"), "xacro_argument");
}

}  // namespace
}  // namespace gaitwright
