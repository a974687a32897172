// SPDX-License-Identifier: BSD-3-Clause
#include "workflows/exchange/footstep_file.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <numbers>

#include "kinematics/base/file.h"
#include "kinematics/spatial/rotation.h"
#include "planning/paths/standing_feet.h"
#include "planning/plan/built_in_terrain.h"
#include "tests/scratch_folder.h"
#include "workflows/walk/walk.h"

namespace gaitwright {
namespace {

const RobotModel& FourFeet() {
  static const RobotModel model = *ChooseRobot("a1", "");
  return model;
}

const std::string kSteps =
    "swing_s: 0.4\npause_s: 0.3\nfootsteps:\n"
    "- {foot: RL_foot, x_m: -0.12, y_m: 0.13}\n"
    "- {foot: FL_foot, x_m: 0.24, y_m: 0.13}\n"
    "- {foot: RR_foot, x_m: -0.12, y_m: -0.13}\n"
    "- {foot: FR_foot, x_m: 0.24, y_m: -0.13}\n";

Result<FootstepSkeleton> Steps(const std::string& text) {
  return ReadFootsteps(FourFeet(), FlatTerrain(), text, "steps.yaml", 0.005);
}

void ExpectNoSteps(const std::string& text, const std::string& part) {
  const Result<FootstepSkeleton> steps = Steps(text);
  ASSERT_FALSE(steps.ok()) << part;
  EXPECT_EQ(steps.failure().code, FailureCode::kFootsteps);
  EXPECT_NE(steps.failure().message.find(part), std::string::npos) << steps.failure().message;
}

TEST(FootstepFile, TimesFollowFromSwingsAndPauses) {
  const Result<FootstepSkeleton> steps = Steps(kSteps);
  ASSERT_TRUE(steps.ok()) << steps.failure().message;
  EXPECT_EQ(steps->footsteps.footholds.size(), 8U);
  ASSERT_EQ(steps->schedule.phases.size(), 9U);
  EXPECT_NEAR(steps->schedule.phases[0].end_s, 0.8, 1e-9);
  EXPECT_NEAR(steps->schedule.phases[1].end_s, 1.2, 1e-9);
  EXPECT_NEAR(steps->schedule.phases[2].end_s, 1.5, 1e-9);
  EXPECT_NEAR(steps->schedule.end_s(), 0.8 + 4 * 0.4 + 3 * 0.3 + 0.8, 1e-9);
  CheckSchedule(steps->schedule, 4);
}

TEST(FootstepFile, TimesMayBeGiven) {
  const Result<FootstepSkeleton> steps = Steps(
      "footsteps:\n- {foot: RL_foot, x_m: -0.12, y_m: 0.13, lift_off_s: 1.0, touch_down_s: 1.5}\n"
      "- {foot: FR_foot, x_m: 0.2, y_m: -0.13, lift_off_s: 1.0, touch_down_s: 1.5, yaw_rad: 0.1, z_m: 0.005}\n");
  ASSERT_TRUE(steps.ok()) << steps.failure().message;
  ASSERT_EQ(steps->schedule.phases.size(), 3U);
  EXPECT_NEAR(steps->schedule.phases[1].start_s, 1.0, 1e-9);
}

TEST(FootstepFile, IsReadStrictly) {
  ExpectNoSteps(std::string(100, '[') + std::string(100, ']'), "nested more than");
  ExpectNoSteps("swing_s: 0.4\n", "footsteps");
  ExpectNoSteps("footsteps: []\n", "footsteps is empty");
  ExpectNoSteps("footsteps: [{foot: LF, x_m: 0, y_m: 0}]\n", "robot 'a1' has no foot 'LF'; it has ");
  ExpectNoSteps("footsteps: [{foot: FL_foot, x_m: 0.2, y_m: 0.1}]\n",
                "needs lift_off_s and touch_down_s, or a swing_s");
  ExpectNoSteps("footsteps: [{foot: FL_foot, x_m: 0.2, y_m: 0.1, lift_off_s: 1}]\n", "must be given together");
  ExpectNoSteps("swing_s: 0.4\nfootsteps: [{foot: FL_foot, x_m: 0.2, y_m: 0.1, z_m: 0.1}]\n",
                "z_m = 0.1 m is not on the ground");
  ExpectNoSteps("footsteps: [{foot: FL_foot, x_m: 0.2, y_m: 0.1, lift_off_s: 1, touch_down_s: 1}]\n", "at least");
  ExpectNoSteps(
      "footsteps:\n- {foot: FL_foot, x_m: 0.2, y_m: 0.1, lift_off_s: 1, touch_down_s: 1.5}\n"
      "- {foot: FL_foot, x_m: 0.2, y_m: 0.1, lift_off_s: 1.2, touch_down_s: 1.8}\n",
      "must stand");
  ExpectNoSteps("swing_s: .inf\nfootsteps: [{foot: FL_foot, x_m: 0.2, y_m: 0.1}]\n", "line 1");
  ExpectNoSteps("start: [{foot: FL_foot, x_m: 0.2, y_m: 0.1}]\nswing_s: 0.4\nfootsteps: []\n", "start has 1 of 4 feet");
  ExpectNoSteps("swings_s: 0.4\nfootsteps: []\n", "'swing_s'");
}

TEST(FootstepFile, WhatTakesMoreThanAnHourIsRefusedWithTheLine) {
  std::string text = "swing_s: 600\npause_s: 600\nfootsteps:\n";
  for (int i = 0; i < 3000; ++i)
    text += i % 2 == 0 ? "- {foot: RL_foot, x_m: -0.12, y_m: 0.13}\n" : "- {foot: FR_foot, x_m: 0.2, y_m: -0.13}\n";
  ExpectNoSteps(text,
                "line 7: foot 'FR_foot' touches down at 4200.8 s and the motion ends 0.8 s later; at most 3600 s");
  ExpectNoSteps(
      "final_stand_s: 3000\nfootsteps:\n- {foot: RL_foot, x_m: 0, y_m: 0.13, lift_off_s: 900, touch_down_s: "
      "901}\n",
      "line 3: foot 'RL_foot' touches down at 901 s and the motion ends 3000 s later");
  ExpectNoSteps("initial_stand_s: 1e9\nfootsteps: []\n", "accepted: 0 to 3600");
}

std::string ManySteps(int count) {
  std::string text = "swing_s: 0.2\npause_s: 0.1\nfootsteps:\n";
  for (int i = 0; i < count; ++i) {
    text += i == 0   ? "- &a {foot: RL_foot, x_m: -0.12, y_m: 0.13}\n"
            : i == 1 ? "- &b {foot: FR_foot, x_m: 0.2, y_m: -0.13}\n"
                     : (i % 2 == 0 ? "- *a\n" : "- *b\n");
  }
  return text;
}

TEST(FootstepFile, ManyStepsAreReadAndNoMoreThanThere) {
  const Result<FootstepSkeleton> steps = Steps(ManySteps(2000));
  ASSERT_TRUE(steps.ok()) << steps.failure().message;
  EXPECT_EQ(steps->footsteps.footholds.size(), 2004U);
  EXPECT_NEAR(steps->schedule.end_s(), 0.8 + 2000 * 0.2 + 1999 * 0.1 + 0.8, 1e-6);
  const PlanarPose &early = steps->path.pose[400], &late = steps->path.pose.back();  // both feet have stepped by 2 s
  EXPECT_NEAR(early.x_m, late.x_m, 1e-12);
  ExpectNoSteps(ManySteps(10001), "has 10001 footsteps; at most 10000 are read");
}

/// Steps of all feet in turn: each at its standing position relative to the origin, rotated to each of these headings.
std::string Turning(double from_rad, double to_rad, int rounds) {
  const std::vector<Pose> standing = StandingFeet(FourFeet());
  const auto place = [&](std::size_t f, double yaw) {
    const Vector3 p = YawRotation(yaw) * standing[f].translation();
    return fmt::format("- {{foot: {}, x_m: {}, y_m: {}, yaw_rad: {}}}\n", FourFeet().feet[f].name, p.x(), p.y(), yaw);
  };
  std::string text = "swing_s: 0.4\npause_s: 0.3\nstart:\n";
  for (std::size_t f = 0; f < standing.size(); ++f) text += place(f, from_rad);
  text += "footsteps:\n";
  for (int k = 1; k <= rounds; ++k) {
    for (const std::size_t f : {3U, 1U, 2U, 0U}) text += place(f, from_rad + k * (to_rad - from_rad) / rounds);
  }
  return text;
}

TEST(FootstepFile, TurnsGoOnBeyondHalfATurn) {
  const Result<FootstepSkeleton> steps = Steps(Turning(0.0, 9.0, 30));
  ASSERT_TRUE(steps.ok()) << steps.failure().message;
  const std::vector<PlanarPose>& path = steps->path.pose;
  for (std::size_t k = 1; k < path.size(); ++k) ASSERT_LT(std::abs(path[k].yaw_rad - path[k - 1].yaw_rad), 0.02) << k;
  EXPECT_NEAR(path.back().yaw_rad, 9.0, 1e-9);
  EXPECT_NEAR(steps->parts.front().command.goal_yaw_rad, 9.0 - 2.0 * std::numbers::pi, 1e-9) << "the same pose";
}

TEST(FootstepFile, ATurnThroughHalfATurnIsPlannedWithoutASpin) {
  ImportRequest request;
  request.file = ScratchFile("turn.yaml");
  ASSERT_TRUE(WriteFileAtomically(request.file, Turning(3.0, 3.3, 2)).ok());
  const Result<ImportedMotion> imported = ImportMotion(FourFeet(), request);
  ASSERT_TRUE(imported.ok()) << imported.failure().message;
  for (const VectorX& v : imported->plan.whole_body.v) ASSERT_LT(std::abs(v[5]), 1.0);
  EXPECT_TRUE(imported->audit.pass()) << AuditText(imported->audit);
}

TEST(FootstepFile, IsPlannedOnIntoAMotionThatPassesAndPlays) {
  ImportRequest request;
  request.file = ScratchFile("steps.yaml");
  ASSERT_TRUE(WriteFileAtomically(request.file, kSteps).ok());
  const Result<ImportedMotion> imported = ImportMotion(FourFeet(), request);
  ASSERT_TRUE(imported.ok()) << imported.failure().message;
  EXPECT_EQ(imported->format, MotionFormat::kFootsteps);
  EXPECT_EQ(imported->rows, 4);
  EXPECT_TRUE(imported->audit.pass()) << AuditText(imported->audit);
  const Foothold& last = imported->plan.footsteps.footholds.back();
  EXPECT_NEAR(last.X_WF.translation().x(), 0.24, 1e-9);
  const PlayRequest usual;
  const Result<PlayedWalk> played = PlayWalk(FourFeet(), imported->plan, usual);
  ASSERT_TRUE(played.ok());
  EXPECT_TRUE(played->report.pass) << played->report.reason;
}

TEST(FootstepFile, StepsOutOfReachAreRefused) {
  ImportRequest request;
  request.file = ScratchFile("far.yaml");
  ASSERT_TRUE(
      WriteFileAtomically(request.file, "swing_s: 0.4\nfootsteps: [{foot: FL_foot, x_m: 1.5, y_m: 0.1}]\n").ok());
  const Result<ImportedMotion> imported = ImportMotion(FourFeet(), request);
  ASSERT_FALSE(imported.ok());
  EXPECT_EQ(imported.failure().kind, FailureKind::kInfeasible);
  EXPECT_NE(imported.failure().message.find("cannot reach its foothold"), std::string::npos);
}

}  // namespace
}  // namespace gaitwright
