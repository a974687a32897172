// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>

#include "planning/terrain/load_terrain.h"
#include "tests/workflows/repair/standing_motion.h"
#include "workflows/repair/found_contacts_internal.h"

namespace gaitwright {
namespace {

FoundContacts ContactsOf(const EvenMotion& motion) {
  const RobotModel& model = NamedRobot("a1");
  const Terrain flat = LoadTerrain("flat", ScaleOf(model)).value();
  return FindContacts(model, motion, FeetOf(model, flat, motion), {});
}

constexpr int kRows = 200;

TEST(FoundContacts, AllFeetStandWhereTheRobotFloats) {
  EvenMotion motion = synthetic::Standing(NamedRobot("a1"), kRows);
  for (VectorX& q : motion.q) q[2] += 0.03;
  const FoundContacts found = ContactsOf(motion);
  EXPECT_NEAR(found.height_m, 0.03, 1e-3);
  for (const FootSet stance : found.stance) EXPECT_EQ(stance, AllFeet(4));
}

TEST(FoundContacts, AFootInTheAirSwings) {
  const RobotModel& model = NamedRobot("a1");
  EvenMotion motion = synthetic::Standing(model, kRows);
  synthetic::BendKnee(model, 1, 80, 120, motion);
  const FoundContacts found = ContactsOf(motion);
  const std::vector<RowRange> stances = StancesOf(found.stance, 1);
  ASSERT_EQ(stances.size(), 2U);
  EXPECT_NEAR(stances[0].last, 78, 2);
  EXPECT_NEAR(stances[1].first, 121, 2);
  EXPECT_EQ(StancesOf(found.stance, 0).size(), 1U);
}

/// A file that was put together, or whose height drifts, floats in one part and not in another one.
TEST(FoundContacts, TheHeightOfThePlaceCounts) {
  const RobotModel& model = NamedRobot("a1");
  EvenMotion motion = synthetic::Standing(model, 1000);
  for (int k = 0; k < 450; ++k) motion.q[static_cast<std::size_t>(k)][2] += 0.02 * std::min(1.0, (450 - k) / 50.0);
  synthetic::BendKnee(model, 1, 150, 190, motion);
  synthetic::BendKnee(model, 2, 700, 740, motion);
  const FoundContacts found = ContactsOf(motion);
  EXPECT_NEAR(found.height_m, 0.0, 1e-3) << "of most of the file";
  EXPECT_EQ(found.false_flights, 0);
  EXPECT_EQ(StancesOf(found.stance, 0).size(), 1U);
  for (const int foot : {1, 2}) {
    const std::vector<RowRange> stances = StancesOf(found.stance, foot);
    ASSERT_EQ(stances.size(), 2U) << foot;
    EXPECT_NEAR(stances[0].last, foot == 1 ? 148 : 698, 2);
    EXPECT_NEAR(stances[1].first, foot == 1 ? 191 : 741, 2);
  }
}

/// Under a heel that is raised about the ankle the toe is deep in the ground, and the lowest.
TEST(FoundContacts, FlatFeetShowWhereTheGroundIs) {
  const RobotModel& model = NamedRobot("h1");
  const Terrain flat = LoadTerrain("flat", ScaleOf(model)).value();
  EvenMotion motion = synthetic::Standing(model, kRows);
  const int ankle = model.joints[static_cast<std::size_t>(model.legs[0].joints.back())].dof;
  for (VectorX& q : motion.q) q[7 + ankle] += 0.2;
  const std::vector<FootTrack> feet = FeetOf(model, flat, motion);
  EXPECT_LT(feet[0].height_m[0], -0.01);
  const FoundContacts found = FindContacts(model, motion, feet, {});
  EXPECT_NEAR(found.height_m, 0.0, 1e-3);
  ASSERT_EQ(StancesOf(found.stance, 1).size(), 1U);
  EXPECT_EQ(StancesOf(found.stance, 1).front().last, kRows - 1);
}

/// Noise at the ends of a file makes a foot look fast. There is no stance on the other side that shows that it is
/// noise.
TEST(FoundContacts, AFootThatOnlyTremblesAtAnEndStands) {
  const RobotModel& model = NamedRobot("a1");
  const int knee = model.joints[static_cast<std::size_t>(model.legs[1].knee_joint)].dof;
  for (const bool at_start : {true, false}) {
    EvenMotion motion = synthetic::Standing(model, kRows);
    for (int k = 0; k < 30; ++k) {
      const int row = at_start ? k : kRows - 1 - k;
      VectorX& q = motion.q[static_cast<std::size_t>(row)];
      q[7 + knee] += 0.022 * std::sin(0.5 * M_PI * k);  // in a circle, so that it is never slow
      q[7 + knee - 2] += 0.015 * std::cos(0.5 * M_PI * k);
    }
    const FoundContacts found = ContactsOf(motion);
    EXPECT_EQ(found.short_swings, 1) << at_start;
    for (const FootSet stance : found.stance) EXPECT_EQ(stance, AllFeet(4)) << at_start;
    synthetic::BendKnee(model, 1, at_start ? 0 : kRows - 30, at_start ? 30 : kRows, motion);
    EXPECT_LT(
        StancesOf(ContactsOf(motion).stance, 1).front().last - StancesOf(ContactsOf(motion).stance, 1).front().first,
        kRows - 20)
        << "a foot in the air does not stand";
  }
}

TEST(FoundContacts, ShortSwingsAndShortStancesAreTakenAway) {
  const RobotModel& model = NamedRobot("a1");
  EvenMotion motion = synthetic::Standing(model, kRows);
  synthetic::BendKnee(model, 0, 50, 54, motion);
  synthetic::BendKnee(model, 2, 80, 120, motion);
  synthetic::BendKnee(model, 2, 125, 160, motion);
  const FoundContacts found = ContactsOf(motion);
  EXPECT_EQ(StancesOf(found.stance, 0).size(), 1U) << "four rows are no swing";
  EXPECT_EQ(StancesOf(found.stance, 2).size(), 2U) << "five rows are no stance";
  EXPECT_EQ(found.short_swings, 1);
  EXPECT_EQ(found.short_stances, 1);
}

TEST(FoundContacts, ARobotThatDoesNotFallStandsOnSomeFoot) {
  const RobotModel& model = NamedRobot("a1");
  EvenMotion motion = synthetic::Standing(model, kRows);
  for (int k = 90; k < 120; ++k) motion.q[static_cast<std::size_t>(k)][2] += 0.05;
  FoundContacts found = ContactsOf(motion);
  EXPECT_EQ(found.false_flights, 1);
  for (const FootSet stance : found.stance) EXPECT_NE(stance, 0U);

  for (int k = 90; k < 120; ++k) motion.a[static_cast<std::size_t>(k)][2] = -9.81;
  found = ContactsOf(motion);
  EXPECT_EQ(found.false_flights, 0);
  EXPECT_EQ(found.stance[105], 0U) << "it falls freely";
}

}  // namespace
}  // namespace gaitwright
