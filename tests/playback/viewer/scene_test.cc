// SPDX-License-Identifier: BSD-3-Clause
#include "playback/viewer/scene.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <optional>

#include "kinematics/base/result.h"
#include "playback/score/motion_series.h"
#include "tests/playback/played.h"
#include "tests/playback/viewer/unpacked.h"

namespace gaitwright {
namespace {

using Json = nlohmann::ordered_json;

using unpacked::Floats, unpacked::Numbers;

Json SceneOf(const synthetic::Played& c, const StabilityReport* report = nullptr) {
  return Json::parse(SceneJson({{"a <walk>", c.model, c.plan, &c.log, report}}))["motions"][0];
}

TEST(Scene, HasAllOfAPlaybackInColumnsOfOneLength) {
  const synthetic::Played c = synthetic::Walked(4, {.count = 4});
  const Json motion = SceneOf(c);
  const std::size_t rows = c.log.samples.size();
  const MotionSeries series = MakeMotionSeries(c.model, c.plan, c.log, {});
  EXPECT_EQ(Floats(motion["time_s"]).size(), rows);
  for (const char* side : {"planned", "measured"}) {
    const Json& track = motion[side];
    for (const char* key :
         {"q", "tau", "com_m", "dcm_m", "zmp_m", "zmp_margin_m", "foot_m", "force_n", "foot_height_m"}) {
      EXPECT_EQ(Floats(track[key]).size(), rows * track[key]["columns"].get<std::size_t>()) << side << " " << key;
    }
    EXPECT_EQ(Numbers<std::uint8_t>(track["contact"], "u8").size(), rows * c.model.feet.size());
    const auto first = Numbers<std::uint32_t>(track["support_first"], "u32");
    EXPECT_EQ(first.size(), rows + 1);
    EXPECT_EQ(Floats(track["support_m"]).size(), 3 * first.back());
  }
  const std::size_t k = rows / 2;
  const auto q = Floats(motion["measured"]["q"]);
  const auto com = Floats(motion["measured"]["com_m"]);
  for (Eigen::Index i = 0; i < c.model.nq(); ++i) {
    EXPECT_FLOAT_EQ(q[k * static_cast<std::size_t>(c.model.nq()) + static_cast<std::size_t>(i)],
                    static_cast<float>(c.log.samples[k].q[i]));
  }
  EXPECT_FLOAT_EQ(com[3 * k], static_cast<float>(series.measured[k].p_WC.x()));
  EXPECT_EQ(motion["footholds"].size(), c.plan.footsteps.footholds.size());
  EXPECT_EQ(motion["swings"].size(), c.plan.swings.size());
  EXPECT_EQ(motion["robot"]["joints"].size(), c.model.joints.size());
}

TEST(Scene, SwingsGoFromFootholdToFoothold) {
  synthetic::Played c = synthetic::Walked(2, {.count = 4});
  SwingTrajectory swing;
  swing.start_s = 1.0;
  swing.end_s = 1.4;
  swing.X_WF_start.translation() = Vector3(0.1, 0.2, 0.0);
  swing.X_WF_end.translation() = Vector3(0.3, 0.2, 0.05);
  swing.lift_m = 0.04;
  c.plan.swings = {swing};
  const Json motion = SceneOf(c);
  const auto points = Floats(motion["swings"][0]["points_m"]);
  for (Eigen::Index i = 0; i < 3; ++i) {
    EXPECT_NEAR(points[static_cast<std::size_t>(i)], c.plan.swings[0].X_WF_start.translation()[i], 1e-6);
    EXPECT_NEAR(points[points.size() - 3 + static_cast<std::size_t>(i)], c.plan.swings[0].X_WF_end.translation()[i],
                1e-6);
  }
}

TEST(Scene, HasTheGhostsPostureAtEverySample) {
  const synthetic::Played c = synthetic::Walked(2, {.count = 4});
  ShownMotion shown{"plan", c.model, c.plan};
  EXPECT_TRUE(Json::parse(SceneJson({shown}))["motions"][0]["ghost"].is_null());
  shown.rate_hz = 50.0;
  shown.ghost = {"the original", [&](double time_s) {
                   return time_s > 0.5 ? VectorX() : VectorX(VectorX::Constant(c.model.nq(), time_s));
                 }};
  const Json motion = Json::parse(SceneJson({shown}))["motions"][0];
  EXPECT_EQ(motion["ghost"]["title"], "the original");
  const auto times = Floats(motion["time_s"]), q = Floats(motion["ghost"]["q"]);
  const auto columns = static_cast<std::size_t>(c.model.nq());
  EXPECT_EQ(motion["ghost"]["q"]["columns"], columns);
  ASSERT_EQ(q.size(), columns * times.size());
  EXPECT_NEAR(times[1] - times[0], 0.02, 1e-6) << "at the lower rate";
  ASSERT_GT(times.back() - times[0], 0.6);
  for (std::size_t k = 0; k < times.size(); ++k) {
    const float since = times[k] - times[0];
    if (std::abs(since - 0.5F) < 1e-3F) continue;
    EXPECT_EQ(std::isnan(q[columns * k]), since > 0.5F) << since;
    if (since < 0.5F) {
      EXPECT_NEAR(q[columns * k + 3], since, 1e-5);
    }
  }
  shown.ghost->posture = [](double) { return VectorX(VectorX::Zero(3)); };
  EXPECT_THROW(SceneJson({shown}), InvalidArgument);
}

TEST(Scene, OfAPlanAloneHasNoMeasuredSide) {
  const synthetic::Played c = synthetic::Walked(2, {.count = 4});
  const Json motion = Json::parse(SceneJson({{"plan", c.model, c.plan}}))["motions"][0];
  EXPECT_TRUE(motion["measured"].is_null());
  EXPECT_TRUE(motion["verdict"].is_null());
  const auto time = Floats(motion["time_s"]);
  EXPECT_FLOAT_EQ(time.front(), static_cast<float>(c.plan.whole_body.start_s));
  EXPECT_NEAR(time.back(), c.plan.whole_body.end_s(), 1.0 / kSceneRateHz);
}

/// A robot whose first body has a visual mesh that only its folder contains.
TEST(Scene, HasVisualMeshesWhereTheirFolderIsKnown) {
  synthetic::Played c = synthetic::Walked(2, {.count = 4});
  const std::filesystem::path folder = std::filesystem::path(testing::TempDir()) / "scene_meshes";
  std::filesystem::create_directories(folder);
  std::ofstream(folder / "trunk.obj")
      << "v 0 0 0\nv 0.1 0 0\nv 0 0.2 0\nv 0 0 0.3\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n";
  Shape touches, looks;
  touches.link = looks.link = "trunk";
  touches.size = Vector3(0.1, 0.2, 0.3);
  c.model.collision_shapes = {touches};
  looks.type = ShapeType::kMesh;
  looks.mesh_file = "trunk.obj";
  looks.size = Vector3(1.0, 1.0, 2.0);
  c.model.visual_shapes = {looks};
  const auto robot_in = [&](const std::optional<std::string>& in) {
    return Json::parse(RobotAndGroundJson(c.model, c.plan.terrain, in))["robot"];
  };
  const Json robot = robot_in(folder.string());
  ASSERT_EQ(robot["meshes"].size(), 1U);
  EXPECT_EQ(robot["shapes"][0]["type"], "mesh");
  EXPECT_EQ(robot["shapes"][0]["mesh"], 0);
  EXPECT_EQ(robot["shapes"][0]["size_m"], Json({1.0, 1.0, 2.0})) << "its scale";
  const auto vertices = Floats(robot["meshes"][0]["vertices_m"]);
  const auto corners = Numbers<std::uint32_t>(robot["meshes"][0]["triangles"], "u32");
  EXPECT_EQ(corners.size(), 12U);
  EXPECT_FLOAT_EQ(*std::max_element(vertices.begin(), vertices.end()), 0.3F);
  for (const std::optional<std::string>& none : {std::optional<std::string>(), std::optional<std::string>("/none")}) {
    const Json other = robot_in(none);
    EXPECT_TRUE(other["meshes"].empty());
    ASSERT_FALSE(other["shapes"].empty()) << "what touches is drawn instead";
    for (const Json& shape : other["shapes"]) EXPECT_NE(shape["type"], "mesh");
  }
}

/// The plan's own ZMP is the same with and without a log.
TEST(Scene, ThePlannedSideOfALogIsThatOfThePlan) {
  const synthetic::Played c = synthetic::Walked(2, {.count = 4});
  const MotionSeries both = MakeMotionSeries(c.model, c.plan, c.log, {});
  const MotionSeries alone = MakePlannedSeries(c.model, c.plan, c.log.log_rate_hz, {});
  std::size_t compared = 0;
  for (const MotionSample& sample : both.planned) {
    for (const MotionSample& other : alone.planned) {
      if (std::abs(other.time_s - sample.time_s) > 1e-9) continue;
      EXPECT_LT((other.p_WC - sample.p_WC).norm(), 1e-9);
      if (sample.time_s > c.plan.whole_body.start_s + 0.1 && sample.has_zmp && other.has_zmp) {
        EXPECT_LT((other.p_WZ - sample.p_WZ).norm(), 1e-3) << sample.time_s;  // the filter starts one sample later
      }
      ++compared;
    }
  }
  EXPECT_GT(compared, both.planned.size() / 2);
  EXPECT_THROW(MakePlannedSeries(c.model, c.plan, 0.0, {}), InvalidArgument);
}

TEST(Scene, MarksTheFallWithItsReasonAndKeepsTheVerdict) {
  synthetic::Played c = synthetic::Walked(4, {.count = 6});
  synthetic::Sink(c.log, 400, 0.1);
  const StabilityReport report = Score(c.model, c.plan, c.log);
  ASSERT_FALSE(report.pass);
  const Json motion = SceneOf(c, &report);
  EXPECT_FALSE(motion["verdict"]["pass"].get<bool>());
  EXPECT_EQ(motion["verdict"]["reason"], report.reason);
  int falls = 0;
  for (const Json& mark : motion["marks"]) {
    if (mark["kind"] != "fall") continue;
    ++falls;
    EXPECT_EQ(mark["text"], report.reason);
    EXPECT_EQ(mark["at_s"], report.At("fell").at_s.value());
  }
  EXPECT_EQ(falls, 1);
}

TEST(Scene, HoldsNothingThatCouldEndItsPlaceInAPage) {
  const synthetic::Played c = synthetic::Stood();
  const std::string json = SceneJson({{"</script><b>&amp;", c.model, c.plan, &c.log}});
  EXPECT_EQ(json.find_first_of("<>&"), std::string::npos);
  EXPECT_EQ(Json::parse(json)["motions"][0]["title"], "</script><b>&amp;");
  EXPECT_THROW(SceneJson({}), InvalidArgument);
}

TEST(Scene, ThinsLogsOfHigherRates) {
  synthetic::Played c = synthetic::Stood();
  const std::size_t rows = c.log.samples.size();
  c.log.log_rate_hz *= 4.0;  // the same samples at four times the rate
  for (std::size_t k = 0; k < rows; ++k)
    c.log.samples[k].time_s = c.log.start_s + static_cast<double>(k + 1) / c.log.log_rate_hz;
  EXPECT_EQ(Floats(SceneOf(c)["time_s"]).size(), (rows + 3) / 4);
}

}  // namespace
}  // namespace gaitwright
