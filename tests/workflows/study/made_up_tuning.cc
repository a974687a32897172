// SPDX-License-Identifier: BSD-3-Clause
#include "tests/workflows/study/made_up_tuning.h"

namespace gaitwright {

MadeUpTuning MakeUpTuning(MadeUpProof proof) {
  MadeUpTuning tuning;
  tuning.study.model.name = "a<1>";
  tuning.study.axes = ParseAxes({"gait.cycle_s=0.3:0.6", "stabilised.dcm_gain=1:3"}, StudyLayout::kTuning);
  tuning.options.trials = 2;
  TuneResult& result = tuning.report.result;
  result.candidates = {{{"0.5", "1.5"}, "usual", {"", {{60.0, true}, {40.0, false}}}, 75.0},
                       {{"0.4", "2.5"}, "surface", {"", {{80.0, true}, {70.0, true}}}, 125.0},
                       {{"0.3", "3"}, "sample", {"the knee, \"FL_calf\", is <weak>", {}}, std::nullopt}};
  tuning.report.metrics = {"goal_error_m", "zmp_margin_p05_m"};
  tuning.report.before.metrics = {0.25, std::nullopt};
  tuning.report.after.metrics = {0.125, std::nullopt};
  tuning.report.before.score = 50.0;
  tuning.report.after.score = 75.0;
  if (proof == MadeUpProof::kNone) return tuning;
  result.favourite = 1;
  result.finalists = {1, 0};
  result.proof.emplace();
  result.proof->trials = 40;
  result.proof->value = {70.0, 120.0, 50.0, 30.0, 70.0};
  result.proof->score = {45.0, 72.0, 27.0, 15.0, 39.0};
  result.proof->survival = {0.5, 1.0, 0.5, 0.25, 0.75};
  if (proof == MadeUpProof::kNoBetter) result.proof->value = {70.0, 71.0, 1.0, -4.0, 6.0};
  if (proof == MadeUpProof::kNothingBefore) result.proof->no_before = "the cycle <is> too short";
  if (proof != MadeUpProof::kNoBetter) result.chosen = 1;
  return tuning;
}

}  // namespace gaitwright
