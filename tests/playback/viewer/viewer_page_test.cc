// SPDX-License-Identifier: BSD-3-Clause
#include "playback/viewer/viewer_page.h"

#include <gtest/gtest.h>

#include "tests/playback/played.h"
#include "tests/playback/xml_check.h"

namespace gaitwright {
namespace {

TEST(ViewerPage, IsWholeAndHoldsTheScene) {
  const synthetic::Played c = synthetic::Stood();
  const std::string page = ViewerPage("a & b", {{"left", c.model, c.plan, &c.log}, {"right", c.model, c.plan}});
  EXPECT_EQ(XmlFault(page), "");
  EXPECT_TRUE(synthetic::Says(page, "<title>a &amp; b</title>"));
  EXPECT_TRUE(synthetic::Says(page, "\"gaitwright-scene\""));
  EXPECT_FALSE(synthetic::Says(page, "<script src"));
  EXPECT_FALSE(synthetic::Says(page, "<link"));
  EXPECT_LT(page.size() - SceneJson({{"left", c.model, c.plan, &c.log}, {"right", c.model, c.plan}}).size(), 3000000U);
}

TEST(ViewerPage, HasTheNoticesOfAllPackagesInIt) {
  const std::string page = LivePage("a");
  for (const char* holder : {"three.js authors", "Leon Sorokin"}) EXPECT_TRUE(synthetic::Says(page, holder)) << holder;
  const std::string terms = "The above copyright notice and this permission notice shall be included in";
  const std::size_t first = page.find(terms);
  ASSERT_NE(first, std::string::npos);
  EXPECT_NE(page.find(terms, first + 1), std::string::npos) << "of each package";
}

TEST(ViewerPage, IsPrintedWhereItIsNoPartOfAReport) {
  EXPECT_TRUE(synthetic::Says(LivePage("a"), "@media print{.gw-part{display:none}}"));
}

}  // namespace
}  // namespace gaitwright
