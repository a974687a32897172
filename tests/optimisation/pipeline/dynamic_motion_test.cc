// SPDX-License-Identifier: BSD-3-Clause
#include "optimisation/pipeline/dynamic_motion.h"

#include <gtest/gtest.h>

namespace gaitwright {
namespace {

Gait TrotOf(double duty_factor) { return {"trot", "", 0.6, {0.0, 0.5, 0.5, 0.0}, std::vector<double>(4, duty_factor)}; }

TEST(IsDynamic, AGaitIsWhereNoFootThatCarriesGoesOn) {
  const CentreOfMassOptions options;
  EXPECT_FALSE(IsDynamic(StandingGait(4), options));
  EXPECT_FALSE(IsDynamic(TrotOf(0.6), options));
  EXPECT_TRUE(IsDynamic(TrotOf(0.5), options));  // the pairs change at once
  EXPECT_TRUE(IsDynamic(TrotOf(0.4), options));  // flight
  EXPECT_TRUE(HasFlight(TrotOf(0.4)));
}

TEST(IsDynamic, WhatIsAskedForIs) {
  CentreOfMassOptions options;
  options.method = "rigid-body";
  EXPECT_TRUE(IsDynamic(TrotOf(0.6), options));
  EXPECT_TRUE(IsDynamic(ContactSchedule{}, options));
}

TEST(IsDynamic, AScheduleIsAsItsGait) {
  const CentreOfMassOptions options;
  const auto schedule = [](std::vector<FootSet> stances) {
    ContactSchedule made;
    for (std::size_t i = 0; i < stances.size(); ++i)
      made.phases.push_back({static_cast<double>(i), static_cast<double>(i) + 1.0, stances[i]});
    return made;
  };
  EXPECT_FALSE(IsDynamic(schedule({0b1111, 0b1001, 0b1111, 0b0110}), options));
  EXPECT_TRUE(IsDynamic(schedule({0b1111, 0b1001, 0b0110}), options));
  EXPECT_TRUE(IsDynamic(schedule({0b1111, 0, 0b1111}), options));
}

}  // namespace
}  // namespace gaitwright
