// SPDX-License-Identifier: BSD-3-Clause
#include "planning/gait/load_gaits.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <set>
#include <string>

#include "tests/scratch_folder.h"

namespace gaitwright {
namespace {

Result<std::vector<GaitEntry>> GaitsOfText(const std::string& text) {
  const std::string path = ScratchFile("load_gaits_test.yaml");
  std::ofstream(path) << text;
  return LoadGaits(path);
}

const GaitEntry* Generated(const std::vector<GaitEntry>& gaits, const std::string& name) {
  const auto at = std::find_if(gaits.begin(), gaits.end(), [&](const GaitEntry& e) { return e.gait.name == name; });
  return at == gaits.end() ? nullptr : &*at;
}

TEST(GeneratedGaits, AWaveLiftsOneFootAtATimeWhateverTheirNumber) {
  for (const int feet : {3, 4, 5, 6, 8, 11}) {
    const std::vector<GaitEntry> gaits = GeneratedGaits(feet);
    const GaitEntry* wave = Generated(gaits, "wave");
    ASSERT_NE(wave, nullptr) << feet;
    ASSERT_EQ(wave->gait.num_feet(), feet);
    EXPECT_GT(wave->cycle_per_leg_time, 0.0);
    EXPECT_EQ(wave->gait.cycle_s, 0.0) << "it scales with the leg";
    std::set<FootSet> lifted;
    for (int k = 0; k < 1000; ++k) {
      const FootSet up = AllFeet(feet) & ~StanceAt(wave->gait, (k + 0.5) / 1000.0);
      EXPECT_EQ(up & (up - 1), 0U) << "no two at once";
      if (up != 0) lifted.insert(up);
    }
    EXPECT_EQ(lifted.size(), static_cast<std::size_t>(feet)) << "each of them";
  }
}

TEST(GeneratedGaits, AWaveGoesFromRearToFrontOnOneSideAndThenOnTheOther) {
  const std::vector<GaitEntry> gaits = GeneratedGaits(6);
  const std::vector<double>& phase = Generated(gaits, "wave")->gait.phase;
  // Left feet are 0, 2, 4 and right ones 1, 3, 5, front first.
  EXPECT_LT(phase[4], phase[2]);
  EXPECT_LT(phase[2], phase[0]);
  EXPECT_LT(phase[0], phase[5]);
  EXPECT_LT(phase[5], phase[3]);
  EXPECT_LT(phase[3], phase[1]);
}

TEST(GeneratedGaits, AlternatingSetsHaveNoTwoNeighbours) {
  for (const int feet : {6, 8, 10}) {
    const std::vector<GaitEntry> gaits = GeneratedGaits(feet);
    const GaitEntry* sets = Generated(gaits, "alternating");
    ASSERT_NE(sets, nullptr) << feet;
    const std::vector<double>& phase = sets->gait.phase;
    const auto apart = [&](int a, int b) {
      return std::abs(phase[static_cast<std::size_t>(a)] - phase[static_cast<std::size_t>(b)]);
    };
    for (int foot = 0; foot < feet; ++foot) {
      if (foot % 2 == 0) {
        EXPECT_EQ(apart(foot, foot + 1), 0.5) << "across";
      }
      if (foot + 2 < feet) {
        EXPECT_EQ(apart(foot, foot + 2), 0.5) << "behind";
      }
    }
    EXPECT_FALSE(HasFlight(sets->gait));
  }
}

TEST(GeneratedGaits, AreThoseThatTheNumberOfFeetAllows) {
  EXPECT_TRUE(GeneratedGaits(1).empty());
  EXPECT_TRUE(GeneratedGaits(2).empty());
  for (const int feet : {3, 4, 5, 7}) EXPECT_EQ(GeneratedGaits(feet).size(), 1U) << feet;
  for (const int feet : {6, 8}) EXPECT_EQ(GeneratedGaits(feet).size(), 2U) << feet;
}

TEST(BuiltInGaitList, HasEachNameOnceForANumberOfFeetAndSoundTimes) {
  const Result<std::vector<GaitEntry>> gaits = BuiltInGaits();
  ASSERT_TRUE(gaits.ok()) << gaits.failure().message;
  std::set<std::string> names;
  for (const GaitEntry& entry : *gaits) {
    EXPECT_TRUE(names.insert(entry.gait.name).second) << entry.gait.name;
    EXPECT_EQ(entry.gait.phase.size(), entry.gait.duty_factor.size());
    EXPECT_NE(entry.gait.cycle_s > 0.0, entry.cycle_per_leg_time > 0.0) << "one of them: " << entry.gait.name;
    EXPECT_FALSE(entry.gait.description.empty()) << entry.gait.name;
  }
}

TEST(LoadGaitsFile, ANumberStandsForAllFeetAndAListForEach) {
  const auto gaits = GaitsOfText(
      "one: {feet: 3, cycle_s: 0.9, duty_factor: 0.7, phase: [0, 0.25, 0.5]}\n"
      "two: {feet: 2, cycle_per_leg_time: 6, duty_factor: [0.5, 0.6], phase: 0, stride_per_leg: 1.2,"
      " description: both}\n");
  ASSERT_TRUE(gaits.ok()) << gaits.failure().message;
  ASSERT_EQ(gaits->size(), 2U);
  const GaitEntry &one = (*gaits)[0], &two = (*gaits)[1];
  EXPECT_EQ(one.gait, (Gait{"one", "", 0.9, {0.0, 0.25, 0.5}, {0.7, 0.7, 0.7}}));
  EXPECT_EQ(one.cycle_per_leg_time, 0.0);
  EXPECT_EQ(one.stride_per_leg, 0.0);
  EXPECT_EQ(two.gait, (Gait{"two", "both", 0.0, {0.0, 0.0}, {0.5, 0.6}}));
  EXPECT_EQ(two.cycle_per_leg_time, 6.0);
  EXPECT_EQ(two.stride_per_leg, 1.2);
}

TEST(LoadGaitsFile, ValuesAreAcceptedUpToTheirEnds) {
  const auto accepted = [](const std::string& duty, const std::string& phase, const std::string& cycle) {
    return GaitsOfText("g: {feet: 2, cycle_s: " + cycle + ", duty_factor: " + duty + ", phase: " + phase + "}").ok();
  };
  EXPECT_TRUE(accepted("0.05", "0", "0.05"));
  EXPECT_TRUE(accepted("0.99", "0.999", "20"));
  EXPECT_FALSE(accepted("0.049", "0", "1"));
  EXPECT_FALSE(accepted("0.991", "0", "1"));
  EXPECT_FALSE(accepted("0.5", "1", "1"));
  EXPECT_FALSE(accepted("0.5", "-0.1", "1"));
  EXPECT_FALSE(accepted("0.5", "0", "0.049"));
  EXPECT_FALSE(accepted("0.5", "0", "20.1"));
}

TEST(LoadGaitsFile, TurnsOfTheBodyHaveATravelAndOneAxis) {
  const auto read = [](const std::string& keys) {
    return GaitsOfText("g: {feet: 4, cycle_s: 1, duty_factor: 0.5, phase: 0, " + keys + "}");
  };
  const auto flip = read("pitch_turns: -1, travel_per_leg: [-1, 0.5]");
  ASSERT_TRUE(flip.ok()) << flip.failure().message;
  EXPECT_EQ(flip->front().gait.pitch_turns, -1.0);
  EXPECT_EQ(flip->front().gait.roll_turns, 0.0);
  EXPECT_EQ(flip->front().travel_per_leg, (std::array<double, 2>{-1.0, 0.5}));
  EXPECT_FALSE(read("pitch_turns: -1").ok());
  EXPECT_FALSE(read("travel_per_leg: [-1, 0]").ok());
  EXPECT_FALSE(read("pitch_turns: 1, roll_turns: 1, travel_per_leg: [0, 0]").ok());
  EXPECT_FALSE(read("pitch_turns: 0.5, travel_per_leg: [0, 0]").ok());
  EXPECT_FALSE(read("pitch_turns: 1, travel_per_leg: [0]").ok());
}

TEST(LoadGaitsFile, FailuresNameTheFileAndTheLine) {
  const auto wrong = GaitsOfText("good: {feet: 2, cycle_s: 1, duty_factor: 0.6, phase: 0}\n\nbad: {feet: 2}\n");
  ASSERT_FALSE(wrong.ok());
  EXPECT_EQ(wrong.failure().kind, FailureKind::kBadInput);
  EXPECT_EQ(wrong.failure().code, FailureCode::kGait);
  EXPECT_NE(wrong.failure().message.find("load_gaits_test.yaml', line 3"), std::string::npos)
      << wrong.failure().message;
  const auto missing = LoadGaits(ScratchFile("no_such_gaits.yaml"));
  ASSERT_FALSE(missing.ok());
  EXPECT_EQ(missing.failure().kind, FailureKind::kBadInput);
}

}  // namespace
}  // namespace gaitwright
