// SPDX-License-Identifier: BSD-3-Clause
#include "playback/report/engines_part.h"

#include <gtest/gtest.h>

#include "tests/playback/report/made_plots.h"
#include "tests/playback/report/svg_marks.h"
#include "tests/playback/xml_check.h"

namespace gaitwright {
namespace {

/// The part for two equal playbacks, with an agreement that the test provides.
std::string EnginesPartOf(const synthetic::Drawn& c, const Agreement& agreement, bool second_passes = true) {
  StabilityReport second = c.report;
  second.pass = second_passes;
  second.reason = second_passes ? "all <gates> passed" : "it fell";
  return EnginesPart(c.model, c.plan, c.log, c.report, {c.log, second, agreement});
}

Agreement MadeAgreement() {
  Agreement agreement;
  agreement.name_a = "bullet";
  agreement.name_b = "mujoco";
  agreement.end_s = 1.0;
  agreement.samples = 100;
  agreement.quantities = {
      {"slip of <left>", "m", 0.0125, 0.0251, 0.5, 0.02, 0.4, 0.0, 0.0251},
      {"yaw of the base", "rad", 0.001, 0.0021, 0.25, 0.03, std::nullopt, 0.0, 0.0},
  };
  return agreement;
}

/// The curves of a class; lines of two points belong to legends.
std::vector<std::vector<Vector2>> CurvesOf(const std::string& html, const std::string& css) {
  auto paths = svg_marks::Paths(html, css);
  std::erase_if(paths, [](const auto& path) { return path.size() < 3; });
  return paths;
}

TEST(EnginesPart, IsWellFormedAndNamesBothEngines) {
  const synthetic::Drawn c(synthetic::Walked(2, {.count = 2}));
  const std::string html = EnginesPartOf(c, MadeAgreement());
  EXPECT_EQ(XmlFault("<div>" + html + "</div>"), "");
  for (const char* part : {"<td>Bullet</td>", "<td>MuJoCo</td>", "<figure id=\"engines_balance\">",
                           "<figure id=\"engines_forces\">", "all &lt;gates&gt; passed"})
    EXPECT_NE(html.find(part), std::string::npos) << part;
}

TEST(EnginesPart, LengthsAreInMillimetresAndOtherUnitsAsTheyAre) {
  const synthetic::Drawn c(synthetic::Stood());
  const std::string html = EnginesPartOf(c, MadeAgreement());
  EXPECT_NE(html.find("<tr><td>slip of &lt;left&gt;</td><td class=\"n\">12.5 mm</td><td class=\"n\">25.1 mm</td><td "
                      "class=\"n\">0.50 s</td><td class=\"n\">20.0 mm</td><td class=\"n\">0.40 s</td></tr>"),
            std::string::npos)
      << html.substr(0, 3000);
  EXPECT_NE(html.find("<td class=\"n\">0.001 rad</td><td class=\"n\">0.0021 rad</td><td class=\"n\">0.25 s</td><td "
                      "class=\"n\">0.03 rad</td><td class=\"n\">\u2013</td></tr>"),
            std::string::npos);
}

TEST(EnginesPart, EachEngineHasItsOwnVerdict) {
  const synthetic::Drawn c(synthetic::Walked(2, {.count = 2}));
  ASSERT_TRUE(c.report.pass);
  const std::string both = EnginesPartOf(c, MadeAgreement(), true), one = EnginesPartOf(c, MadeAgreement(), false);
  EXPECT_EQ(svg_marks::Count(both, "<span class=\"mark pass\">pass</span>"), 2);
  EXPECT_EQ(svg_marks::Count(one, "<span class=\"mark pass\">pass</span>"), 1);
  EXPECT_EQ(svg_marks::Count(one, "<span class=\"mark fail\">FAIL</span>"), 1);
  EXPECT_LT(one.find("mark pass"), one.find("mark fail")) << "the first engine comes first";
}

// For two equal playbacks, both curves of each pair are equal.
TEST(EnginesPart, EqualPlaybacksHaveEqualCurves) {
  const synthetic::Drawn c(synthetic::Walked(2, {.count = 2}));
  const std::string html = EnginesPartOf(c, MadeAgreement());
  for (const char* ink : {"zmp", "foot"}) {  // the height is constant
    const auto a = CurvesOf(html, std::string(ink) + " planned"), b = CurvesOf(html, std::string(ink) + " measured");
    ASSERT_FALSE(a.empty()) << ink;
    EXPECT_EQ(a, b) << ink;
  }
  EXPECT_EQ(CurvesOf(html, "foot planned").size(), c.model.feet.size());
}

}  // namespace
}  // namespace gaitwright
