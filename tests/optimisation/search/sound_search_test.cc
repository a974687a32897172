// SPDX-License-Identifier: BSD-3-Clause
// The search with an artificial evaluator: which candidates it evaluates, in which order and with which effort, and its
// result. No plan is made.
#include "optimisation/search/sound_search.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <utility>
#include <vector>

namespace gaitwright {
namespace {

using Kind = SearchSituation::Kind;

Failure TooMuch() { return {FailureKind::kInfeasible, FailureCode::kFootholdOutOfReach, "Made up", "", {}}; }

/// Evaluates candidates by a function, and records the queries.
class MadeUp : public Evaluator {
 public:
  using IsSoundAt = std::function<bool(const Candidate&, Effort)>;
  explicit MadeUp(IsSoundAt sound) : sound_(std::move(sound)) {}

  Evaluation Evaluate(const Candidate& candidate, Effort effort) override {
    asked.emplace_back(candidate, effort);
    Evaluation evaluation = refused;
    evaluation.refusal.reset();
    if (!sound_(candidate, effort)) {
      evaluation.refusal = TooMuch();
      if (violated) evaluation.refusal->violation = Violation{*violated, 0.0, "", 0.0, 0.0, ""};
    }
    return evaluation;
  }
  bool Flies(const Candidate& candidate) override { return candidate.pace > flies_above; }

  int Count(Effort effort) const {
    return static_cast<int>(
        std::count_if(asked.begin(), asked.end(), [&](const auto& a) { return a.second == effort; }));
  }

  std::vector<std::pair<Candidate, Effort>> asked;
  std::optional<Law> violated;  // law that refusals violate
  Evaluation refused;           // set except for its refusal
  double flies_above = std::numeric_limits<double>::infinity();

 private:
  IsSoundAt sound_;
};

SearchProblem ProblemAt(Kind kind, double pace) {
  SearchProblem problem;
  problem.situation.kind = kind;
  problem.paces = {pace, 10.0};
  return problem;
}

TEST(FindSound, TakesTheWalkAsAskedForWhereThatIsSound) {
  for (const Kind kind : {Kind::kLevel, Kind::kUneven}) {
    MadeUp evaluator([](const Candidate&, Effort) { return true; });
    const SearchResult result = FindSound(ProblemAt(kind, 0.5), evaluator);
    EXPECT_TRUE(result.evaluation.sound());
    EXPECT_EQ(result.candidate, (Candidate{0.5}));
    EXPECT_EQ(result.why, std::nullopt);
    ASSERT_EQ(evaluator.asked.size(), 1U);
    EXPECT_EQ(evaluator.asked.front().second, Effort::kWhole);
  }
}

TEST(FindSound, OnLevelGroundWholeWalksArePlannedOnlyWhereTheirStartIsSound) {
  MadeUp evaluator([](const Candidate& c, Effort effort) {
    return effort == Effort::kStart ? c.cycle == 3 || c.cycle == 4 : c.cycle == 4;
  });
  const SearchResult result = FindSound(ProblemAt(Kind::kLevel, 0.5), evaluator);
  EXPECT_EQ(result.candidate, (Candidate{0.5, 4}));
  EXPECT_EQ(result.why, FailureCode::kFootholdOutOfReach);
  EXPECT_EQ(evaluator.Count(Effort::kStart), 4);
  EXPECT_EQ(evaluator.Count(Effort::kWhole), 3);
}

TEST(FindSound, WhatTheGroundForbidsIsTriedWithSlowerStepsFirst) {
  MadeUp evaluator([](const Candidate& c, Effort) { return c.cycle == 1 || c.cycle == -1; });
  EXPECT_EQ(FindSound(ProblemAt(Kind::kLevel, 0.5), evaluator).candidate.cycle, 1);
  evaluator.refused.by_ground = true;
  EXPECT_EQ(FindSound(ProblemAt(Kind::kLevel, 0.5), evaluator).candidate.cycle, -1);
}

TEST(FindSound, TheWholeBodyIsOptimisedWhereJointsRefuseAllPasses) {
  MadeUp evaluator([](const Candidate& c, Effort) { return c.finishes && c.cycle == 3; });
  EXPECT_FALSE(FindSound(ProblemAt(Kind::kLevel, 0.5), evaluator).evaluation.sound()) << "no law of joints is violated";
  for (const auto& [law, is_of_joints] : {std::pair(Law::kJointPosition, true), std::pair(Law::kJointTorque, true),
                                          std::pair(Law::kSelfCollision, false)}) {
    evaluator.violated = law;
    const SearchResult result = FindSound(ProblemAt(Kind::kLevel, 0.5), evaluator);
    EXPECT_EQ(result.evaluation.sound(), is_of_joints);
    EXPECT_EQ(result.candidate.finishes, is_of_joints);
    EXPECT_EQ(result.candidate.cycle, is_of_joints ? 3 : 0);
    EXPECT_FALSE(FindSound(ProblemAt(Kind::kFlying, 0.5), evaluator).evaluation.sound());
  }
}

TEST(FindSound, AWholeBodyThatLeavesAmpleRoomComesBeforeOtherCycles) {
  MadeUp evaluator([](const Candidate& c, Effort) { return c.finishes || c.cycle == 1; });
  evaluator.violated = Law::kJointTorque;
  EXPECT_EQ(FindSound(ProblemAt(Kind::kLevel, 0.5), evaluator).candidate, (Candidate{.pace = 0.5, .finishes = true}));
  EXPECT_EQ(evaluator.Count(Effort::kWhole), 2);
  EXPECT_EQ(evaluator.Count(Effort::kStart), 0);
  evaluator.refused.room = Room::kAsSolved;
  EXPECT_EQ(FindSound(ProblemAt(Kind::kLevel, 0.5), evaluator).candidate, (Candidate{0.5, 1}));
}

/// Refusals by joints only where the given function says so.
class JointsRefuse : public MadeUp {
 public:
  JointsRefuse(IsSoundAt sound, std::function<bool(const Candidate&)> of_joints)
      : MadeUp(std::move(sound)), of_joints_(std::move(of_joints)) {}
  Evaluation Evaluate(const Candidate& candidate, Effort effort) override {
    violated = of_joints_(candidate) ? std::optional(Law::kJointVelocity) : std::nullopt;
    return MadeUp::Evaluate(candidate, effort);
  }

 private:
  std::function<bool(const Candidate&)> of_joints_;
};

TEST(FindSound, TheWholeBodyIsOptimisedAlsoWhereJointsRefuseOnlyOtherCycles) {
  // The requested walk is out of reach; with shorter cycles, motors are too slow.
  JointsRefuse evaluator([](const Candidate& c, Effort) { return c.finishes && c.cycle == 6; },
                         [](const Candidate& c) { return c.cycle > 2; });
  EXPECT_TRUE(FindSound(ProblemAt(Kind::kLevel, 0.5), evaluator).candidate.finishes);
}

TEST(FindSound, HeelsRiseOnlyWhereFlatSolesAreRefused) {
  MadeUp evaluator([](const Candidate& c, Effort) { return c.heel_off_rad > 0.0; });
  evaluator.violated = Law::kJointPosition;
  SearchProblem problem = ProblemAt(Kind::kLevel, 0.5);
  EXPECT_FALSE(FindSound(problem, evaluator).evaluation.sound());
  EXPECT_TRUE(std::none_of(evaluator.asked.begin(), evaluator.asked.end(), [](const auto& asked) {
    return asked.first.heel_off_rad > 0.0;
  })) << "no sole steps forward";
  evaluator.asked.clear();
  problem.situation.may_raise_heels = true;
  const SearchResult result = FindSound(problem, evaluator);
  ASSERT_TRUE(result.evaluation.sound());
  EXPECT_GT(result.candidate.heel_off_rad, 0.0);
  EXPECT_TRUE(result.candidate.finishes);
  bool raised = false;
  for (const auto& [candidate, effort] : evaluator.asked) {
    EXPECT_FALSE(raised && candidate.heel_off_rad == 0.0) << "flat soles are tried first";
    raised = raised || candidate.heel_off_rad > 0.0;
  }
  EXPECT_FALSE(FindSound(ProblemAt(Kind::kFlying, 0.5), evaluator).evaluation.sound());
}

TEST(FindSound, APaceIsLoweredOnlyWhereNobodyAskedForIt) {
  const auto sound = [](const Candidate& c, Effort) { return c.pace <= 0.31; };
  SearchProblem problem = ProblemAt(Kind::kLevel, 0.5);
  MadeUp evaluator(sound);
  EXPECT_FALSE(FindSound(problem, evaluator).evaluation.sound());
  problem.situation.may_slow_down = true;
  const SearchResult result = FindSound(problem, evaluator);
  EXPECT_TRUE(result.evaluation.sound());
  EXPECT_DOUBLE_EQ(result.candidate.pace, 0.31);
}

TEST(FindSound, FootholdsMoveWhereNoFlightIsSound) {
  MadeUp evaluator([](const Candidate& c, Effort) { return c.other_footholds; });
  SearchProblem problem = ProblemAt(Kind::kFlying, 0.5);
  EXPECT_FALSE(FindSound(problem, evaluator).evaluation.sound());
  EXPECT_EQ(evaluator.asked.size(), 1U) << "they may not move";
  problem.situation.may_move_feet = true;
  EXPECT_EQ(FindSound(problem, evaluator).candidate, (Candidate{0.5, 0, 1.0, true}));
  problem.situation.may_vary_flight = true;
  evaluator.asked.clear();
  EXPECT_TRUE(FindSound(problem, evaluator).candidate.other_footholds);
  EXPECT_EQ(evaluator.Count(Effort::kFirstLook), 3) << "two other flights, other footholds";
  EXPECT_EQ(evaluator.Count(Effort::kWhole), 2) << "the requested walk, and the one with other footholds";
}

TEST(FindSound, TheLargestPaceIsThatOfTheBestCycle) {
  // The largest possible speed is 0.42 at cycle 5; whole walks are slightly worse than their starts.
  const auto largest = [](int cycle) { return 0.42 - 0.02 * std::abs(cycle - 5); };
  MadeUp evaluator([&](const Candidate& c, Effort effort) {
    return c.pace <= largest(c.cycle) - (effort == Effort::kWhole ? 0.015 : 0.0);
  });
  SearchProblem problem = ProblemAt(Kind::kLevel, 0.5);
  problem.situation.may_slow_down = true;
  const SearchResult result = FindSound(problem, evaluator);
  ASSERT_TRUE(result.evaluation.sound());
  EXPECT_EQ(result.candidate.cycle, 5);
  EXPECT_DOUBLE_EQ(result.candidate.pace, 0.4);
  EXPECT_LT(evaluator.asked.size(), 60U);
}

TEST(FindSound, OverUnevenGroundFewWalksAreTriedAndNoStarts) {
  MadeUp evaluator([](const Candidate&, Effort) { return false; });
  SearchProblem problem = ProblemAt(Kind::kUneven, 0.5);
  EXPECT_FALSE(FindSound(problem, evaluator).evaluation.sound());
  EXPECT_EQ(evaluator.asked.size(), 5U);
  EXPECT_EQ(evaluator.Count(Effort::kWhole), 5);
  problem.situation.may_slow_down = true;
  MadeUp slow([](const Candidate& c, Effort) { return c.pace < 0.3; });
  EXPECT_DOUBLE_EQ(FindSound(problem, slow).candidate.pace, 0.25);
}

TEST(FindSound, HeelsRiseWhereFlatSolesFindNoFootholds) {
  SearchProblem problem = ProblemAt(Kind::kUneven, 0.5);
  MadeUp raised([](const Candidate& c, Effort) { return c.heel_off_rad > 0.0 && c.pace < 0.2; });
  raised.refused.no_footholds = raised.refused.at_every_pace = true;
  EXPECT_FALSE(FindSound(problem, raised).evaluation.sound());
  EXPECT_EQ(raised.asked.size(), 1U) << "its feet may not be raised";

  problem.situation.may_raise_heels = true;
  raised.refused.at_every_pace = false;
  raised.asked.clear();
  EXPECT_FALSE(FindSound(problem, raised).evaluation.sound()) << "the speed is requested";
  EXPECT_EQ(raised.asked.size(), 2U);

  problem.situation.may_slow_down = true;
  const SearchResult found = FindSound(problem, raised);
  ASSERT_TRUE(found.evaluation.sound());
  EXPECT_TRUE(found.candidate.finishes);
  EXPECT_GT(found.candidate.heel_off_rad, 0.0);
  EXPECT_DOUBLE_EQ(found.candidate.pace, 0.35 * 0.5);
  EXPECT_EQ(found.why, FailureCode::kNoFootholds);
}

TEST(FindSound, OtherLeapsThanTheRequestedAreLookedAtBeforeTheyArePlanned) {
  MadeUp evaluator([](const Candidate& c, Effort) { return c.flight > 1.0; });
  SearchProblem problem = ProblemAt(Kind::kFlying, 0.5);
  EXPECT_FALSE(FindSound(problem, evaluator).evaluation.sound());
  EXPECT_EQ(evaluator.Count(Effort::kWhole), 1);
  problem.situation.may_vary_flight = true;
  evaluator.asked.clear();
  EXPECT_DOUBLE_EQ(FindSound(problem, evaluator).candidate.flight, 1.15);
  EXPECT_GE(evaluator.Count(Effort::kFirstLook), 1);
  EXPECT_EQ(evaluator.Count(Effort::kWhole), 2);
}

/// At its own pace a robot walks with its whole body optimised at once, where that leaves room for controllers.
TEST(FindSound, AWalkAtItsOwnPaceIsCalm) {
  SearchProblem problem = ProblemAt(Kind::kLevel, 0.5);
  problem.situation.may_slow_down = true;
  problem.situation.may_raise_heels = true;
  MadeUp evaluator([](const Candidate& c, Effort) { return c.finishes; });
  evaluator.violated = Law::kJointVelocity;
  SearchResult found = FindSound(problem, evaluator);
  EXPECT_EQ(found.candidate, (Candidate{0.5, 0, 1.0, false, true}));
  EXPECT_EQ(evaluator.Count(Effort::kWhole), 2);
  EXPECT_EQ(evaluator.Count(Effort::kStart), 0);

  MadeUp slower([](const Candidate& c, Effort) { return c.finishes && c.pace < 0.4; });
  slower.violated = Law::kJointVelocity;
  found = FindSound(problem, slower);
  EXPECT_TRUE(found.candidate.finishes);
  EXPECT_DOUBLE_EQ(found.candidate.pace, 0.35);
  EXPECT_EQ(found.candidate.heel_off_rad, 0.0);

  MadeUp without_room([](const Candidate& c, Effort) { return c.finishes || c.pace < 0.1; });
  without_room.violated = Law::kJointVelocity;
  without_room.refused.room = Room::kNone;
  found = FindSound(problem, without_room);
  EXPECT_FALSE(found.candidate.finishes);
  EXPECT_LT(found.candidate.pace, 0.1);
}

TEST(FindSound, StopsWhereNoPaceHelps) {
  MadeUp evaluator([](const Candidate&, Effort) { return false; });
  evaluator.refused.at_every_pace = true;
  EXPECT_FALSE(FindSound(ProblemAt(Kind::kLevel, 0.5), evaluator).evaluation.sound());
  EXPECT_EQ(evaluator.asked.size(), 1U);
}

TEST(SlowerThatIsSound, NamesTheLargestPaceOnLevelGround) {
  for (const double limit : {0.049, 0.13, 0.27, 0.49}) {
    MadeUp evaluator([&](const Candidate& c, Effort) { return c.pace <= limit; });
    const SlowerPace slower = SlowerThatIsSound(ProblemAt(Kind::kLevel, 0.5), evaluator);
    EXPECT_DOUBLE_EQ(slower.value, limit);
    EXPECT_EQ(slower.known, SlowerPace::Known::kLargest);
  }
}

TEST(SlowerThatIsSound, IsLargerWithTheOptimisedWholeBody) {
  MadeUp evaluator([](const Candidate& c, Effort) { return c.pace <= (c.finishes ? 0.41 : 0.2); });
  evaluator.violated = Law::kJointTorque;
  const SlowerPace slower = SlowerThatIsSound(ProblemAt(Kind::kLevel, 0.6), evaluator);
  EXPECT_GT(slower.value, 0.35);
  EXPECT_LE(slower.value, 0.41);
  EXPECT_EQ(slower.known, SlowerPace::Known::kMay);

  MadeUp without([](const Candidate& c, Effort) { return c.pace <= 0.2 && !c.finishes; });
  without.violated = Law::kJointTorque;
  const SlowerPace of_passes = SlowerThatIsSound(ProblemAt(Kind::kLevel, 0.6), without);
  EXPECT_DOUBLE_EQ(of_passes.value, 0.2);
  EXPECT_EQ(of_passes.known, SlowerPace::Known::kFeasible) << "the whole body was not optimised at all paces";

  evaluator.violated.reset();
  EXPECT_DOUBLE_EQ(SlowerThatIsSound(ProblemAt(Kind::kLevel, 0.6), evaluator).value, 0.2);
}

TEST(SlowerThatIsSound, IsFoundAlsoIfTheRequestIsFarOutOfReach) {
  MadeUp evaluator([](const Candidate& c, Effort) { return c.pace <= (c.finishes ? 0.25 : 0.2); });
  evaluator.violated = Law::kJointTorque;
  const SlowerPace slower = SlowerThatIsSound(ProblemAt(Kind::kLevel, 3.0), evaluator);
  EXPECT_GT(slower.value, 0.22);
  EXPECT_LE(slower.value, 0.25);
  EXPECT_EQ(slower.known, SlowerPace::Known::kMay);
}

TEST(SlowerThatIsSound, IsLargerAlsoIfFootholdsOfTheRequestAreOutOfReach) {
  JointsRefuse evaluator([](const Candidate& c, Effort) { return c.pace <= (c.finishes ? 0.3 : 0.2); },
                         [](const Candidate& c) { return c.pace < 1.0; });
  const SlowerPace slower = SlowerThatIsSound(ProblemAt(Kind::kLevel, 3.0), evaluator);
  EXPECT_GT(slower.value, 0.25);
  EXPECT_EQ(slower.known, SlowerPace::Known::kMay);
}

TEST(SlowerThatIsSound, OfAGaitThatFliesIsAsMuchSlowerAsItsLimitsSay) {
  MadeUp evaluator([](const Candidate& c, Effort) { return c.pace < 1.0; });
  evaluator.refused.ease = 0.6;
  evaluator.flies_above = 0.0;
  const SlowerPace slower = SlowerThatIsSound(ProblemAt(Kind::kFlying, 2.0), evaluator);
  EXPECT_EQ(slower.known, SlowerPace::Known::kMay);
  EXPECT_GT(slower.value, 0.4);
  EXPECT_LT(slower.value, 1.0);
  EXPECT_EQ(evaluator.Count(Effort::kWhole), 0);
}

TEST(SlowerThatIsSound, OfAGaitThatFliesByItsSpeedMayStayOnTheGround) {
  MadeUp evaluator([](const Candidate& c, Effort) { return c.flight == 0.0 && c.pace <= 0.9; });
  evaluator.flies_above = 0.8;
  SearchProblem problem = ProblemAt(Kind::kFlying, 2.0);
  EXPECT_EQ(SlowerThatIsSound(problem, evaluator).value, 0.0);
  problem.grounded = Kind::kLevel;
  const double slower = SlowerThatIsSound(problem, evaluator).value;
  EXPECT_GT(slower, 0.7);
  EXPECT_LE(slower, 0.8);
}

TEST(SlowerThatIsSound, ThereIsNoneOfAWalkInPlace) {
  MadeUp evaluator([](const Candidate&, Effort) { return true; });
  SearchProblem problem = ProblemAt(Kind::kLevel, 0.5);
  problem.in_place = true;
  EXPECT_EQ(SlowerThatIsSound(problem, evaluator).value, 0.0);
  EXPECT_TRUE(evaluator.asked.empty());
}

}  // namespace
}  // namespace gaitwright
