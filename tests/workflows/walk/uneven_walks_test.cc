// SPDX-License-Identifier: BSD-3-Clause
#include "tests/workflows/walk/uneven_walks.h"

#include <gtest/gtest.h>

namespace gaitwright {
namespace {

class UnevenWalks : public testing::TestWithParam<UnevenWalk> {};

TEST_P(UnevenWalks, PassWithFeetWhereTheyAreToBe) { ExpectToWalk(GetParam()); }

INSTANTIATE_TEST_SUITE_P(A1, UnevenWalks,
                         testing::Values(UnevenWalk{"a1", "stairs:rise_m=0.07,tread_m=0.25,count=3", 4.0},
                                         UnevenWalk{"a1", "stairs:rise_m=0.1,tread_m=0.3,count=3", 4.0},
                                         UnevenWalk{"a1", "slope:angle_deg=15", 4.0},
                                         UnevenWalk{"a1", "block:height_m=0.1", 4.0},
                                         UnevenWalk{"a1", "gap:width_m=0.15", 4.0},
                                         UnevenWalk{"a1", "stepping-stones", 4.0},
                                         UnevenWalk{"a1", "rough:amplitude_m=0.03", 2.0}));

INSTANTIATE_TEST_SUITE_P(Nao, UnevenWalks,
                         testing::Values(UnevenWalk{"nao", "slope:angle_deg=5", 1.5},
                                         UnevenWalk{"nao", "rough:amplitude_m=0.005", 0.7},
                                         UnevenWalk{"nao", "rough:amplitude_m=0.005", 1.0},
                                         UnevenWalk{"nao", "stepping-stones", 1.0}));

}  // namespace
}  // namespace gaitwright
