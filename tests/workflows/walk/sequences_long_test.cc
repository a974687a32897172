// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "tests/workflows/walk/sequences.h"

namespace gaitwright {
namespace {

TEST(SequencesLong, A1TrotsStandsAndBounds) {
  ExpectToWalk("trot: speed=1.5, distance=1.5; stand: duration=1; bound: speed=0.8, distance=1.5", 3);
}

TEST(SequencesLong, A1GoesFromAFastTrotOverIntoABound) {
  ExpectToWalk("trot: speed=1.5, distance=1.5; bound: speed=0.8, distance=1.5", 2);
}

TEST(SequencesLong, A1GoesFromBoundingToTrottingToLeapingWithoutStopping) {
  ExpectToWalk("bound: speed=0.8, distance=1; trot: speed=0.5, distance=1; pronk: speed=0.4, distance=0.5", 3);
}

}  // namespace
}  // namespace gaitwright
