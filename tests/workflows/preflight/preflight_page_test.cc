// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "tests/playback/xml_check.h"
#include "tests/workflows/preflight/made_up_preflight.h"

namespace gaitwright {
namespace {

int TimesOnPage(const std::string& text, const std::string& part) {
  int count = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + part.size())) ++count;
  return count;
}

TEST(PreflightPaper, IsWellFormedLoadsNothingAndEscapesItsInput) {
  for (const bool trials : {false, true}) {
    const std::string page = PreflightPage(MakeUpPreflight(trials));
    EXPECT_EQ(XmlFault(page.substr(page.find("<html"))), "");
    EXPECT_EQ(TimesOnPage(page, "<script"), 0);
    EXPECT_EQ(TimesOnPage(page, "src="), 0);
    EXPECT_EQ(TimesOnPage(page, "a<1>"), 0);
    EXPECT_GT(TimesOnPage(page, "a&lt;1&gt;"), 0);
    EXPECT_GT(TimesOnPage(page, "trot &amp; stand"), 0);
    EXPECT_EQ(page, PreflightPage(MakeUpPreflight(trials))) << "the same bytes again";
  }
}

TEST(PreflightPaper, TheVerdictIsAGoOrNoneWithItsFirstReason) {
  Preflight p = MakeUpPreflight();
  EXPECT_EQ(TimesOnPage(PreflightPage(p), "<span class=\"verdict pass\">GO</span>"), 1);
  p.reasons = {"the knee is weak", "nobody tried it"};
  const std::string page = PreflightPage(p);
  EXPECT_EQ(TimesOnPage(page, "<span class=\"verdict fail\">NO-GO</span>"), 1);
  EXPECT_EQ(TimesOnPage(page, "the knee is weak (first of 2 reasons)."), 1);
  EXPECT_GE(TimesOnPage(page, "<li>nobody tried it</li>"), 1);
}

TEST(PreflightPaper, HashesAreWholeAndThereAreLinesToSign) {
  const std::string page = PreflightPage(MakeUpPreflight());
  for (const char* hash : {"robot-hash", "motion-hash", "plan-hash"})
    EXPECT_EQ(TimesOnPage(page, std::string(">") + hash + "<"), 1) << hash;
  EXPECT_GT(TimesOnPage(page, "class=\"sign\""), 0);
}

/// A bar shows the used share of a limit.
TEST(PreflightPaper, BarsShowWhatIsUsedOfALimit) {
  Preflight p = MakeUpPreflight();
  EXPECT_GT(TimesOnPage(PreflightPage(p), "<i class=\"pass\" style=\"width:80%\">"), 0) << "20 % are left";
  p.audit.margins[0].share = -0.5;
  EXPECT_GT(TimesOnPage(PreflightPage(p), "<i class=\"fail\" style=\"width:100%\">"), 0) << "beyond it";
}

TEST(PreflightPaper, TrialsAreShownWithTheirDisturbances) {
  const std::string with = PreflightPage(MakeUpPreflight(true)), without = PreflightPage(MakeUpPreflight());
  EXPECT_GT(TimesOnPage(with, "97 of 100 trials survived"), 0);
  EXPECT_GT(TimesOnPage(with, "friction: &lt;0.5&gt;"), 0);
  EXPECT_GT(TimesOnPage(with, "tipped &lt;over&gt;"), 0);
  EXPECT_EQ(TimesOnPage(without, "trials survived"), 0);
}

}  // namespace
}  // namespace gaitwright
