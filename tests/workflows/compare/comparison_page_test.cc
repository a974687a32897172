// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "tests/playback/played.h"
#include "tests/playback/xml_check.h"
#include "workflows/compare/comparison_text.h"

namespace gaitwright {
namespace {

/// Joint positions only, as in the log of a robot.
ComparedMotion JointsAlone(const synthetic::Played& walker) {
  MotionTable table;
  for (const LogSample& sample : walker.log.samples) {
    table.time_s.push_back(sample.time_s);
    table.q.emplace_back(sample.q.tail(walker.model.num_dofs()));
  }
  return ComparedTable(walker.model, table, "robot.csv");
}

/// The figure of a page with this id; empty if there is none.
std::string FigureOf(const std::string& page, const std::string& id) {
  const std::size_t begin = page.find("<figure id=\"" + id + "\">");
  return begin == std::string::npos ? "" : page.substr(begin, page.find("</figure>", begin) - begin);
}

bool Shows(const std::string& figure, const std::string& name) { return synthetic::Says(figure, ">" + name + "<"); }

TEST(ComparisonPage, APlotOfWhatOneSideAloneSaysHasNoLegendForTheOther) {
  const synthetic::Played walker = synthetic::Walked(2, {.count = 6});
  const ComparedMotion log = ComparedLog(walker.model, walker.log, "log.json"), table = JointsAlone(walker);
  const std::string page = ComparisonPage(log, table, CompareMotions(log, table), {});
  const std::string turned = ComparisonPage(table, log, CompareMotions(table, log), {});
  EXPECT_EQ(XmlFault(page), "");
  for (const char* id : {"top_view", "base_position", "base_attitude", "contacts", "joint_torques"}) {
    SCOPED_TRACE(id);
    const std::string first = FigureOf(page, id), second = FigureOf(turned, id);
    EXPECT_TRUE(Shows(first, "A") && !Shows(first, "B"));
    EXPECT_TRUE(synthetic::Says(first, "A only; B has no such data."));
    EXPECT_TRUE(Shows(second, "B") && !Shows(second, "A"));
    EXPECT_TRUE(synthetic::Says(second, "B only; A has no such data."));
  }
  const std::string both = FigureOf(page, "joint_positions");
  EXPECT_TRUE(Shows(both, "A") && Shows(both, "B"));
  EXPECT_FALSE(synthetic::Says(both, "alone"));
}

}  // namespace
}  // namespace gaitwright
