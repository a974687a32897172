// SPDX-License-Identifier: BSD-3-Clause
#include "kinematics/base/data_shape.h"

#include <gtest/gtest.h>
#include <yaml-cpp/yaml.h>

#include <nlohmann/json.hpp>

#include "kinematics/base/result.h"
#include "kinematics/base/strict_yaml_internal.h"

namespace gaitwright {
namespace {

using namespace shapes;

DataShape Wheel() {
  return Object({{"name", Text()},
                 {"spokes", Whole(3, 40), "How many."},
                 Optional("radius_m", Positive(2.0)),
                 Optional("tilt_deg", Number(-5.0, 5.0)),
                 Optional("kind", Text({"wire", "disc"}))});
}

std::string ReasonRefused(const std::string& yaml, const std::string& key) {
  const DataShape shape = Wheel();
  try {
    const YAML::Node node = YAML::Load(yaml);
    const YamlMap map(node, "a wheel", shape);
    map.InRange(key);
  } catch (const InvalidArgument& error) {
    return error.what();
  }
  return "";
}

TEST(DataShape, GivesItsReaderKeysAndRanges) {
  EXPECT_EQ(Wheel().NeededKeys(), (std::vector<std::string>{"name", "spokes"}));
  EXPECT_EQ(Wheel().OtherKeys(), (std::vector<std::string>{"radius_m", "tilt_deg", "kind"}));
  EXPECT_EQ(ReasonRefused("{name: a, spokes: 8, radius_m: 0.3}", "radius_m"), "");
  EXPECT_EQ(ReasonRefused("{name: a, spoke: 8}", "spokes"),
            "line 1: a wheel has the unknown key 'spoke'; the nearest is 'spokes'");
  EXPECT_EQ(ReasonRefused("{name: a}", "spokes"), "line 1: a wheel lacks the key 'spokes'");
  EXPECT_EQ(ReasonRefused("{name: a, spokes: 2}", "spokes"), "line 1: 'spokes' is 2; accepted: 3 to 40");
  EXPECT_EQ(ReasonRefused("{name: a, spokes: 4.5}", "spokes"), "line 1: 'spokes' is 4.5; a whole number is needed");
  EXPECT_EQ(ReasonRefused("{name: a, spokes: 8, radius_m: 0}", "radius_m"),
            "line 1: 'radius_m' is 0; it must be above 0");
  EXPECT_EQ(ReasonRefused("{name: a, spokes: 8, radius_m: 3}", "radius_m"),
            "line 1: 'radius_m' is 3; at most 2 is accepted");
  EXPECT_THROW(Wheel().At("spoke"), InvalidArgument) << "the reader asks for what the shape does not have";
}

TEST(DataShape, IsWrittenAsASchema) {
  const auto schema = nlohmann::json::parse(SchemaOf(Wheel(), "A wheel", "It turns."));
  EXPECT_EQ(schema["$schema"], "https://json-schema.org/draft/2020-12/schema");
  EXPECT_EQ(schema["title"], "A wheel");
  EXPECT_EQ(schema["required"], (nlohmann::json{"name", "spokes"}));
  EXPECT_EQ(schema["additionalProperties"], false);
  EXPECT_EQ(schema["properties"]["spokes"],
            (nlohmann::json{{"type", "integer"}, {"minimum", 3}, {"maximum", 40}, {"description", "How many."}}));
  EXPECT_EQ(schema["properties"]["radius_m"],
            (nlohmann::json{{"type", "number"}, {"exclusiveMinimum", 0.0}, {"maximum", 2.0}}));
  EXPECT_EQ(schema["properties"]["kind"]["enum"], (nlohmann::json{"wire", "disc"}));
}

TEST(DataShape, SaysWhatGoesInPlaceOfAnother) {
  const DataShape value = OrNull(Either(Number(), List(Number(), 2, 3)));
  const auto schema = nlohmann::json::parse(SchemaOf(Object({{"value", value}}, {{"value", "none"}}), "t", "d"));
  EXPECT_EQ(schema["properties"]["value"]["anyOf"].size(), 3U);
  EXPECT_EQ(schema["properties"]["value"]["anyOf"][1]["minItems"], 2);
  EXPECT_EQ(schema["properties"]["value"]["anyOf"][2]["type"], "null");
  EXPECT_EQ(schema["allOf"][0]["oneOf"][1]["required"], (nlohmann::json{"none"}));
}

TEST(DataShape, TakesAnOptionsFieldAsItIs) {
  double height = 0.05;
  const ShapeMember member = Field({"height_m", &height, "m", 0.0, 1.0, "Lift of the sole.", {}});
  EXPECT_FALSE(member.needed);
  EXPECT_EQ(member.meaning, "Lift of the sole. [m]");
  EXPECT_EQ(member.shape.highest, 1.0);
}

}  // namespace
}  // namespace gaitwright
