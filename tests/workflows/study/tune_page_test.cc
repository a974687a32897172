// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "tests/playback/xml_check.h"
#include "tests/workflows/study/made_up_sweep.h"
#include "tests/workflows/study/made_up_tuning.h"
#include "workflows/study/tune_files.h"

namespace gaitwright {
namespace {

std::string PageOfTuning(MadeUpProof proof) {
  const MadeUpTuning tuning = MakeUpTuning(proof);
  return TunePage(tuning.study, tuning.report, tuning.options);
}

TEST(TunePage, IsWellFormedHoweverTheTuningEnded) {
  for (const MadeUpProof proof :
       {MadeUpProof::kBetter, MadeUpProof::kNoBetter, MadeUpProof::kNone, MadeUpProof::kNothingBefore}) {
    const std::string page = PageOfTuning(proof);
    EXPECT_EQ(XmlFault(page.substr(page.find("<html"))), "");
    EXPECT_EQ(page, PageOfTuning(proof)) << "the same bytes again";
    EXPECT_EQ(CountOf(page, "http://www.w3.org/1999/xhtml") + CountOf(page, "http://www.w3.org/2000/svg"),
              CountOf(page, "://"))
        << "it loads nothing";
    EXPECT_EQ(CountOf(page, "<script"), 0);
  }
}

TEST(TunePage, NamesOfRobotsAndReasonsAreEscaped) {
  const std::string page = PageOfTuning(MadeUpProof::kNothingBefore);
  EXPECT_EQ(CountOf(page, "a<1>"), 0);
  EXPECT_GT(CountOf(page, "a&lt;1&gt;"), 0);
  EXPECT_GT(CountOf(page, "the cycle &lt;is&gt; too short"), 0);
  EXPECT_GT(CountOf(page, "is &lt;weak&gt;"), 0);
}

TEST(TunePage, TheVerdictIsMarkedAsPassOrFail) {
  EXPECT_EQ(CountOf(PageOfTuning(MadeUpProof::kBetter), "class=\"reason pass\""), 1);
  EXPECT_EQ(CountOf(PageOfTuning(MadeUpProof::kNoBetter), "class=\"reason fail\""), 1);
  EXPECT_EQ(CountOf(PageOfTuning(MadeUpProof::kNone), "class=\"reason fail\""), 1);
}

TEST(TunePage, HasAResponseForEachOptionAndARowForEachCandidate) {
  const std::string page = PageOfTuning(MadeUpProof::kBetter);
  EXPECT_EQ(CountOf(page, "<figure>"), 1 + 2) << "the search, and each option";
  EXPECT_EQ(CountOf(page, "<td>surface</td>"), 1);
  EXPECT_EQ(CountOf(page, "<td>usual</td>"), 1);
  EXPECT_EQ(CountOf(page, "<td>sample</td>"), 1);
}

TEST(TunePage, AMetricThatNeitherWalkHasIsLeftOut) {
  const std::string page = PageOfTuning(MadeUpProof::kBetter);
  EXPECT_EQ(CountOf(page, "<td>goal_error_m</td>"), 1);
  EXPECT_EQ(CountOf(page, "<td>zmp_margin_p05_m</td>"), 0);
}

TEST(TunePage, SurvivalIsInPerCentAndSigned) {
  const std::string page = PageOfTuning(MadeUpProof::kBetter);
  EXPECT_GT(CountOf(page, "<td>+50.00</td>"), 0);
  EXPECT_EQ(CountOf(page, "<td>+25.00 to +75.00</td>"), 1);
  EXPECT_EQ(CountOf(PageOfTuning(MadeUpProof::kNoBetter), "<td>-4.00 to +6.00</td>"), 1);
}

}  // namespace
}  // namespace gaitwright
