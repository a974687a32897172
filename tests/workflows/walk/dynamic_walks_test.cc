// SPDX-License-Identifier: BSD-3-Clause
#include "tests/workflows/walk/dynamic_walks.h"

#include <gtest/gtest.h>

namespace gaitwright {
namespace {

TEST(DynamicWalks, A1Bounds) { ExpectToFly({"bound", 0.8, 1.0}); }

TEST(DynamicWalks, A1LeapsOverFourTenthsOfAMetre) { ExpectToFly(OneLeap("flat", 0.4)); }

TEST(DynamicWalks, A1JumpsOntoABlockOf15Centimetres) {
  ExpectToFly(OneLeap("block:height_m=0.15,start_m=0.31,length_m=2", 0.52));
}

TEST(DynamicWalks, A1JumpsDownFromABlockOf15Centimetres) {
  ExpectToFly(OneLeap("block:height_m=0.15,start_m=-1.5,length_m=1.72", 0.6));
}

}  // namespace
}  // namespace gaitwright
