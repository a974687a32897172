// SPDX-License-Identifier: BSD-3-Clause
#include "playback/trials/distribution.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "kinematics/base/result.h"

namespace gaitwright {
namespace {

constexpr int kMany = 20000;

struct Moments {
  double mean = 0.0, std = 0.0, lowest = 1e300, highest = -1e300;
};

Moments MomentsOf(const Distribution& distribution) {
  Moments m;
  double squares = 0.0;
  for (int i = 0; i < kMany; ++i) {
    NamedRandom random(static_cast<std::uint64_t>(i), "figure");
    const double x = Draw(distribution, random);
    m.mean += x / kMany;
    squares += x * x / kMany;
    m.lowest = std::min(m.lowest, x);
    m.highest = std::max(m.highest, x);
  }
  m.std = std::sqrt(squares - m.mean * m.mean);
  return m;
}

TEST(DistributionTest, UniformIsEvenAndWithinItsEnds) {
  const Moments m = MomentsOf(Distribution::Uniform(-1.0, 3.0));
  EXPECT_NEAR(m.mean, 1.0, 0.03);
  EXPECT_NEAR(m.std, 4.0 / std::sqrt(12.0), 0.02);
  EXPECT_GE(m.lowest, -1.0);
  EXPECT_LT(m.lowest, -0.99);
  EXPECT_LE(m.highest, 3.0);
  EXPECT_GT(m.highest, 2.99);
}

TEST(DistributionTest, NormalHasItsMomentsAndIsCutNotPiledUp) {
  const Moments wide = MomentsOf(Distribution::Normal(2.0, 0.5, -10.0, 10.0));
  EXPECT_NEAR(wide.mean, 2.0, 0.015);
  EXPECT_NEAR(wide.std, 0.5, 0.01);
  // Cut to one standard deviation on both sides: variance 1 - 2 phi(1) / (2 Phi(1) - 1) = 0.2912.
  const Distribution cut = Distribution::Normal(2.0, 0.5, 1.5, 2.5);
  const Moments m = MomentsOf(cut);
  EXPECT_NEAR(m.std, 0.5 * std::sqrt(0.2912), 0.005);
  EXPECT_GE(m.lowest, 1.5);
  EXPECT_LE(m.highest, 2.5);
  int at_ends = 0;
  for (int i = 0; i < 1000; ++i) {
    NamedRandom random(static_cast<std::uint64_t>(i), "cut");
    const double x = Draw(cut, random);
    at_ends += x == 1.5 || x == 2.5 ? 1 : 0;
  }
  EXPECT_EQ(at_ends, 0);
}

TEST(DistributionTest, ChoicesComeAboutAsOften) {
  const Distribution numbers = Distribution::OneOf(std::vector<double>{1.0, 2.0, 5.0});
  const Distribution words = Distribution::OneOf(std::vector<std::string>{"base", "robot"});
  int twos = 0, bases = 0;
  for (int i = 0; i < kMany; ++i) {
    NamedRandom random(static_cast<std::uint64_t>(i), "choice");
    twos += Draw(numbers, random) == 2.0 ? 1 : 0;
    bases += DrawWord(words, random) == "base" ? 1 : 0;
  }
  EXPECT_NEAR(static_cast<double>(twos) / kMany, 1.0 / 3.0, 0.015);
  EXPECT_NEAR(static_cast<double>(bases) / kMany, 0.5, 0.015);
  NamedRandom random(1, "x");
  EXPECT_EQ(Draw(Distribution::Fixed(7.5), random), 7.5);
  EXPECT_THROW(Draw(words, random), InvalidArgument);
  EXPECT_THROW(DrawWord(numbers, random), InvalidArgument);
}

TEST(DistributionTest, WhatIsNoDistributionIsRefused) {
  EXPECT_THROW(Distribution::Uniform(1.0, 0.0), InvalidArgument);
  EXPECT_THROW(Distribution::Uniform(0.0, std::nan("")), InvalidArgument);
  EXPECT_THROW(Distribution::Normal(0.0, 0.0, -1.0, 1.0), InvalidArgument);
  EXPECT_THROW(Distribution::Normal(0.0, 1.0, 5.0, 6.0), InvalidArgument);
  EXPECT_THROW(Distribution::OneOf(std::vector<double>()), InvalidArgument);
  EXPECT_FALSE(Distribution::Fixed(1.0).varies());
  EXPECT_FALSE(Distribution::OneOf(std::vector<std::string>{"a", "a"}).varies());
  EXPECT_TRUE(Distribution::Uniform(0.0, 1.0).varies());
}

TEST(DistributionTest, NamesAndSeedsHaveStreamsOfTheirOwn) {
  NamedRandom a(3, "mass_scale"), again(3, "mass_scale"), other(3, "friction"), next(4, "mass_scale");
  const double first = a.Uniform();
  EXPECT_EQ(first, again.Uniform());
  EXPECT_NE(first, other.Uniform());
  EXPECT_NE(first, next.Uniform());
  // Neighbouring seeds are not correlated.
  double product = 0.0;
  for (int i = 0; i < kMany; ++i) {
    NamedRandom x(static_cast<std::uint64_t>(i), "n"), y(static_cast<std::uint64_t>(i) + 1, "n");
    product += (x.Uniform() - 0.5) * (y.Uniform() - 0.5) / kMany;
  }
  EXPECT_NEAR(12.0 * product, 0.0, 0.03);
}

TEST(DistributionTest, SeedsOfTrialsDifferAndFitTheFlag) {
  std::set<std::uint64_t> seen;
  for (int i = 0; i < kMany; ++i) seen.insert(SeedOfTrial(0, i));
  EXPECT_EQ(seen.size(), static_cast<std::size_t>(kMany));
  EXPECT_LT(*seen.rbegin(), 1ULL << 31);
  EXPECT_NE(SeedOfTrial(0, 0), SeedOfTrial(1, 0));
}

}  // namespace
}  // namespace gaitwright
