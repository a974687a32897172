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
