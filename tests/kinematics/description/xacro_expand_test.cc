// SPDX-License-Identifier: BSD-3-Clause
#include "tests/kinematics/description/xacro_files.h"

namespace gaitwright {
namespace {

/// The expansion of a whole file, or the failure.
Result<std::string> ExpandedRoot(const std::string& text, const std::map<std::string, std::string>& arguments = {}) {
  return ExpandXacroText(text, "robot.xacro", arguments, SourcesWith({}));
}

FailureCode CodeOfRoot(const std::string& text, const std::map<std::string, std::string>& arguments = {}) {
  const Result<std::string> expanded = ExpandedRoot(text, arguments);
  EXPECT_FALSE(expanded.ok()) << text;
  return expanded.failure().code;
}

// Plain text is unchanged, so an expanded text can be expanded again.
TEST(XacroExpand, IsDoneAfterOnce) {
  const std::string text =
      "<robot name='r' xmlns:xacro='x'><xacro:macro name='m' params='n'><link name='l${n}'>a &lt; "
      "b</link></xacro:macro>"
      "<xacro:m n='1'/><xacro:if value='true'><xacro:m n='2'/></xacro:if></robot>";
  const Result<std::string> once = ExpandedRoot(text);
  ASSERT_TRUE(once.ok()) << once.failure().message;
  EXPECT_FALSE(IsXacro(*once));
  const Result<std::string> twice = ExpandedRoot(*once);
  ASSERT_TRUE(twice.ok()) << twice.failure().message;
  EXPECT_EQ(*twice, *once);
}

TEST(XacroExpand, AttributesAreEvaluatedInTheirOrder) {
  EXPECT_EQ(InnerXacro("<a z='${1}' y='b' x=\"${'&lt;'}\"/>"), "<a z=\"1\" y=\"b\" x=\"&lt;\"/>");
  EXPECT_EQ(InnerXacro("<${x}/>").substr(0, 7), "not_xml");
}

TEST(XacroExpand, ElementsOfOtherNamespacesStay) {
  EXPECT_EQ(InnerXacro("<k:if value='0'><k:b/></k:if>"), "<k:if value=\"0\"><k:b/></k:if>");
  EXPECT_EQ(InnerXacro("<a><property name='p' value='1'/></a>"), "<a><property name=\"p\" value=\"1\"/></a>")
      << "below the root an element without prefix is the description's own";
}

TEST(XacroExpand, WithoutThePrefixOnlyItsOwnFormsAreDirectives) {
  EXPECT_EQ(InnerXacro("<if/>"), "<if/>");
  EXPECT_EQ(InnerXacro("<a><if value='1'><b/></if></a>"), "<a><b/></a>");
  EXPECT_EQ(InnerXacro("<include/>"), "<include/>");
  EXPECT_EQ(InnerXacro("<macro name='m'><b/></macro><a><m/></a>"), "<a><b/></a>");
  EXPECT_EQ(InnerXacro("<xacro:macro name='m'><b/></xacro:macro><m/>"), "<m/>") << "called as it was defined";
}

TEST(XacroExpand, CommentsGoAndCdataStaysAsItIs) {
  EXPECT_EQ(InnerXacro("<!-- ${missing} --><a><![CDATA[${missing} <b/>]]></a>"), "<a><![CDATA[${missing} <b/>]]></a>");
}

TEST(XacroExpand, TheRootIsExpandedLastAndLosesTheNamespace) {
  const Result<std::string> expanded = ExpandedRoot(
      "<robot name='${n}' version='$(arg v)' xmlns:xacro='x' xmlns:k='y'><xacro:property name='n' value='5'/>"
      "<xacro:arg name='v' default='2'/></robot>");
  ASSERT_TRUE(expanded.ok()) << expanded.failure().message;
  EXPECT_NE(expanded->find("<robot name=\"5\" version=\"2\" xmlns:k=\"y\"/>"), std::string::npos) << *expanded;
}

TEST(XacroExpand, RefusesByCode) {
  EXPECT_EQ(CodeOfRoot(""), FailureCode::kNotXml);
  EXPECT_EQ(CodeOfRoot("<robot><a></robot>"), FailureCode::kNotXml);
  EXPECT_EQ(CodeOfRoot(std::string("<robot>\0</robot>", 16)), FailureCode::kNotXml);
  EXPECT_EQ(CodeOfRoot("<xacro:if value='1'/>"), FailureCode::kNotUrdf);
  EXPECT_EQ(CodeOfRoot("<robot xacro:name='a'/>"), FailureCode::kUnknownAttribute);
  EXPECT_EQ(CodeOfRoot("<robot><a xacro:x='1'/></robot>"), FailureCode::kUnknownAttribute);
  EXPECT_EQ(CodeOfRoot("<robot><xacro:leg/></robot>"), FailureCode::kUnknownMacro);
  EXPECT_EQ(CodeOfRoot("<robot/>", {{"a", "1"}}), FailureCode::kUnknownArgument);
  EXPECT_EQ(CodeOfRoot("<robot a='&#1;'/>"), FailureCode::kNotText);
}

TEST(XacroExpand, AFailureNamesTheElementThatIsExpanded) {
  const Result<std::string> expanded = ExpandedRoot("<robot>\n<a>\n<b/>\n${1 / 0}</a></robot>");
  ASSERT_FALSE(expanded.ok());
  EXPECT_EQ(expanded.failure().stage, "ExpandXacro");
  EXPECT_TRUE(expanded.failure().message.starts_with("robot.xacro:2: <a>: ")) << expanded.failure().message;
  EXPECT_TRUE(expanded.failure().suggestions.empty());
}

TEST(XacroExpand, OnlyTheInnermostCallsAreListed) {
  std::string text = "<robot><xacro:macro name='m0'>${missing}</xacro:macro>";
  for (int i = 1; i < 10; ++i)
    text += "<xacro:macro name='m" + std::to_string(i) + "'><xacro:m" + std::to_string(i - 1) + "/></xacro:macro>";
  const Result<std::string> expanded = ExpandedRoot(text + "<xacro:m9/></robot>");
  ASSERT_FALSE(expanded.ok());
  ASSERT_EQ(expanded.failure().suggestions.size(), 6U);
  EXPECT_EQ(expanded.failure().suggestions[0].text, "called by <xacro:m0> in robot.xacro:1");
  EXPECT_EQ(expanded.failure().suggestions[5].text, "called by <xacro:m5> in robot.xacro:1");
}

}  // namespace
}  // namespace gaitwright
