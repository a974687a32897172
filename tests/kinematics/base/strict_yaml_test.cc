// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <yaml-cpp/yaml.h>

#include "kinematics/base/data_shape.h"
#include "kinematics/base/result.h"
#include "kinematics/base/strict_yaml_internal.h"

namespace gaitwright {
namespace {

/// The message of a refused call, or "".
template <class Call>
std::string YamlRefusal(const Call& call) {
  try {
    call();
  } catch (const InvalidArgument& error) {
    return error.what();
  }
  return "";
}

TEST(StrictYamlNumber, TakesFiniteNumbersOnly) {
  EXPECT_EQ(NumberOf(LoadYaml("2.5e-1"), "it"), 0.25);
  EXPECT_EQ(NumberOf(LoadYaml("-3"), "it"), -3.0);
  for (const char* text : {"a", ".nan", ".inf", "-.inf", "[1]", "{a: 1}", "~", "1 2", "true"})
    EXPECT_NE(YamlRefusal([&] { NumberOf(LoadYaml(text), "it"); }), "") << text;
  EXPECT_EQ(YamlRefusal([] { NumberOf(LoadYaml("\n\n[1]"), "'mass'"); }),
            "line 3: 'mass' is a list; one word or text is needed");
}

TEST(StrictYamlNumber, BoundsBelongToTheRange) {
  for (const double number : {-1.0, 0.5, 2.0}) {
    const YAML::Node node = LoadYaml(std::to_string(number));
    EXPECT_EQ(NumberOf(node, "it", -1.0, 2.0), number);
  }
  for (const char* beyond : {"-1.001", "2.001"})
    EXPECT_NE(YamlRefusal([&] { NumberOf(LoadYaml(beyond), "it", -1.0, 2.0); }).find("accepted: -1 to 2"),
              std::string::npos);
}

TEST(StrictYamlNumber, AShapeMayLeaveItsLowestOutAndAskForWholeNumbers) {
  const DataShape positive = shapes::Positive(10.0), whole = shapes::Whole(0.0, 5.0);
  EXPECT_EQ(NumberOf(LoadYaml("10"), "it", positive), 10.0);
  EXPECT_EQ(NumberOf(LoadYaml("0.001"), "it", positive), 0.001);
  for (const char* wrong : {"0", "-1", "10.01"})
    EXPECT_NE(YamlRefusal([&] { NumberOf(LoadYaml(wrong), "it", positive); }), "") << wrong;
  EXPECT_EQ(NumberOf(LoadYaml("0"), "it", whole), 0.0);
  EXPECT_EQ(NumberOf(LoadYaml("5.0"), "it", whole), 5.0);
  for (const char* wrong : {"2.5", "6", "-1"})
    EXPECT_NE(YamlRefusal([&] { NumberOf(LoadYaml(wrong), "it", whole); }), "") << wrong;
}

TEST(StrictYaml, ListsAndKindsAreDistinguished) {
  EXPECT_EQ(ListOf(LoadYaml("[1, [2], {a: 3}]"), "it").size(), 3U);
  EXPECT_TRUE(ListOf(LoadYaml("[]"), "it").empty());
  EXPECT_EQ(YamlRefusal([] { ListOf(LoadYaml("{a: 1}"), "'feet'"); }), "line 1: 'feet' is a map; a list is needed");
  const std::vector<std::pair<std::string, std::string>> kinds = {
      {"[1]", "a list"}, {"{a: 1}", "a map"}, {"~", "empty"}, {"word", "a single value"}};
  for (const auto& [text, kind] : kinds) EXPECT_EQ(KindOf(LoadYaml(text)), kind) << text;
  EXPECT_EQ(LineOf(LoadYaml("a: 1\nb:\n  c: 2")["b"]["c"]), 3);
}

TEST(YamlMap, KeepsTheOrderOfItsKeysAndFindsThem) {
  const YAML::Node node = LoadYaml("{b: 1, a: two, c: ~}");
  const YamlMap map(node, "it");
  std::vector<std::string> keys;
  for (const YamlMap::Entry& entry : map.entries()) keys.push_back(entry.key);
  EXPECT_EQ(keys, (std::vector<std::string>{"b", "a", "c"}));
  EXPECT_EQ(map.Number("b"), 1.0);
  EXPECT_EQ(map.Text("a"), "two");
  EXPECT_EQ(map.Text("z"), "");
  EXPECT_EQ(map.Number("z"), std::nullopt);
  EXPECT_EQ(map.Positive("z"), std::nullopt);
  EXPECT_EQ(map.Find("z"), nullptr);
  ASSERT_NE(map.Find("c"), nullptr) << "a key without a value is there";
  EXPECT_NE(YamlRefusal([&] { map.Number("a"); }), "");
}

TEST(YamlMap, RefusesKeysThatAreUnknownTwiceOrNoWords) {
  const auto refusal = [](const std::string& text) {
    return YamlRefusal([&] { YamlMap(LoadYaml(text), "the foot", {"link", "radius_m"}); });
  };
  EXPECT_EQ(refusal("{link: a, radius_m: 1}"), "");
  EXPECT_EQ(refusal("link: a\nradus_m: 1"),
            "line 2: the foot has the unknown key 'radus_m'; the nearest is 'radius_m'");
  EXPECT_EQ(refusal("link: a\nlink: b"), "line 2: the foot has the key 'link' twice");
  EXPECT_NE(refusal("[1, 2]: a"), "");
  EXPECT_EQ(refusal("[link]"), "line 1: the foot is a list; a map of keys is needed");
}

TEST(YamlMap, AShapeSaysWhatIsNeededAndInWhichRange) {
  const DataShape shape =
      shapes::Object({{"name", shapes::Text()}, shapes::Optional("mass_kg", shapes::Positive(100.0))});
  const YAML::Node node = LoadYaml("{name: a, mass_kg: 5}");
  EXPECT_EQ(YamlMap(node, "it", shape).InRange("mass_kg"), 5.0);
  const YAML::Node heavy = LoadYaml("{name: a, mass_kg: 500}"), none = LoadYaml("{name: a}");
  EXPECT_EQ(YamlMap(none, "it", shape).InRange("mass_kg"), std::nullopt);
  EXPECT_EQ(YamlRefusal([&] { YamlMap(heavy, "it", shape).InRange("mass_kg"); }),
            "line 1: 'mass_kg' is 500; at most 100 is accepted");
  EXPECT_EQ(YamlRefusal([&] { YamlMap(LoadYaml("{mass_kg: 5}"), "it", shape); }), "line 1: it lacks the key 'name'");
}

TEST(YamlMap, APositiveNumberIsOverZero) {
  const YAML::Node node = LoadYaml("{a: 0.5, b: 0, c: -1}");
  const YamlMap map(node, "it");
  EXPECT_EQ(map.Positive("a"), 0.5);
  EXPECT_EQ(YamlRefusal([&] { map.Positive("b"); }), "line 1: 'b' is 0; it must be above 0");
  EXPECT_NE(YamlRefusal([&] { map.Positive("c"); }), "");
}

}  // namespace
}  // namespace gaitwright
