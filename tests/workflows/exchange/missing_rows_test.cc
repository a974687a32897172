// SPDX-License-Identifier: BSD-3-Clause
#include "workflows/exchange/missing_rows.h"

#include <gtest/gtest.h>

#include <cmath>

namespace gaitwright {
namespace {

TEST(MissingRows, AreWhereAStepIsMuchLongerThanTheUsualOne) {
  EXPECT_EQ(LongestStep({0.0, 0.02, 0.04, 0.3}), 3.0 * 0.02);
  EXPECT_EQ(LongestStep({0.0, 0.001, 0.002, 0.003}), 0.03) << "a fast log may pause a little";
  EXPECT_EQ(LongestStep({0.0, 9.0}), INFINITY) << "of one step none is usual";
  const std::vector<double> even = {0.0, 0.2, 0.4, 0.6};
  EXPECT_TRUE(GapsOf(even, LongestStep(even)).empty()) << "few rows are not missing ones";
}

TEST(MissingRows, RowsAtTheEndsOfAGapAreInNone) {
  const std::vector<TimeGap> gaps = GapsOf({0.0, 0.01, 0.51, 0.52, 1.02, 1.03}, 0.03);
  ASSERT_EQ(gaps.size(), 2U);
  for (const double at_s : {-1.0, 0.0, 0.01, 0.51, 0.515, 0.52, 1.02, 2.0}) EXPECT_FALSE(InGap(gaps, at_s)) << at_s;
  for (const double at_s : {0.0101, 0.3, 0.5099, 0.53, 1.0199}) EXPECT_TRUE(InGap(gaps, at_s)) << at_s;
  EXPECT_FALSE(InGap({}, 0.3));
}

TEST(MissingRows, AreReportedByTheLongestGap) {
  EXPECT_EQ(MissingRowsText({0.0, 0.01, 0.02, 0.03}), "");
  EXPECT_EQ(MissingRowsText({0.0, 0.01, 0.02, 0.03, 1.03, 1.04}),
            "rows are missing: no row for 1 s after 0.03 s of the file; rows are usually 10 ms apart");
  EXPECT_EQ(MissingRowsText({0.0, 0.01, 0.02, 0.03, 0.33, 0.34, 0.35, 0.85, 0.86}),
            "rows are missing in 2 places, and this is the longest gap: no row for 0.5 s after 0.35 "
            "s of the file; rows are usually 10 ms apart");
}

}  // namespace
}  // namespace gaitwright
