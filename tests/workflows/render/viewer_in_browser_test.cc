// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "kinematics/dynamics/dynamics.h"
#include "kinematics/model/load_robot.h"
#include "playback/report/report_page.h"
#include "playback/viewer/viewer_page.h"
#include "tests/workflows/render/shown_page.h"
#include "workflows/render/render_pictures.h"

namespace gaitwright {
namespace {

ShownMotion Shown(const ShownWalk& walk) {
  return {TitleOf(walk.model, walk.plan), walk.model, walk.plan, &walk.played.log, &walk.played.report};
}

WalkRequest Request(double distance_m, const std::string& terrain = "flat", const std::string& gait = "") {
  WalkRequest request;
  request.gait = gait;
  request.terrain = terrain;
  request.command.distance_m = distance_m;
  return request;
}

/// Number of different colours in a picture of a canvas, from a sample of its points.
constexpr char kColours[] =
    "((canvas) => { const copy = document.createElement('canvas'); copy.width = canvas.width; copy.height = "
    "canvas.height; const c = copy.getContext('2d'); c.drawImage(canvas, 0, 0); const d = c.getImageData(0, 0, "
    "copy.width, copy.height).data; const seen = new Set(); for (let i = 0; i < d.length; i += 52) seen.add(d[i] << 16 "
    "| "
    "d[i + 1] << 8 | d[i + 2]); return seen.size; })";

void ExpectNoComplaint(const ShownPage& page) {
  for (const std::string& complaint : page.browser().complaints()) ADD_FAILURE() << complaint;
}

/// The poses of all bodies agree with the program's kinematics, which the page does not share.
void ExpectBodiesAreWhereTheyAre(const ShownPage& page, const ShownWalk& walk) {
  DynamicsScratch scratch(walk.model);
  for (const std::size_t k : {std::size_t{0}, walk.played.log.samples.size() / 2, walk.played.log.samples.size() - 1}) {
    const LogSample& sample = walk.played.log.samples[k];
    ForwardKinematics(walk.model, sample.q, scratch);
    page.Ask("v.showNow(" + std::to_string(sample.time_s + 1e-4) + ") ?? 0");
    for (std::size_t body = 0; body < walk.model.bodies.size(); ++body) {
      const auto p = page.Ask("v.stages[0].robot.bodyPosition(" + std::to_string(body) + ").toArray()");
      const Vector3 shown(p[0].get<double>(), p[1].get<double>(), p[2].get<double>());
      EXPECT_LT((shown - scratch.p_WB[body]).norm(), 1e-5) << walk.model.bodies[body].name << " at " << sample.time_s;
    }
  }
}

/// Moving the slider moves the robot and the cursors of timeline and plots.
void ExpectScrubbingWorks(const ShownPage& page) {
  const std::string state =
      "[v.stages[0].robot.bodyPosition(0).x, document.querySelector('.gw-track .gw-now').style.transform, "
      "document.querySelector('.gw-plot .gw-now').style.transform, v.clock.time]";
  page.Ask("v.showNow(0) ?? 0");
  const auto before = page.Ask(state);
  page.Ask(
      "(() => { const s = document.querySelector('.gw-slider'); s.value = 0.6 * v.clock.end; s.dispatchEvent(new "
      "Event('input')); return 0; })()");
  const auto after = page.Ask(state);
  for (std::size_t i = 0; i < 4; ++i) EXPECT_NE(before[i], after[i]) << i;
  EXPECT_NEAR(after[3].get<double>(), 0.6 * page.Ask("v.clock.end").get<double>(), 0.006);
}

void ExpectPicturesAreNotEmpty(const ShownPage& page) {
  page.Ask("v.showNow(0.5 * v.clock.end) ?? 0");
  const auto colours =
      page.Ask("[v.look('side'), v.stages[0].draw(), " + std::string(kColours) + "(v.stages[0].canvas)][2]");
  EXPECT_GT(colours.get<int>(), 100) << "ground, robot, shadows";
  const auto plots = page.Ask("[...document.querySelectorAll('.gw-plot canvas')].map(" + std::string(kColours) + ")");
  EXPECT_EQ(plots.size(), 8U);
  for (const auto& plot : plots) EXPECT_GT(plot.get<int>(), 3);
  const auto data = page.Ask("v.plots[0].plots.map((p) => p.plot.data.slice(1).map((d) => d.some((x) => x !== null)))");
  for (std::size_t i = 0; i < data.size(); ++i)
    for (const auto& line : data[i]) EXPECT_TRUE(line.get<bool>()) << "plot " << i;
}

void ExpectAllWorks(const ShownWalk& walk) {
  const ShownPage page(ViewerPage("test", {Shown(walk)}));
  ExpectBodiesAreWhereTheyAre(page, walk);
  ExpectScrubbingWorks(page);
  ExpectPicturesAreNotEmpty(page);
  EXPECT_EQ(page.Ask("v.stages[0].overlays.root.children.map((group) => group.name)"), nlohmann::json(OverlayNames()))
      << "what pictures may leave out is what the page has";
  ExpectNoComplaint(page);
}

TEST(ViewerInBrowser, ShowsATrot) { ExpectAllWorks(MakeShownWalk("a1", Request(0.5, "flat", "trot"))); }

TEST(ViewerInBrowser, ShowsAWalkOnSoles) {
  WalkRequest request;
  request.command.extent = WalkCommand::Extent::kSteps;
  request.command.steps = 4;
  request.command.step_length_m = 0.04;
  ExpectAllWorks(MakeShownWalk("nao", request));
}

TEST(ViewerInBrowser, ShowsAClimb) { ExpectAllWorks(MakeShownWalk("a1", Request(1.5, "stairs"))); }

TEST(ViewerInBrowser, MarksAFallOnTheTimelineWithItsReason) {
  const ShownWalk walk = MakeShownWalk("a1", Request(1.0, "flat", "trot"), {0.0, 400.0, 0.0});
  ASSERT_FALSE(walk.played.report.pass);
  const ShownPage page(ViewerPage("test", {Shown(walk)}));
  ExpectBodiesAreWhereTheyAre(page, walk);
  ExpectPicturesAreNotEmpty(page);
  const std::string title = page.Ask("document.querySelector('.gw-mark.gw-fall').title").get<std::string>();
  EXPECT_NE(title.find(walk.played.report.reason), std::string::npos) << title;
  EXPECT_EQ(page.Ask("document.querySelector('.gw-mark.gw-fall').textContent"), "fall: " + walk.played.report.reason);
  EXPECT_EQ(page.Ask("document.querySelector('.gw-reason').textContent"), walk.played.report.reason);
  EXPECT_EQ(page.Ask("document.querySelector('.gw-reason').getBoundingClientRect().top >= "
                     "document.querySelector('.gw-stage').getBoundingClientRect().bottom"),
            true)
      << "the reason is not over the robot";
  EXPECT_GE(page.Ask("parseFloat(getComputedStyle(document.querySelector('.gw-reason')).fontSize)").get<double>(),
            16.0);
  page.Ask("document.querySelector('.gw-mark.gw-fall').click() ?? 0");
  EXPECT_NEAR(page.Ask("v.clock.time").get<double>(), walk.played.report.At("fell").at_s.value(), 1e-6);
  ExpectNoComplaint(page);
}

TEST(ViewerInBrowser, ShowsTwoLogsSideBySideUnderOneClock) {
  const ShownWalk a = MakeShownWalk("a1", Request(0.3, "flat", "trot"));
  const ShownWalk b = MakeShownWalk("a1", Request(0.3, "flat", "walk"));
  const ShownPage page(ViewerPage("test", {Shown(a), Shown(b)}));
  EXPECT_EQ(page.Ask("document.querySelectorAll('.gw-stage canvas').length"), 2);
  page.Ask("v.showNow(0.8) ?? 0");
  const auto x = page.Ask("v.stages.map((s) => s.robot.bodyPosition(0).x)");
  EXPECT_NE(x[0], x[1]);
  ExpectNoComplaint(page);
}

TEST(ViewerInBrowser, ShowsAnotherMotionAsAGhost) {
  const ShownWalk walk = MakeShownWalk("a1", Request(0.3, "flat", "trot"));
  ShownMotion shown{TitleOf(walk.model, walk.plan), walk.model, walk.plan};
  const WholeBodyTrajectory& rows = walk.plan.whole_body;
  shown.ghost = {"the original", [&](double time_s) {
                   const auto row = static_cast<std::size_t>(std::lround(time_s / rows.step_s));
                   VectorX q = rows.q[std::min(row, rows.q.size() - 1)];
                   q[1] += 0.5;
                   return time_s > 1.0 ? VectorX() : q;
                 }};
  const ShownPage page(ViewerPage("test", {shown}));
  EXPECT_EQ(page.Ask("[...document.querySelectorAll('.gw-legend label')][0].textContent.trim()"),
            "the original as a ghost");
  const std::string apart = "v.stages[0].ghost.bodyPosition(0).y - v.stages[0].robot.bodyPosition(0).y";
  page.Ask("v.showNow(0.4) ?? 0");
  EXPECT_NEAR(page.Ask(apart).get<double>(), 0.5, 1e-5);
  EXPECT_EQ(page.Ask("v.stages[0].ghost.root.visible"), true);
  const std::string shot = "[v.look('front'), v.stages[0].draw(), v.stages[0].canvas.toDataURL()][2]";
  const auto with = page.Ask(shot);
  page.Ask("v.setOverlay('ghost', false) ?? 0");
  EXPECT_NE(page.Ask(shot), with) << "the ghost is in the picture";
  page.Ask("v.setOverlay('ghost', true) ?? 0");
  page.Ask("v.showNow(1.2) ?? 0");
  EXPECT_EQ(page.Ask("v.stages[0].ghost.root.visible"), false) << "it has ended";
  ExpectNoComplaint(page);
}

TEST(ViewerInBrowser, MarksAndCursorsAreThoseOfTheirOwnMotion) {
  const ShownWalk fallen = MakeShownWalk("a1", Request(1.0, "flat", "trot"), {0.0, 400.0, 0.0});
  const ShownWalk longer = MakeShownWalk("a1", Request(1.0, "flat", "trot"));
  const ShownPage page(ViewerPage("test", {Shown(fallen), Shown(longer)}));
  const auto rows = page.Ask(
      "[...document.querySelectorAll('.gw-feet span')].map((row) => row.getBoundingClientRect()).map((box) => "
      "[box.top, "
      "box.bottom])");
  ASSERT_EQ(rows.size(), 8U);
  const auto marks = page.Ask(
      "[...document.querySelectorAll('.gw-mark')].filter((mark) => mark.title.includes('fell')).map((mark) => "
      "mark.getBoundingClientRect()).map((box) => [box.top, box.bottom])");
  ASSERT_FALSE(marks.empty());
  for (const auto& mark : marks) {
    EXPECT_LE(mark[0], rows[0][0]);
    EXPECT_GE(mark[1], rows[3][1].get<double>() - 4.0);
    EXPECT_LT(mark[1], rows[4][0]) << "on the rows of the other";
  }
  const auto hidden = [&](const std::string& time) {
    return page.Ask("[v.showNow(" + time +
                    "), ...v.plots.map((p) => p.plots.every(({ cursor }) => cursor.hidden))].slice(1)");
  };
  EXPECT_EQ(hidden("0.5"), nlohmann::json({false, false}));
  EXPECT_EQ(hidden("v.clock.end"), nlohmann::json({true, false})) << "the first has ended";
  EXPECT_EQ(
      page.Ask("document.querySelector('.gw-plots').scrollWidth <= document.querySelector('.gw-plots').clientWidth"),
      true);
  ExpectNoComplaint(page);
}

TEST(ViewerInBrowser, IsDrivenByTheKeyboard) {
  const ShownWalk walk = MakeShownWalk("a1", Request(0.3, "flat", "trot"));
  const ShownPage page(ViewerPage("test", {Shown(walk)}));
  const auto press = [&](const std::string& key) { ASSERT_TRUE(page.browser().Press(key).ok()); };
  press("End");
  EXPECT_EQ(page.Ask("v.clock.time === v.clock.end"), true);
  press("Home");
  EXPECT_EQ(page.Ask("v.clock.time === v.clock.start"), true);
  press("ArrowRight");
  EXPECT_NEAR(page.Ask("v.clock.time - v.clock.start").get<double>(), 0.005, 1e-6);
  for (int k = 1; k < 12; ++k) {
    EXPECT_EQ(page.Ask("v.stages[0].shown"), k) << "each press goes on by one sample";
    press("ArrowRight");
  }
  press(" ");
  EXPECT_EQ(page.Ask("v.clock.playing"), true);
  press(" ");
  EXPECT_EQ(page.Ask("v.clock.playing"), false);
  const auto theme = page.Ask("document.querySelector('.gw-viewer').dataset.theme");
  press("t");
  EXPECT_NE(page.Ask("document.querySelector('.gw-viewer').dataset.theme"), theme);
  press("g");
  EXPECT_EQ(page.Ask("v.stages[0].overlays.group('ghost').visible"), false);
  ExpectNoComplaint(page);
}

/// Camera position relative to its target: heading and angle from the vertical [degree], and distance.
std::array<double, 3> CameraOf(const ShownPage& page) {
  const auto p = page.Ask("v.stages[0].camera.position.clone().sub(v.stages[0].controls.target).toArray()");
  const Vector3 offset(p.at(0).get<double>(), p.at(1).get<double>(), p.at(2).get<double>());
  constexpr double kDegree = std::numbers::pi / 180.0;
  return {std::atan2(offset.y(), offset.x()) / kDegree, std::acos(offset.z() / offset.norm()) / kDegree, offset.norm()};
}

TEST(ViewerInBrowser, TurnsTheCameraByKeys) {
  const ShownWalk walk = MakeShownWalk("a1", Request(0.3, "flat", "trot"));
  const ShownPage page(ViewerPage("test", {Shown(walk)}));
  const auto press = [&](const std::string& key, int times = 1) {
    for (int i = 0; i < times; ++i) ASSERT_TRUE(page.browser().Press(key).ok());
  };
  const std::array<double, 3> at_first = CameraOf(page);
  press("d", 4);
  EXPECT_NEAR(CameraOf(page)[0], at_first[0] + 30.0, 1e-3);
  press("A", 2);
  EXPECT_NEAR(CameraOf(page)[0], at_first[0] + 15.0, 1e-3);
  press("w", 2);
  EXPECT_NEAR(CameraOf(page)[1], at_first[1] - 15.0, 1e-3);
  EXPECT_NEAR(CameraOf(page)[2], at_first[2], 1e-6);
  press("s", 15);
  EXPECT_LT(CameraOf(page)[1], 90.0) << "never from below the ground";
  press("e");
  EXPECT_NEAR(CameraOf(page)[2], 0.9 * at_first[2], 1e-6);
  press("q", 50);
  const double farthest = CameraOf(page)[2];
  press("q");
  EXPECT_NEAR(CameraOf(page)[2], farthest, 1e-6);
  press("1");
  EXPECT_NEAR(CameraOf(page)[0], at_first[0], 1e-3);
  ExpectNoComplaint(page);
}

TEST(ViewerInBrowser, IsPartOfTheReport) {
  const ShownWalk walk = MakeShownWalk("a1", Request(0.3, "flat", "trot"));
  ReportWords words;
  words.viewer = ViewerPart({Shown(walk)});
  const ShownPage page(ReportPage(walk.model, walk.plan, walk.played.log, walk.played.report, words));
  ExpectScrubbingWorks(page);
  EXPECT_EQ(page.Ask("[...document.querySelectorAll('.gw-reason')].every((e) => e.offsetParent === null)"), true)
      << "the report says it at its head";
  page.Ask("v.showNow(0.2) ?? 0");
  ASSERT_TRUE(page.browser().Press("End").ok());
  EXPECT_EQ(page.Ask("v.clock.time"), 0.2) << "keys are the report's until the part has the focus";
  page.Ask("document.querySelector('.gw-part').focus() ?? 0");
  ASSERT_TRUE(page.browser().Press("End").ok());
  EXPECT_EQ(page.Ask("v.clock.time === v.clock.end"), true);
  ExpectNoComplaint(page);
}

}  // namespace
}  // namespace gaitwright
