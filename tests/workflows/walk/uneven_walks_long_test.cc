// SPDX-License-Identifier: BSD-3-Clause
// Longer walks over uneven ground and around obstacles.
#include <gtest/gtest.h>

#include "tests/workflows/walk/uneven_walks.h"

namespace gaitwright {
namespace {

class LongUnevenWalks : public testing::TestWithParam<UnevenWalk> {};

TEST_P(LongUnevenWalks, PassWithFeetWhereTheyAreToBe) { ExpectToWalk(GetParam()); }

INSTANTIATE_TEST_SUITE_P(
    A1, LongUnevenWalks,
    testing::Values(UnevenWalk{"a1", "stairs:rise_m=0.07,tread_m=0.25,count=3", 4.0, 0.0, 0.0, "walk"},
                    UnevenWalk{"a1", "doorway", 0.0, 5.0, 0.0}, UnevenWalk{"a1", "maze", 0.0, 6.2, 0.0}));

INSTANTIATE_TEST_SUITE_P(Nao, LongUnevenWalks,
                         testing::Values(UnevenWalk{"nao", "stairs:rise_m=0.02,count=3", 2.0},
                                         UnevenWalk{"nao", "slope:angle_deg=5", 3.5},
                                         UnevenWalk{"nao", "doorway", 0.0, 1.5, 0.0},
                                         UnevenWalk{"nao", "maze:columns=1,rows=3", 0.0, 1.5, 0.0}));

}  // namespace
}  // namespace gaitwright
