// SPDX-License-Identifier: BSD-3-Clause
#include "workflows/cluster/shared_trials.h"

#include <gtest/gtest.h>

#include "tests/playback/trials/made_outcomes.h"

namespace gaitwright {
namespace {

TEST(SharedTrials, AnOutcomeComesBackAsItWas) {
  for (const TrialOutcome& outcome : made::Outcomes(20, 25.0))
    EXPECT_EQ(TrialOfAnswer(AnswerOf(outcome)).value(), outcome);
}

TEST(SharedTrials, AFailureComesBackWithItsCodeAndHints) {
  for (const FailureKind kind : {FailureKind::kBadInput, FailureKind::kInfeasible}) {
    const Failure failure{
        kind, FailureCode::kLatePush, "Play", "the push begins at 5 s\nand \"late\"", {"push earlier", "or not"}};
    const Result<TrialOutcome> again = TrialOfAnswer(AnswerOf(failure));
    ASSERT_FALSE(again.ok());
    EXPECT_EQ(again.failure(), failure);
  }
}

TEST(SharedTrials, AnythingElseIsRefused) {
  for (const char* text : {"", "{}", "{\"failure\":", "{\"failure\":{\"code\":\"x\"}}", "{\"failure\":3}"})
    EXPECT_THROW((void)TrialOfAnswer(text), InvalidArgument) << text;
}

}  // namespace
}  // namespace gaitwright
