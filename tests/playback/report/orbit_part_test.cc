// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <string>

#include "playback/report/orbit_part_internal.h"

namespace gaitwright {
namespace {

std::size_t CountOf(const std::string& text, const std::string& part) {
  std::size_t count = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++count;
  return count;
}

TEST(OrbitPart, DrawsEveryMultiplierAndListsTheLargest) {
  OrbitStability orbit;
  orbit.cycles = 7;
  orbit.playbacks = 24;
  for (int i = 0; i < 8; ++i) orbit.multipliers.values.emplace_back(0.9 / (1.0 + i), 0.0);
  const std::string html = OrbitPart(orbit);
  EXPECT_NE(html.find("<h2>Orbit stability</h2>"), std::string::npos);
  EXPECT_NE(html.find("id=\"floquet_multipliers\""), std::string::npos);
  EXPECT_EQ(CountOf(html, "<tr><td"), 6U);
  EXPECT_GE(CountOf(html, "<circle"), 8U);
  EXPECT_NE(html.find("0.900"), std::string::npos);
}

TEST(OrbitPart, SaysWhyThereAreNoMultipliers) {
  OrbitStability orbit;
  orbit.missing = "the robot falls after a push < 1 N s";
  const std::string html = OrbitPart(orbit);
  EXPECT_NE(html.find("push &lt; 1 N s."), std::string::npos);
  EXPECT_EQ(html.find("<table"), std::string::npos);
}

}  // namespace
}  // namespace gaitwright
