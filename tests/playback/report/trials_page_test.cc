// SPDX-License-Identifier: BSD-3-Clause
#include "playback/report/trials_page.h"

#include <gtest/gtest.h>

#include "tests/playback/trials/made_outcomes.h"
#include "tests/playback/xml_check.h"

namespace gaitwright {
namespace {

TEST(TrialsPageTest, IsWellFormedAndShowsWhatMatters) {
  const RobustnessReport report = ReduceTrials(made::Subject(), made::Outcomes(120, 25.0));
  const std::string page = TrialsPage(report);
  EXPECT_EQ(XmlFault(page), "");
  for (const char* part :
       {"id=\"pushes\"", "id=\"survival_by_cause\"", "id=\"gates\"", "id=\"scores\"", "smallest fatal",
        "Causes of falls", "a foot slid", "push1.left_n", "mass_scale: 1", "goal_error_m"})
    EXPECT_NE(page.find(part), std::string::npos) << part;
  EXPECT_NE(page.find(std::to_string(report.Outcome(report.worst[0]).seed)), std::string::npos);
  EXPECT_EQ(page.find("nan"), std::string::npos);
  EXPECT_EQ(page, TrialsPage(report));
}

TEST(TrialsPageTest, SaysAtItsHeadWhatWasTried) {
  TrialSubject subject = made::Subject();
  subject.robot_hash = "9cec4752cb17175f";
  subject.plan_hash = "fffa398efbc33624";
  subject.whole_plan_hash = "14acbd1094d2bceb";
  subject.seed = 5;
  const std::string page = TrialsPage(ReduceTrials(subject, made::Outcomes(20, 25.0)));
  const std::string head = page.substr(0, page.find("class=\"cards\""));
  for (const char* part : {"robot hash 9cec4752cb17175f", "plan hash 14acbd1094d2bceb", "logs fffa398efbc33624",
                           "controller stabilised", "seed 5"})
    EXPECT_NE(head.find(part), std::string::npos) << part;
}

TEST(TrialsPageTest, SaysWhereTrialsRepeatOthers) {
  std::vector<TrialOutcome> outcomes = made::Outcomes(20, 25.0);
  EXPECT_EQ(TrialsPage(ReduceTrials(made::Subject(), outcomes)).find("identical"), std::string::npos);
  for (TrialOutcome& outcome : outcomes) outcome.log_hash = "same";
  const std::string page = TrialsPage(ReduceTrials(made::Subject(), outcomes));
  EXPECT_NE(page.find("all 20 trials are identical"), std::string::npos);
  EXPECT_EQ(XmlFault(page), "");
}

TEST(TrialsPageTest, HasNothingToShowOfWhatThereWasNot) {
  std::vector<TrialOutcome> calm = made::Outcomes(5, 1000.0);
  for (TrialOutcome& outcome : calm) outcome.sampled.resize(1);
  const std::string page = TrialsPage(ReduceTrials(made::Subject(), calm));
  EXPECT_EQ(XmlFault(page), "");
  EXPECT_EQ(page.find("id=\"pushes\""), std::string::npos);
  EXPECT_EQ(page.find("id=\"survival_by_cause\""), std::string::npos);
  EXPECT_EQ(XmlFault(TrialsPage(ReduceTrials(made::Subject(), {}))), "");
}

}  // namespace
}  // namespace gaitwright
