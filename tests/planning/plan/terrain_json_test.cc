// SPDX-License-Identifier: BSD-3-Clause
// Grounds in plan files: they are read back unchanged; one error is refused and named.
#include <gtest/gtest.h>

#include <functional>
#include <nlohmann/json.hpp>

#include "planning/plan/built_in_terrain.h"
#include "planning/plan/plan_json.h"

namespace gaitwright {
namespace {

using Json = nlohmann::ordered_json;

/// The smallest valid plan: one foot, one joint, one row.
MotionPlan SmallPlan(const Terrain& terrain) {
  MotionPlan plan;
  plan.terrain = terrain;
  plan.parts = {{{"stand", "", 1.0, {0.0}, {0.9}}, {}, {}, 0.0, 1.0}};
  plan.schedule.phases = {{0.0, 1.0, 1}};
  plan.whole_body.step_s = 0.005;
  plan.whole_body.q = {VectorX::Unit(8, 6)};
  plan.whole_body.v = plan.whole_body.a = {VectorX::Zero(7)};
  plan.whole_body.tau = {VectorX::Zero(1)};
  plan.whole_body.wrenches = {{ContactWrench{}}};
  plan.centroidal.p_WC = plan.centroidal.v_WC = plan.centroidal.a_WC = {Vector3::Zero()};
  plan.centroidal.p_WZ = {Vector2::Zero()};
  Foothold foothold;
  foothold.patch = terrain.num_surfaces() - 1;
  plan.footsteps.footholds = {foothold};
  return plan;
}

Terrain Everything() {
  Terrain terrain = *MakeTerrain("rough:length_m=0.5,width_m=0.4", {});
  Obstacle box, post, wedge;
  box.name = "box";
  box.size_m << 0.3, 0.2, 0.1;
  post.name = "post";
  post.type = ShapeType::kCylinder;
  post.X_WO.translation() << 1.0, 2.0, 0.3;
  post.size_m << 0.05, 0.6, 0.0;
  wedge.name = "wedge";
  wedge.type = ShapeType::kMesh;
  wedge.vertices_O = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  terrain.obstacles = {box, post, wedge};
  return terrain;
}

std::string ReasonTerrainRefused(const std::function<void(Json&)>& change) {
  static const std::string good = PlanToJson(SmallPlan(Everything()));
  Json j = Json::parse(good);
  change(j["terrain"]);
  const Result<MotionPlan> plan = PlanFromJson(j.dump(), "x.json");
  if (plan.ok()) return "";
  return plan.failure().message.substr(std::string("'x.json' is refused: ").size());
}

TEST(TerrainJson, EveryKindOfGroundComesBack) {
  const Terrain good = Everything();
  const Result<MotionPlan> plan = PlanFromJson(PlanToJson(SmallPlan(good)), "x.json");
  ASSERT_TRUE(plan.ok()) << plan.failure().message;
  EXPECT_EQ(plan->footsteps.footholds[0].patch, 1) << "the height field, after the one patch";
  const HeightField &was = good.height_fields[0], &is = plan->terrain.height_fields.at(0);
  EXPECT_EQ(is.name, was.name);
  EXPECT_EQ(is.origin_W, was.origin_W);
  EXPECT_EQ(is.resolution_m, was.resolution_m);
  EXPECT_EQ(is.columns, was.columns);
  EXPECT_EQ(is.rows, was.rows);
  EXPECT_EQ(is.height_m, was.height_m);
  EXPECT_EQ(is.friction, was.friction);
  ASSERT_EQ(plan->terrain.obstacles.size(), 3U);
  for (std::size_t i = 0; i < 3; ++i) {
    const Obstacle &old = good.obstacles[i], &now = plan->terrain.obstacles[i];
    EXPECT_EQ(now.name, old.name);
    EXPECT_EQ(now.type, old.type);
    EXPECT_TRUE(now.X_WO.isApprox(old.X_WO, 1e-15));
    EXPECT_EQ(now.size_m, old.size_m);
    EXPECT_EQ(now.vertices_O, old.vertices_O);
  }
  EXPECT_EQ(PlanToJson(*plan), PlanToJson(SmallPlan(good))) << "the same bytes again";
}

TEST(TerrainJson, HeightFieldsThatCannotBeAreRefused) {
  EXPECT_EQ(ReasonTerrainRefused([](Json&) {}), "");
  EXPECT_NE(ReasonTerrainRefused([](Json& j) { j["height_fields"][0]["heights_m"].erase(0); }).find("numbers; "),
            std::string::npos);
  EXPECT_EQ(ReasonTerrainRefused([](Json& j) { j["height_fields"][0]["heights_m"][5] = nullptr; }),
            "'terrain.height_fields[0].heights_m[5]' is null; a number is needed");
  EXPECT_EQ(ReasonTerrainRefused([](Json& j) { j["height_fields"][0]["resolution_m"] = 0.0; }),
            "'terrain.height_fields[0].resolution_m' is 0; it must be above 0");
  EXPECT_EQ(ReasonTerrainRefused([](Json& j) { j["height_fields"][0]["rows"] = 1; }),
            "'terrain.height_fields[0].rows' is 1; accepted: 2 to 100000");
  EXPECT_EQ(ReasonTerrainRefused([](Json& j) { j["height_fields"][0].erase("friction"); }),
            "'terrain.height_fields[0]' lacks 'friction'");
  EXPECT_EQ(ReasonTerrainRefused([](Json& j) { j.erase("obstacles"); }), "'terrain' lacks 'obstacles'");
}

TEST(TerrainJson, ObstaclesThatCannotBeAreRefused) {
  EXPECT_EQ(ReasonTerrainRefused([](Json& j) { j["obstacles"][0]["type"] = "ball"; }),
            "'terrain.obstacles[0].type' is 'ball'; accepted: 'box', 'cylinder', 'mesh'");
  EXPECT_EQ(ReasonTerrainRefused([](Json& j) { j["obstacles"][0]["size_m"][1] = 0.0; }),
            "'terrain.obstacles[0].size_m' has a size of 0; it must be above 0");
  EXPECT_EQ(ReasonTerrainRefused([](Json& j) {
              j["obstacles"][1]["size_m"] = {1, 2, 3};
            }),
            "'terrain.obstacles[1].size_m' has 3 numbers; 2 are needed");
  EXPECT_EQ(ReasonTerrainRefused([](Json& j) { j["obstacles"][2]["vertices_m"].erase(0); }),
            "'terrain.obstacles[2].vertices_m' has 3 points; four or more are needed");
  EXPECT_EQ(ReasonTerrainRefused([](Json& j) { j["obstacles"][2].erase("vertices_m"); }),
            "'terrain.obstacles[2]' lacks 'vertices_m'");
  EXPECT_NE(ReasonTerrainRefused([](Json& j) {
              j["obstacles"][0]["vertices_m"] = Json::array();
            }).find("unknown key 'vertices_m'"),
            std::string::npos);
}

}  // namespace
}  // namespace gaitwright
