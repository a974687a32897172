// SPDX-License-Identifier: BSD-3-Clause
#include "workflows/study/centroidal_problems.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "kinematics/base/file.h"
#include "tests/scratch_folder.h"

namespace gaitwright {
namespace {

using Json = nlohmann::ordered_json;

CentroidalProblemSet BuiltInSet() {
  const Result<CentroidalProblemSet> set = LoadCentroidalProblems(CentroidalProblemsPath());
  EXPECT_TRUE(set.ok()) << set.failure().message;
  return set.ok() ? *set : CentroidalProblemSet{};
}

Json BuiltInJson() { return Json::parse(ReadFile(CentroidalProblemsPath()).value()); }

Failure FailureOfSet(const Json& json) {
  const std::string path = ScratchFile("problems.json");
  EXPECT_TRUE(WriteFileAtomically(path, json.dump()).ok());
  const Result<CentroidalProblemSet> set = LoadCentroidalProblems(path);
  EXPECT_FALSE(set.ok());
  if (set.ok()) return {};
  EXPECT_EQ(set.failure().code, FailureCode::kBadProblemSet);
  EXPECT_EQ(set.failure().kind, FailureKind::kBadInput);
  EXPECT_NE(set.failure().message.find(path), std::string::npos);
  return set.failure();
}

TEST(CentroidalProblems, TheBuiltInSetIsReadWhole) {
  const CentroidalProblemSet set = BuiltInSet();
  const Json json = BuiltInJson();
  EXPECT_EQ(set.robots.size(), json.at("robots").size());
  EXPECT_EQ(set.grounds.size(), json.at("grounds").size());
  for (const auto& [name, robot] : set.robots) {
    EXPECT_EQ(robot.mass_kg, json.at("robots").at(name).at("mass_kg").get<double>());
    EXPECT_EQ(robot.feet.size(), json.at("robots").at(name).at("nominal_stance_m").size());
    EXPECT_FALSE(robot.schedules.empty());
    for (const CentroidalSchedule& schedule : robot.schedules)
      EXPECT_EQ(schedule.phase_durations_s.size(), robot.feet.size()) << schedule.name;
  }
}

/// Stances of each foot alternate with swings and fill the duration; the first stance is fixed.
TEST(CentroidalProblems, SchedulesAreStretchedToTheDuration) {
  const CentroidalProblemSet set = BuiltInSet();
  for (const auto& [name, robot] : set.robots) {
    for (const CentroidalSchedule& schedule : robot.schedules) {
      const CentroidalTask task{1.5, 3.2, 0.6};
      const RigidBodyProblem problem = CentroidalProblem(robot, schedule, set.grounds.front(), task);
      EXPECT_NO_THROW(CheckRigidBodyProblem(problem)) << name << schedule.name;
      std::vector<double> ends(robot.feet.size(), -1.0);
      for (const RigidStance& stance : problem.stances) {
        double& end = ends[static_cast<std::size_t>(stance.foot)];
        EXPECT_EQ(stance.held, end < 0.0) << "the first of each foot";
        EXPECT_EQ(stance.start_s == 0.0, end < 0.0);
        EXPECT_GT(stance.start_s, end);
        EXPECT_LE(stance.end_s, task.duration_s);
        EXPECT_EQ(stance.friction, 0.6);
        end = stance.end_s;
      }
      for (std::size_t f = 0; f < ends.size(); ++f) {
        const bool ends_in_stance = schedule.phase_durations_s[f].size() % 2 == 1;
        EXPECT_EQ(ends[f] == task.duration_s, ends_in_stance) << schedule.name;
      }
    }
  }
}

TEST(CentroidalProblems, TheGoalIsForwardAtTheSameHeightAboveTheGround) {
  const CentroidalProblemSet set = BuiltInSet();
  const CentroidalRobot& robot = set.robots.front().second;
  for (const Terrain& ground : set.grounds) {
    const RigidBodyProblem level = CentroidalProblem(robot, robot.schedules.front(), ground, {1.0, 2.0, 0.5, 0.0}),
                           higher = CentroidalProblem(robot, robot.schedules.front(), ground, {1.0, 2.0, 0.5, 0.25});
    const auto over = [&](const Vector3& p) { return p.z() - GroundAt(ground, p.head<2>()).height_m; };
    EXPECT_NEAR(level.goal.p_WC.x() - level.start.p_WC.x(), 1.0, 1e-12) << ground.name;
    EXPECT_NEAR(over(level.goal.p_WC), over(level.start.p_WC), 1e-12) << ground.name;
    EXPECT_NEAR(higher.goal.p_WC.z() - level.goal.p_WC.z(), 0.25, 1e-12) << ground.name;
  }
}

TEST(CentroidalProblems, FrictionIsReplacedOnEveryPatch) {
  Terrain ground = BuiltInSet().grounds.back();
  ASSERT_FALSE(ground.patches.empty());
  for (const TerrainPatch& patch : WithFriction(ground, 0.33).patches) EXPECT_EQ(patch.friction, 0.33);
}

TEST(CentroidalProblems, WhatNoBodyCanHaveIsRefused) {
  const std::string robot = BuiltInJson().at("robots").items().begin().key();
  const auto spoilt = [&](const std::string& key, const Json& value) {
    Json json = BuiltInJson();
    json["robots"][robot][key] = value;
    return FailureOfSet(json).message;
  };
  EXPECT_NE(spoilt("inertia_kg_m2", Json::parse(R"({"xx":1,"xy":0,"xz":0,"yy":1,"yz":0,"zz":3})"))
                .find("triangle inequality"),
            std::string::npos);
  EXPECT_NE(spoilt("mass_kg", -1.0).find("mass_kg"), std::string::npos);
  EXPECT_NE(spoilt("reach_box_half_m", Json::array({0.1, 0.0, 0.1})).find("reach_box_half_m"), std::string::npos);
  EXPECT_NE(spoilt("nominal_stance_m", Json::array()).find("has 0 feet"), std::string::npos);
}

TEST(CentroidalProblems, SchedulesOfOtherFeetAndKeysThatAreMissingAreRefused) {
  Json json = BuiltInJson();
  json.erase("friction");
  EXPECT_NE(FailureOfSet(json).message.find("friction"), std::string::npos);
  json = BuiltInJson();
  for (auto& [name, schedules] : json["schedules"].items()) schedules[0]["phase_durations_s"].push_back({1.0});
  EXPECT_NE(FailureOfSet(json).message.find("is not for"), std::string::npos);
  FailureOfSet(Json::array());
  EXPECT_FALSE(LoadCentroidalProblems("/nowhere/problems.json").ok());
}

}  // namespace
}  // namespace gaitwright
