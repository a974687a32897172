// SPDX-License-Identifier: BSD-3-Clause
#include "workflows/study/tune.h"

#include <gtest/gtest.h>
#include <yaml-cpp/yaml.h>

#include "tests/workflows/study/made_up_tuning.h"

namespace gaitwright {
namespace {

bool IsTunable(const std::string& range) {
  try {
    CheckTunable({ParseAxis(range, StudyLayout::kTuning)});
    return true;
  } catch (const InvalidArgument& error) {
    EXPECT_NE(std::string(error.what()).find("'" + range.substr(0, range.find('=')) + "'"), std::string::npos);
    return false;
  }
}

TEST(TunedAxes, AreOfTheWalkAndItsControllerAndNotOfTheWorldOrTheCommand) {
  EXPECT_TRUE(IsTunable("gait.cycle_s=0.3:0.6"));
  EXPECT_TRUE(IsTunable("stabilised.dcm_gain=1:3"));
  EXPECT_FALSE(IsTunable("speed=0.1:0.3")) << "scores of other commands do not compare";
  EXPECT_FALSE(IsTunable("play.friction=0.4:0.8"));
  EXPECT_FALSE(IsTunable("command_delay_s=0:0.01"));
  EXPECT_NO_THROW(CheckTunable({}));
}

TEST(TunedAxes, UsualValuesAreThoseOfTheRequests) {
  MadeUpTuning tuning = MakeUpTuning(MadeUpProof::kBetter);
  tuning.study.walk.gait_options.cycle_s = 0.55;
  tuning.study.play.stabilised.dcm_gain = 2.25;
  EXPECT_EQ(UsualValues(tuning.study), (StudyPoint{"0.55", "2.25"}));
  tuning.study.axes[0].key = "gait.no_such_key";
  EXPECT_THROW(UsualValues(tuning.study), InvalidArgument);
}

TEST(TunedAxes, TheIdentityIsThatOfRangesOptionsAndTrials) {
  const MadeUpTuning tuning = MakeUpTuning(MadeUpProof::kBetter);
  const std::string own = TuneIdentity(tuning.study, tuning.options, "standard");
  EXPECT_EQ(TuneIdentity(tuning.study, tuning.options, "standard"), own);
  EXPECT_NE(TuneIdentity(tuning.study, tuning.options, "other"), own);
  TuneOptions more = tuning.options;
  ++more.finalists;
  EXPECT_NE(TuneIdentity(tuning.study, more, "standard"), own);
  Study wider = tuning.study;
  wider.axes[0].high += 0.1;
  EXPECT_NE(TuneIdentity(wider, tuning.options, "standard"), own);
}

TEST(TunedOptionFiles, HoldTheChosenValuesAndSayWhetherTheyAreBetter) {
  const MadeUpTuning better = MakeUpTuning(MadeUpProof::kBetter), same = MakeUpTuning(MadeUpProof::kNoBetter),
                     first = MakeUpTuning(MadeUpProof::kNothingBefore);
  const YAML::Node chosen = YAML::Load(TunedOptions(better.study, better.report.result)),
                   kept = YAML::Load(TunedOptions(same.study, same.report.result));
  EXPECT_EQ(chosen.size(), 2U);
  EXPECT_EQ(chosen["gait.cycle_s"].as<double>(), 0.4);
  EXPECT_EQ(chosen["stabilised.dcm_gain"].as<double>(), 2.5);
  EXPECT_EQ(kept["gait.cycle_s"].as<double>(), 0.5) << "the usual values";
  const auto begins = [](const MadeUpTuning& tuning, const std::string& words) {
    return TunedOptions(tuning.study, tuning.report.result).starts_with(words);
  };
  EXPECT_TRUE(begins(better, "# Tuned; better"));
  EXPECT_TRUE(begins(same, "# Not better"));
  EXPECT_TRUE(begins(first, "# Tuned; the present values have no plan that passes its audit"));
}

}  // namespace
}  // namespace gaitwright
