// SPDX-License-Identifier: BSD-3-Clause
// Included files, YAML files, arguments and substitutions.
#include <gtest/gtest.h>

#include "tests/kinematics/description/xacro_files.h"

namespace gaitwright {
namespace {

std::string XacroFileText(const std::string& inside) {
  return "<robot xmlns:xacro='http://www.ros.org/wiki/xacro'>\n" + inside + "</robot>";
}

std::string XacroIncludes(const std::string& file, const std::string& more = "") {
  return "<xacro:include filename=\"" + file + "\" " + more + "/>";
}

void ExpectIn(const std::string& message, const std::vector<std::string>& parts) {
  for (const std::string& part : parts)
    EXPECT_NE(message.find(part), std::string::npos) << message << "\nlacks " << part;
}

TEST(XacroInclude, FilesShareTheirNames) {
  const TextFiles files = {
      {"parts/leg.xacro", XacroFileText("<xacro:include filename='size.xacro'/><xacro:macro name='leg'>"
                                        "<l s='${size}'/></xacro:macro><in_leg/>")},
      {"parts/size.xacro", XacroFileText("<xacro:property name='size' value='3'/>")}};
  EXPECT_EQ(InnerXacro(XacroIncludes("parts/leg.xacro") + "<xacro:leg/>", files), "<in_leg/><l s=\"3\"/>");
}

TEST(XacroInclude, PackagesAreFound) {
  const TextFiles files = {{"/packages/bot/urdf/a.xacro", XacroFileText("<a d='$(dirname)'/>")}};
  EXPECT_EQ(InnerXacro(XacroIncludes("$(find bot)/urdf/a.xacro"), files), "<a d=\"/packages/bot/urdf\"/>");
  EXPECT_EQ(InnerXacro("<xacro:property name='p' value='bot'/>" + XacroIncludes("$(find ${p})/urdf/a.xacro"), files),
            "<a d=\"/packages/bot/urdf\"/>");
  ExpectIn(InnerXacro("\n" + XacroIncludes("$(find bott)/urdf/a.xacro"), files),
           {"no_package: robot.xacro:2: <xacro:include>", "'bott' is not found", "bott=DIR"});
}

TEST(XacroInclude, FilesGoByTheUrlsOfMeshesToo) {
  const TextFiles files = {{"/packages/bot/urdf/a.xacro", XacroFileText("<a/>")}, {"/b.xacro", XacroFileText("<b/>")}};
  EXPECT_EQ(InnerXacro(XacroIncludes("package://bot/urdf/a.xacro"), files), "<a/>");
  EXPECT_EQ(InnerXacro(XacroIncludes("file://$(find bot)/urdf/a.xacro"), files), "<a/>");
  EXPECT_EQ(InnerXacro(XacroIncludes("file:///b.xacro"), files), "<b/>");
  ExpectIn(InnerXacro(XacroIncludes("package://bott/urdf/a.xacro"), files), {"no_package", "'bott' is not found"});
  ExpectIn(InnerXacro(XacroIncludes("package://bot"), files), {"xacro_include", "no such file"});
  ExpectIn(InnerXacro(XacroIncludes("package://"), files), {"no_package"});
}

TEST(XacroInclude, ANamespaceKeepsNamesApart) {
  const TextFiles files = {{"arm.xacro", XacroFileText("<xacro:property name='n' value='${k + 6}'/><xacro:property "
                                                       "name='k' value='1'/><xacro:macro name='m' params='a:=1'>"
                                                       "<m n='${n}' a='${a}'/></xacro:macro>")}};
  const std::string with = "<xacro:property name='n' value='0'/>" + XacroIncludes("arm.xacro", "ns='arm'");
  EXPECT_EQ(InnerXacro(with + "${n} ${arm.n} ${arm.n * 2}", files), "0 7 14");
  EXPECT_EQ(InnerXacro(with + "<xacro:arm.m a='2'/>", files), "<m n=\"7\" a=\"2\"/>");
  ExpectIn(InnerXacro(with + "${arm.nn}", files), {"unknown_property", "'arm.nn'"});
  ExpectIn(InnerXacro(with + "<xacro:m/>", files), {"unknown_macro", "arm.m"});
}

TEST(XacroInclude, AMissingFileIsRefusedUnlessItIsOptional) {
  EXPECT_EQ(InnerXacro(XacroIncludes("no.xacro", "optional='true'") + "<a/>"), "<a/>");
  ExpectIn(InnerXacro("\n\n" + XacroIncludes("no.xacro")),
           {"xacro_include: robot.xacro:3: <xacro:include>", "no such file: 'no.xacro'"});
  ExpectIn(InnerXacro(XacroIncludes("*.xacro")), {"xacro_include", "pattern"});
}

TEST(XacroInclude, AFileThatIncludesItselfIsRefused) {
  const TextFiles files = {{"a.xacro", XacroFileText(XacroIncludes("b.xacro"))},
                           {"b.xacro", XacroFileText(XacroIncludes("a.xacro"))}};
  ExpectIn(InnerXacro(XacroIncludes("a.xacro"), files), {"xacro_recursion: b.xacro:2", "'a.xacro' includes itself"});
}

TEST(XacroInclude, FailuresNameTheIncludedFile) {
  const TextFiles files = {{"a.xacro", XacroFileText("<xacro:macro name='m'>\n<x v='${q}'/></xacro:macro>")},
                           {"bad.xacro", "<robot>\n<a></robot>"}};
  ExpectIn(InnerXacro(XacroIncludes("a.xacro") + "<xacro:m/>", files), {"unknown_property: a.xacro:3: <x>"});
  ExpectIn(InnerXacro(XacroIncludes("bad.xacro"), files), {"not_xml: robot.xacro:1", "bad.xacro:2: it is not XML"});
}

TEST(XacroYaml, GivesNestedValuesAndUnits) {
  const TextFiles files = {{"config/limits.yaml",
                            "hip: {lower: !degrees -90, upper: 1.5, names: [a, 'b', 3]}\n"
                            "knee:\n  effort: 40\n  on: yes\n  text: \"12\"\n  none: ~\n  small: 1e-3\n"}};
  const std::string load = "<xacro:property name='c' value=\"${xacro.load_yaml('config/limits.yaml')}\"/>";
  EXPECT_EQ(InnerXacro(load + "${c['hip']['lower'] == -pi / 2}", files), "True");
  EXPECT_EQ(InnerXacro(load + "${c.hip.upper + 1} ${c.hip.names[2] + 1} ${c['hip'].names[1]}", files), "2.5 4 b");
  EXPECT_EQ(InnerXacro(load + "${c.knee.effort} ${c.knee.text + 'x'} ${c.knee.none} ${c.knee.small}", files),
            "40 12x None 0.001");
  EXPECT_EQ(InnerXacro(load + "${c['knee'][True]}", files), "True");  // the key `on` is a truth value in YAML 1.1
  EXPECT_EQ(InnerXacro("${load_yaml('config/limits.yaml')['knee']['effort'] * 2}", files), "80");
  ExpectIn(InnerXacro(load + "${c.hips}", files), {"unknown_key", "'hips'", "'hip'"});
}

TEST(XacroYaml, IsReadBesideTheFileThatNamesIt) {
  const TextFiles files = {
      {"parts/leg.xacro", XacroFileText("<xacro:property name='c' value=\"${load_yaml('leg.yaml')}\"/>")},
      {"parts/leg.yaml", "mass: 3\n"}};
  EXPECT_EQ(InnerXacro(XacroIncludes("parts/leg.xacro") + "${c.mass}", files), "3");
}

TEST(XacroYaml, RefusesWhatIsNoYaml) {
  ExpectIn(InnerXacro("\n${load_yaml('no.yaml')}"), {"xacro_yaml", "robot.xacro:1", "no such file: 'no.yaml'"});
  ExpectIn(InnerXacro("${load_yaml('a.yaml')}", {{"a.yaml", "a: [1"}}), {"xacro_yaml", "a.yaml: line"});
  ExpectIn(InnerXacro("${load_yaml('a.yaml')}", {{"a.yaml", "a: 1\n---\nb: 2"}}),
           {"xacro_yaml", "second YAML document"});
}

TEST(XacroArgument, HasADefaultOrAGivenValue) {
  const std::string text = "<xacro:arg name='kind' default='${1 + 1}'/><a b='$(arg kind)'/>";
  EXPECT_EQ(InnerXacro(text), "<a b=\"2\"/>");
  EXPECT_EQ(InnerXacro(text, {}, {{"kind", "x"}}), "<a b=\"x\"/>");
  EXPECT_EQ(InnerXacro("<xacro:arg name='on' default='true'/><xacro:if value='$(arg on)'>y</xacro:if>"), "y");
  EXPECT_EQ(InnerXacro(text + "${'$(arg kind)' == 'x'}", {}, {{"kind", "x"}}), "<a b=\"x\"/>True");
  EXPECT_EQ(InnerXacro(text + "${xacro.arg('kind') + '!'}"), "<a b=\"2\"/>2!");
}

TEST(XacroArgument, TheRootMayUseWhatTheFileDeclares) {
  const Result<std::string> expanded =
      ExpandXacroText("<robot name='$(arg name)' xmlns:xacro='x'><xacro:arg name='name' default='bot'/></robot>", "f",
                      {}, SourcesWith({}));
  ASSERT_TRUE(expanded.ok()) << expanded.failure().message;
  EXPECT_NE(expanded->find("<robot name=\"bot\"/>"), std::string::npos) << *expanded;
}

TEST(XacroArgument, RefusesOnesThatAreMissingOrNotUsed) {
  ExpectIn(InnerXacro("\n<a b='$(arg kind)'/>"), {"xacro_argument: robot.xacro:2: <a>", "'kind' has no value"});
  ExpectIn(InnerXacro("<xacro:arg name='kind' default='1'/>", {}, {{"kinds", "2"}}),
           {"unknown_argument", "'kinds'", "'kind'"});
}

TEST(XacroSubstitution, ReadsTheEnvironmentAndEvaluates) {
  EXPECT_EQ(InnerXacro("<a b='$(env ROBOT) $(optenv NONE no thing) $(optenv ROBOT x)'/>"),
            "<a b=\"bot no thing bot\"/>");
  const std::string argument = "<xacro:arg name='n' default='3'/>";
  EXPECT_EQ(InnerXacro(argument + "<a b='$(eval n * 2)'/>"), "<a b=\"6\"/>");
  EXPECT_EQ(InnerXacro(argument + "<a b=\"$(eval arg('n') == 3 and env('ROBOT') == 'bot')\"/>"), "<a b=\"True\"/>");
  EXPECT_EQ(InnerXacro("<a b='$(dirname)'/>"), "<a b=\".\"/>");
  ExpectIn(InnerXacro("<a b='$(env NONE)'/>"), {"no_variable", "'NONE'"});
  ExpectIn(InnerXacro("<a b='$(anon x)'/>"), {"unknown_substitution", "$(anon", "'find'"});
  ExpectIn(InnerXacro("${xacro.fatal('choose', 3)}"), {"xacro_fatal", "choose 3"});
}

TEST(XacroResult, HasNoTraceOfXacro) {
  const std::string text =
      "<?xml version='1.0'?>\n<!-- a --><robot name='r' xmlns:xacro='http://wiki.ros.org/xacro' xmlns:k='urn:k'>"
      "<!-- b --><xacro:property name='x' value='1'/><gazebo reference='a'><plugin "
      "name='p'>&lt;raw&gt;</plugin></gazebo>"
      "<ros2_control k:x='${x}'><![CDATA[${kept}]]></ros2_control></robot>";
  const Result<std::string> expanded = ExpandXacroText(text, "f", {}, SourcesWith({}));
  ASSERT_TRUE(expanded.ok()) << expanded.failure().message;
  EXPECT_EQ(*expanded,
            "<?xml version=\"1.0\" encoding=\"utf-8\"?>\n<robot name=\"r\" xmlns:k=\"urn:k\">\n"
            "    <gazebo reference=\"a\">\n        <plugin name=\"p\">&lt;raw&gt;</plugin>\n    </gazebo>\n"
            "    <ros2_control k:x=\"1\"><![CDATA[${kept}]]></ros2_control>\n</robot>\n");
}

TEST(XacroResult, AXacroFileIsDistinguishedFromAUrdf) {
  EXPECT_TRUE(IsXacro("<robot><xacro:leg/></robot>"));
  EXPECT_TRUE(IsXacro("<robot><a b='${x}'/></robot>"));
  EXPECT_TRUE(IsXacro("<robot><include filename='$(find a)/b'/></robot>"));
  EXPECT_FALSE(IsXacro("<robot xmlns:xacro='http://wiki.ros.org/xacro'><link name='a'/></robot>"));
  EXPECT_FALSE(IsXacro("<!-- made of ${x} by <xacro:y> --><robot/>"));
}

}  // namespace
}  // namespace gaitwright
