// SPDX-License-Identifier: BSD-3-Clause
#include "playback/report/report_page.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <regex>

#include "playback/report/plot_style.h"
#include "playback/report/plots.h"
#include "playback/score/gates.h"
#include "tests/playback/played.h"
#include "tests/playback/xml_check.h"

namespace gaitwright {
namespace {

struct Case : synthetic::Played {
  StabilityReport report;
};

Case MakeCase(int legs, int steps, bool falls) {
  Case c{synthetic::Walked(legs, {.count = steps}), {}};
  c.plan.parts.front().gait.name = "walk & run";
  c.plan.provenance.options = {{"speed_m_s", "<0.3>"}};
  if (falls) synthetic::Sink(c.log, 400, 0.1);
  c.report = Score(c.model, c.plan, c.log);
  return c;
}

TEST(ReportPage, IsWholeWellFormedAndHoldsEveryPlotAndFigure) {
  for (const bool falls : {false, true}) {
    const Case c = MakeCase(4, 6, falls);
    const std::string page = ReportPage(c.model, c.plan, c.log, c.report, {{"every law holds: a < b"}, {}, ""});
    EXPECT_EQ(XmlFault(page), "");
    EXPECT_FALSE(synthetic::Says(page, "http")) << "no network";
    EXPECT_FALSE(synthetic::Says(page, "<script"));
    EXPECT_FALSE(std::regex_search(page, std::regex(R"(\bnan\b)"))) << "all numbers are finite";
    EXPECT_TRUE(synthetic::Says(page, falls ? ">FAIL<" : ">PASS<"));
    EXPECT_TRUE(synthetic::Says(page, "every law holds: a &lt; b"));
    EXPECT_TRUE(synthetic::Says(page, "walk &amp; run"));
    EXPECT_TRUE(synthetic::Says(page, "prefers-color-scheme:dark"));
    for (const MetricRule& rule : MetricRules()) EXPECT_TRUE(synthetic::Says(page, ">" + rule.key + "<")) << rule.key;
    for (const Plot& plot : MakePlots(c.model, c.plan, c.log, c.report)) {
      EXPECT_TRUE(synthetic::Says(page, "<figure id=\"" + plot.name + "\">")) << plot.name;
      EXPECT_TRUE(synthetic::Says(page, plot.svg)) << plot.name;
    }
  }
}

TEST(ReportPage, ShowsACommandThatPlansNoContacts) {
  Case c = MakeCase(4, 6, false);
  c.plan.parts.clear();
  c.plan.schedule.phases.clear();
  c.plan.footsteps.footholds.clear();
  c.plan.whole_body.tau.clear();
  c.plan.whole_body.wrenches.clear();
  c.report = Score(c.model, c.plan, c.log);
  const std::string page = ReportPage(c.model, c.plan, c.log, c.report);
  EXPECT_EQ(XmlFault(page), "");
  EXPECT_FALSE(std::regex_search(page, std::regex(R"(\bnan\b)"))) << "all numbers are finite";
  EXPECT_TRUE(synthetic::Says(page, "a learned policy"));
  EXPECT_TRUE(synthetic::Says(page, "the command plans no contacts"));
}

TEST(ReportPage, SetsASecondEngineBesideTheFirstAndNeedsBothToPass) {
  const Case c = MakeCase(4, 6, false), fallen = MakeCase(4, 6, true);
  const auto page = [&](const Case& second) {
    const Agreement agreement = AgreementOf(c.model, c.plan, c.log, second.log);
    ReportWords words;
    words.second.emplace(SecondVerdict{second.log, second.report, agreement});
    return ReportPage(c.model, c.plan, c.log, c.report, words);
  };
  const std::string both = page(c), one = page(fallen), alone = ReportPage(c.model, c.plan, c.log, c.report);
  for (const std::string& html : {both, one}) {
    EXPECT_EQ(XmlFault(html), "");
    EXPECT_TRUE(synthetic::Says(html, "<h2 id=\"engines\">"));
    EXPECT_TRUE(synthetic::Says(html, "<figure id=\"engines_forces\">"));
  }
  EXPECT_TRUE(synthetic::Says(both, "<span class=\"verdict pass\">PASS<"));
  EXPECT_TRUE(synthetic::Says(one, "<span class=\"verdict fail\">FAIL<")) << "a fall in the second engine is a fail";
  EXPECT_FALSE(synthetic::Says(alone, "id=\"engines\""));
}

TEST(ReportPage, ShowsUnevenGroundFromAboveAndFromTheSide) {
  Case c = MakeCase(4, 6, false);
  const auto side = [&] {
    const std::vector<Plot> plots = MakePlots(c.model, c.plan, c.log, c.report);
    const auto found = std::find_if(plots.begin(), plots.end(), [](const Plot& p) { return p.name == "side_view"; });
    return found == plots.end() ? std::string() : found->svg;
  };
  EXPECT_EQ(side(), "");
  Obstacle post;
  post.name = "post";
  post.size_m = Vector3(0.1, 0.1, 0.5);
  post.X_WO.translation() = Vector3(0.2, 0.6, 0.25);
  const std::string bare = MakePlots(c.model, c.plan, c.log, c.report).front().svg;
  c.plan.terrain.obstacles.push_back(post);
  EXPECT_EQ(XmlFault(side()), "");
  EXPECT_TRUE(synthetic::Says(side(), "From the side"));
  EXPECT_TRUE(synthetic::Says(side(), "ground"));
  EXPECT_NE(MakePlots(c.model, c.plan, c.log, c.report).front().svg, bare) << "the post is drawn from above";
}

TEST(ReportPage, TellsTheOptionsThatAreNotUsual) {
  const Case c = MakeCase(2, 2, false);
  const std::string page = ReportPage(c.model, c.plan, c.log, c.report, {{}, {{"a.gain", "<2>", "1.5"}}, ""});
  EXPECT_EQ(XmlFault(page), "");
  EXPECT_TRUE(synthetic::Says(page, ">a.gain</span></td><td>&lt;2&gt;</td><td>1.5</td>"));
  EXPECT_FALSE(synthetic::Says(page, "default value."));
  EXPECT_TRUE(synthetic::Says(ReportPage(c.model, c.plan, c.log, c.report), "Every option had its default value."));
}

TEST(ReportPage, AnObjectionOverrulesPhysics) {
  const Case c = MakeCase(2, 2, false);
  ASSERT_TRUE(c.report.pass);
  const std::string page = ReportPage(c.model, c.plan, c.log, c.report, {{}, {}, "the plan fails its audit: reach"});
  EXPECT_TRUE(synthetic::Says(page, ">FAIL<"));
  EXPECT_FALSE(synthetic::Says(page, ">PASS<"));
  EXPECT_TRUE(synthetic::Says(page, "The plan fails its audit: reach; in physics, " + c.report.reason + "."));
}

TEST(ReportPage, PlotsHaveNamesFitForFilesAndAreFilesOfTheirOwn) {
  const Case c = MakeCase(2, 6, false);
  std::vector<std::string> names;
  for (const Plot& plot : MakePlots(c.model, c.plan, c.log, c.report)) {
    names.push_back(plot.name);
    EXPECT_EQ(plot.name.find_first_not_of("abcdefghijklmnopqrstuvwxyz_"), std::string::npos) << plot.name;
    EXPECT_EQ(XmlFault(StandaloneSvg(plot.svg)), "") << plot.name;
    EXPECT_FALSE(plot.caption.empty());
  }
  EXPECT_EQ(names, (std::vector<std::string>{"top_view", "zmp_com_x", "zmp_com_y", "margins", "errors", "base_attitude",
                                             "base_height", "gait", "foot_heights", "foot_forces", "torque_use",
                                             "joint_torques", "joint_positions"}));
}

TEST(ReportPage, SaysWherePartsBegin) {
  Case c = MakeCase(2, 6, false);
  EXPECT_FALSE(synthetic::Says(ReportPage(c.model, c.plan, c.log, c.report), "from 0.00 s"));
  c.plan.parts = {{StandingGait(2), {}, {}, 0.0, 1.5}, c.plan.parts.front()};
  c.plan.parts[1].start_s = 1.5;
  const std::string page = ReportPage(c.model, c.plan, c.log, c.report);
  EXPECT_TRUE(synthetic::Says(page, "stand from 0.00 s, walk &amp; run from 1.50 s"));
  EXPECT_TRUE(synthetic::Says(page, ">walk &amp; run</text>")) << "beside a line of a plot";
}

TEST(ReportPage, EveryLimitOfATorqueIsDrawn) {
  Case c = MakeCase(2, 6, false);
  for (LogSample& sample : c.log.samples) sample.tau_peak[0] = 0.5 * c.model.dof_effort_limit(0);
  std::vector<Plot> plots = MakePlots(c.model, c.plan, c.log, c.report);
  const auto use = std::find_if(plots.begin(), plots.end(), [](const Plot& plot) { return plot.name == "torque_use"; });
  ASSERT_NE(use, plots.end());
  EXPECT_TRUE(synthetic::Says(use->svg, "[%]"));
  EXPECT_TRUE(synthetic::Says(use->svg, ">limit<"));
  for (int d = 0; d < c.model.num_dofs(); ++d)
    EXPECT_TRUE(synthetic::Says(use->svg, fmt::format(">{}, {:.4g} N", c.model.dof_names[static_cast<std::size_t>(d)],
                                                      c.model.dof_effort_limit(d))));
}

TEST(ReportPage, ALongMotionStaysSmall) {
  const Case c = MakeCase(4, 80, false);
  ASSERT_GT(c.log.samples.size(), 8000u);
  EXPECT_LT(ReportPage(c.model, c.plan, c.log, c.report).size(), 1'500'000u);
}

TEST(ReportPage, TheSameInputsGiveTheSameBytes) {
  const Case c = MakeCase(2, 2, false);
  EXPECT_EQ(ReportPage(c.model, c.plan, c.log, c.report), ReportPage(c.model, c.plan, c.log, c.report));
}

}  // namespace
}  // namespace gaitwright
