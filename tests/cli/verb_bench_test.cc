// SPDX-License-Identifier: BSD-3-Clause
// Output of `gaitwright bench`.
#include "tests/cli/stranger.h"

namespace gaitwright::cli {
namespace {

using Bench = Stranger;

TEST_F(Bench, ACaseIsSolvedAndItsFaultsAreReported) {
  const Ran ran = Run({"bench", "centroidal", "--only", "hyq-1-gap", "--json"});
  EXPECT_EQ(ran.status, 0) << ran.err;
  const Json report = ran.json();
  ASSERT_EQ(report.at("cases").size(), 1U);
  const Json& one = report.at("cases")[0];
  EXPECT_EQ(one.at("robot"), "hyq");
  EXPECT_EQ(one.at("schedule"), "1 flying trot");
  EXPECT_EQ(one.at("solved"), true) << one.at("reason");
  EXPECT_LT(one.at("at_1_khz").at("torque_balance_mg_m").get<double>(), 1e-3);
  EXPECT_LE(one.at("at_1_khz").at("friction_mg").get<double>(), 0.0);
  EXPECT_GT(one.at("iterations").get<int>(), 3);
}

TEST_F(Bench, ATableHasALineForEachCaseAndASum) {
  const Ran ran = Run({"bench", "centroidal", "--only", "monoped-3-flat", "--duration", "3.0", "--as-asked"});
  EXPECT_EQ(ran.status, 0) << ran.err;
  EXPECT_NE(ran.out.find("monoped  3 hop"), std::string::npos) << ran.out;
  EXPECT_NE(ran.out.find("1 of 1 cases solved as given"), std::string::npos) << ran.out;
}

TEST_F(Bench, BetterContactTimesOfSolvedCasesAreReported) {
  const Ran ran = Run({"bench", "centroidal", "--only", "monoped-3-flat", "--timing", "fixed", "--json"});
  EXPECT_EQ(ran.status, 0) << ran.err;
  const Json one = ran.json().at("cases")[0];
  const Json& timing = one.at("timing");
  EXPECT_EQ(timing.at("refusal"), "");
  EXPECT_EQ(timing.at("keeps_all_laws"), true);
  EXPECT_EQ(timing.at("cost_before"), one.at("cost"));
  EXPECT_LT(timing.at("cost").get<double>(), 0.95 * timing.at("cost_before").get<double>());
  EXPECT_EQ(timing.at("duration_s"), one.at("duration_s"));
  EXPECT_LT(timing.at("at_1_khz").at("torque_balance_mg_m").get<double>(), 1e-3);
  const Ran freely = Run({"bench", "centroidal", "--only", "monoped-3-flat", "--timing", "free", "--json"});
  EXPECT_NE(freely.json().at("cases")[0].at("timing").at("duration_s"), one.at("duration_s"));
  const Ran without = Run({"bench", "centroidal", "--only", "monoped-3-flat", "--json"});
  EXPECT_TRUE(without.json().at("cases")[0].at("timing").is_null());
}

TEST_F(Bench, ATableOfTimesSaysWhatIsGainedOrRefused) {
  const Ran ran = Run({"bench", "centroidal", "--only", "monoped-3-flat", "--timing", "fixed"});
  EXPECT_NE(ran.out.find("1 of 1 timed motions satisfy all constraints; the cost falls by"), std::string::npos)
      << ran.out;
  const Ran refused =
      Run({"bench", "centroidal", "--only", "monoped-3-flat", "--timing", "fixed", "--set", "timing.shortest_s=0.5"});
  EXPECT_NE(
      refused.out.find("the shortest durations of the 7 phases sum to 3.5 s; the longest accepted total is 2.4 s"),
      std::string::npos)
      << refused.out;
  EXPECT_NE(refused.out.find("0 of 1 timed motions satisfy all constraints"), std::string::npos) << refused.out;
}

TEST_F(Bench, WholeBodiesAreFinished) {
  const Ran ran = Run({"bench", "whole-body", "--only", "a1-chain-200", "--json"});
  EXPECT_EQ(ran.status, 0) << ran.err;
  const Json one = ran.json().at("cases")[0];
  EXPECT_EQ(one.at("audit"), "pass") << one.at("reason");
  EXPECT_LE(one.at("whole_body").at("residual_force_mg").get<double>(), 1e-3);
  EXPECT_LE(one.at("whole_body").at("residual_moment_mgl").get<double>(), 1e-3);
  EXPECT_GT(one.at("whole_body").at("knots").get<int>(), 150);
  const Ran table = Run({"bench", "whole-body", "--only", "a1-chain-200"});
  EXPECT_NE(table.out.find("a1-chain-200"), std::string::npos) << table.out;
  ExpectRefused(Run({"bench", "whole-body", "--only", "horse"}), 1, {"no case name contains 'horse'", "a1-trot-3.5"});
}

TEST_F(Bench, StepTasksAreThoseOfAnyRobot) {
  const Ran ran = Run({"bench", "whole-body", "--robot", "go1", "--only", "trot", "--json"});
  ASSERT_EQ(ran.status, 0) << ran.err;
  ASSERT_EQ(ran.json().at("cases").size(), 1U);
  const Json one = ran.json().at("cases")[0];
  EXPECT_EQ(one.at("case"), "go1-step-trot");
  EXPECT_EQ(one.at("audit"), "pass") << one.at("reason");
  EXPECT_LE(one.at("whole_body").at("iterations").get<int>(), 30);
  ExpectRefused(Run({"bench", "whole-body", "--robot", "nao", "--only", "trot"}), 1, {"trot", "step-walk"});
}

TEST_F(Bench, RefusesWhatThereIsNot) {
  ExpectRefused(Run({"bench", "centroidal", "--only", "hyq-1-gap", "--timing", "loose"}), 1, {"loose", "fixed"});

  ExpectRefused(Run({"bench", "centroidal", "--only", "horse"}), 1, {"no case name contains 'horse'", "hyq-1-gap"});
  ExpectRefused(Run({"bench", "centroidal", "--problems", "none.json"}), 1, {"none.json"});
  ExpectRefused(Run({"bench", "centroidal", "--set", "spacing=1"}), 1, {"spacing_s"});
  ExpectRefused(Run({"bench", "centroidal", "--only", "hyq-1-flat", "--duration", "-1"}), 1, {"the duration is -1 s"});
  ExpectRefused(Run({"bench"}), 1, {});
}

}  // namespace
}  // namespace gaitwright::cli
