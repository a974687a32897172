// SPDX-License-Identifier: BSD-3-Clause
#include "optimisation/pipeline/swings_along.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "kinematics/model/load_robot.h"
#include "optimisation/pipeline/walk_problem.h"
#include "planning/gait/find_gait.h"

namespace gaitwright {
namespace {

/// A bound of two cycles, as the motion of a rigid body with massless legs; made once.
struct FirstBound {
  RobotModel model = *LoadNamedRobot("a1");
  Terrain ground = FlatTerrain();
  WalkCommand command;
  Gait gait;
  MotionOptions options;
  FootstepSkeleton skeleton;
  PlanOverPatches motion;
  RigidBodyOptions planning;

  FirstBound() {
    command.speed_m_s = 0.5;
    command.distance_m = 0.2;
    gait = *FindGait(model, "bound", 0.5, {});
    skeleton = *PlanFootsteps(model, ground, gait, command, options.footsteps);
    Use([&](const MotionTask& task) {
      const FlightSwings shapes(model, skeleton.schedule, options.swing);
      motion.choice.problem = WalkProblem(task, CarriedBody(model, nullptr), nullptr, shapes);
      motion.choice.patches = PatchesOf(task, motion.choice.problem);
      planning = WalkOptions(task, motion.choice.problem);
      planning.method = "interior-point";
      motion.plan = *PlanRigidBody(motion.choice.problem, planning);
    });
  }

  void Use(const std::function<void(const MotionTask&)>& use) const {
    const BodyPath path(model, skeleton, gait.cycle_s);
    use({model, ground, skeleton, options, path, gait.cycle_s});
  }

  /// The same with one swing through the ground.
  PlanOverPatches Scuffing(std::size_t swing) const {
    PlanOverPatches scuffing = motion;
    scuffing.choice.problem.swings[swing].lift_m = -0.02;
    return scuffing;
  }
};

const FirstBound& BoundOnce() {
  static const FirstBound bound;
  return bound;
}

TEST(CheckSwings, PassesSwingsThatAreClearAndWithinReach) {
  const FirstBound& bound = BoundOnce();
  bound.Use([&](const MotionTask& task) {
    const MotionVerdict verdict = CheckSwings(task, bound.motion, {});
    EXPECT_TRUE(verdict.passes) << verdict.stray_m;
    EXPECT_FALSE(SwingsTouch(task, bound.motion, {}));
    EXPECT_EQ(verdict.stray_m, 0.0);
    ASSERT_EQ(verdict.swings.size(), bound.motion.choice.problem.swings.size());
    for (const RigidSwing& swing : verdict.swings) EXPECT_FALSE(swing.free);
  });
}

TEST(CheckSwings, OneThroughTheGroundIsFreedWithThoseInTheAirWithIt) {
  const FirstBound& bound = BoundOnce();
  bound.Use([&](const MotionTask& task) {
    const MotionVerdict verdict = CheckSwings(task, bound.Scuffing(0), {});
    EXPECT_FALSE(verdict.passes);
    EXPECT_TRUE(SwingsTouch(task, bound.Scuffing(0), {}));
    EXPECT_GT(verdict.stray_m, 0.0);
    EXPECT_TRUE(verdict.swings[0].free);
    EXPECT_FALSE(verdict.swings[0].planes.empty());
    const auto freed =
        std::count_if(verdict.swings.begin(), verdict.swings.end(), [](const auto& s) { return s.free; });
    EXPECT_GE(freed, 2) << "both feet of a pair swing together in a bound";
    EXPECT_LT(freed, static_cast<int>(verdict.swings.size()));
  });
}

TEST(WithSwingsAlong, BringsASwingOutOfTheGroundAndGivesItThen) {
  const FirstBound& bound = BoundOnce();
  bound.Use([&](const MotionTask& task) {
    EXPECT_FALSE(WithSwingsAlong(task, bound.motion, bound.planning, {}).has_value()) << "nothing is wrong with it";
    const std::optional<PlanOverPatches> found = WithSwingsAlong(task, bound.Scuffing(0), bound.planning, {});
    ASSERT_TRUE(found.has_value());
    EXPECT_TRUE(CheckSwings(task, *found, {}).passes);
    const std::vector<RigidSwing>& swings = found->choice.problem.swings;
    EXPECT_FALSE(swings[0].detour_W.empty());
    for (const RigidSwing& swing : swings) EXPECT_FALSE(swing.free);
    EXPECT_EQ(found->plan.numbers.x.size(), bound.motion.plan.numbers.x.size()) << "swings are no unknowns any more";
  });
}

}  // namespace
}  // namespace gaitwright
