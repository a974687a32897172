// SPDX-License-Identifier: BSD-3-Clause
#include "examples/trials.h"

#include <gtest/gtest.h>

#include "kinematics/base/file.h"
#include "kinematics/base/result.h"
#include "tests/built_paths.h"
#include "tests/scratch_folder.h"

namespace gaitwright::examples {
namespace {

const std::string kHobby = SourceFolder() + "/examples/disturbances/a1_hobby.yaml";

/// The ends of Wilson's interval are the shares p from which the one that was found is just as far off as chance takes
/// it: (share - p)^2 = z^2 p (1 - p) / n.
void ExpectWilson(const ShareInterval& survival, int n) {
  constexpr double kZ = 1.959964;
  for (const double p : {survival.low, survival.high}) {
    EXPECT_NEAR((survival.share - p) * (survival.share - p), kZ * kZ * p * (1.0 - p) / n, 1e-7);
  }
}

TEST(TrialsExample, TheWorstTrialIsRepeatedFromItsSeed) {
  const TriedWalk few = TryWalk("a1", kHobby, 2, 1), more = TryWalk("a1", kHobby, 4, 1);
  for (const TriedWalk& tried : {few, more}) {
    EXPECT_EQ(tried.repeated.log_hash, tried.worst.log_hash);
    EXPECT_EQ(tried.repeated.seed, tried.worst.seed);
    EXPECT_EQ(tried.report.different, tried.report.n) << "each trial is another playback";
    ExpectWilson(tried.report.survival, tried.report.n);
    for (const TrialOutcome& outcome : tried.report.outcomes) EXPECT_GE(outcome.score, tried.worst.score);
  }
  ASSERT_EQ(more.report.n, 4);
  for (int i = 0; i < few.report.n; ++i)
    EXPECT_EQ(few.report.Outcome(i).log_hash, more.report.Outcome(i).log_hash)
        << "a longer study begins with the same trials";
}

TEST(TrialsExample, AMisspeltDisturbanceIsNamed) {
  const std::string file = ScratchFile("misspelt.yaml");
  ASSERT_TRUE(WriteFileAtomically(file, "mas_scale: 1.1\n"));
  try {
    TryWalk("a1", file, 1, 1);
    ADD_FAILURE();
  } catch (const InvalidArgument& error) {
    EXPECT_NE(std::string(error.what()).find("mass_scale"), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace gaitwright::examples
