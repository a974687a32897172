// SPDX-License-Identifier: BSD-3-Clause
// The JSON of studies has the shapes of the schemas.
#include <gtest/gtest.h>

#include "tests/workflows/formats/fits_shape.h"
#include "tests/workflows/study/made_up_sweep.h"
#include "tests/workflows/study/made_up_tuning.h"
#include "workflows/formats/result_shapes_internal.h"
#include "workflows/study/sweep_files.h"
#include "workflows/study/tune_files.h"

namespace gaitwright {
namespace {

using Json = nlohmann::ordered_json;

Json SweepObject(int trials) {
  const MadeUpSweep sweep = MakeUpSweep({"speed=0.3:0.7:5", "play.push_on=base,robot"}, trials);
  return Json::parse(SweepJson(sweep.study, sweep.outcomes, {}));
}

TEST(StudyShapes, ASweepHasTheShapeOfItsResult) {
  for (const int trials : {0, 8}) EXPECT_EQ(Misfit(SweepObject(trials), SweepResultShape()), "") << trials;
}

Json TuningObject(MadeUpProof proof) {
  const MadeUpTuning tuning = MakeUpTuning(proof);
  return Json::parse(TuneJson(tuning.study, tuning.report, tuning.options, {}));
}

TEST(StudyShapes, ATuningHasTheShapeOfItsResultHoweverItEnded) {
  for (const MadeUpProof proof :
       {MadeUpProof::kBetter, MadeUpProof::kNoBetter, MadeUpProof::kNone, MadeUpProof::kNothingBefore})
    EXPECT_EQ(Misfit(TuningObject(proof), TuneResultShape()), "") << static_cast<int>(proof);
}

/// Tests the check itself: it finds a missing key, an extra key, and a value of another type.
TEST(StudyShapes, AnObjectThatIsSpoiltDoesNotFit) {
  Json tuning = TuningObject(MadeUpProof::kBetter);
  EXPECT_EQ(Misfit(Without(tuning, "verdict"), TuneResultShape()), "$ lacks verdict");
  tuning["colour"] = 1;
  EXPECT_EQ(Misfit(tuning, TuneResultShape()), "$ has an unknown key colour");
  tuning.erase("colour");
  tuning["better"] = "yes";
  EXPECT_EQ(Misfit(tuning, TuneResultShape()), "$.better is no truth value");
}

}  // namespace
}  // namespace gaitwright
