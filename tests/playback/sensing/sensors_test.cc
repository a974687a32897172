// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "kinematics/base/result.h"
#include "kinematics/spatial/rotation.h"
#include "playback/sensing/contact_sensors.h"
#include "playback/sensing/encoders.h"
#include "playback/sensing/imu.h"
#include "playback/sensing/sample_clock.h"

namespace gaitwright {
namespace {

constexpr double kSensorStep = 0.001;

struct Statistics {
  double mean = 0.0, deviation = 0.0;
};

Statistics Of(const std::vector<double>& values) {
  Statistics s;
  for (const double x : values) s.mean += x / static_cast<double>(values.size());
  for (const double x : values) s.deviation += (x - s.mean) * (x - s.mean) / static_cast<double>(values.size());
  s.deviation = std::sqrt(s.deviation);
  return s;
}

/// Means of `count` consecutive values.
std::vector<double> Averaged(const std::vector<double>& values, std::size_t count) {
  std::vector<double> means;
  for (std::size_t i = 0; i + count <= values.size(); i += count) {
    double sum = 0.0;
    for (std::size_t k = 0; k < count; ++k) sum += values[i + k];
    means.push_back(sum / static_cast<double>(count));
  }
  return means;
}

VectorX AtRest() {
  VectorX q = VectorX::Zero(7);
  q[6] = 1.0;
  return q;
}

TEST(SampleClock, OfARateThatIsNextToNoneReadsOnce) {
  for (const double rate_hz : {1e-9, 1e-300}) {
    SampleClock clock(rate_hz, 1e-3);
    EXPECT_TRUE(clock.Tick());
    for (int i = 0; i < 10000; ++i) ASSERT_FALSE(clock.Tick()) << rate_hz;
  }
}

TEST(NoiseStream, HasTheMomentsOfItsDistributions) {
  NoiseStream noise(3, 1);
  std::vector<double> even, normal, fourth;
  for (int i = 0; i < 200000; ++i) {
    even.push_back(noise.Uniform());
    normal.push_back(noise.Normal());
    fourth.push_back(std::pow(normal.back(), 4));
    ASSERT_TRUE(even.back() >= 0.0 && even.back() < 1.0);
  }
  EXPECT_NEAR(Of(even).mean, 0.5, 0.003);
  EXPECT_NEAR(Of(even).deviation, std::sqrt(1.0 / 12.0), 0.003);
  EXPECT_NEAR(Of(normal).mean, 0.0, 0.01);
  EXPECT_NEAR(Of(normal).deviation, 1.0, 0.01);
  EXPECT_NEAR(Of(fourth).mean, 3.0, 0.15);
}

TEST(NoiseStream, IsTheSameForASeedAndAnotherForAnother) {
  NoiseStream a(3, 1), b(3, 1), other_seed(4, 1), other_stream(3, 2);
  double with_seed = 0.0, with_stream = 0.0;
  for (int i = 0; i < 10000; ++i) {
    const double x = a.Normal();
    ASSERT_EQ(x, b.Normal());
    with_seed += x * other_seed.Normal() / 10000;
    with_stream += x * other_stream.Normal() / 10000;
  }
  EXPECT_NEAR(with_seed, 0.0, 0.05);
  EXPECT_NEAR(with_stream, 0.0, 0.05);
}

TEST(DelayLine, HandsOutWhatWentInSoManyStepsAgo) {
  for (const double delay_s : {0.0, 0.001, 0.004, 0.0044, 0.1}) {
    DelayLine<int> line(DelaySteps(delay_s, kSensorStep));
    const int late = static_cast<int>(std::lround(delay_s / kSensorStep));
    for (int k = 0; k < 300; ++k) EXPECT_EQ(line.Push(k), std::max(0, k - late)) << delay_s;
    line.Reset();
    EXPECT_EQ(line.Push(1000), 1000);
  }
}

TEST(Encoders, PerfectOnesTellPositionsAndTheirDifferences) {
  Encoders encoders(2, {}, kSensorStep);
  for (int k = 0; k < 50; ++k) {
    const double t = k * kSensorStep;
    const Vector2 q(std::sin(20.0 * t), 0.3 * t);
    const JointReading& reading = encoders.Read(q);
    EXPECT_EQ(reading.q_raw, q);
    EXPECT_NEAR((reading.q - q).norm(), 0.0, 1e-15);
    const Vector2 before(std::sin(20.0 * (t - kSensorStep)), 0.3 * (t - kSensorStep));
    if (k > 0) {
      EXPECT_NEAR((reading.v - (q - before) / kSensorStep).norm(), 0.0, 1e-10);
    }
  }
}

TEST(Encoders, HaveTheNoiseBiasAndResolutionOfTheirSheet) {
  SensorOptions sheet;
  sheet.encoder_noise_rad = 2e-3;
  sheet.encoder_bias_rad = 0.01;
  std::vector<double> biases;
  for (int seed = 0; seed < 300; ++seed) {
    sheet.seed = seed;
    Encoders encoders(1, sheet, kSensorStep);
    std::vector<double> errors;
    for (int k = 0; k < 2000; ++k) errors.push_back(encoders.Read(VectorX::Constant(1, 0.7)).q_raw[0] - 0.7);
    EXPECT_NEAR(Of(errors).deviation, 2e-3, 2e-4);
    EXPECT_LE(std::abs(Of(errors).mean), 0.0102);
    biases.push_back(Of(errors).mean);
  }
  EXPECT_NEAR(Of(biases).mean, 0.0, 1.2e-3);
  EXPECT_NEAR(Of(biases).deviation, 0.01 / std::sqrt(3.0), 5e-4);
  SensorOptions coarse;
  coarse.encoder_resolution_rad = 0.01;
  Encoders steps(1, coarse, kSensorStep);
  for (int k = 0; k < 100; ++k) {
    const double q = 0.00123 * k, read = steps.Read(VectorX::Constant(1, q)).q_raw[0];
    EXPECT_LE(std::abs(read - q), 0.005 + 1e-12);
    EXPECT_NEAR(std::remainder(read, 0.01), 0.0, 1e-12);
  }
}

TEST(Encoders, AreReadAtTheirRateAndLate) {
  SensorOptions sheet;
  sheet.encoder_rate_hz = 200.0;
  sheet.encoder_delay_s = 0.003;
  Encoders encoders(1, sheet, kSensorStep);
  for (int k = 0; k < 100; ++k) {
    const JointReading& reading = encoders.Read(VectorX::Constant(1, k));
    const int then = std::max(0, k - 3);
    EXPECT_EQ(reading.q_raw[0], then / 5 * 5);
    if (k >= 3) {
      EXPECT_EQ(reading.is_fresh, then % 5 == 0) << k;
    }
  }
}

TEST(Encoders, SpeedsFollowWithoutErrorAndSmoothAsTheFilterSays) {
  SensorOptions sheet;
  sheet.speed_cutoff_hz = 40.0;
  Encoders clean(1, sheet, kSensorStep);
  JointReading reading;
  for (int k = 0; k < 500; ++k) reading = clean.Read(VectorX::Constant(1, 2.0 * k * kSensorStep));
  EXPECT_NEAR(reading.v[0], 2.0, 1e-6);
  EXPECT_NEAR(reading.q[0], 2.0 * 499 * kSensorStep, 1e-6);
  sheet.encoder_noise_rad = 1e-3;
  const auto noise_of = [](const SensorOptions& options) {
    Encoders noisy(1, options, kSensorStep);
    std::vector<double> speeds;
    for (int k = 0; k < 100000; ++k) speeds.push_back(noisy.Read(VectorX::Zero(1)).v[0]);
    return Of(speeds).deviation;
  };
  const double w = 2.0 * std::numbers::pi * 40.0;
  EXPECT_NEAR(noise_of(sheet) / (1e-3 * std::sqrt(kSensorStep * w * w * w) / 2.0), 1.0, 0.25);
  sheet.speed_cutoff_hz = 0.0;
  EXPECT_NEAR(noise_of(sheet), std::sqrt(2.0) * 1e-3 / kSensorStep, 0.02);
}

TEST(Imu, APerfectOneTellsRateAndSpecificForce) {
  Imu imu({}, kSensorStep);
  const Vector3 w_B(0.3, -0.5, 0.8), a_W(1.0, 2.0, -3.0);
  VectorX q = AtRest(), v = VectorX::Zero(6);
  Matrix3 R = RotationExp(Vector3(0.2, 0.1, -0.4));
  for (int k = 0; k < 20; ++k) {
    R = R * RotationExp(kSensorStep * w_B);
    q.segment<4>(3) = Quaternion(R).coeffs();
    v.head<3>() += kSensorStep * a_W;
    v.segment<3>(3) = R * w_B;
    const ImuReading& reading = imu.Read(q, v);
    EXPECT_NEAR((reading.rate_B - w_B).norm(), 0.0, 1e-9);
    const Vector3 force = R.transpose() * ((k > 0 ? a_W : Vector3(Vector3::Zero())) + Vector3(0.0, 0.0, kGravity));
    EXPECT_NEAR((reading.force_B - force).norm(), 0.0, 1e-9) << k;
  }
}

/// Standard deviations of a rate sensor's readings, and of their means over 0.1 s.
std::pair<double, double> NoiseOf(const SensorOptions& sheet, double step_s) {
  Imu imu(sheet, step_s);
  std::vector<double> rates;
  const double every_s = sheet.imu_rate_hz > 0.0 ? 1.0 / sheet.imu_rate_hz : step_s;
  const int stride = static_cast<int>(std::lround(every_s / step_s));
  for (int k = 0; k < 20000 * stride; ++k) {
    const ImuReading& reading = imu.Read(AtRest(), VectorX::Zero(6));
    if (k % stride == 0) rates.push_back(reading.rate_B.x());
  }
  return {Of(rates).deviation, Of(Averaged(rates, static_cast<std::size_t>(std::lround(0.1 / every_s)))).deviation};
}

TEST(Imu, WhiteNoiseGoesWithTheRootOfTheRateAndItsMeanDoesNot) {
  SensorOptions sheet;
  sheet.gyroscope_noise_rad_s_sqrt_hz = 0.005;
  for (const double step_s : {0.001, 0.0005}) {
    for (const double rate_hz : {0.0, 500.0, 100.0}) {
      sheet.imu_rate_hz = rate_hz;
      const double f = rate_hz > 0.0 ? rate_hz : 1.0 / step_s;
      const auto [reading, mean] = NoiseOf(sheet, step_s);
      EXPECT_NEAR(reading / (0.005 * std::sqrt(f)), 1.0, 0.05) << rate_hz;
      EXPECT_NEAR(mean / (0.005 * std::sqrt(10.0)), 1.0, 0.15) << rate_hz;
    }
  }
}

TEST(Imu, BiasesHaveTheirMagnitudeInAnyDirectionAndWander) {
  SensorOptions sheet;
  sheet.gyroscope_bias_rad_s = 0.01;
  sheet.accelerometer_bias_m_s2 = 0.2;
  Vector3 mean = Vector3::Zero();
  for (int seed = 0; seed < 400; ++seed) {
    sheet.seed = seed;
    Imu imu(sheet, kSensorStep);
    const ImuReading reading = imu.Read(AtRest(), VectorX::Zero(6));
    EXPECT_NEAR(reading.rate_B.norm(), 0.01, 1e-12);
    EXPECT_NEAR((reading.force_B - Vector3(0.0, 0.0, kGravity)).norm(), 0.2, 1e-9);
    mean += reading.rate_B / 0.01 / 400.0;
  }
  EXPECT_LT(mean.norm(), 0.1);
  SensorOptions walk;
  walk.gyroscope_walk_rad_s2_sqrt_hz = 0.02;
  walk.accelerometer_walk_m_s3_sqrt_hz = 0.3;
  std::vector<double> rates, forces;
  for (int seed = 0; seed < 400; ++seed) {
    walk.seed = seed;
    Imu imu(walk, 0.01);
    for (int k = 0; k < 100; ++k) imu.Read(AtRest(), VectorX::Zero(6));
    rates.push_back(imu.gyroscope_bias().y());
    forces.push_back(imu.accelerometer_bias().y());
  }
  EXPECT_NEAR(Of(rates).deviation, 0.02, 0.003) << "after one second";
  EXPECT_NEAR(Of(forces).deviation, 0.3, 0.04);
}

TEST(Imu, SlowOnesTellTheMeanSinceTheReadingBeforeAndLateOnesTellItLate) {
  SensorOptions sheet;
  sheet.imu_rate_hz = 250.0;
  sheet.imu_delay_s = 0.002;
  Imu imu(sheet, kSensorStep);
  VectorX v = VectorX::Zero(6);
  for (int k = 0; k < 60; ++k) {
    v[0] = 0.01 * k * k;
    const double force = imu.Read(AtRest(), v).force_B.x();
    const int read = (k - 2) / 4 * 4;  // the step of the reading
    if (k >= 6) {
      EXPECT_NEAR(force, (0.01 * read * read - 0.01 * (read - 4) * (read - 4)) / (4 * kSensorStep), 1e-9) << k;
    }
  }
}

std::vector<ContactWrench> Loads(double first_n, double second_n) {
  return {{Vector3(3.0, 0.0, first_n), Vector3::Ones()}, {Vector3(0.0, 0.0, second_n), Vector3::Zero()}};
}

TEST(ContactSensors, PerfectOnesTellWhoTouchesAndHowHard) {
  ContactSensors sensors(2, 100.0, {}, kSensorStep);
  const ContactReading reading = sensors.Read(FootBit(0), Loads(30.0, 0.0));
  EXPECT_EQ(reading.contact, FootBit(0));
  EXPECT_EQ(reading.load_n, (std::vector<double>{30.0, 0.0}));
}

TEST(ContactSensors, HaveAThresholdNoiseAndWrongReadings) {
  SensorOptions sheet;
  sheet.contact_threshold = 0.1;
  ContactSensors threshold(2, 100.0, sheet, kSensorStep);
  EXPECT_EQ(threshold.Read(AllFeet(2), Loads(9.9, 10.1)).contact, FootBit(1));
  sheet.contact_noise = 0.01;
  sheet.contact_missed = 0.03;
  sheet.contact_false = 0.05;
  ContactSensors noisy(2, 100.0, sheet, kSensorStep);
  std::vector<double> loads;
  int missed = 0, wrong = 0;
  for (int k = 0; k < 20000; ++k) {
    const ContactReading& reading = noisy.Read(FootBit(0), Loads(50.0, 0.0));
    loads.push_back(reading.load_n[0]);
    missed += Contains(reading.contact, 0) ? 0 : 1;
    wrong += Contains(reading.contact, 1) ? 1 : 0;
    ASSERT_GE(reading.load_n[1], 0.0);
  }
  EXPECT_NEAR(Of(loads).mean, 50.0, 0.05);
  EXPECT_NEAR(Of(loads).deviation, 1.0, 0.05);
  EXPECT_NEAR(missed / 20000.0, 0.03, 0.005);
  EXPECT_NEAR(wrong / 20000.0, 0.05, 0.006);
}

TEST(ContactSensors, AreReadAtTheirRateAndLate) {
  SensorOptions sheet;
  sheet.contact_rate_hz = 500.0;
  sheet.contact_delay_s = 0.002;
  ContactSensors sensors(2, 100.0, sheet, kSensorStep);
  for (int k = 0; k < 40; ++k) {
    const double load = sensors.Read(AllFeet(2), Loads(k + 1.0, 1.0)).load_n[0];
    const int before = std::max(0, k - 2);
    EXPECT_EQ(load, before - before % 2 + 1.0);
  }
}

TEST(SensorOptions, SetsAreNamedAndTheirFiguresAreLegal) {
  for (const std::string& name : SensorKinds()) {
    SensorOptions sheet = SensorsOfKind(name);
    EXPECT_NO_THROW(CheckOptions(sheet.Fields())) << name;
    EXPECT_EQ(sheet == SensorOptions{}, name == "ideal") << name;
  }
  EXPECT_DOUBLE_EQ(SensorsOfKind("hobby").gyroscope_noise_rad_s_sqrt_hz, 0.005);
  EXPECT_DOUBLE_EQ(SensorsOfKind("hobby").accelerometer_bias_m_s2, 0.02 * kGravity);
  try {
    SensorsOfKind("bad");
    FAIL();
  } catch (const InvalidArgument& error) {
    EXPECT_STREQ(error.what(), "unknown set of sensors 'bad'; accepted: 'ideal', 'good', 'hobby'");
  }
  EXPECT_EQ(StateSourceOf("estimated"), StateSource::kEstimated);
  EXPECT_THROW(StateSourceOf("guessed"), InvalidArgument);
}

}  // namespace
}  // namespace gaitwright
