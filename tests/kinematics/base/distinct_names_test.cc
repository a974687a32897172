// SPDX-License-Identifier: BSD-3-Clause
#include "kinematics/base/distinct_names.h"

#include <gtest/gtest.h>

namespace gaitwright {
namespace {

using Names = std::vector<std::string>;

TEST(DistinctNames, AreKeptWhereTheyDiffer) {
  EXPECT_EQ(DistinctNames({}, " "), Names{});
  EXPECT_EQ(DistinctNames({"a", "b", ""}, " "), (Names{"a", "b", ""}));
}

TEST(DistinctNames, GetANumberWhereTheyAreTheSame) {
  EXPECT_EQ(DistinctNames({"stone", "stone", "wall", "stone"}, " "), (Names{"stone", "stone 2", "wall", "stone 3"}));
  EXPECT_EQ(DistinctNames({"a", "a", "a_2"}, "_"), (Names{"a", "a_3", "a_2"})) << "a name that is there is not made";
  EXPECT_EQ(DistinctNames({"", ""}, "_"), (Names{"", "_2"}));
}

}  // namespace
}  // namespace gaitwright
