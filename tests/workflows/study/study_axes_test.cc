// SPDX-License-Identifier: BSD-3-Clause
#include "workflows/study/study_axes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>

namespace gaitwright {
namespace {

std::string Refusal(const std::string& text, StudyLayout layout) {
  try {
    ParseAxis(text, layout);
  } catch (const InvalidArgument& error) {
    return error.what();
  }
  return "accepted";
}

TEST(StudyAxes, ARangeWithACountHasItsEndsAndEvenSteps) {
  const StudyAxis axis = ParseAxis("speed=0.1:0.5:5", StudyLayout::kGrid);
  EXPECT_EQ(axis.values, (StudyPoint{"0.1", "0.2", "0.3", "0.4", "0.5"})) << "no digits of rounding";
  EXPECT_EQ(axis.unit, "m/s");
  EXPECT_FALSE(axis.is_range());
}

TEST(StudyAxes, ListsTakeNumbersWordsAndSwitches) {
  EXPECT_EQ(ParseAxis("stabilised.dcm_gain=2,1.5,3", StudyLayout::kGrid).values, (StudyPoint{"2", "1.5", "3"}));
  EXPECT_EQ(ParseAxis("play.push_on=robot,base", StudyLayout::kSamples).values, (StudyPoint{"robot", "base"}));
  EXPECT_EQ(ParseAxis("play.lock_unmoved=true,false", StudyLayout::kGrid).values, (StudyPoint{"true", "false"}));
  EXPECT_FALSE(ParseAxis("play.push_on=robot", StudyLayout::kGrid).numbers);
}

TEST(StudyAxes, RefusalsSayWhatIsWrongAndWhatIsAccepted) {
  using enum StudyLayout;
  const std::string grid = "KEY=FROM:TO:COUNT or KEY=a,b,c; ranges without a count are for --samples";
  EXPECT_EQ(Refusal("speed", kGrid), "'speed' is not an axis; accepted: " + grid);
  EXPECT_EQ(Refusal("speed=", kGrid), "'speed=' is not an axis; accepted: " + grid);
  EXPECT_EQ(Refusal("speed=0.1:0.5", kGrid), "'speed=0.1:0.5' is not an axis; accepted: " + grid);
  EXPECT_EQ(Refusal("speed=0.1:0.5:3", kSamples),
            "'speed=0.1:0.5:3' is not an axis; accepted: KEY=FROM:TO or KEY=a,b,c");
  EXPECT_EQ(Refusal("gait.cycle_s=0.3,0.4", kTuning), "'gait.cycle_s=0.3,0.4' is not an axis; accepted: KEY=FROM:TO");
  EXPECT_EQ(Refusal("sped=1:2:3", kGrid), "'sped=1:2:3': there is no option 'sped'; the nearest is 'speed'");
  EXPECT_EQ(Refusal("com-method=a,b", kGrid),
            "'com-method=a,b': there is no option 'com-method'; --list-options=all prints all option keys");
  EXPECT_EQ(
      Refusal("gait.cycle=0.3:0.4:2", kGrid),
      "'gait.cycle=0.3:0.4:2': there is no option 'gait.cycle'; the nearest are 'gait.cycle_s', 'gait.cycle_step_s'");
  EXPECT_EQ(Refusal("speed=0.5:0.1:3", kGrid),
            "'speed=0.5:0.1:3': 0.5 to 0.1 is not a range; the first must be below the second");
  EXPECT_EQ(Refusal("gait.duty_factor=0.5:1.2:3", kGrid),
            "'gait.duty_factor=0.5:1.2:3': option 'gait.duty_factor' is 1.2; accepted: 0 to 0.99");
  EXPECT_EQ(Refusal("speed=a:2:3", kGrid), "'speed=a:2:3': 'a' is not a finite number");
  EXPECT_EQ(Refusal("speed=0:inf:3", kGrid), "'speed=0:inf:3': 'inf' is not a finite number");
  EXPECT_EQ(Refusal("speed=0:1:1", kGrid), "'speed=0:1:1': the count is 1; whole numbers from 2 to 10000 are accepted");
  EXPECT_EQ(Refusal("speed=0:1:2.5", kGrid),
            "'speed=0:1:2.5': the count is 2.5; whole numbers from 2 to 10000 are accepted");
  EXPECT_EQ(Refusal("speed=0.1,0.10", kGrid), "'speed=0.1,0.10': the value 0.1 is given twice");
  EXPECT_EQ(Refusal("play.push_on=0:1", kSamples),
            "'play.push_on=0:1': option 'play.push_on' is not a number and has no range; give single values as "
            "play.push_on=a,b,c (for a sweep)");
  EXPECT_EQ(Refusal("play.actuation=motors", kGrid)
                .find("'play.actuation=motors': option 'play.actuation' is 'motors'; accepted: "),
            0U);
}

TEST(StudyAxes, NoneAndTheSameTwiceAreRefused) {
  EXPECT_THROW(ParseAxes({}, StudyLayout::kGrid), InvalidArgument);
  try {
    ParseAxes({"speed=0.1:0.2:2", "speed=0.3,0.4"}, StudyLayout::kGrid);
    FAIL() << "accepted";
  } catch (const InvalidArgument& error) {
    EXPECT_STREQ(error.what(), "'speed=0.3,0.4': speed is varied twice");
  }
}

TEST(StudyAxes, OfAGridTheLastAxisRunsFastest) {
  const auto axes = ParseAxes({"speed=0.1,0.2", "play.friction=0.5,0.6,0.7"}, StudyLayout::kGrid);
  const std::vector<StudyPoint> expected = {{"0.1", "0.5"}, {"0.1", "0.6"}, {"0.1", "0.7"},
                                            {"0.2", "0.5"}, {"0.2", "0.6"}, {"0.2", "0.7"}};
  EXPECT_EQ(GridPoints(axes), expected);
}

TEST(StudyAxes, AGridOfTooManyPointsIsRefused) {
  const auto axes = ParseAxes({"speed=0:1:10000", "lateral_speed=0:1:101"}, StudyLayout::kGrid);
  EXPECT_THROW(GridPoints(axes), InvalidArgument);
}

TEST(StudyAxes, SamplesAreThoseOfHaltonBetweenTheEnds) {
  const auto axes = ParseAxes({"speed=1:2", "yaw_rate=-1:1", "play.push_on=base,robot"}, StudyLayout::kSamples);
  const auto points = SampledPoints(axes, 100, 0);
  EXPECT_EQ(points[0], (StudyPoint{"1.5", "-0.333333", "base"})) << "1/2, 1/3, 1/5";
  EXPECT_EQ(points[1], (StudyPoint{"1.25", "0.333333", "base"})) << "1/4, 2/3, 2/5";
  EXPECT_EQ(points[2], (StudyPoint{"1.75", "-0.777778", "robot"})) << "3/4, 1/9, 3/5";
  std::map<std::string, int> words;
  for (const StudyPoint& point : points) ++words[point[2]];
  EXPECT_NEAR(words["base"], 50, 3);
  EXPECT_NE(SampledPoints(axes, 5, 1), SampledPoints(axes, 5, 2));
  EXPECT_EQ(SampledPoints(axes, 5, 1), SampledPoints(axes, 5, 1));
}

TEST(StudyAxes, WholeNumbersAreSampledAsSuch) {
  StudyAxis axis{.key = "n", .unit = "1", .values = {}, .low = 1.0, .high = 4.0, .numbers = true, .whole = true};
  EXPECT_EQ(ValueAt(axis, 0.0), "1");
  EXPECT_EQ(ValueAt(axis, 0.5), "3") << "halves go away from zero";
  EXPECT_EQ(ValueAt(axis, 1.0), "4");
}

TEST(StudyAxes, NumbersBelowTheSmallestNormalOneAreNumbers) {
  EXPECT_EQ(NumberOfValue("1e-320"), 1e-320);
  EXPECT_EQ(ValueAt(ParseAxis("yaw_rate=1e-320:2e-320", StudyLayout::kTuning), 0.0), "1e-320");
  EXPECT_THROW(NumberOfValue("trot"), InvalidArgument);
}

TEST(StudyAxes, APointGoesWhereItsKeysSay) {
  const auto axes =
      ParseAxes({"speed=0.4,0.5", "gait.cycle_s=0.6,0.7", "stabilised.dcm_gain=1.5,2"}, StudyLayout::kGrid);
  WalkRequest walk;
  PlayRequest play;
  ApplyPoint(axes, {"0.5", "0.6", "2"}, walk, play);
  EXPECT_EQ(walk.command.speed_m_s, 0.5);
  EXPECT_EQ(walk.gait_options.cycle_s, 0.6);
  EXPECT_EQ(play.stabilised.dcm_gain, 2.0);
  EXPECT_EQ(PointText(axes, {"0.5", "0.6", "2"}), "speed=0.5, gait.cycle_s=0.6, stabilised.dcm_gain=2");
}

TEST(StudyAxes, TellsWhatShapesThePlan) {
  for (const char* key : {"speed", "step_length", "gait.cycle_s", "swing.height_m"})
    EXPECT_TRUE(ShapesThePlan(key)) << key;
  for (const char* key : {"stabilised.dcm_gain", "play.friction", "gains.stance_damping"})
    EXPECT_FALSE(ShapesThePlan(key)) << key;
}

}  // namespace
}  // namespace gaitwright
