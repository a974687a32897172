// SPDX-License-Identifier: BSD-3-Clause
// Random grounds: a plan passes or is refused with its reason, and most walkable grounds are solved.
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <cstdio>
#include <exception>
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <tuple>
#include <vector>

#include "kinematics/model/load_robot.h"
#include "planning/terrain/load_terrain.h"
#include "tests/built_paths.h"
#include "tests/workflows/walk/coarse_search.h"
#include "tests/workflows/walk/random_grounds.h"

namespace gaitwright {
namespace {

constexpr int kSeeds = 67;           // of each kind of ground
constexpr double kLeastShare = 0.7;  // share of the walks for which a coarse search finds footholds

/// Results of the walks over the grounds of one kind.
struct Tally {
  int solved = 0;
  int walkable = 0;         ///< grounds on which the coarse search finds footholds
  int walkable_solved = 0;  ///< walkable grounds that are solved
  std::map<std::string, std::vector<int>> refused =
      {};  ///< seeds, by the failure's code and the coarse search's answer

  double share() const { return walkable == 0 ? 1.0 : static_cast<double>(walkable_solved) / walkable; }
};

/// Whether a message names a quantity: a number with its unit.
bool NamesQuantity(const std::string& message) {
  static const std::set<std::string> kUnits = {"m", "mm", "rad", "deg", "s", "N", "Nm", "m/s", "rad/s"};
  std::istringstream words(message);
  std::string word, before;
  while (words >> word) {
    word.erase(
        std::find_if(word.begin(), word.end(), [](char c) { return c == ',' || c == ';' || c == ':' || c == ')'; }),
        word.end());
    if (kUnits.contains(word) && !before.empty() && std::isdigit(static_cast<unsigned char>(before.back())) != 0)
      return true;
    before = word;
  }
  return false;
}

void ExpectReason(const Failure& failure) {
  EXPECT_EQ(failure.kind, FailureKind::kInfeasible) << failure.message;
  EXPECT_NE(failure.code, FailureCode::kInternal) << failure.message;
  EXPECT_TRUE(NamesQuantity(failure.message)) << failure.message;
}

class RandomGrounds : public testing::TestWithParam<std::tuple<std::string, RandomGroundKind>> {
 protected:
  RandomGrounds() : model_(LoadNamedRobot(std::get<0>(GetParam())).value()) {}

  void Walk(int seed) {
    const std::string folder = BuildFolder() + "/random-grounds";
    const TerrainScale scale = ScaleOf(model_);
    const RandomGround ground =
        MakeRandomGround(std::get<1>(GetParam()), static_cast<std::uint64_t>(seed), scale, folder);
    SCOPED_TRACE(fmt::format("gaitwright plan --robot {} {}", model_.name, ground.flags));
    WalkRequest request;
    request.terrain = ground.terrain;
    request.command = ground.command;
    const Result<PlannedWalk> planned = PlanWalk(model_, request);
    if (planned) {
      EXPECT_TRUE(planned->audit.pass()) << AuditText(planned->audit);
    } else {
      ExpectReason(planned.failure());
    }
    Count(seed, ground, planned, SearchCoarsely(model_, LoadTerrain(ground.terrain, scale).value(), request).found);
  }

  void Count(int seed, const RandomGround& ground, const Result<PlannedWalk>& planned, bool walkable) {
    tally_.walkable += walkable ? 1 : 0;
    if (planned) {
      ++tally_.solved;
      tally_.walkable_solved += walkable ? 1 : 0;
    } else {
      tally_.refused[FailureCodeName(planned.failure().code) + (walkable ? ", walkable" : "")].push_back(seed);
    }
    const std::string end = planned ? planned->motion.summary : planned.failure().message;
    fmt::print("seed {}, {}: {} ({})\n", seed, walkable ? "walkable" : "not walkable", end, ground.flags);
    std::fflush(stdout);
  }

  void Report() const {
    fmt::print(
        "{} {}: {} solved of {}; {} walkable by a coarse search, {} of "
        "them solved ({:.0f} %)\n",
        model_.name, NameOf(std::get<1>(GetParam())), tally_.solved, kSeeds, tally_.walkable, tally_.walkable_solved,
        100.0 * tally_.share());
    for (const auto& [code, seeds] : tally_.refused)
      fmt::print("  {} {}: seeds {}\n", seeds.size(), code, fmt::join(seeds, " "));
    RecordProperty("solved", tally_.solved);
    RecordProperty("walkable", tally_.walkable);
    RecordProperty("walkable_solved", tally_.walkable_solved);
  }

  RobotModel model_;
  Tally tally_;
};

TEST_P(RandomGrounds, AreWalkedSoundlyOrRefusedWithTheReason) {
  for (int seed = 1; seed <= kSeeds; ++seed) {
    try {
      Walk(seed);
    } catch (const std::exception& error) {
      ADD_FAILURE() << "seed " << seed << ": " << error.what();
    }
  }
  Report();
  EXPECT_GE(tally_.share(), kLeastShare);
}

INSTANTIATE_TEST_SUITE_P(All, RandomGrounds,
                         testing::Combine(testing::Values("a1", "nao"),
                                          testing::Values(RandomGroundKind::kStones, RandomGroundKind::kRough,
                                                          RandomGroundKind::kWalls)),
                         [](const auto& of) { return std::get<0>(of.param) + "_" + NameOf(std::get<1>(of.param)); });

}  // namespace
}  // namespace gaitwright
