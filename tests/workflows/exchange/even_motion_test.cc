// SPDX-License-Identifier: BSD-3-Clause
#include "workflows/exchange/even_motion.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "kinematics/base/non_finite.h"
#include "kinematics/base/result.h"
#include "kinematics/spatial/rotation.h"
#include "tests/playback/synthetic.h"

namespace gaitwright {
namespace {

std::vector<double> TimesEvery(double step_s, int count, double start_s = 0.0) {
  std::vector<double> times;
  for (int k = 0; k < count; ++k) times.push_back(start_s + step_s * k);
  return times;
}

/// A biped whose base and joints follow cubics, which splines reproduce exactly.
double CubicAt(int i, double t) { return 0.1 * i + (0.2 - 0.1 * i) * t + 0.5 * i * t * t - 0.3 * t * t * t; }
double CubicRate(int i, double t) { return (0.2 - 0.1 * i) + i * t - 0.9 * t * t; }
double CubicAcceleration(int i, double t) { return i - 1.8 * t; }

MotionTable CubicTable(const std::vector<double>& time_s) {
  MotionTable table;
  table.format = MotionFormat::kCsv;
  table.time_s = time_s;
  for (const double t : time_s) {
    VectorX q(6);
    for (int d = 0; d < 6; ++d) q[d] = CubicAt(d, t);
    table.base_m.emplace_back(CubicAt(1, t), CubicAt(2, t), CubicAt(3, t));
    table.quaternion.emplace_back(0.0, 0.0, 0.0, 1.0);
    table.q.push_back(q);
  }
  return table;
}

/// A motion with its notes and warnings.
struct ResampledTable {
  EvenMotion motion;
  std::vector<DerivedPart> derived;
  std::vector<std::string> warnings;

  bool IsDerived(const std::string& what) const {
    return std::any_of(derived.begin(), derived.end(), [&](const DerivedPart& part) { return part.what == what; });
  }
};

ResampledTable ResampledBiped(const MotionTable& table, const ImportOptions& options = {}) {
  ResampledTable result;
  result.motion = Resample(synthetic::Robot(2, FootType::kSphere), table, options, result.derived, result.warnings);
  return result;
}

TEST(EvenMotion, TheGridIsTheFilesOwnWhereItsStepsAreAlike) {
  EXPECT_DOUBLE_EQ(GridStepOf(TimesEvery(0.004, 100), {}), 0.004);
  EXPECT_DOUBLE_EQ(GridStepOf(TimesEvery(0.004, 100, 1.7e9), {}), 0.004) << "a clock since 1970 has few digits";
  EXPECT_DOUBLE_EQ(GridStepOf(TimesEvery(0.02, 100), {}), 0.005) << "too coarse";
  EXPECT_DOUBLE_EQ(GridStepOf(TimesEvery(0.0005, 100), {}), 0.005) << "too fine";
  EXPECT_DOUBLE_EQ(GridStepOf({0.0, 0.004, 0.009, 0.012, 0.02}, {}), 0.005) << "uneven";
  EXPECT_DOUBLE_EQ(GridStepOf({0.0}, {}), 0.005);
  std::vector<double> short_end = TimesEvery(0.004, 100);
  short_end.push_back(short_end.back() + 0.001);
  EXPECT_DOUBLE_EQ(GridStepOf(short_end, {}), 0.004);
  ImportOptions options;
  options.grid_step_s = 0.002;
  EXPECT_DOUBLE_EQ(GridStepOf(TimesEvery(0.004, 100), options), 0.002);
}

TEST(EvenMotion, CubicsAreReproducedWithTheirDerivativesBetweenUnevenRows) {
  const ResampledTable result = ResampledBiped(CubicTable({0.0, 0.013, 0.02, 0.041, 0.05, 0.067, 0.08, 0.1}));
  const EvenMotion& motion = result.motion;
  EXPECT_EQ(motion.step_s, 0.005);
  ASSERT_EQ(motion.size(), 21);
  for (int k = 0; k < motion.size(); ++k) {
    const auto row = static_cast<std::size_t>(k);
    const double t = motion.TimeOf(k);
    for (int d = 0; d < 6; ++d) {
      EXPECT_NEAR(motion.q[row][7 + d], CubicAt(d, t), 1e-10);
      EXPECT_NEAR(motion.v[row][6 + d], CubicRate(d, t), 1e-8);
      EXPECT_NEAR(motion.a[row][6 + d], CubicAcceleration(d, t), 1e-5);
    }
    EXPECT_NEAR(motion.q[row][1], CubicAt(2, t), 1e-10);
    EXPECT_NEAR(motion.v[row][1], CubicRate(2, t), 1e-8);
  }
  EXPECT_TRUE(result.IsDerived("rows"));
  EXPECT_TRUE(result.IsDerived("joint velocities"));
}

TEST(EvenMotion, RowsOnTheGridAreKeptAndTimeBeginsAtZero) {
  const MotionTable table = CubicTable(TimesEvery(0.005, 30, 12.5));
  const ResampledTable result = ResampledBiped(table);
  ASSERT_EQ(result.motion.size(), 30);
  for (std::size_t k = 0; k < 30; ++k) EXPECT_LT((result.motion.q[k].tail(6) - table.q[k]).norm(), 1e-9);
  EXPECT_TRUE(result.IsDerived("time"));
  EXPECT_FALSE(result.IsDerived("rows"));
  EXPECT_FALSE(ResampledBiped(CubicTable(TimesEvery(0.005, 30))).IsDerived("time"));
}

TEST(EvenMotion, AShortLastStepIsLeftOutAndSaid) {
  std::vector<double> times = TimesEvery(0.005, 20);
  times.push_back(times.back() + 0.002);
  const ResampledTable result = ResampledBiped(CubicTable(times));
  EXPECT_EQ(result.motion.size(), 20);
  EXPECT_TRUE(result.IsDerived("end"));
}

/// The angular velocity does not depend on the signs of the quaternions.
TEST(EvenMotion, AngularVelocityIsThatOfTheRotations) {
  MotionTable table = CubicTable(TimesEvery(0.005, 60));
  const auto turn = [](double t) -> Matrix3 {
    return RotationExp(Vector3(0.3 * std::sin(3.0 * t), 0.5 * t, -0.2 * t)) * RotationExp(Vector3(0.0, 0.0, 1.0));
  };
  for (std::size_t k = 0; k < table.time_s.size(); ++k) {
    table.quaternion[k] = Quaternion(turn(table.time_s[k])).coeffs();
    if (k % 3 == 0) table.quaternion[k] *= -2.0;  // sign and length of a quaternion must not matter
  }
  const EvenMotion motion = ResampledBiped(table).motion;
  for (int k = 5; k < motion.size() - 5; ++k) {
    const auto row = static_cast<std::size_t>(k);
    constexpr double kDelta = 1e-4;
    const double t = motion.TimeOf(k);
    const auto rate = [&](double at) -> Vector3 {
      return RotationLog(turn(at + kDelta) * turn(at - kDelta).transpose()) / (2.0 * kDelta);
    };
    EXPECT_NEAR(motion.q[row].segment<4>(3).norm(), 1.0, 1e-12);
    EXPECT_LT((motion.v[row].segment<3>(3) - rate(t)).norm(), 1e-5) << k;
    EXPECT_LT((motion.a[row].segment<3>(3) - (rate(t + kDelta) - rate(t - kDelta)) / (2.0 * kDelta)).norm(), 1e-2) << k;
  }
}

TEST(EvenMotion, GivenVelocitiesAreMetAtTheRowsUnlessTheyAreNotWanted) {
  MotionTable table = CubicTable(TimesEvery(0.02, 10));
  for (const double t : table.time_s) {
    VectorX v(6);
    for (int d = 0; d < 6; ++d) v[d] = CubicRate(d, t) + 0.01;  // not exactly the derivatives of the positions
    table.v.push_back(v);
  }
  const ResampledTable given = ResampledBiped(table);
  ImportOptions options;
  options.velocities = "derived";
  const ResampledTable derived = ResampledBiped(table, options);
  for (int row = 0; row < table.rows(); ++row) {
    const auto k = static_cast<std::size_t>(4 * row);  // every 20 ms on a grid of 5 ms
    EXPECT_NEAR(given.motion.v[k][8], table.v[static_cast<std::size_t>(row)][2], 1e-9);
    EXPECT_NEAR(given.motion.q[k][9], table.q[static_cast<std::size_t>(row)][2], 1e-9);
    EXPECT_NEAR(derived.motion.v[k][8], CubicRate(2, table.time_s[static_cast<std::size_t>(row)]), 1e-8);
  }
  EXPECT_FALSE(given.IsDerived("joint velocities"));
  EXPECT_TRUE(derived.IsDerived("joint velocities"));
}

TEST(EvenMotion, VelocitiesThatAreNotOfThePositionsAreWarnedOf) {
  MotionTable table = CubicTable(TimesEvery(0.005, 40));
  for (std::size_t k = 0; k < 40; ++k) table.v.emplace_back(VectorX::Constant(6, 5.0));
  const ResampledTable result = ResampledBiped(table);
  const bool warned = std::any_of(result.warnings.begin(), result.warnings.end(), [](const std::string& warning) {
    return warning.find("velocities=derived") != std::string::npos;
  });
  EXPECT_TRUE(warned);
}

TEST(EvenMotion, ContactsHoldAndTorquesAreLinearBetweenRows) {
  MotionTable table = CubicTable({0.0, 0.02, 0.04});
  table.contact = {0b01, 0b10, 0b11};
  table.tau = {VectorX::Constant(6, 0.0), VectorX::Constant(6, 4.0), VectorX::Constant(6, kNaN)};
  table.force_W.assign(3, std::vector<Vector3>(2, Vector3::Zero()));
  table.force_W[1][1] = Vector3(0.0, 0.0, 8.0);
  const EvenMotion motion = ResampledBiped(table).motion;
  ASSERT_EQ(motion.size(), 9);
  EXPECT_EQ(motion.contact, (std::vector<FootSet>{0b01, 0b01, 0b01, 0b01, 0b10, 0b10, 0b10, 0b10, 0b11}));
  EXPECT_NEAR(motion.tau[1][0], 1.0, 1e-9);
  EXPECT_TRUE(std::isnan(motion.tau[6][0])) << "half of it is unknown";
  EXPECT_NEAR(motion.force_W[3][1].z(), 6.0, 1e-9);
  EXPECT_NEAR(motion.force_W[6][1].z(), 4.0, 1e-9);
}

TEST(EvenMotion, ALiftRaisesTheBaseAlone) {
  ImportOptions options;
  options.lift_m = 0.25;
  const MotionTable table = CubicTable(TimesEvery(0.005, 20));
  const EvenMotion as_is = ResampledBiped(table).motion, lifted = ResampledBiped(table, options).motion;
  for (std::size_t k = 0; k < as_is.q.size(); ++k)
    EXPECT_LT((lifted.q[k] - as_is.q[k] - 0.25 * VectorX::Unit(13, 2)).norm(), 1e-12);
}

TEST(EvenMotion, SmoothingTakesNoiseOutAndWithoutItNoiseIsWarnedOf) {
  MotionTable table = CubicTable(TimesEvery(0.005, 200));
  for (std::size_t k = 0; k < table.q.size(); ++k) table.q[k][0] += k % 2 == 0 ? 1e-3 : -1e-3;
  ImportOptions options;
  options.smoothing_hz = 10.0;
  const ResampledTable noisy = ResampledBiped(table), smooth = ResampledBiped(table, options);
  EXPECT_GT(std::abs(noisy.motion.a[100][6] - CubicAcceleration(0, 0.5)), 50.0);
  EXPECT_NEAR(smooth.motion.a[100][6], CubicAcceleration(0, 0.5), 1.0);
  EXPECT_FALSE(noisy.warnings.empty());
  EXPECT_TRUE(smooth.warnings.empty());
}

TEST(EvenMotion, OptionsOutOfRangeAndTooManyRowsAreRefused) {
  ImportOptions options;
  options.velocities = "guessed";
  EXPECT_THROW(ResampledBiped(CubicTable({0.0, 0.01, 0.02}), options), InvalidArgument);
  EXPECT_THROW(ResampledBiped(CubicTable({0.0, 0.01, 1e5})), InvalidArgument) << "20 million rows";
}

}  // namespace
}  // namespace gaitwright
