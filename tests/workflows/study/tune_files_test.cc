// SPDX-License-Identifier: BSD-3-Clause
#include "workflows/study/tune_files.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/workflows/study/made_up_sweep.h"
#include "tests/workflows/study/made_up_tuning.h"

namespace gaitwright {
namespace {

using Json = nlohmann::ordered_json;

Json JsonOfTuning(MadeUpProof proof, const WrittenFiles& files = {}) {
  const MadeUpTuning tuning = MakeUpTuning(proof);
  return Json::parse(TuneJson(tuning.study, tuning.report, tuning.options, files));
}

std::string VerdictWith(MadeUpProof proof) { return VerdictOf(MakeUpTuning(proof).report.result); }

TEST(TuneFiles, TheVerdictSaysWhetherItIsBetterAndByHowMuch) {
  EXPECT_EQ(VerdictWith(MadeUpProof::kBetter),
            "better: 70.00 to 120.00 on 40 held-out trials, difference 50.00 (95 % interval 30.00 to 70.00)");
  EXPECT_EQ(VerdictWith(MadeUpProof::kNoBetter),
            "no better: 70.00 to 71.00 on 40 held-out trials, difference 1.00 (95 % interval -4.00 to 6.00); the "
            "present values are kept");
  EXPECT_EQ(VerdictWith(MadeUpProof::kNone).substr(0, 9), "no better");
  const std::string nothing_before = VerdictWith(MadeUpProof::kNothingBefore);
  EXPECT_EQ(nothing_before.substr(0, 6), "better");
  EXPECT_NE(nothing_before.find("the cycle <is> too short"), std::string::npos);
  EXPECT_EQ(nothing_before.find("70.00"), std::string::npos) << "nothing is compared with";
}

TEST(TuneFiles, JsonHasTheChosenValuesAsNumbers) {
  const Json better = JsonOfTuning(MadeUpProof::kBetter), same = JsonOfTuning(MadeUpProof::kNoBetter);
  EXPECT_EQ(better.at("better"), true);
  EXPECT_EQ(better.at("usual"), Json::parse(R"({"gait.cycle_s": 0.5, "stabilised.dcm_gain": 1.5})"));
  EXPECT_EQ(better.at("options"), Json::parse(R"({"gait.cycle_s": 0.4, "stabilised.dcm_gain": 2.5})"));
  EXPECT_EQ(same.at("better"), false);
  EXPECT_EQ(same.at("options"), same.at("usual")) << "the usual values are kept";
  EXPECT_EQ(same.at("favourite").at("candidate"), 1);
  EXPECT_EQ(better.at("axes")[0], Json::parse(R"({"key": "gait.cycle_s", "unit": "s", "from": 0.3, "to": 0.6})"));
}

TEST(TuneFiles, ARefusedCandidateHasItsReasonAndNoFigures) {
  const Json candidates = JsonOfTuning(MadeUpProof::kBetter).at("candidates");
  ASSERT_EQ(candidates.size(), 3U);
  EXPECT_EQ(candidates[0].at("score_mean"), 50.0);
  EXPECT_EQ(candidates[0].at("survived"), 1);
  EXPECT_EQ(candidates[0].at("refusal"), "");
  EXPECT_EQ(candidates[2].at("refusal"), "the knee, \"FL_calf\", is <weak>");
  for (const char* key : {"value", "score_mean", "survived"}) EXPECT_TRUE(candidates[2].at(key).is_null()) << key;
}

TEST(TuneFiles, WithoutAProofOrWithNothingBeforeFiguresAreNull) {
  EXPECT_TRUE(JsonOfTuning(MadeUpProof::kNone).at("held_out").is_null());
  const Json alone = JsonOfTuning(MadeUpProof::kNothingBefore).at("held_out");
  EXPECT_EQ(alone.at("no_before"), "the cycle <is> too short");
  for (const char* key : {"before", "difference", "low", "high"})
    EXPECT_TRUE(alone.at("value").at(key).is_null()) << key;
  EXPECT_EQ(alone.at("value").at("after"), 120.0);
  EXPECT_EQ(JsonOfTuning(MadeUpProof::kBetter).at("held_out").at("survival").at("low"), 0.25);
}

TEST(TuneFiles, MetricsHaveBothWalksAndNullWhereOneHasNone) {
  const Json metrics = JsonOfTuning(MadeUpProof::kBetter).at("metrics");
  EXPECT_EQ(metrics.at("goal_error_m"), Json::parse(R"({"before": 0.25, "after": 0.125})"));
  EXPECT_TRUE(metrics.at("zmp_margin_p05_m").at("before").is_null());
}

TEST(TuneFiles, WrittenFilesAreNamedByKind) {
  const Json files = JsonOfTuning(MadeUpProof::kBetter, {{"options", "a.yaml"}, {"page", "b.html"}}).at("files");
  EXPECT_EQ(files, Json::parse(R"({"options": "a.yaml", "page": "b.html"})"));
}

TEST(TuneFiles, TheTextCountsCandidatesAndShowsEachOptionBeforeAndAfter) {
  const MadeUpTuning tuning = MakeUpTuning(MadeUpProof::kBetter);
  const std::string text = TuneText(tuning.study, tuning.report, tuning.options);
  EXPECT_NE(text.find("3 candidates, 1 of them refused, 2 trials each\n"), std::string::npos) << text;
  EXPECT_EQ(CountOf(text, " -> "), 4) << "two options, score and survival";
  EXPECT_NE(text.find("50.0 % -> 100.0 %"), std::string::npos) << text;
  const MadeUpTuning none = MakeUpTuning(MadeUpProof::kNone);
  EXPECT_EQ(CountOf(TuneText(none.study, none.report, none.options), "held-out score"), 0);
}

}  // namespace
}  // namespace gaitwright
