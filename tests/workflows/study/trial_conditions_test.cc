// SPDX-License-Identifier: BSD-3-Clause
#include "workflows/study/trial_conditions.h"

#include <gtest/gtest.h>

#include "workflows/walk/walk.h"

namespace gaitwright {
namespace {

/// The reported conditions of a request, one line each.
std::vector<std::string> ConditionLines(PlayRequest request) {
  std::vector<std::string> lines;
  for (const OptionChange& condition : TrialConditions(TextsOf(request.Fields())))
    lines.push_back(ConditionText(condition));
  return lines;
}

using Lines = std::vector<std::string>;

TEST(TrialConditions, TellOfStateSensorsAndDelayWhateverTheyAre) {
  EXPECT_EQ(ConditionLines({}), (Lines{"state true", "sensors not used", "command_delay_s 0"}));
  PlayRequest request;
  request.sensing.sensors = SensorsOfKind("hobby");
  EXPECT_EQ(ConditionLines(request), (Lines{"state true", "sensors not used", "command_delay_s 0"}))
      << "with the true state";
  request.sensing.state = "estimated";
  request.sensing.command_delay_s = 0.004;
  EXPECT_EQ(ConditionLines(request), (Lines{"state estimated (default true)", "sensors hobby (default ideal)",
                                            "command_delay_s 0.004 (default 0)"}));
}

TEST(TrialConditions, NameFiguresOfSensorsThatAreNotThoseOfTheNearestSet) {
  PlayRequest request;
  request.sensing.state = "measured";
  EXPECT_EQ(ConditionLines(request)[1], "sensors ideal");
  request.sensing.sensors = SensorsOfKind("good");
  request.sensing.sensors.encoder_bias_rad = 0.01;
  request.sensing.sensors.seed = 7;
  EXPECT_EQ(ConditionLines(request), (Lines{"state measured (default true)", "sensors good (default ideal)",
                                            "sensors.encoder_bias_rad 0.01 (default 0)", "command_delay_s 0"}));
}

TEST(TrialConditions, NameEveryOptionThatIsNotAtItsUsualValue) {
  PlayRequest request;
  request.play.world.friction = 0.4;
  request.stabilised.dcm_gain = 1.5;
  request.play.world.seed = 3;
  EXPECT_EQ(ConditionLines(request), (Lines{"state true", "sensors not used", "command_delay_s 0",
                                            "play.friction 0.4 (default 0)", "stabilised.dcm_gain 1.5 (default 1.3)"}));
}

TEST(TrialConditions, FlagsAreThoseThatAct) {
  PlayRequest request;
  request.controller = "joint-pd";
  request.stabilised.dcm_gain = 1.5;
  request.sensing.sensors = SensorsOfKind("hobby");
  request.play.world.friction = 0.4;
  EXPECT_EQ(FlagsOf("joint-pd", TextsOf(request.Fields())), "--controller joint-pd --set play.friction=0.4");
  EXPECT_EQ(FlagsOf("stabilised", TextsOf(request.Fields())), "--set play.friction=0.4 --set stabilised.dcm_gain=1.5");
  request.play.world.ground_slope_direction_deg = 90.0;
  const OptionTexts slope = TextsOf(request.Fields());
  EXPECT_EQ(FlagsOf("joint-pd", slope), "--controller joint-pd --set play.friction=0.4");
  EXPECT_EQ(FlagsOf("joint-pd", slope, {"play.ground_slope_deg"}),
            "--controller joint-pd --set play.friction=0.4 --set play.ground_slope_direction_deg=90");
}

TEST(TrialConditions, SayWhatTheResultDoesNotSayOrTheProgramNotKnow) {
  const std::vector<OptionChange> conditions = TrialConditions({{"play.magic", "on"}});
  ASSERT_EQ(conditions.size(), 4U);
  EXPECT_EQ(conditions[0].value, "not said");
  EXPECT_EQ(conditions[1].value, "not said");
  EXPECT_EQ(conditions[2].value, "not said");
  EXPECT_EQ(ConditionText(conditions[3]), "play.magic on (not known to this program)");
}

}  // namespace
}  // namespace gaitwright
