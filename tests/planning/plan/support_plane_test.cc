// SPDX-License-Identifier: BSD-3-Clause
#include "planning/plan/support_plane.h"

#include <gtest/gtest.h>

#include <random>

#include "kinematics/base/result.h"

namespace gaitwright {
namespace {

/// Four feet at the corners of a rectangle, at heights that no plane goes through.
ContactsByFoot FourFeet() {
  return {{{0.2, 0.1, 0.00}}, {{0.2, -0.1, 0.03}}, {{-0.2, 0.1, 0.05}}, {{-0.2, -0.1, 0.01}}};
}

constexpr FootSet kOneDiagonal = 0b1001, kOther = 0b0110, kAll = 0b1111;

ContactSchedule TrotSchedule() {
  return {{{0.0, 0.5, kAll}, {0.5, 0.8, kOneDiagonal}, {0.8, 0.9, kAll}, {0.9, 1.2, kOther}, {1.2, 2.0, kAll}}};
}

TEST(SupportPlane, HoldsTheLineOfTwoFeetAndIsLevelAcrossIt) {
  const ContactsByFoot feet = FourFeet();
  const GroundPlane plane = PlaneThrough(feet, kOneDiagonal);
  const Vector3 a = feet[0][0], b = feet[3][0];
  EXPECT_NEAR(plane.HeightAt(a.head<2>()), a.z(), 1e-12);
  EXPECT_NEAR(plane.HeightAt(b.head<2>()), b.z(), 1e-12);
  const Vector2 along = (b - a).head<2>(), across(-along.y(), along.x());
  EXPECT_NE(plane.slope.dot(along), 0.0);
  EXPECT_NEAR(plane.slope.dot(across), 0.0, 1e-12);
}

TEST(SupportPlane, GoesThroughThreeFeetAndIsLevelUnderOne) {
  const ContactsByFoot feet = FourFeet();
  const GroundPlane three = PlaneThrough(feet, 0b0111);
  for (const std::size_t f : {0U, 1U, 2U}) EXPECT_NEAR(three.HeightAt(feet[f][0].head<2>()), feet[f][0].z(), 1e-12);
  const GroundPlane one = PlaneThrough(feet, 0b0100);
  EXPECT_EQ(one.slope.norm(), 0.0);
  EXPECT_NEAR(one.height_m, 0.05, 1e-12);
}

TEST(SupportPlane, DoesNotJumpWhereStancesChange) {
  const ContactsByFoot feet = FourFeet();
  const ContactSchedule schedule = TrotSchedule();
  for (const double boundary : {0.5, 0.8, 0.9, 1.2}) {
    const GroundPlane before = SupportPlaneAt(schedule, boundary - 1e-9, feet);
    const GroundPlane after = SupportPlaneAt(schedule, boundary + 1e-9, feet);
    EXPECT_NEAR(before.height_m, after.height_m, 1e-6) << boundary;
    EXPECT_NEAR((before.slope - after.slope).norm(), 0.0, 1e-6) << boundary;
  }
  const GroundPlane first = SupportPlaneAt(schedule, 0.8, feet), last = SupportPlaneAt(schedule, 0.9, feet);
  EXPECT_NEAR((first.slope - PlaneThrough(feet, kOneDiagonal).slope).norm(), 0.0, 1e-6);
  EXPECT_NEAR((last.slope - PlaneThrough(feet, kOther).slope).norm(), 0.0, 1e-6);
}

TEST(SupportPlane, TheZeroMomentPointOfForcesAtTwoFeetLiesOnTheirLine) {
  const ContactsByFoot feet = FourFeet();
  const Vector3 a = feet[0][0], b = feet[3][0], p_WP(0.03, -0.02, 0.4);
  const GroundPlane plane = PlaneThrough(feet, kOneDiagonal);
  std::mt19937 random(3);
  std::uniform_real_distribution<double> share(-1.0, 1.0);
  for (int i = 0; i < 50; ++i) {
    const Vector3 f_a(10.0 * share(random), 10.0 * share(random), 60.0 + 20.0 * share(random));
    const Vector3 f_b(10.0 * share(random), 10.0 * share(random), 60.0 + 20.0 * share(random));
    const Vector3 moment = (a - p_WP).cross(f_a) + (b - p_WP).cross(f_b);
    const Vector3 zmp = ZeroMomentPoint(p_WP, f_a + f_b, moment, plane);
    EXPECT_NEAR(zmp.z(), plane.HeightAt(zmp.head<2>()), 1e-12);
    EXPECT_NEAR((zmp - a).cross((b - a).normalized()).norm(), 0.0, 1e-12);
  }
}

TEST(SupportPlane, OfLevelGroundGivesTheZeroMomentPointOfLevelGround) {
  const Vector3 p_WP(0.1, 0.2, 0.5), force(5.0, -7.0, 100.0), moment(3.0, -4.0, 1.0);
  const Vector3 zmp = ZeroMomentPoint(p_WP, force, moment, GroundPlane{0.1, Vector2::Zero()});
  EXPECT_NEAR((zmp.head<2>() - ZeroMomentPoint(p_WP, force, moment, 0.1)).norm(), 0.0, 1e-14);
  EXPECT_THROW(ZeroMomentPoint(p_WP, -force, moment, GroundPlane{}), InvalidArgument);
}

TEST(CarryingPlane, GoesEvenlyWithAFootInTheAirFromItsFootholdToTheNext) {
  FootstepPlan footsteps;
  for (int f = 0; f < 3; ++f) {
    Foothold foothold;
    foothold.foot = f;
    foothold.liftoff_s = f == 2 ? 1.0 : 10.0;
    foothold.X_WF.translation() = Vector3(f == 2 ? 1.0 : 0.0, f == 0 ? 0.5 : -0.5, 0.0);
    footsteps.footholds.push_back(foothold);
  }
  Foothold higher = footsteps.footholds.back();
  higher.touchdown_s = 2.0;
  higher.liftoff_s = 10.0;
  higher.X_WF.translation().z() = 0.4;
  footsteps.footholds.push_back(higher);
  for (const auto& [time_s, height] : {std::pair(0.5, 0.0), std::pair(1.0, 0.0), std::pair(1.25, 0.1),
                                       std::pair(1.75, 0.3), std::pair(2.0, 0.4), std::pair(5.0, 0.4)}) {
    const GroundPlane plane = CarryingPlaneAt(footsteps, 3, time_s);
    EXPECT_NEAR(plane.HeightAt(Vector2(1.0, -0.5)), height, 1e-12);
    EXPECT_NEAR(plane.HeightAt(Vector2(0.0, 0.5)), 0.0, 1e-12);
  }
}

}  // namespace
}  // namespace gaitwright
