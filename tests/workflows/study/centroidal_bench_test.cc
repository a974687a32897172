// SPDX-License-Identifier: BSD-3-Clause
#include "workflows/study/centroidal_bench.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>

#include "tests/scratch_folder.h"

namespace gaitwright {
namespace {

CentroidalProblemSet Set() {
  const Result<CentroidalProblemSet> set = LoadCentroidalProblems(CentroidalProblemsPath());
  EXPECT_TRUE(set.ok()) << set.failure().message;
  return set.ok() ? *set : CentroidalProblemSet{};
}

CentroidalTask Asked(const CentroidalProblemSet& set) { return {set.distance_m, set.duration_s, set.friction}; }

TEST(CentroidalProblems, AreFourRobotsByFiveSchedulesOnSevenGrounds) {
  const CentroidalProblemSet set = Set();
  ASSERT_EQ(set.robots.size(), 4U);
  EXPECT_EQ(set.grounds.size(), 7U);
  EXPECT_EQ(CasesOf(set).size(), 140U);
  EXPECT_EQ(CasesOf(set, "hyq-1").size(), 7U);
  EXPECT_EQ(CasesOf(set, "hyq-1-gap").size(), 1U);
  EXPECT_EQ(CasesOf(set, "no-such").size(), 0U);
  EXPECT_EQ(set.robots[2].first, "hyq");
  EXPECT_EQ(set.robots[2].second.mass_kg, 83.0);
  EXPECT_EQ(set.robots[2].second.schedules[1].name, "flying trot");
}

TEST(CentroidalProblems, EveryOneIsAProblemThatCanBeAsked) {
  const CentroidalProblemSet set = Set();
  for (const CentroidalCase& one : CasesOf(set)) {
    const CentroidalRobot& robot = set.robots[one.robot].second;
    const RigidBodyProblem problem =
        CentroidalProblem(robot, robot.schedules[one.schedule], set.grounds[one.ground], {2.1, 3.6, 0.5});
    EXPECT_NO_THROW(CheckRigidBodyProblem(problem));
    EXPECT_EQ(problem.duration_s, 3.6);
    double last = 0.0;
    for (const RigidStance& stance : problem.stances) last = std::max(last, stance.end_s);
    EXPECT_EQ(last, 3.6);
  }
}

TEST(CentroidalBench, SolvesAFlyingTrotOnFlatGroundAndOverAGap) {
  const CentroidalProblemSet set = Set();
  for (const char* filter : {"hyq-1-flat", "hyq-1-gap"}) {
    const CentroidalOutcome outcome = RunCase(set, CasesOf(set, filter)[0], Asked(set), {});
    EXPECT_TRUE(outcome.solved) << outcome.reason;
    EXPECT_EQ(outcome.reason, "");
    EXPECT_LT(outcome.between.Largest(), 1e-3);
    EXPECT_LE(outcome.between.friction, 0.0);
    EXPECT_LE(outcome.between.unilateral, 0.0);
    EXPECT_GT(outcome.variables, 100);
    EXPECT_GT(outcome.peak_memory_mb, 1.0);
  }
}

TEST(CentroidalBench, OtherPatchesAreFoundWhereTheFirstOnesHaveNoMotion) {
  const CentroidalProblemSet set = Set();
  for (const char* filter : {"hyq-4-stairs", "anymal-3-block"}) {
    const CentroidalOutcome outcome = RunCase(set, CasesOf(set, filter)[0], Asked(set), {});
    EXPECT_TRUE(outcome.solved) << outcome.reason;
    EXPECT_GT(outcome.choices, 1);
    EXPECT_LT(outcome.between.Largest(), 1e-3);
  }
}

TEST(CentroidalBench, TimesAsVariablesCostLessOnEachGround) {
  const CentroidalProblemSet set = Set();
  for (const char* name : {"monoped-3-stairs", "biped-0-gap", "hyq-1-block", "hyq-1-slope"}) {
    const std::vector<CentroidalCase> cases = CasesOf(set, name);
    ASSERT_EQ(cases.size(), 1U) << name;
    const CentroidalOutcome outcome = RunCase(set, cases[0], Asked(set), {}, {false, TimingOptions{}});
    ASSERT_TRUE(outcome.timing.has_value()) << name << " " << outcome.reason;
    EXPECT_TRUE(outcome.timing->keeps) << name;
    EXPECT_EQ(outcome.timing->cost_before, outcome.cost);
    EXPECT_EQ(outcome.timing->duration_s, outcome.task.duration_s);
    EXPECT_GE(outcome.timing->Fall(), 0.05) << name;
    EXPECT_LE(std::max(outcome.timing->between.friction, outcome.timing->between.unilateral), 0.0) << name;
    EXPECT_FALSE(RunCase(set, cases[0], Asked(set), {}).timing.has_value());
  }
}

TEST(CentroidalBench, OtherTimesMendWhatHasNoMotionAsAsked) {
  const CentroidalProblemSet set = Set();
  const std::vector<CentroidalCase> cases = CasesOf(set, "anymal-4-stairs");
  ASSERT_EQ(cases.size(), 1U);
  const CentroidalOutcome outcome = RunCase(set, cases[0], Asked(set), {}, {true, TimingOptions{}});
  EXPECT_FALSE(outcome.solved);
  EXPECT_FALSE(outcome.eased);
  ASSERT_TRUE(outcome.timing.has_value());
  EXPECT_TRUE(outcome.timing->mended);
  EXPECT_TRUE(outcome.timing->keeps) << outcome.timing->refusal;
  EXPECT_NE(CentroidalTable({outcome}).find(
                "1 of 1 cases that are infeasible with the given timing are feasible with another"),
            std::string::npos);
}

TEST(CentroidalBench, EasesWhatHasNoMotionAsAskedAndSaysWhy) {
  const CentroidalProblemSet set = Set();
  const CentroidalTask hasty{2.1, 1.2, 0.5};
  const CentroidalCase one = CasesOf(set, "biped-0-flat")[0];
  const CentroidalOutcome asked = RunCase(set, one, hasty, {}), eased = RunCase(set, one, hasty, {}, {true});
  EXPECT_FALSE(asked.solved);
  EXPECT_NE(asked.reason.find("stays violated by"), std::string::npos) << asked.reason;
  EXPECT_TRUE(eased.solved && eased.eased) << eased.reason;
  EXPECT_EQ(eased.reason, asked.reason);
  EXPECT_GT(eased.task.duration_s, 1.2);
  const std::string table = CentroidalTable({asked, eased});
  EXPECT_NE(table.find("no motion"), std::string::npos) << table;
  EXPECT_NE(table.find("0 of 2 cases solved as given, 1 more if eased"), std::string::npos) << table;
}

TEST(CentroidalBench, AGoalThatIsNotHeldOrNotReachedIsRefusedForThatAndMoved) {
  const CentroidalProblemSet set = Set();
  const CentroidalOutcome steep = RunCase(set, CasesOf(set, "monoped-1-slope")[0], Asked(set), {}, {true});
  EXPECT_NE(steep.reason.find("too steep for a friction of 0.50; 0.70 is needed"), std::string::npos) << steep.reason;
  EXPECT_TRUE(steep.eased);
  EXPECT_EQ(steep.task.friction, 0.8);
  EXPECT_EQ(steep.task.distance_m, 2.1);
  const CentroidalOutcome astride = RunCase(set, CasesOf(set, "anymal-1-slope")[0], Asked(set), {}, {true});
  EXPECT_NE(astride.reason.find("outside its workspace on every patch"), std::string::npos) << astride.reason;
  EXPECT_TRUE(astride.eased);
  EXPECT_EQ(astride.task.higher_m, -0.05);
  const CentroidalOutcome wall = RunCase(set, CasesOf(set, "hyq-1-chimney")[0], Asked(set), {}, {true});
  EXPECT_TRUE(wall.eased);
  EXPECT_LT(wall.task.distance_m, 1.0);
  for (const CentroidalOutcome& outcome : {steep, astride, wall}) EXPECT_LT(outcome.between.Largest(), 1e-3);
  EXPECT_NE(CentroidalTable({astride}).find("2.1 m -0.05 in 2.4 s, mu 0.5"), std::string::npos);
}

TEST(CentroidalBench, ABipedStandsAstrideARidgeThatHoldsNoFootAlone) {
  const CentroidalProblemSet set = Set();
  const CentroidalOutcome outcome = RunCase(set, CasesOf(set, "biped-4-slope")[0], Asked(set), {});
  EXPECT_TRUE(outcome.solved) << outcome.reason;
  EXPECT_LT(outcome.between.Largest(), 1e-3);
}

TEST(CentroidalProblems, AFileThatIsNoneIsRefusedByName) {
  const auto refusal = [](const std::string& text) -> std::string {
    const std::filesystem::path path = ScratchFile("gaitwright_no_problems.json");
    std::ofstream(path) << text;
    const Result<CentroidalProblemSet> set = LoadCentroidalProblems(path.string());
    std::filesystem::remove(path);
    return set.ok() ? "none" : set.failure().message;
  };
  EXPECT_NE(refusal("{").find("gaitwright_no_problems.json' is not a set of problems: "), std::string::npos);
  EXPECT_NE(refusal("{}").find("friction"), std::string::npos);
  EXPECT_NE(refusal("{\"friction\": 0}").find("0.001 to 100"), std::string::npos) << refusal("{\"friction\": 0}");
  EXPECT_FALSE(LoadCentroidalProblems("/no/such/file.json").ok());
}

}  // namespace
}  // namespace gaitwright
