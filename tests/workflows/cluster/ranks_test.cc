// SPDX-License-Identifier: BSD-3-Clause
// A process that was not started by an MPI launcher.
#include "workflows/cluster/ranks.h"

#include <gtest/gtest.h>

#include <vector>

namespace gaitwright {
namespace {

TEST(Ranks, AProcessOfItsOwnLeadsAlone) {
  const Ranks ranks = Ranks::Join();
  EXPECT_EQ(ranks.rank(), 0);
  EXPECT_EQ(ranks.count(), 1);
  EXPECT_TRUE(ranks.leads());
  const std::vector<Ranks> copies(2, ranks);
  for (const Ranks& copy : copies) EXPECT_EQ(copy.rank(), ranks.rank());
}

TEST(Ranks, AbortEndsTheProcessWithItsStatus) { EXPECT_EXIT(Ranks::Join().Abort(7), testing::ExitedWithCode(7), ""); }

TEST(Ranks, TheBuildWithMpiIsTheOneThatHasALauncher) {
#ifdef GAITWRIGHT_MPIRUN
  EXPECT_TRUE(BuiltWithMpi());
#else
  EXPECT_FALSE(BuiltWithMpi());
#endif
}

}  // namespace
}  // namespace gaitwright
