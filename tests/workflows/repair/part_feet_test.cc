// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "kinematics/spatial/rotation.h"
#include "planning/terrain/load_terrain.h"
#include "tests/workflows/repair/standing_motion.h"
#include "workflows/repair/part_feet_internal.h"

namespace gaitwright {
namespace {

constexpr double kApart = 0.01;  // [m]

using Stances = std::vector<std::vector<PinnedPlace>>;

Stances Parted(const RobotModel& model, Stances stances) {
  PartFeet(model, LoadTerrain("flat", ScaleOf(model)).value(), kApart, stances);
  return stances;
}

PinnedPlace PlaceAt(double x, double y, RowRange rows) {
  PinnedPlace place{rows};
  place.X_WF.translation() = Vector3(x, y, 0.0);
  return place;
}

/// Two feet of a quadrupedal robot on nearly one place, the others elsewhere.
Stances OnOnePlace(const RobotModel& model, RowRange of_second) {
  Stances stances(model.legs.size());
  stances[0] = {PlaceAt(0.3, 0.101, {0, 50})};
  stances[1] = {PlaceAt(0.3, 0.099, of_second)};
  for (std::size_t f = 2; f < stances.size(); ++f) stances[f] = {PlaceAt(-0.3, f == 2 ? 0.2 : -0.2, {0, 50})};
  return stances;
}

TEST(PartFeet, SpheresOnOnePlacePartEvenly) {
  const RobotModel& model = NamedRobot("a1");
  const Stances parted = Parted(model, OnOnePlace(model, {20, 80}));
  const Vector3 a = parted[0][0].X_WF.translation(), b = parted[1][0].X_WF.translation();
  EXPECT_NEAR((a - b).norm(), model.feet[0].radius + model.feet[1].radius + kApart, 1e-4);
  EXPECT_NEAR(0.5 * (a + b).y(), 0.1, 1e-9) << "both by the same way";
  EXPECT_GT(a.y(), b.y());
  EXPECT_NEAR(parted[0][0].parted_m, a.y() - 0.101, 1e-9);
  EXPECT_EQ(parted[2][0].parted_m, 0.0);
  const Stances again = Parted(model, parted);
  EXPECT_EQ(again[0][0].X_WF.translation(), a);
}

TEST(PartFeet, StancesAtOtherTimesMayShareAPlace) {
  const RobotModel& model = NamedRobot("a1");
  const Stances parted = Parted(model, OnOnePlace(model, {51, 80}));
  EXPECT_EQ(parted[0][0].parted_m, 0.0);
  EXPECT_EQ(parted[1][0].parted_m, 0.0);
}

/// Soles that stand half inside each other, turned against each other.
TEST(PartFeet, SolesPartInTheShortestDirection) {
  const RobotModel& model = NamedRobot("h1");
  Stances stances = {{PlaceAt(0.0, 0.01, {0, 50})}, {PlaceAt(0.0, -0.01, {0, 50})}};
  stances[0][0].X_WF.linear() = YawRotation(0.3);
  const Stances parted = Parted(model, stances);
  const Vector3 shift = parted[0][0].X_WF.translation() - stances[0][0].X_WF.translation();
  EXPECT_GT(shift.norm(), 0.005);
  EXPECT_GT(std::abs(shift.y()), 2.0 * std::abs(shift.x())) << "soles are longer than they are wide";
  EXPECT_EQ(shift.z(), 0.0);
  EXPECT_TRUE(parted[0][0].X_WF.linear() == stances[0][0].X_WF.linear());
  EXPECT_NEAR((parted[1][0].X_WF.translation() - stances[1][0].X_WF.translation() + shift).norm(), 0.0, 1e-12);
}

}  // namespace
}  // namespace gaitwright
