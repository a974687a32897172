// SPDX-License-Identifier: BSD-3-Clause
// Results of the verbs that show or list something.
#include <gtest/gtest.h>

#include <set>

#include "tests/workflows/formats/fits_shape.h"
#include "workflows/formats/result_shapes_internal.h"

namespace gaitwright {
namespace {

using ShownJson = nlohmann::ordered_json;

ShownJson ShownTerrain() {
  return {{"name", "stairs"},
          {"description", "steps up"},
          {"robot", "a1"},
          {"parameters", ShownJson::array({{{"key", "steps"},
                                            {"value", "3"},
                                            {"unit", "1"},
                                            {"lowest", 1},
                                            {"highest", 20},
                                            {"meaning", "Number of steps."}}})},
          {"patches", ShownJson::array({{{"name", "ground"},
                                         {"origin_m", {0.0, 0.0, 0.0}},
                                         {"normal", {0.0, 0.0, 1.0}},
                                         {"outline_m", ShownJson::array()},
                                         {"friction", 0.7}}})},
          {"height_fields", ShownJson::array()},
          {"obstacles", ShownJson::array({{{"name", "post"}, {"type", "box"}, {"position_m", {1.0, 0.0, 0.5}}}})},
          {"markers", ShownJson::array({{{"name", "door"}, {"position_m", {1.0, 2.0}}}})},
          {"files", {{"picture", "t.svg"}}}};
}

TEST(ShowShapes, TerrainsAreAListOrOneThatIsShown) {
  const DataShape shape = TerrainsResultShape();
  const ShownJson list = {{"terrains", ShownJson::array({{{"name", "flat"},
                                                          {"description", "level"},
                                                          {"parameters", ShownJson::array({"friction"})}}})}};
  EXPECT_EQ(Misfit(list, shape), "");
  EXPECT_EQ(Misfit(ShownTerrain(), shape), "");
  ShownJson nameless = list;
  nameless["terrains"][0].erase("name");
  EXPECT_NE(Misfit(nameless, shape), "");
  for (const char* key : {"name", "patches", "obstacles", "markers"})
    EXPECT_NE(Misfit(Without(ShownTerrain(), key), shape), "") << key;
}

TEST(ShowShapes, PlacesOfATerrainHaveTheirNumberOfCoordinates) {
  ShownJson terrain = ShownTerrain();
  terrain["markers"][0]["position_m"] = {1.0, 2.0, 3.0};
  EXPECT_NE(Misfit(terrain, TerrainsResultShape()), "") << "a marker is in plan view";
  terrain = ShownTerrain();
  terrain["obstacles"][0]["position_m"] = {1.0, 2.0};
  EXPECT_NE(Misfit(terrain, TerrainsResultShape()), "");
}

TEST(ShowShapes, RobotsAreAListOneThatIsShownOrACheck) {
  const DataShape shape = RobotsResultShape();
  const ShownJson list = {
      {"robots", ShownJson::array({{{"name", "a1"}, {"legs", 4}, {"motors", 12}, {"mass_kg", 12.5}}})}};
  const ShownJson check = {
      {"robot", "a1"},
      {"verdict", "walks"},
      {"errors", 0},
      {"warnings", 1},
      {"findings",
       ShownJson::array(
           {{{"level", "warning"}, {"code", "mass"}, {"part", "trunk"}, {"line", nullptr}, {"message", "x"}}})},
      {"files", ShownJson::object()}};
  EXPECT_EQ(Misfit(list, shape), "");
  EXPECT_EQ(Misfit(check, shape), "") << "a finding without a line has null";
  ShownJson half = list;
  half["robots"][0]["legs"] = 4.5;
  EXPECT_NE(Misfit(half, shape), "");
  EXPECT_NE(Misfit(Without(check, "verdict"), shape), "");
}

TEST(ShowShapes, ACycleOfAGaitThatIsDerivedIsNull) {
  ShownJson gait = {{"name", "trot"},
                    {"feet", 4},
                    {"description", "diagonals"},
                    {"cycle_s", nullptr},
                    {"cycle_per_leg_time", 2.5},
                    {"stride_per_leg", nullptr},
                    {"pitch_turns", 0.0},
                    {"roll_turns", 0.0},
                    {"travel_per_leg", nullptr},
                    {"phase", {0, 0.5, 0.5, 0}},
                    {"duty_factor", {0.5, 0.5, 0.5, 0.5}},
                    {"flight", false}};
  EXPECT_EQ(Misfit({{"gaits", ShownJson::array({gait})}}, GaitsResultShape()), "");
  gait["cycle_s"] = 0.5;
  EXPECT_EQ(Misfit({{"gaits", ShownJson::array({gait})}}, GaitsResultShape()), "");
  gait["flight"] = nullptr;
  EXPECT_EQ(Misfit({{"gaits", ShownJson::array({gait})}}, GaitsResultShape()), "$.gaits[0].flight is no truth value");
}

TEST(ShowShapes, PicturesPagesAndAddressesHaveTheirKeys) {
  EXPECT_EQ(Misfit({{"shows", "a1"}, {"page_bytes", 10}, {"files", {{"page", "a.html"}}}}, ViewResultShape()), "");
  EXPECT_EQ(Misfit({{"files", {{"gif", "a.gif"}}}}, RenderResultShape()), "") << "cycles are of figures alone";
  EXPECT_EQ(Misfit({{"files", {{"figure", "a.pdf"}}}, {"cycles", 2}}, RenderResultShape()), "");
  EXPECT_EQ(Misfit({{"files", {{"page", "a.html"}}}}, RenderResultShape()), "$.files has an unknown key page");
  EXPECT_EQ(Misfit({{"url", "http://localhost:1/"}}, LiveResultShape()), "");
  EXPECT_EQ(Misfit({{"files", {"a.md", "b.md"}}}, ReferenceResultShape()), "");
  EXPECT_EQ(Misfit({{"schemas", ShownJson::array({{{"name", "walk"}, {"title", "Walk"}}})}}, ReferenceResultShape()),
            "");
}

TEST(ShowShapes, NoResultHasAKeyTwice) {
  for (const DataShape& shape : {RobotsResultShape(), GaitsResultShape(), TerrainsResultShape(), ViewResultShape(),
                                 RenderResultShape(), LiveResultShape(), OptionListShape(), ReferenceResultShape()}) {
    const std::vector<std::string> keys = shape.Keys();
    EXPECT_EQ(std::set<std::string>(keys.begin(), keys.end()).size(), keys.size());
  }
}

}  // namespace
}  // namespace gaitwright
