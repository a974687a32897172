// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <tuple>

#include "kinematics/base/result.h"
#include "kinematics/model/load_robot.h"
#include "planning/gait/find_gait.h"
#include "planning/gait/schedule_contacts.h"
#include "tests/scratch_folder.h"

namespace gaitwright {
namespace {

TEST(Gaits, BuiltInOnesAreWhatTheirNamesSay) {
  const auto gaits = BuiltInGaits();
  ASSERT_TRUE(gaits.ok()) << gaits.failure().message;
  ASSERT_GE(gaits->size(), 8U);
  for (const GaitEntry& entry : *gaits) {
    const std::vector<std::string> fly = {"hop",  "run",      "bound",       "pronk",           "gallop",
                                          "jump", "backflip", "barrel-roll", "barrel-roll-left"};
    EXPECT_EQ(HasFlight(entry.gait), std::count(fly.begin(), fly.end(), entry.gait.name) == 1) << entry.gait.name;
    EXPECT_EQ(TurnsOver(entry.gait), entry.travel_per_leg.has_value()) << entry.gait.name;
  }
}

TEST(Gaits, CrawlKeepsThreeFeetOnTheGround) {
  const Result<RobotModel> a1 = LoadNamedRobot("a1");
  const Result<Gait> crawl = FindGait(*a1, "walk", 0.1, {});
  ASSERT_TRUE(crawl.ok());
  for (double u = 0.0; u < 1.0; u += 0.001) EXPECT_GE(__builtin_popcountll(StanceAt(*crawl, u)), 3);
}

TEST(Gaits, FasterWalkingShortensTheCycle) {
  const Result<RobotModel> a1 = LoadNamedRobot("a1");
  const double slow = FindGait(*a1, "trot", 0.3, {})->cycle_s, fast = FindGait(*a1, "trot", 0.8, {})->cycle_s;
  EXPECT_NEAR(slow, 0.5, 0.02);
  EXPECT_LT(fast, slow);
}

/// At the transition to running, no feet lift exactly when others land, because forces would jump from pair to pair.
TEST(Gaits, RunsWithAClearFlightOrWalksWithAClearDoubleSupport) {
  const Result<RobotModel> a1 = LoadNamedRobot("a1");
  int flying = 0;
  for (int i = 0; i <= 100; ++i) {
    const Gait gait = *FindGait(*a1, "trot", 1.0 + 0.005 * i, {});
    const Result<ContactSchedule> schedule = ScheduleContacts(gait, {});
    ASSERT_TRUE(schedule.ok());
    flying += HasFlight(gait) ? 1 : 0;
    for (std::size_t k = 1; k < schedule->phases.size(); ++k) {
      const FootSet before = schedule->phases[k - 1].stance, after = schedule->phases[k].stance;
      EXPECT_FALSE((before & ~after) != 0 && (after & ~before) != 0) << 1.0 + 0.005 * i << " m/s, phase " << k;
    }
  }
  EXPECT_GT(flying, 20);
  EXPECT_LT(flying, 80);
}

TEST(Gaits, UnknownNameListsWhatThereIs) {
  const Result<RobotModel> nao = LoadNamedRobot("nao");
  const Result<Gait> gait = FindGait(*nao, "trot", 0.1, {});
  ASSERT_FALSE(gait.ok());
  EXPECT_NE(gait.failure().message.find("'biped'"), std::string::npos);
}

TEST(Gaits, OneForAnotherNumberOfFeetSaysSo) {
  const Result<RobotModel> a1 = LoadNamedRobot("a1"), nao = LoadNamedRobot("nao");
  for (const auto& [model, name, feet] : {std::tuple{&*a1, "hop", "is for 2 feet, but the robot has 4"},
                                          std::tuple{&*a1, "run", "is for 2 feet, but the robot has 4"},
                                          std::tuple{&*nao, "pronk", "is for 4 feet, but the robot has 2"}}) {
    const Result<Gait> gait = FindGait(*model, name, 0.1, {});
    ASSERT_FALSE(gait.ok());
    EXPECT_NE(gait.failure().message.find(feet), std::string::npos) << gait.failure().message;
  }
  EXPECT_TRUE(FindGait(*nao, "hop", 0.1, {}).ok());
  EXPECT_TRUE(FindGait(*nao, "run", 0.1, {}).ok());
}

TEST(Gaits, HoppersLeaveTheGroundTogetherAndRunnersInTurn) {
  const Result<RobotModel> nao = LoadNamedRobot("nao");
  const Gait hop = *FindGait(*nao, "hop", 0.1, {}), run = *FindGait(*nao, "run", 0.1, {});
  bool left = false, right = false;
  for (double u = 0.0005; u < 1.0; u += 0.001) {
    EXPECT_TRUE(StanceAt(hop, u) == 0 || StanceAt(hop, u) == AllFeet(2)) << u;
    EXPECT_NE(StanceAt(run, u), AllFeet(2)) << u;
    left = left || StanceAt(run, u) == FootBit(0);
    right = right || StanceAt(run, u) == FootBit(1);
  }
  EXPECT_TRUE(left && right);
}

TEST(Gaits, FilesAreValidated) {
  const std::string path = ScratchFile("gaits_test.yaml");
  const auto message = [&](const std::string& text) {
    std::ofstream(path) << text;
    const auto gaits = LoadGaits(path);
    std::remove(path.c_str());
    return gaits.ok() ? std::string() : gaits.failure().message;
  };
  EXPECT_EQ(message("hop: {feet: 2, cycle_s: 1.0, duty_factor: 0.6, phase: [0, 0.5]}"), "");
  EXPECT_NE(message("hop: {feet: 2, cycle_s: 1.0, duty_facto: 0.6, phase: [0, 0.5]}").find("'duty_factor'"),
            std::string::npos);
  EXPECT_NE(message("hop: {feet: 2, cycle_s: .nan, duty_factor: 0.6, phase: [0, 0.5]}").find("cycle_s"),
            std::string::npos);
  EXPECT_NE(message("hop: {feet: 2, cycle_s: 1.0, duty_factor: 0.6, phase: [0, 0.5, 0.7]}").find("3 entries"),
            std::string::npos);
  EXPECT_NE(message("hop: {feet: 2, cycle_s: 1.0, duty_factor: 1.6, phase: 0}").find("accepted"), std::string::npos);
  const std::string hop = "hop: {feet: 2, cycle_s: 1.0, duty_factor: 0.6, phase: [0, 0.5]}\n";
  const std::vector<std::pair<std::string, std::string>> wrong = {
      {"hop: {feet: 2.5, cycle_s: 1.0, duty_factor: 0.6, phase: 0}", "line 1: feet is 2.5; a whole number"},
      {"hop: {feet: two, cycle_s: 1.0, duty_factor: 0.6, phase: 0}", "line 1: feet is 'two'; a number"},
      {"hop:\n  feet: 2\n  cycle_s: 1\n  duty_factor: {a: 1}\n  phase: 0", "line 4: duty_factor is a map"},
      {"hop: {feet: 2, cycle_s: [1], duty_factor: 0.6, phase: 0}", "cycle_s is a list"},
      {"hop: {feet: 2, cycle_s: 1, cycle_per_leg_time: 8, duty_factor: 0.6, phase: 0}", "has both"},
      {"hop: {feet: 2, feet: 2, cycle_s: 1, duty_factor: 0.6, phase: 0}", "gait 'hop' has the key 'feet' twice"},
      {"[1]: {feet: 2}", "a key of the file is a list"},
      {"hop: {feet: 2, cycle_s: 1, duty_factor: 0.6, phase: 0, stride_per_leg: 0}", "stride_per_leg is 0; accepted"},
      {"hop: 3", "gait 'hop' is a single value"},
      {"[1, 2]", "contains no gaits"},
      {"hop: {feet: 2", "line 1: not valid YAML"},
      {hop + hop, "line 2: the file has the key 'hop' twice"}};
  for (const auto& [text, part] : wrong) EXPECT_NE(message(text).find(part), std::string::npos) << message(text);
}

TEST(Gaits, LeapsHaveAStrideOfTheirOwn) {
  const Result<RobotModel> a1 = LoadNamedRobot("a1");
  EXPECT_NEAR(*OwnStride(*a1, "jump"), 3.0 * a1->leg_length_m(), 1e-12);
  EXPECT_EQ(*OwnStride(*a1, "trot"), 0.0);
  EXPECT_FALSE(OwnStride(*a1, "hover").ok());
}

TEST(Gaits, OneOfAFileIsPickedByItsName) {
  const Result<RobotModel> nao = LoadNamedRobot("nao");
  const std::string path = ScratchFile("gaits_of_a_file.yaml");
  std::ofstream(path) << "four: {feet: 4, cycle_s: 1.0, duty_factor: 0.6, phase: [0, 0.5, 0.5, 0]}\n"
                         "slow: {feet: 2, cycle_s: 2.0, duty_factor: 0.6, phase: [0, 0.5]}\n"
                         "fast: {feet: 2, cycle_s: 0.8, duty_factor: 0.6, phase: [0, 0.5]}\n";
  EXPECT_EQ(FindGait(*nao, path + ":fast", 0.1, {})->cycle_s, 0.8);
  EXPECT_EQ(FindGait(*nao, path + ":slow", 0.1, {})->cycle_s, 2.0);
  EXPECT_EQ(*ShortestCycle(*nao, path + ":slow", {}), 2.0) << "a time that is given stays";
  EXPECT_NE(FindGait(*nao, path, 0.1, {}).failure().message.find("FILE:NAME"), std::string::npos);
  EXPECT_NE(FindGait(*nao, path + ":four", 0.1, {}).failure().message.find("for 4 feet"), std::string::npos);
  EXPECT_NE(FindGait(*nao, path + ":best", 0.1, {}).failure().message.find("'fast'"), std::string::npos);
  std::remove(path.c_str());
}

TEST(Gaits, AreMadeForAnyNumberOfFeet) {
  for (int feet = 3; feet <= 16; ++feet) {
    SCOPED_TRACE(feet);
    RobotModel model = *LoadNamedRobot("a1");
    model.feet.resize(static_cast<std::size_t>(feet));
    for (const char* name : {"", "walk", "wave"}) {
      const Result<Gait> gait = FindGait(model, name, 0.1, {});
      ASSERT_TRUE(gait.ok()) << gait.failure().message;
      EXPECT_EQ(gait->num_feet(), feet);
      EXPECT_FALSE(HasFlight(*gait));
    }
    const Result<Gait> wave = FindGait(model, "wave", 0.1, {});
    for (double u = 0.0; u < 1.0; u += 0.001) EXPECT_GE(__builtin_popcountll(StanceAt(*wave, u)), feet - 1);
  }
}

TEST(Gaits, GeneratedOnesMeetTheListedOnes) {
  const Result<RobotModel> a1 = LoadNamedRobot("a1");
  EXPECT_EQ(FindGait(*a1, "wave", 0.1, {})->phase, FindGait(*a1, "crawl", 0.1, {})->phase);
  EXPECT_NEAR(FindGait(*a1, "wave", 0.1, {})->duty_factor[0], FindGait(*a1, "crawl", 0.1, {})->duty_factor[0], 1e-12);
  const auto listed = BuiltInGaits();
  const auto tripod =
      std::find_if(listed->begin(), listed->end(), [](const auto& e) { return e.gait.name == "tripod"; });
  ASSERT_NE(tripod, listed->end());
  EXPECT_EQ(GeneratedGaits(6).back().gait.phase, tripod->gait.phase);
}

TEST(Gaits, OptionsTooSmallAreRefusedByName) {
  const Result<RobotModel> a1 = LoadNamedRobot("a1");
  GaitOptions options;
  options.cycle_s = 0.01;
  EXPECT_NE(FindGait(*a1, "", 0.3, options).failure().message.find("'gait.cycle_s' is 0.01 s"), std::string::npos);
  options = {};
  options.duty_factor = 0.01;
  EXPECT_NE(FindGait(*a1, "", 0.3, options).failure().message.find("'gait.duty_factor'"), std::string::npos);
}

TEST(Schedule, IntervalsAbutExactlyOnTheGrid) {
  for (const char* name : {"trot", "crawl", "amble", "pace"}) {
    const Result<RobotModel> a1 = LoadNamedRobot("a1");
    Gait gait = *FindGait(*a1, name, 0.2, {});
    for (int i = 0; i < 20; ++i) {
      gait.cycle_s = 0.31 + 0.0717 * i;
      ScheduleRequest request;
      request.stepping_s = 3.0 * gait.cycle_s;
      const Result<ContactSchedule> schedule = ScheduleContacts(gait, request);
      ASSERT_TRUE(schedule.ok());
      EXPECT_NO_THROW(CheckSchedule(*schedule, 4));
      EXPECT_EQ(schedule->phases.front().stance, AllFeet(4));
      EXPECT_EQ(schedule->phases.back().stance, AllFeet(4));
      for (const ContactPhase& phase : schedule->phases) {
        EXPECT_NEAR(std::remainder(phase.start_s, request.grid_s), 0.0, 1e-9);
        EXPECT_NE(phase.stance, FootSet{0});
      }
    }
  }
}

TEST(Schedule, IsThatOfItsIntervals) {
  const std::vector<std::vector<ContactInterval>> by_foot = {
      {{0.0, 1.0}, {2.0, 5.0}}, {{0.0, 2.0}, {2.0, 3.0}, {4.0, 5.0}}, {{1.0, 4.5}}, {}};
  const ContactSchedule schedule = ScheduleFromIntervals(by_foot, 0.0, 5.0);
  const std::vector<ContactPhase> expected = {{0.0, 1.0, 3}, {1.0, 2.0, 6}, {2.0, 3.0, 7},
                                              {3.0, 4.0, 5}, {4.0, 4.5, 7}, {4.5, 5.0, 3}};
  EXPECT_EQ(schedule.phases, expected);
  EXPECT_EQ(IntervalsOf(schedule, 0), by_foot[0]);
  EXPECT_EQ(IntervalsOf(schedule, 1), (std::vector<ContactInterval>{{0.0, 3.0}, {4.0, 5.0}}));
  EXPECT_EQ(IntervalsOf(schedule, 2), by_foot[2]);
}

TEST(Schedule, FlightsArePhasesOnNoFoot) {
  const Result<RobotModel> a1 = LoadNamedRobot("a1");
  for (const char* name : {"bound", "pronk", "gallop", "jump"}) {
    const Gait gait = *FindGait(*a1, name, 0.5, {});
    ScheduleRequest request;
    request.stepping_s = 3.0 * gait.cycle_s;
    const Result<ContactSchedule> schedule = ScheduleContacts(gait, request);
    ASSERT_TRUE(schedule.ok()) << schedule.failure().message;
    EXPECT_NO_THROW(CheckSchedule(*schedule, 4));
    EXPECT_EQ(schedule->phases.front().stance, AllFeet(4));
    EXPECT_EQ(schedule->phases.back().stance, AllFeet(4));
    const auto flights = std::count_if(schedule->phases.begin(), schedule->phases.end(),
                                       [](const ContactPhase& phase) { return phase.stance == 0; });
    EXPECT_GE(flights, 3) << name;
  }
}

TEST(Schedule, AFlightLastsWhatNoFootIsDownFor) {
  const Result<RobotModel> a1 = LoadNamedRobot("a1");
  const Gait pronk = *FindGait(*a1, "pronk", 0.5, {});
  ScheduleRequest request;
  request.stepping_s = 3.0 * pronk.cycle_s;
  const ContactSchedule schedule = *ScheduleContacts(pronk, request);
  for (const ContactPhase& phase : schedule.phases) {
    if (phase.stance != 0) continue;
    EXPECT_NEAR(phase.end_s - phase.start_s, (1.0 - pronk.duty_factor[0]) * pronk.cycle_s, request.grid_s);
  }
}

TEST(Schedule, FlightsAndDoubleSupportsAreAlikeInEveryCycle) {
  const Result<RobotModel> a1 = LoadNamedRobot("a1");
  Gait trot = *FindGait(*a1, "trot", 0.2, {});
  for (const double duty : {0.48, 0.491, 0.493, 0.5, 0.505, 0.512}) {
    for (int i = 0; i < 50; ++i) {
      trot.duty_factor.assign(4, duty);
      trot.cycle_s = 0.35 + 0.0037 * i;
      ScheduleRequest request;
      request.stepping_s = 6.0 * trot.cycle_s;
      const ContactSchedule schedule = *ScheduleContacts(trot, request);
      const int exact = static_cast<int>(std::lround((0.5 - duty) * trot.cycle_s / request.grid_s));
      const int most = static_cast<int>(schedule.phases.size()) - 2;
      for (int k = 2; k < most; ++k) {  // between the first and the last step
        const ContactPhase& phase = schedule.phases[static_cast<std::size_t>(k)];
        if (phase.stance != 0 && phase.stance != AllFeet(4)) continue;
        EXPECT_EQ(std::lround((phase.end_s - phase.start_s) / request.grid_s), std::abs(exact));
        EXPECT_EQ(phase.stance == 0, exact > 0);
      }
      EXPECT_GT(most, exact == 0 ? 8 : 18) << "there are such phases";
    }
  }
}

TEST(Schedule, PairsStayTogetherOnAnyGrid) {
  const Result<RobotModel> a1 = LoadNamedRobot("a1");
  Gait trot = *FindGait(*a1, "trot", 0.2, {});
  for (const double grid : {0.001, 0.0033, 0.005, 0.01}) {
    for (int i = 0; i < 50; ++i) {
      trot.cycle_s = 0.4 + 0.005 * i;  // many parts of it fall between two steps of a grid
      ScheduleRequest request;
      request.grid_s = grid;
      request.stepping_s = 4.0 * trot.cycle_s;
      const Result<ContactSchedule> schedule = ScheduleContacts(trot, request);
      ASSERT_TRUE(schedule.ok()) << schedule.failure().message;
      for (const ContactPhase& phase : schedule->phases) {
        EXPECT_EQ(Contains(phase.stance, 0), Contains(phase.stance, 3));
        EXPECT_EQ(Contains(phase.stance, 1), Contains(phase.stance, 2));
        EXPECT_NEAR(std::remainder(phase.start_s, grid), 0.0, 1e-9);
      }
    }
  }
}

TEST(Schedule, SwingsShorterThanTheGridAreRefused) {
  const Result<RobotModel> a1 = LoadNamedRobot("a1");
  Gait trot = *FindGait(*a1, "trot", 0.2, {});
  trot.cycle_s = 0.04;
  ScheduleRequest request;
  request.grid_s = 0.01;
  const Result<ContactSchedule> schedule = ScheduleContacts(trot, request);
  ASSERT_FALSE(schedule.ok());
  EXPECT_EQ(schedule.failure().kind, FailureKind::kBadInput);
  EXPECT_NE(schedule.failure().message.find("grid (0.01 s)"), std::string::npos);
}

TEST(Schedule, FeetMayLiftJustAsOthersLand) {
  const Result<RobotModel> a1 = LoadNamedRobot("a1");
  GaitOptions options;
  options.duty_factor = 0.5;
  ScheduleRequest request;
  request.footfalls = 8;
  const Result<ContactSchedule> schedule = ScheduleContacts(*FindGait(*a1, "trot", 0.3, options), request);
  ASSERT_TRUE(schedule.ok()) << schedule.failure().message;
  EXPECT_NO_THROW(CheckSchedule(*schedule, 4));
  const std::vector<ContactPhase>& phases = schedule->phases;
  ASSERT_EQ(phases.size(), 6U) << "standing, two pairs twice in turn, standing";
  for (std::size_t i = 1; i + 1 < phases.size(); ++i) {
    EXPECT_TRUE(phases[i].stance == FootSet{0b1001} || phases[i].stance == FootSet{0b0110}) << i;
    if (i > 1) {
      EXPECT_EQ(phases[i].stance & phases[i - 1].stance, FootSet{0}) << "before phase " << i;
    }
  }
}

TEST(Schedule, TheFirstFootCanBeChosen) {
  const Result<RobotModel> nao = LoadNamedRobot("nao");
  for (int foot = 0; foot < 2; ++foot) {
    ScheduleRequest request;
    request.footfalls = 3;
    request.first_foot = foot;
    const ContactSchedule schedule = *ScheduleContacts(*FindGait(*nao, "", 0.05, {}), request);
    EXPECT_EQ(schedule.phases[1].stance, FootBit(1 - foot));
    EXPECT_EQ(IntervalsOf(schedule, foot).size(), 3U);
    EXPECT_EQ(IntervalsOf(schedule, 1 - foot).size(), 2U);
  }
}

TEST(Schedule, MistakesAreNamed) {
  EXPECT_THROW(CheckSchedule({}, 2), InvalidArgument);
  EXPECT_THROW(CheckSchedule({{{0.0, 1.0, 3}, {1.1, 2.0, 1}}}, 2), InvalidArgument);
  EXPECT_THROW(CheckSchedule({{{0.0, 1.0, 8}}}, 2), InvalidArgument);
}

}  // namespace
}  // namespace gaitwright
