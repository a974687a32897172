// SPDX-License-Identifier: BSD-3-Clause
#include "workflows/exchange/knot_spline.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "kinematics/base/result.h"

namespace gaitwright {
namespace {

std::vector<double> UnevenTimes(int count) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> step(0.01, 0.05);
  std::vector<double> times = {0.3};
  while (static_cast<int>(times.size()) < count) times.push_back(times.back() + step(random));
  return times;
}

TEST(KnotSpline, IsExactForCubics) {
  const std::vector<double> times = UnevenTimes(12);
  std::vector<double> values;
  const auto cubic = [](double t) { return 1.0 + t * (2.0 + t * (-3.0 + 4.0 * t)); };
  for (const double t : times) values.push_back(cubic(t));
  const KnotSpline spline(times, values);
  for (double t = times.front(); t <= times.back(); t += 0.0031) {
    const Motion1 at = spline.At(t);
    EXPECT_NEAR(at.value, cubic(t), 1e-12);
    EXPECT_NEAR(at.rate, 2.0 - 6.0 * t + 12.0 * t * t, 1e-10);
    EXPECT_NEAR(at.acceleration, -6.0 + 24.0 * t, 1e-8);
  }
}

TEST(KnotSpline, FollowsASineAndItsDerivatives) {
  std::vector<double> times, values;
  for (int i = 0; i <= 200; ++i) times.push_back(0.005 * i), values.push_back(std::sin(20.0 * times.back()));
  const KnotSpline spline(times, values);
  for (double t = 0.05; t < 0.95; t += 0.0017) {
    const Motion1 at = spline.At(t);
    EXPECT_NEAR(at.rate, 20.0 * std::cos(20.0 * t), 1e-3);
    EXPECT_NEAR(at.acceleration, -400.0 * std::sin(20.0 * t), 0.5);
  }
}

TEST(KnotSpline, FewKnotsMakeALineOrAParabola) {
  EXPECT_NEAR(KnotSpline({0.0, 2.0}, {1.0, 5.0}).At(1.5).value, 4.0, 1e-12);
  const KnotSpline parabola({0.0, 1.0, 3.0}, {0.0, 1.0, 9.0});
  EXPECT_NEAR(parabola.At(2.0).value, 4.0, 1e-12);
  EXPECT_NEAR(parabola.At(2.0).acceleration, 2.0, 1e-12);
}

TEST(KnotSpline, RefusesWhatIsNoCurve) {
  EXPECT_THROW(KnotSpline({0.0}, {1.0}), InvalidArgument);
  EXPECT_THROW(KnotSpline({0.0, 0.0}, {1.0, 2.0}), InvalidArgument);
  EXPECT_THROW(KnotSpline({0.0, 1.0}, {1.0}), InvalidArgument);
  EXPECT_THROW((void)Smoothed({0.0, 1.0, 2.0}, {1.0, 2.0, 1.0}, 0.0), InvalidArgument);
}

TEST(Smoothing, PassesWhatIsSlowAndTakesOutWhatIsFast) {
  std::vector<double> times, slow, fast;
  for (int i = 0; i <= 1000; ++i) {
    times.push_back(0.005 * i);
    slow.push_back(std::sin(2.0 * M_PI * 1.0 * times.back()));
    fast.push_back(std::sin(2.0 * M_PI * 60.0 * times.back()));
  }
  const std::vector<double> kept = Smoothed(times, slow, 10.0), gone = Smoothed(times, fast, 10.0);
  for (std::size_t i = 100; i < 900; ++i) {
    EXPECT_NEAR(kept[i], slow[i], 2e-4);
    EXPECT_LT(std::abs(gone[i]), 1e-2);
  }
}

TEST(Smoothing, HalvesWhatIsAtItsFrequency) {
  std::vector<double> times, values;
  for (int i = 0; i <= 4000; ++i)
    times.push_back(0.001 * i), values.push_back(std::sin(2.0 * M_PI * 8.0 * times.back()));
  const std::vector<double> smooth = Smoothed(times, values, 8.0);
  for (std::size_t i = 1000; i < 3000; ++i) EXPECT_NEAR(smooth[i], 0.5 * values[i], 0.01);
}

TEST(NoiseOf, FindsTheNoiseUnderAMotion) {
  std::mt19937 random(3);
  std::normal_distribution<double> noise(0.0, 1e-3);
  std::vector<double> clean, noisy;
  for (int i = 0; i < 2000; ++i) {
    clean.push_back(std::sin(0.03 * i));
    noisy.push_back(clean.back() + noise(random));
  }
  EXPECT_LT(NoiseOf(clean), 1e-6);
  EXPECT_NEAR(NoiseOf(noisy), 1e-3, 1e-4);
  EXPECT_EQ(NoiseOf({1.0, 2.0}), 0.0);
}

}  // namespace
}  // namespace gaitwright
