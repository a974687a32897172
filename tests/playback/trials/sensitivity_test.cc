// SPDX-License-Identifier: BSD-3-Clause
#include "playback/trials/sensitivity.h"

#include <gtest/gtest.h>

#include <cmath>

#include "kinematics/base/result.h"
#include "playback/trials/distribution.h"

namespace gaitwright {
namespace {

TEST(RankTestTest, ExactForSmallGroups) {
  // All three of the first exceed all four of the second: 2 of C(7, 3) = 35 arrangements are as extreme.
  const RankTest all = CompareRanks({5, 6, 7}, {1, 2, 3, 4});
  EXPECT_EQ(all.effect, 1.0);
  EXPECT_NEAR(all.p, 2.0 / 35.0, 1e-12);
  EXPECT_NEAR(CompareRanks({1, 2, 3, 4}, {5, 6, 7}).p, 2.0 / 35.0, 1e-12);
  // U = 1: two arrangements are at most one swap away, on each side.
  EXPECT_NEAR(CompareRanks({4, 6, 7}, {1, 2, 3, 5}).p, 4.0 / 35.0, 1e-12);
  EXPECT_NEAR(CompareRanks({1, 4}, {2, 3}).p, 1.0, 1e-12);
  EXPECT_EQ(CompareRanks({}, {1.0}).p, 1.0);
}

TEST(RankTestTest, ApproximationMeetsTheExactOne) {
  std::vector<double> first, second;
  NamedRandom random(1, "x");
  for (int i = 0; i < 20; ++i) first.push_back(random.Uniform() + 0.25);
  for (int i = 0; i < 25; ++i) second.push_back(random.Uniform());
  const double exact = CompareRanks(first, second).p;
  second.push_back(second.back());  // one tie: uses the approximation
  const double near = CompareRanks(first, second).p;
  EXPECT_GT(exact, 0.0);
  EXPECT_NEAR(std::log(near / exact), 0.0, 0.35);
}

TEST(RankTestTest, ErrorsOfTheFirstKindAreAsRareAsPromised) {
  int sure = 0;
  constexpr int kTests = 2000;
  for (int t = 0; t < kTests; ++t) {
    NamedRandom random(static_cast<std::uint64_t>(t), "null");
    std::vector<double> first(8), second(32);
    for (double& x : first) x = random.Uniform();
    for (double& x : second) x = random.Uniform();
    sure += CompareRanks(first, second).p < 0.05 ? 1 : 0;
  }
  EXPECT_LT(sure, 0.06 * kTests);
  EXPECT_GT(sure, 0.03 * kTests);
}

/// Trials that fall according to `cause`.
struct Made {
  std::vector<SampledColumn> columns;
  std::vector<char> fell;
};

template <class Cause>
Made Make(int n, Cause cause) {
  Made made;
  made.columns = {{"mass", "1", {}}, {"friction", "1", {}}, {"shift", "m", {}}, {"place", "", {}, {}}};
  for (int i = 0; i < n; ++i) {
    NamedRandom random(static_cast<std::uint64_t>(i), "made");
    const double mass = random.Uniform(), friction = random.Uniform(), shift = random.Uniform() - 0.5;
    const std::string place = random.Uniform() < 0.5 ? "base" : "robot";
    made.columns[0].values.push_back(mass);
    made.columns[1].values.push_back(friction);
    made.columns[2].values.push_back(shift);
    made.columns[3].words.push_back(place);
    made.fell.push_back(cause(friction, shift, place, random.Uniform()) ? 1 : 0);
  }
  return made;
}

TEST(SensitivityTest, FindsAKnownCause) {
  const Made low = Make(60, [](double mu, double, const std::string&, double luck) { return mu + 0.2 * luck < 0.25; });
  const std::vector<Sensitivity> ranked = RankDisturbances(low.columns, low.fell);
  ASSERT_EQ(ranked.size(), 4U);
  EXPECT_EQ(ranked[0].name, "friction");
  EXPECT_EQ(ranked[0].how, "less");
  EXPECT_GT(ranked[0].effect, 0.8);
  EXPECT_LT(ranked[0].p, 1e-4);
  EXPECT_LT(ranked[0].weight, -1.0);
  EXPECT_LT(ranked[0].median_fell, ranked[0].median_survived);
  for (std::size_t i = 1; i < ranked.size(); ++i) {
    EXPECT_GT(ranked[i].p, 0.01) << ranked[i].name;
    EXPECT_LT(std::abs(ranked[i].weight), std::abs(ranked[0].weight));
  }
}

TEST(SensitivityTest, FindsACauseOnBothSidesAndOneOfWords) {
  const Made far = Make(80, [](double, double shift, const std::string&, double) { return std::abs(shift) > 0.4; });
  EXPECT_EQ(RankDisturbances(far.columns, far.fell)[0].name, "shift");
  EXPECT_EQ(RankDisturbances(far.columns, far.fell)[0].how, "far off");
  const Made word =
      Make(80, [](double, double, const std::string& place, double luck) { return place == "base" && luck < 0.7; });
  const Sensitivity first = RankDisturbances(word.columns, word.fell)[0];
  EXPECT_EQ(first.name, "place");
  EXPECT_EQ(first.how, "is base");
}

TEST(SensitivityTest, WithoutFallsOrDifferencesThereIsNothingToTell) {
  Made made = Make(20, [](double, double, const std::string&, double) { return false; });
  EXPECT_TRUE(RankDisturbances(made.columns, made.fell).empty());
  made.fell.assign(20, 1);
  EXPECT_TRUE(RankDisturbances(made.columns, made.fell).empty());
  made.fell[0] = 0;
  made.columns.push_back({"same", "1", std::vector<double>(20, 2.0)});
  EXPECT_EQ(RankDisturbances(made.columns, made.fell).size(), 4U);
  made.columns.back().values.pop_back();
  EXPECT_THROW(RankDisturbances(made.columns, made.fell), InvalidArgument);
}

}  // namespace
}  // namespace gaitwright
