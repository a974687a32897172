// SPDX-License-Identifier: BSD-3-Clause
#include "workflows/study/candidate_worth.h"

#include <gtest/gtest.h>

#include <cmath>

#include "kinematics/base/random.h"

namespace gaitwright {
namespace {

TEST(CandidateWorth, ValueIsScoreAndSurvival) {
  const CandidateWorth worth{"", {{80.0, true}, {10.0, false}}};
  EXPECT_DOUBLE_EQ(*MeanValue(worth, 50.0), 70.0);
  EXPECT_DOUBLE_EQ(*MeanValue(worth, 0.0), 45.0);
  EXPECT_EQ(MeanValue({"too fast", {}}, 50.0), std::nullopt);
}

TEST(CandidateWorth, ALineReadsBackToTheBit) {
  const CandidateWorth worth{"", {{1.0 / 3.0, true}, {1e-17, false}}}, refused{"the knee \"bends\"\ntoo far", {}};
  EXPECT_EQ(*WorthFromLine(WorthToLine(worth)), worth);
  EXPECT_EQ(*WorthFromLine(WorthToLine(refused)), refused);
  EXPECT_EQ(WorthToLine(refused).find('\n'), std::string::npos);
  EXPECT_FALSE(WorthFromLine("{\"refusal\": 3"));
  EXPECT_FALSE(WorthFromLine(R"({"refusal": "too fast", "trials": [[90.0, true]]})")) << "no trials without a plan";
  EXPECT_FALSE(WorthFromLine(R"({"refusal": "", "trials": [[1e308, true], [1e308, true]]})")) << "no finite mean";
}

TEST(PairedDifference, IsThatOfTheBook) {
  // Differences 1 .. 10: mean 5.5, standard deviation 3.02765, t(9) = 2.262157.
  std::vector<double> before(10, 100.0), after;
  for (int i = 1; i <= 10; ++i) after.push_back(100.0 + i);
  const PairedDifference d = DifferenceOf(before, after);
  EXPECT_NEAR(d.mean, 5.5, 1e-12);
  EXPECT_NEAR(d.high - d.mean, 2.262157 * 3.0276504 / std::sqrt(10.0), 2e-3);
  EXPECT_NEAR(d.mean - d.low, d.high - d.mean, 1e-12);
  EXPECT_TRUE(d.better());
  EXPECT_FALSE(DifferenceOf(after, before).better());
  const std::vector<double> ones(150, 1.0);
  EXPECT_EQ(DifferenceOf(ones, ones).before, 1.0) << "a share of all is not above one";
}

TEST(PairedDifference, PairingSeesThroughWhatBothShare) {
  SplitMix random(1);
  std::vector<double> before, after;
  for (int i = 0; i < 50; ++i) {
    before.push_back(30.0 * random.Normal());
    after.push_back(before.back() + 1.0 + 0.5 * random.Normal());
  }
  EXPECT_TRUE(DifferenceOf(before, after).better()) << "a step of 1 under common noise of 30";
}

TEST(PairedDifference, NoiseAloneIsSeldomBetter) {
  SplitMix random(2);
  int better = 0;
  for (int experiment = 0; experiment < 2000; ++experiment) {
    std::vector<double> before, after;
    for (int i = 0; i < 20; ++i) {
      before.push_back(random.Normal());
      after.push_back(random.Normal());
    }
    better += DifferenceOf(before, after).better() ? 1 : 0;
  }
  EXPECT_NEAR(better, 0.025 * 2000, 25) << "one end of a 95 % interval";
}

/// Pairs with these counts: true in both, only after, only before, in neither.
PairedDifference Shares(int both, int after, int before, int neither) {
  std::vector<double> first, second;
  const auto add = [&](int count, double was, double is) {
    first.insert(first.end(), static_cast<std::size_t>(count), was);
    second.insert(second.end(), static_cast<std::size_t>(count), is);
  };
  add(both, 1.0, 1.0);
  add(after, 0.0, 1.0);
  add(before, 1.0, 0.0);
  add(neither, 0.0, 0.0);
  return DifferenceOfShares(first, second);
}

TEST(PairedDifference, OfSharesIsNewcombes) {
  const PairedDifference table = Shares(36, 12, 2, 0);  // from Newcombe's table II
  EXPECT_NEAR(table.mean, 0.2, 1e-12);
  EXPECT_NEAR(table.low, 0.0569, 5e-5);
  EXPECT_NEAR(table.high, 0.3404, 5e-5);
  const PairedDifference bentur = Shares(1, 1, 7, 12);  // Fagerland, Lydersen, Laake, Stat. Med. 33(16), 2014
  EXPECT_NEAR(bentur.low, -0.507, 5e-4);
  EXPECT_NEAR(bentur.high, -0.026, 5e-4);
}

TEST(PairedDifference, OfSharesHasAWidthWhereAllAreAlike) {
  const PairedDifference all = Shares(100, 0, 0, 0);
  EXPECT_EQ(all.before, 1.0);
  EXPECT_EQ(all.mean, 0.0);
  EXPECT_NEAR(all.low, -0.037, 1e-3);
  EXPECT_EQ(all.high, -all.low);
  const PairedDifference turned = Shares(0, 100, 0, 0);
  EXPECT_EQ(turned.high, 1.0);
  EXPECT_TRUE(turned.better());
  EXPECT_LT(turned.low, 1.0);
}

/// Exchanging before and after changes only the sign.
TEST(PairedDifference, OfSharesIsFair) {
  for (const auto& [both, after, before, neither] : {std::tuple(30, 8, 3, 9), {0, 4, 4, 2}, {20, 20, 0, 20}}) {
    const PairedDifference there = Shares(both, after, before, neither), back = Shares(both, before, after, neither);
    EXPECT_NEAR(there.low, -back.high, 1e-12);
    EXPECT_NEAR(there.high, -back.low, 1e-12);
  }
}

TEST(PairedDifference, TooFewOrUnlikePairsAreRefused) {
  EXPECT_THROW(DifferenceOfShares({1, 0, 1, 1, 1}, {1, 0, 1, 1, 1}), InvalidArgument);
  EXPECT_THROW(DifferenceOfShares({1, 0, 1, 1, 1, 0.5}, {1, 0, 1, 1, 1, 1}), InvalidArgument);
  EXPECT_THROW(DifferenceOf({1, 2, 3, 4, 5}, {1, 2, 3, 4, 5}), InvalidArgument);
  EXPECT_THROW(DifferenceOf({1, 2, 3, 4, 5, 6}, {1, 2, 3, 4, 5}), InvalidArgument);
}

}  // namespace
}  // namespace gaitwright
