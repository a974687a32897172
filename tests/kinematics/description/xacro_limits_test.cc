// SPDX-License-Identifier: BSD-3-Clause
// Malicious descriptions are refused quickly, with a message.
#include <gtest/gtest.h>

#include "tests/kinematics/description/xacro_files.h"

namespace gaitwright {
namespace {

void ExpectLimit(const std::string& inside, const std::string& part, const TextFiles& files = {}) {
  const std::string message = InnerXacro(inside, files);
  EXPECT_TRUE(message.starts_with("xacro_limit: ")) << message.substr(0, 300);
  EXPECT_NE(message.find(part), std::string::npos) << message.substr(0, 300);
}

std::string RepeatedXacro(const std::string& text, int times) {
  std::string all;
  for (int i = 0; i < times; ++i) all += text;
  return all;
}

/// Properties n0 to n<count>. Each contains the previous one twice, and the first contains `first`.
std::string DoublingProperties(int count, const std::string& first, const std::string& twice) {
  std::string text = "<xacro:property name='n0' value=\"" + first + "\"/>";
  for (int i = 1; i <= count; ++i) {
    std::string value = twice;
    for (std::size_t at = value.find('#'); at != std::string::npos; at = value.find('#'))
      value.replace(at, 1, "n" + std::to_string(i - 1));
    text += "<xacro:property name='n" + std::to_string(i) + "' value=\"${" + value + "}\"/>";
  }
  return text + "${n" + std::to_string(count) + "}";
}

TEST(XacroLimits, AMacroThatCallsItselfEnds) {
  ExpectLimit("<xacro:macro name='m'><xacro:m/></xacro:macro><xacro:m/>", "'m' calls itself");
}

TEST(XacroLimits, ABlockThatInsertsItselfEnds) {
  ExpectLimit("<xacro:property name='b'><xacro:insert_block name='b'/></xacro:property><xacro:insert_block name='b'/>",
              "check whether one uses itself");
}

TEST(XacroLimits, MacrosThatDoubleEnd) {
  std::string text = "<xacro:macro name='m0'><a/></xacro:macro>";
  for (int i = 1; i <= 60; ++i) {
    const std::string call = "<xacro:m" + std::to_string(i - 1) + "/>";
    text += "<xacro:macro name='m" + std::to_string(i) + "'>" + call + call + "</xacro:macro>";
  }
  ExpectLimit(text + "<xacro:m60/>", "more than");
}

TEST(XacroLimits, TextsThatDoubleEnd) {
  ExpectLimit(DoublingProperties(60, "'ab'", "# + #"), "a text has");
  ExpectLimit(DoublingProperties(60, "ab", "'%s%s' % [#, #]"), "text");
  ExpectLimit("${'a' * 10000000}", "too long");
}

TEST(XacroLimits, ListsThatDoubleEnd) {
  ExpectLimit(DoublingProperties(60, "${[1, 2]}", "# + #"), "items");
  ExpectLimit(DoublingProperties(60, "${[1, 2]}", "[#, #]"), "nested lists and dictionaries");
  ExpectLimit(DoublingProperties(30, "${[1, 2]}", "[#, #]"), "printed text of a list has");
}

TEST(XacroLimits, LongComputationsEnd) {
  ExpectLimit("${sum([sum([j for j in range(9000)]) for i in range(9000)])}", "steps");
}

TEST(XacroLimits, DeepExpressionsEnd) {
  ExpectLimit("${" + RepeatedXacro("(", 100000) + "}", "at most 65536");
  ExpectLimit("${" + RepeatedXacro("(", 1000) + "1" + RepeatedXacro(")", 1000) + "}", "nested expressions");
  ExpectLimit("${" + RepeatedXacro("-", 1000) + "1}", "nested expressions");
  ExpectLimit("${1" + RepeatedXacro("**1", 1000) + "}", "nested expressions");
  ExpectLimit("${a" + RepeatedXacro("[0]", 1000) + "}", "in a row");
  ExpectLimit("<a b='" + RepeatedXacro("$(arg ", 1000) + RepeatedXacro(")", 1000) + "'/>", "nested ");
  EXPECT_EQ(InnerXacro("${1" + RepeatedXacro(" + 1", 10000) + "}"), "10001");
}

TEST(XacroLimits, LongChainsOfPropertiesEnd) {
  ExpectLimit(DoublingProperties(1000, "1", "# + 0"), "nested ");
  EXPECT_EQ(InnerXacro(DoublingProperties(90, "1", "# + 0")), "1");
}

TEST(XacroLimits, DeepElementsEnd) {
  EXPECT_TRUE(InnerXacro(RepeatedXacro("<a>", 450) + RepeatedXacro("</a>", 450)).starts_with("not_xml: "));
  const std::string nest =
      "<xacro:macro name='m' params='n'><a><xacro:if value='${n}'><xacro:m n='${n - 1}'/></xacro:if>"
      "</a></xacro:macro>";
  ExpectLimit(nest + "<xacro:m n='95'/>", "nested elements");
  EXPECT_TRUE(InnerXacro(nest + "<xacro:m n='60'/>").starts_with("<a><a>"));
}

TEST(XacroLimits, LargeResultsEnd) {
  const std::string text = "<xacro:macro name='m' params='*b'>" + RepeatedXacro("<xacro:insert_block name='b'/>", 100) +
                           "</xacro:macro><xacro:m><a b=\"${'abcdefgh' * 100000}\"/></xacro:m>";
  ExpectLimit(text, "more than 64 MiB");
}

}  // namespace
}  // namespace gaitwright
