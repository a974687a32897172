// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "kinematics/base/non_finite.h"
#include "tests/playback/played.h"
#include "workflows/compare/compare_parts_internal.h"

namespace gaitwright {
namespace {

const FigurePair* FindFigure(const std::vector<FigurePair>& figures, const std::string& key) {
  const auto found = std::find_if(figures.begin(), figures.end(), [&](const FigurePair& f) { return f.key == key; });
  return found == figures.end() ? nullptr : &*found;
}

/// Both values of a quantity that both sides have.
std::pair<double, double> BothOf(const std::vector<FigurePair>& figures, const std::string& key) {
  const FigurePair* figure = FindFigure(figures, key);
  EXPECT_TRUE(figure != nullptr && figure->a && figure->b) << key;
  if (figure == nullptr || !figure->a || !figure->b) return {kNaN, kNaN};
  return {*figure->a, *figure->b};
}

const WordDifference* FindWord(const std::vector<WordDifference>& words, const std::string& key) {
  const auto found = std::find_if(words.begin(), words.end(), [&](const WordDifference& w) { return w.key == key; });
  return found == words.end() ? nullptr : &*found;
}

TEST(CompareFigures, OfAPlanAndItsLogAreTheirMotions) {
  const synthetic::Played walker = synthetic::Walked(2, {.count = 4, .lift_m = 0.03});
  synthetic::Played played = walker;
  played.log.samples[100].q[2] += 0.05;
  played.log.samples[200].q[2] -= 0.02;
  played.log.stances[1].slip_m = 0.013;
  const auto figures =
      FiguresOf(ComparedPlan(walker.model, walker.plan, "a"), ComparedLog(walker.model, played.log, "b"));
  const WholeBodyTrajectory& body = walker.plan.whole_body;
  EXPECT_NEAR(BothOf(figures, "duration_s").first, body.end_s() - body.start_s, 1e-9);
  EXPECT_NEAR(BothOf(figures, "base_travel_m").first, (body.q.back() - body.q.front()).head<2>().norm(), 1e-9);
  EXPECT_NEAR(BothOf(figures, "base_height_max_m").first, synthetic::kHeight, 1e-9);
  EXPECT_NEAR(BothOf(figures, "base_height_max_m").second, synthetic::kHeight + 0.05, 1e-9);
  EXPECT_NEAR(BothOf(figures, "base_height_min_m").second, synthetic::kHeight - 0.02, 1e-9);
  EXPECT_NEAR(BothOf(figures, "base_tilt_max_rad").second, 0.0, 1e-6);
  EXPECT_NEAR(FindFigure(figures, "slip_max_m")->b.value(), 0.013, 1e-12);
  EXPECT_FALSE(FindFigure(figures, "slip_max_m")->a) << "a plan does not slip";
  EXPECT_EQ(FindFigure(figures, "footholds")->a.value(), static_cast<double>(walker.plan.footsteps.footholds.size()));
  EXPECT_FALSE(FindFigure(figures, "footholds")->b);
}

TEST(CompareFigures, UseOfSpeedAndTorqueIsTheLargestShareOfALimit) {
  const synthetic::Played walker = synthetic::Walked(2, {.count = 2});
  synthetic::Played fast = walker;
  fast.log.samples[50].v[6 + 4] = -7.5;  // the limit is 10 m/s
  fast.log.samples[60].tau[3] = -150.0;  // the limit is 200 N
  const auto figures = FiguresOf(ComparedLog(walker.model, walker.log, "a"), ComparedLog(walker.model, fast.log, "b"));
  EXPECT_NEAR(BothOf(figures, "joint_speed_use_max").second, 0.75, 1e-12);
  EXPECT_NEAR(BothOf(figures, "torque_of_limit_max").second, 0.75, 1e-12);
  EXPECT_LT(BothOf(figures, "joint_speed_use_max").first, 0.75);
}

TEST(CompareFigures, TiltIsTheAngleOfTheBasesAxisAndNotItsHeading) {
  const synthetic::Played walker = synthetic::Stood();
  synthetic::Played turned = walker, tilted = walker;
  turned.log.samples[10].q.segment<4>(3) << 0.0, 0.0, std::sin(0.4), std::cos(0.4);
  tilted.log.samples[10].q.segment<4>(3) << std::sin(0.1), 0.0, 0.0, std::cos(0.1);
  const auto figures =
      FiguresOf(ComparedLog(walker.model, turned.log, "a"), ComparedLog(walker.model, tilted.log, "b"));
  EXPECT_NEAR(BothOf(figures, "base_tilt_max_rad").first, 0.0, 1e-6);
  EXPECT_NEAR(BothOf(figures, "base_tilt_max_rad").second, 0.2, 1e-9);
}

TEST(CompareFigures, WithoutABaseThereAreNoFiguresOfIt) {
  MotionTable table;
  table.time_s = {0.0, 0.1};
  table.q.assign(2, VectorX::Zero(6));
  const RobotModel model = synthetic::Robot(2, FootType::kSphere);
  const auto figures = FiguresOf(ComparedTable(model, table, "a"), ComparedTable(model, table, "b"));
  EXPECT_EQ(FindFigure(figures, "base_travel_m"), nullptr);
  EXPECT_EQ(FindFigure(figures, "torque_of_limit_max"), nullptr);
  EXPECT_NEAR(BothOf(figures, "duration_s").first, 0.1, 1e-12);
}

TEST(CompareWords, NothingDiffersFromItself) {
  const synthetic::Played walker = synthetic::Stood();
  const ComparedMotion plan = ComparedPlan(walker.model, walker.plan, "a"),
                       log = ComparedLog(walker.model, walker.log, "b");
  EXPECT_TRUE(WordsOf(plan, plan).empty());
  EXPECT_TRUE(WordsOf(log, log).empty());
}

TEST(CompareWords, OptionsThatDifferAreNamedWithBothValues) {
  synthetic::Played a = synthetic::Stood(), b = a;
  a.plan.provenance.options = {{"swing.height_m", "0.05"}, {"gait.cycle_s", "0.5"}, {"seed", "1"}};
  b.plan.provenance.options = {{"swing.height_m", "0.08"}, {"gait.cycle_s", "0.5"}, {"extra", "on"}};
  b.plan.provenance.seed = 7;
  const auto words = WordsOf(ComparedPlan(a.model, a.plan, "a"), ComparedPlan(b.model, b.plan, "b"));
  const WordDifference* height = FindWord(words, "swing.height_m");
  ASSERT_NE(height, nullptr);
  EXPECT_EQ(height->a, "0.05");
  EXPECT_EQ(height->b, "0.08");
  EXPECT_EQ(height->only, ' ');
  EXPECT_EQ(FindWord(words, "gait.cycle_s"), nullptr);
  ASSERT_NE(FindWord(words, "extra"), nullptr);
  EXPECT_EQ(FindWord(words, "extra")->a, "");
  EXPECT_EQ(FindWord(words, "extra")->b, "on");
}

/// Options of a group that only one side has are marked, so that the text can summarise them.
TEST(CompareWords, AGroupThatOneSideAloneHasIsMarked) {
  synthetic::Played a = synthetic::Stood(), b = a;
  a.plan.provenance.options = {{"stairs.rise_m", "0.1"}, {"stairs.run_m", "0.3"}, {"swing.height_m", "0.05"}};
  b.plan.provenance.options = {{"swing.time_s", "0.4"}, {"swing.height_m", "0.05"}};
  const auto words = WordsOf(ComparedPlan(a.model, a.plan, "a"), ComparedPlan(b.model, b.plan, "b"));
  ASSERT_NE(FindWord(words, "stairs.rise_m"), nullptr);
  EXPECT_EQ(FindWord(words, "stairs.rise_m")->only, 'a');
  EXPECT_EQ(FindWord(words, "stairs.run_m")->only, 'a');
  EXPECT_EQ(FindWord(words, "swing.time_s")->only, ' ') << "the other side has some of this group";
}

/// Non-default options of a playback are listed in a comparison with a plan, which has no such options.
TEST(CompareWords, UnusualOptionsOfAPlaybackAreReportedBesideItsPlan) {
  synthetic::Played walker = synthetic::Stood();
  walker.log.options = {{"play.friction", "0.123"}};
  const ComparedMotion plan = ComparedPlan(walker.model, walker.plan, "a"),
                       log = ComparedLog(walker.model, walker.log, "b");
  const auto ab = WordsOf(plan, log), ba = WordsOf(log, plan);
  const WordDifference *there = FindWord(ab, "play.friction"), *back = FindWord(ba, "play.friction");
  ASSERT_TRUE(there != nullptr && back != nullptr);
  EXPECT_EQ(there->b, "0.123");
  EXPECT_NE(there->a, "0.123");
  EXPECT_EQ(back->a, "0.123");
  EXPECT_EQ(back->b, there->a);
}

}  // namespace
}  // namespace gaitwright
