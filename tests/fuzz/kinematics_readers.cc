// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <optional>

#include "kinematics/base/options.h"
#include "kinematics/base/text.h"
#include "kinematics/description/mjcf.h"
#include "kinematics/description/xacro.h"
#include "kinematics/model/load_robot.h"
#include "kinematics/model/mend_urdf.h"
#include "kinematics/model/urdf_check.h"
#include "tests/fuzz/inputs.h"
#include "tests/fuzz/reader.h"
#include "tests/fuzz/robot_laws.h"

namespace gaitwright::fuzz {
namespace {

Verdict ReadUrdf(const std::string& input) {
  const Result<RobotModel> model = LoadRobotFromText(input, "");
  if (!model) return Verdict::kRefused;
  const MendedUrdf mended = MendUrdf(input);
  Require(!CheckUrdf(mended.text), "a robot is not made of a URDF that the check refuses");
  Require(MendUrdf(mended.text).text == mended.text, "a mended file needs no further mending");
  CheckRobotLaws(*model);
  return Verdict::kAccepted;
}

/// In the same folder are `part.xacro`, also in the package `bot`, `sizes.yaml` and the input again as `self.xacro`.
Result<std::string> ExpandInput(const std::string& input) {
  const auto missing = [](const std::string& what) {
    return Failure{
        FailureKind::kBadInput, FailureCode::kNoSuchFile, "File", fmt::format("no such file: '{}'", what), {}};
  };
  XacroSources sources;
  sources.read = [&](const std::string& path) -> Result<std::string> {
    if (path == "self.xacro") return input;
    if (path == "sizes.yaml")
      return std::string("leg: {length: 0.2, angle: !degrees 30, names: [a, 'b', 3]}\nmass: 1.5\n");
    if (path != "part.xacro" && path != "/bot/part.xacro") return missing(path);
    return std::string(
        "<robot xmlns:xacro='x'><xacro:property name='part' value='2'/><xacro:macro name='part' params='n:=1 *o'>"
        "<part n='${n * part}'><xacro:insert_block name='o'/></part></xacro:macro></robot>");
  };
  sources.find_package = [&](const std::string& name, const std::string&) -> Result<std::string> {
    return name == "bot" ? Result<std::string>(std::string("/bot")) : missing(name);
  };
  sources.environment = [](const std::string& name) {
    return name == "ROBOT" ? std::optional<std::string>("bot") : std::nullopt;
  };
  return ExpandXacroText(input, "input.xacro", {}, sources);
}

Verdict ReadXacro(const std::string& input) {
  const Result<std::string> expanded = ExpandInput(input);
  if (!expanded) {
    Require(expanded.failure().code != FailureCode::kInternal && !expanded.failure().message.empty(),
            "a refusal has a code and a reason");
    return Verdict::kRefused;
  }
  // An escape, which a second pass would evaluate
  if (expanded->find('$') != std::string::npos) return Verdict::kAccepted;
  const Result<std::string> again = ExpandInput(*expanded);
  Require(again.ok(), "expanded text is plain XML");
  Require(ExpandInput(*again).value() == *again, "expanding again changes nothing");
  return Verdict::kAccepted;
}

/// For a robot with joints A_hip, A_knee and so on for four legs, and feet A_foot and so on.
Verdict ReadRobotYaml(const std::string& input) {
  static const std::string urdf = SourceFile("tests/fuzz/corpus/urdf/four_legs.urdf");
  const Result<RobotModel> model = LoadRobotFromText(urdf, input);
  if (!model) return Verdict::kRefused;
  CheckRobotLaws(*model);
  return Verdict::kAccepted;
}

/// A model; its meshes are all one tetrahedron, and its included files are all one leg.
Verdict ReadMjcf(const std::string& input) {
  static const std::string leg = SourceFile("tests/fuzz/corpus/mjcf/leg.xml");
  MjcfFiles files;
  files.text = [](const std::string& file) -> Result<std::string> {
    if (file == "leg.xml") return leg;
    return Failure{FailureKind::kBadInput, FailureCode::kNoFile, "ReadFile", "no such file", {}};
  };
  files.mesh = [](const std::string&) -> Result<MjcfMesh> {
    return MjcfMesh{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}}};
  };
  const Result<ConvertedMjcf> converted = ConvertMjcfText(input, files);
  if (!converted) {
    Require(IsPlainText(converted.failure().message), "the reason for a refusal is printable");
    return Verdict::kRefused;
  }
  Require(IsMjcf(input), "a converted file is recognised as a model");
  for (const std::string& note : converted->notes) Require(IsPlainText(note), "a note is printable");
  Result<RobotModel> model = LoadRobotFromText(converted->urdf, converted->yaml);
  if (!model && model.failure().code == FailureCode::kRobotYaml)  // the keyframe is not a stance
    model = LoadRobotFromText(converted->urdf, converted->yaml_without_posture);
  if (!model) {
    Require(model.failure().code != FailureCode::kNotXml && model.failure().code != FailureCode::kRobotYaml &&
                model.failure().code != FailureCode::kUnknownLink && model.failure().code != FailureCode::kUrdfMissing,
            "the URDF and the robot.yaml of a model are valid: " + model.failure().message);
    return Verdict::kRefused;
  }
  CheckRobotLaws(*model);
  return Verdict::kAccepted;
}

Verdict ReadMeshOf(const std::string& input, const std::string& ending) {
  const Result<Mesh> mesh = ReadMesh(InFile(input, ending));
  if (!mesh) return Verdict::kRefused;
  CheckMeshLaws(*mesh);
  return Verdict::kAccepted;
}
Verdict ReadStl(const std::string& input) { return ReadMeshOf(input, ".stl"); }
Verdict ReadObj(const std::string& input) { return ReadMeshOf(input, ".obj"); }
Verdict ReadCollada(const std::string& input) { return ReadMeshOf(input, ".dae"); }

/// Options of every kind, for this reader only.
struct EveryKind {
  double length_m = 0.5;
  int count = 3;
  bool fast = false;
  std::string method = "optimised", name;

  OptionFields Fields() {
    return {{"length_m", &length_m, "m", -1.0, 1e6, "A length.", {}},
            {"count", &count, "1", 1.0, 100.0, "A count.", {}},
            {"fast", &fast, "", 0.0, 1.0, "A switch.", {}},
            {"method", &method, "", 0.0, 0.0, "A choice.", {"optimised", "preview"}},
            {"name", &name, "", 0.0, 0.0, "A text.", {}}};
  }
};

/// A key and its value per line, as in --set and YAML.
Verdict ReadOption(const std::string& input) {
  EveryKind options;
  OptionFields fields = options.Fields();
  const std::string key = input.substr(0, input.find('='));
  const std::string text = key.size() < input.size() ? input.substr(key.size() + 1) : "";
  try {
    SetOption(fields, key, text);
  } catch (const InvalidArgument&) {
    return Verdict::kRefused;
  }
  CheckOptions(fields);
  for (const OptionField& field : fields) {
    EveryKind again;
    OptionFields copy = again.Fields();
    SetOption(copy, field.key, OptionText(field));
    for (const OptionField& other : copy)
      Require(other.key != field.key || OptionText(other) == OptionText(field), "an option is read back as it is");
  }
  return Verdict::kAccepted;
}

const std::vector<std::string> kUrdfWords = {"<link name='x'/>",
                                             "<joint name='j' type='revolute'>",
                                             "continuous",
                                             "prismatic",
                                             "fixed",
                                             "revolute",
                                             "<mimic joint='A_hip' multiplier='2' offset='0.1'/>",
                                             "<limit lower='-1' upper='1' effort='1' velocity='1'/>",
                                             "<axis xyz='0 0 1'/>",
                                             "<inertial>",
                                             "</inertial>",
                                             "<mass value='1'/>",
                                             "<origin xyz='0 0 0' rpy='0 0 0'/>",
                                             "<collision><geometry><box size='1 1 1'/></geometry></collision>",
                                             "<sphere radius='1'/>",
                                             "<cylinder radius='1' length='1'/>",
                                             "<mesh filename='a.stl'/>",
                                             "&#0;",
                                             "&#xD800;",
                                             "&amp;",
                                             "<![CDATA[",
                                             "]]>",
                                             "<!--",
                                             "-->",
                                             "<?xml version='1.0'?>",
                                             "<!DOCTYPE a [<!ENTITY b \"c\">]>",
                                             "xyz",
                                             "rpy",
                                             "trunk",
                                             "A_hip",
                                             "A_knee",
                                             "A_thigh",
                                             "B_foot"};
const std::vector<std::string> kXacroWords = {"<xacro:property name='a' value='${b}'/>",
                                              "<xacro:property name='b' default='1' scope='global' lazy_eval='false'/>",
                                              "scope='parent'",
                                              "<xacro:macro name='m' params='a b:=1 *c **d e:=^|2'>",
                                              "</xacro:macro>",
                                              "<xacro:m a='1'><o/><p/></xacro:m>",
                                              "<xacro:insert_block name='c'/>",
                                              "<xacro:if value='${a}'>",
                                              "</xacro:if>",
                                              "<xacro:unless value='0'/>",
                                              "<xacro:include filename='part.xacro' ns='n'/>",
                                              "<xacro:include filename='self.xacro'/>",
                                              "<xacro:arg name='k' default='1'/>",
                                              "<xacro:element xacro:name='x'/>",
                                              "<xacro:attribute name='x' value='1'/>",
                                              "<xacro:call macro='m'/>",
                                              "${load_yaml('sizes.yaml')}",
                                              "${",
                                              "}",
                                              "$$",
                                              "$(arg k)",
                                              "$(find bot)",
                                              "$(env ROBOT)",
                                              "$(optenv NONE x)",
                                              "$(eval 1 + 1)",
                                              "$(dirname)",
                                              " ** ",
                                              " // ",
                                              " % ",
                                              " and ",
                                              " if a else b",
                                              " in ",
                                              "[1, 2][0]",
                                              "{'k': 1}",
                                              ".k",
                                              "[1:]",
                                              "dict(a=1)",
                                              "[x for x in range(9)]",
                                              "'a' * 1000",
                                              "'%5.2f' % pi",
                                              "9223372036854775807",
                                              "1e308",
                                              "-1",
                                              "nan",
                                              "None",
                                              "'text'",
                                              "sqrt(2)",
                                              "round(0.5, 3)",
                                              "sorted([2, 1])",
                                              ".split('a')",
                                              "&#13;",
                                              "&#0;",
                                              "]]>",
                                              "<![CDATA["};
const std::vector<std::string> kYamlWords = {"name",
                                             "description",
                                             "limits",
                                             "feet",
                                             "rests",
                                             "trunk",
                                             "legs",
                                             "mirror_pairs",
                                             "standing",
                                             "standing_base_height_m",
                                             "nominal_speed_m_s",
                                             "gains",
                                             "motors",
                                             "link",
                                             "type",
                                             "radius_m",
                                             "sole_m",
                                             "joints",
                                             "knee",
                                             "knee_side",
                                             "plus",
                                             "minus",
                                             "sole",
                                             "line",
                                             "sphere",
                                             "point",
                                             "A_hip",
                                             "A_knee",
                                             "A_foot",
                                             "B_foot",
                                             "stiffness_nm_rad",
                                             "lower_rad",
                                             "upper_rad",
                                             "lower_m",
                                             "effort_nm",
                                             "velocity_rad_s",
                                             "corner_velocity_rad_s",
                                             "no_load_velocity_rad_s",
                                             "continuous_nm",
                                             "rotor_inertia_kg_m2",
                                             "transmissions",
                                             "joints",
                                             "motors",
                                             "ratios",
                                             "thermal_s",
                                             "&a",
                                             "*a",
                                             "<<: *a",
                                             "!!str",
                                             "---",
                                             "...",
                                             "|",
                                             ">",
                                             "? ",
                                             "{",
                                             "}",
                                             "[",
                                             "]",
                                             "\"\\0\"",
                                             "\"\\xff\"",
                                             "'",
                                             "~",
                                             ".nan",
                                             ".inf",
                                             "%YAML 1.2",
                                             "\t"};
const std::vector<std::string> kMjcfWords = {
    "<body name='x' pos='0 0 1'>",
    "</body>",
    "<joint name='j' type='ball' pos='0 0 1'/>",
    "<joint type='slide' range='-1 1' ref='0.5'/>",
    "<freejoint/>",
    "<frame euler='10 20 30'>",
    "</frame>",
    "<geom type='capsule' size='0.1' fromto='0 0 0 0 0 1'/>",
    "<geom type='ellipsoid' size='0.1 0.2 0.3'/>",
    "<geom type='mesh' mesh='m'/>",
    "<inertial pos='0 0 0' mass='1' fullinertia='1 1 1 0 0 0'/>",
    "<compiler angle='radian' balanceinertia='true' settotalmass='9'/>",
    "<compiler inertiafromgeom='true' boundmass='0.1' boundinertia='0.1'/>",
    "<default><default class='c'><geom size='0.1'/></default></default>",
    "childclass='c'",
    "class='c'",
    "<asset><mesh name='m' file='m.stl' scale='1 1 -1' refpos='1 0 0'/></asset>",
    "<include file='leg.xml'/>",
    "<equality><joint joint1='A_hip' joint2='B_hip' polycoef='0 2'/></equality>",
    "<equality><joint joint1='A_hip'/></equality>",
    "<connect body1='A_thigh' body2='trunk'/>",
    "<motor joint='A_hip' gear='2' ctrlrange='-1 1'/>",
    "<position joint='A_knee' kp='10' kv='1' forcerange='-5 5'/>",
    "<key name='home' qpos='0 0 0 1 0 0 0'/>",
    "<replicate count='3'/>",
    "quat='1 0 0 0'",
    "axisangle='1 0 0 90'",
    "xyaxes='1 0 0 0 1 0'",
    "zaxis='0 0 -1'",
    "limited='true'",
    "true",
    "A_hip",
    "trunk",
    "&#1;",
    "&#xD800;",
    "<!--",
    "-->",
    "<![CDATA["};
const std::vector<std::string> kStlWords = {"solid",   "facet normal 0 0 1", "outer loop", "vertex 0 0 1",
                                            "endloop", "endfacet",           "endsolid",   "vertex nan inf 1e99"};
const std::vector<std::string> kObjWords = {"v 1 2 3\n",          "f 1 2 3\n",  "f -1 -2 -3\n",
                                            "f 1/1/1 2//2 3/3\n", "vn 0 0 1\n", "f 1 2 3 4 5 6\n",
                                            "usemtl a\n",         "\\\n",       "o a\n"};
const std::vector<std::string> kColladaWords = {"<node id=\"n\">",
                                                "</node>",
                                                "<instance_node url=\"#n\"/>",
                                                "<instance_geometry url=\"#g\"/>",
                                                "<p>0 1 2</p>",
                                                "<vcount>3 4</vcount>",
                                                "polylist",
                                                "polygons",
                                                "tristrips",
                                                "trifans",
                                                "triangles",
                                                "count",
                                                "stride",
                                                "offset",
                                                "<matrix>1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1</matrix>",
                                                "<scale>1 1 0</scale>",
                                                "<rotate>0 0 1 90</rotate>",
                                                "source",
                                                "meter=\"1e-3\"",
                                                "<input semantic=\"NORMAL\" source=\"#p\" offset=\"1\"/>",
                                                "library_nodes",
                                                "lookat"};

}  // namespace

const std::vector<Reader>& Readers() {
  static const std::vector<Reader> readers = {
      {"urdf", ReadUrdf, kUrdfWords, {}, nullptr, 300},
      {"xacro", ReadXacro, kXacroWords, {}},
      {"robot_yaml", ReadRobotYaml, kYamlWords, {}, nullptr, 400},
      {"mjcf", ReadMjcf, kMjcfWords, {}, nullptr, 400},
      {"mesh_stl", ReadStl, kStlWords, {}},
      {"mesh_obj", ReadObj, kObjWords, {}},
      {"mesh_dae", ReadCollada, kColladaWords, {}},
      {"option", ReadOption, {"length_m=", "count=", "fast=", "method=", "name=", "true", "false", "preview"}, {}}};
  return readers;
}

}  // namespace gaitwright::fuzz
