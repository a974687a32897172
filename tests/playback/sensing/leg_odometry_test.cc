// SPDX-License-Identifier: BSD-3-Clause
#include "playback/sensing/leg_odometry.h"

#include <gtest/gtest.h>

#include "tests/kinematics/allocations.h"
#include "tests/playback/sensing/swaying.h"

namespace gaitwright {
namespace {

constexpr double kStep = 0.001;
using Error = Eigen::Matrix<double, 9, 1>;

/// A swaying robot, its sensors and its estimate.
struct Case {
  Case(swaying::Robot moved, FootSet stands, const SensorOptions& sensors, const OdometryOptions& options = {})
      : robot(std::move(moved)),
        encoders(robot.model.num_dofs(), sensors, kStep),
        imu(sensors, kStep),
        odometry(robot.model, ground, {options, sensors, kStep}) {
    odometry.Start(robot.q);
    feet.contact = stands;
    feet.load_n.assign(robot.model.feet.size(), robot.model.weight_n());
  }

  void Step() {
    robot.MoveTo(static_cast<double>(++count) * kStep, kStep);
    odometry.Update(imu.Read(robot.q, robot.v), encoders.Read(robot.q.tail(robot.model.num_dofs())), feet);
  }

  Error Off() const { return odometry.ErrorAgainst(robot.q, robot.v); }

  swaying::Robot robot;
  Terrain ground = {};
  Encoders encoders;
  Imu imu;
  LegOdometry odometry;
  ContactReading feet;
  int count = 0;
};

SensorOptions Hobby(int seed) {
  SensorOptions sensors = SensorsOfKind("hobby");
  sensors.imu_delay_s = 0.0;
  sensors.seed = seed;
  return sensors;
}

TEST(LegOdometry, PerfectSensorsGiveTheTruth) {
  for (const bool sole : {false, true}) {
    Case c(sole ? swaying::OnASole() : swaying::OnPoints(), sole ? FootBit(0) : AllFeet(4), {});
    double most = 0.0, moved = 0.0;
    for (int k = 0; k < 2000; ++k) {
      c.Step();
      most = std::max(most, c.Off().cwiseAbs().maxCoeff());
      moved = std::max(moved, c.robot.v.head<6>().norm());
    }
    EXPECT_GT(moved, 0.1);
    EXPECT_LT(most, 1e-3) << sole;
    EXPECT_EQ(c.odometry.slips(), 0);
    EXPECT_TRUE(c.odometry.Holds(0));
  }
}

/// A sole that turns onto the ground in the middle of its stance turns the sole, not the estimate of the base.
TEST(LegOdometry, ASoleThatRocksInStanceDoesNotTiltTheEstimate) {
  for (const Vector3& turn : {Vector3(0.05, 0.0, 0.0), Vector3(0.0, -0.05, 0.0), Vector3(0.0, 0.0, 0.05)}) {
    Case c(swaying::OnASole(), FootBit(0), Hobby(3));
    c.robot.RockSoles(turn, 0.5, 0.12);
    const auto off_after = [&](int steps) -> Error {
      for (int k = 0; k < steps; ++k) c.Step();
      return c.Off();
    };
    const Error before = off_after(500), after = off_after(140);
    EXPECT_LT((after - before).head<3>().norm(), 0.2 * turn.norm()) << turn.transpose();
    EXPECT_LT(after.segment<3>(3).norm(), 0.03) << turn.transpose();
  }
}

/// Effect of an initial error, or a bias, without feet, from differences of complete predictions.
Error LedTo(int index, double size) {
  const RobotModel model = LoadNamedRobot("a1").value();
  const Terrain ground;
  LegOdometry odometry(model, ground, {{}, {}, kStep});
  VectorX start = StandingConfiguration(model), q = start, v = VectorX::Zero(model.nv());
  start.head<3>() += Vector3(0.3, -0.2, 0.1);
  q = start;
  Eigen::Matrix<double, 15, 1> xi = Eigen::Matrix<double, 15, 1>::Zero();
  if (index >= 0) xi[index] = size;
  const Matrix3 turn = RotationExp(xi.head<3>());
  q.segment<4>(3) = Quaternion(turn.transpose()).coeffs();  // the truth; the estimate starts upright and at rest
  q.head<3>() = turn.transpose() * (start.head<3>() - xi.segment<3>(6));
  v.head<3>() = -turn.transpose() * xi.segment<3>(3);
  odometry.Start(start);
  Matrix3 R = BaseRotation(q);
  for (int k = 0; k < 300; ++k) {
    const double t = k * kStep;
    const Vector3 rate(1.0 + t, 2.0 * std::cos(9.0 * t), -1.5),
        force(3.0, -2.0 + 5.0 * t, kGravity + std::sin(8.0 * t));
    R = R * RotationExp(kStep * rate);
    v.head<3>() += kStep * (R * force - Vector3(0.0, 0.0, kGravity));
    q.head<3>() += kStep * v.head<3>();
    odometry.Predict({rate - xi.segment<3>(9), force - xi.segment<3>(12)});
  }
  q.segment<4>(3) = Quaternion(R).coeffs();
  return odometry.ErrorAgainst(q, v);
}

TEST(LegOdometry, CovarianceGrowsAsFiniteDifferencesOfThePredictionSay) {
  constexpr double kSize = 1e-6;
  const RobotModel model = LoadNamedRobot("a1").value();
  const Terrain ground;
  SensorOptions sheet;
  sheet.gyroscope_bias_rad_s = 0.05;
  sheet.accelerometer_bias_m_s2 = 0.5;
  LegOdometry odometry(model, ground, {{}, sheet, kStep});
  VectorX start = StandingConfiguration(model);
  start.head<3>() += Vector3(0.3, -0.2, 0.1);
  odometry.Start(start);
  const MatrixX before = odometry.covariance().topLeftCorner(15, 15);
  for (int k = 0; k < 300; ++k) {
    const double t = k * kStep;
    odometry.Predict(
        {Vector3(1.0 + t, 2.0 * std::cos(9.0 * t), -1.5), Vector3(3.0, -2.0 + 5.0 * t, kGravity + std::sin(8.0 * t))});
  }
  Eigen::Matrix<double, 9, 15> led;
  for (int i = 0; i < 15; ++i) led.col(i) = (LedTo(i, kSize) - LedTo(i, -kSize)) / (2.0 * kSize);
  EXPECT_LT(LedTo(-1, 0.0).norm(), 1e-12);
  const MatrixX expected = led * before * led.transpose(), found = odometry.covariance().topLeftCorner(9, 9);
  EXPECT_GT((found - before.topLeftCorner(9, 9)).norm(), 0.1 * before.norm()) << "it does change";
  for (int i = 0; i < 9; ++i) {
    for (int j = 0; j < 9; ++j) {
      const double scale = std::sqrt(expected(i, i) * expected(j, j));
      EXPECT_NEAR(found(i, j) / scale, expected(i, j) / scale, 0.02) << i << " " << j;
    }
  }
}

TEST(LegOdometry, PositionAndHeadingAreUnknownWhileTiltAndVelocityAreKnown) {
  Case c(swaying::OnPoints(), AllFeet(4), Hobby(3));
  const auto variance = [&](int i) { return c.odometry.covariance()(i, i); };
  for (int k = 0; k < 1000; ++k) c.Step();
  const double yaw = variance(2), tilt = variance(0) + variance(1);
  double before = 0.0;
  for (int k = 0; k < 6000; ++k) {
    c.Step();
    EXPECT_GE(variance(2), before * (1.0 - 1e-6)) << "no news of the heading";
    before = variance(2);
    EXPECT_LT(std::sqrt(variance(3) + variance(4)), 0.05);
    EXPECT_LT(c.Off().head<2>().norm(), 0.04);
    EXPECT_LT(c.Off().segment<3>(3).norm(), 0.06);
  }
  EXPECT_GT(variance(2), 1.5 * yaw);
  EXPECT_LT(variance(0) + variance(1), tilt);
  EXPECT_LT((c.odometry.gyroscope_bias() - c.imu.gyroscope_bias()).norm(), 0.2 * c.imu.gyroscope_bias().norm());
}

TEST(LegOdometry, ItsErrorsAreAsLargeAsItSays) {
  constexpr int kSeeds = 12;
  OdometryOptions options;
  options.model_error_m = 1e-5;
  double sum = 0.0;
  int count = 0;
  for (int seed = 0; seed < kSeeds; ++seed) {
    SensorOptions sensors = Hobby(100 + seed);
    // The true tilt at the start has the uncertainty that the filter assumes.
    Case c(swaying::OnPoints(), AllFeet(4), sensors, options);
    NoiseStream luck(seed, 77);
    VectorX start = c.robot.q;
    start.segment<4>(3) =
        Quaternion(RotationExp(options.start_tilt_rad * Vector3(luck.Normal(), luck.Normal(), 0.0))).coeffs();
    c.odometry.Start(start);
    for (int k = 0; k < 1500; ++k) {
      c.Step();
      if (k % 100 != 99) continue;
      const Eigen::Matrix<double, 5, 1> e = c.Off()({0, 1, 3, 4, 5});
      const Eigen::Matrix<double, 5, 5> P = c.odometry.covariance()({0, 1, 3, 4, 5}, {0, 1, 3, 4, 5});
      sum += e.dot(P.ldlt().solve(e)) / 5.0;
      ++count;
    }
  }
  EXPECT_GT(sum / count, 0.3) << "it is not timid";
  EXPECT_LT(sum / count, 1.7) << "nor bold";
}

TEST(LegOdometry, AFootThatSlipsIsTakenAnew) {
  Case c(swaying::OnPoints(), AllFeet(4), Hobby(5));
  for (int k = 0; k < 500; ++k) c.Step();
  const Vector3 before = c.Off().tail<3>();
  const int slips = c.odometry.slips();
  JointReading joints;
  for (int k = 0; k < 500; ++k) {
    c.robot.MoveTo(static_cast<double>(++c.count) * kStep, kStep);
    VectorX q = c.robot.q;
    q.segment<3>(7) += Vector3(0.1, 0.1, 0.0);  // only the first leg has moved
    c.odometry.Update(c.imu.Read(c.robot.q, c.robot.v), c.encoders.Read(q.tail(c.robot.model.num_dofs())), c.feet);
  }
  EXPECT_GT(c.odometry.slips(), slips);
  EXPECT_LT((c.Off().tail<3>() - before).norm(), 0.01);
}

/// A plane through the origin that rises along x, unbounded.
Terrain SlopeOf(double angle_rad) {
  Terrain ground = FlatTerrain();
  ground.patches.front().X_WT.linear() = RotationExp(-angle_rad * Vector3::UnitY());
  return ground;
}

/// Errors of place and velocity of a ball that rolls up a slope, as shares of its distance and speed. The whole robot
/// turns about its centre as one body. The filter trusts the ball more than the IMU.
Vector2 RollingErrors(double slope_rad, const Terrain& ground) {
  constexpr double kRadius = 0.05, kRate = 1.0;
  RobotModel model = LoadNamedRobot("a1").value();
  for (Foot& foot : model.feet) {
    foot.type = FootType::kSphere;
    foot.radius = kRadius;
  }
  LegOdometry odometry(model, ground, {{}, Hobby(0), kStep});
  const VectorX start = StandingConfiguration(model);
  odometry.Start(start);
  DynamicsScratch scratch(model);
  ForwardKinematics(model, start, scratch);
  const Vector3 ball = FramePose(scratch, model.feet[0].body, model.feet[0].X_BF).translation();
  const Vector3 forward = RotationExp(-slope_rad * Vector3::UnitY()) * Vector3::UnitX();
  Encoders encoders(model.num_dofs(), {}, kStep);
  Imu imu({}, kStep);
  VectorX q = start, v = VectorX::Zero(model.nv());
  const ContactReading feet{FootBit(0), std::vector<double>(4, model.weight_n())};
  Vector3 rolled = ball;
  for (int k = 0; k <= 400; ++k) {
    const double t = kStep * k, angle = kRate * t * t;  // from rest
    const VectorX before = q;
    const Matrix3 R = RotationExp(angle * Vector3::UnitY()), R_before = BaseRotation(before);
    rolled = ball + kRadius * angle * forward;
    q.head<3>() = rolled + R * (start.head<3>() - ball);
    q.segment<4>(3) = Quaternion(R).coeffs();
    v.head<3>() = (q - before).head<3>() / kStep;
    v.segment<3>(3) = R * RotationLog(R_before.transpose() * R) / kStep;
    odometry.Update(imu.Read(q, v), encoders.Read(q.tail(model.num_dofs())), feet);
  }
  EXPECT_GT((rolled - ball).norm(), 1e-3);
  return {(odometry.p_WF(0) - rolled).norm() / (rolled - ball).norm(),
          (odometry.v_WB() - v.head<3>()).norm() / v.head<3>().norm()};
}

TEST(LegOdometry, ASphereRolls) {
  const Vector2 errors = RollingErrors(0.0, Terrain());
  EXPECT_LT(errors[0], 0.1);
  EXPECT_LT(errors[1], 0.1);
}

TEST(LegOdometry, ASphereRollsAlongTheSlopeThatItStandsOn) {
  for (const double slope_rad : {0.5, -0.5}) {
    const Vector2 errors = RollingErrors(slope_rad, SlopeOf(slope_rad));
    EXPECT_LT(errors[0], 0.1);
    EXPECT_LT(errors[1], 0.1);
    EXPECT_GT(RollingErrors(slope_rad, FlatTerrain())[0], 0.2) << "it matters";
  }
}

TEST(LegOdometry, ASphereOnAKnownSlopeIsAtItsHeight) {
  constexpr double kSlope = 0.4;
  RobotModel model = LoadNamedRobot("a1").value();
  OdometryOptions knows;
  knows.terrain_height_m = 1e-4;
  const Terrain ground = SlopeOf(kSlope);
  LegOdometry odometry(model, ground, {knows, Hobby(1), kStep});
  VectorX q = StandingConfiguration(model);
  DynamicsScratch scratch(model);
  ForwardKinematics(model, q, scratch);
  const Foot& foot = model.feet[0];
  const Vector3 centre = FramePose(scratch, foot.body, foot.X_BF).translation();
  const double rests = std::tan(kSlope) * centre.x() + foot.radius / std::cos(kSlope);
  q[2] += rests - centre.z();
  odometry.Start(q);
  odometry.Predict({Vector3::Zero(), Vector3(0.0, 0.0, kGravity)});
  odometry.Correct({q.tail(12), q.tail(12), VectorX::Zero(12), true}, {FootBit(0), std::vector<double>(4, 30.0)});
  EXPECT_NEAR(odometry.p_WF(0).z(), rests, 1e-5) << "nothing to correct";
}

TEST(LegOdometry, GroundThatIsKnownHoldsTheHeight) {
  OdometryOptions knows;
  knows.terrain_height_m = 0.001;
  for (const bool known : {false, true}) {
    const RobotModel model = LoadNamedRobot("a1").value();
    const Terrain ground = FlatTerrain();
    LegOdometry odometry(model, ground, {known ? knows : OdometryOptions{}, Hobby(1), kStep});
    VectorX q = StandingConfiguration(model);
    odometry.Start(q);
    const double variance = odometry.covariance()(8, 8);
    for (int k = 0; k < 200; ++k) odometry.Predict({Vector3::Zero(), Vector3(0.0, 0.0, kGravity)});
    ContactReading feet{AllFeet(4), std::vector<double>(4, 30.0)};
    JointReading joints{q.tail(12), q.tail(12), VectorX::Zero(12), true};
    odometry.Correct(joints, feet);
    if (known) {
      EXPECT_LT(std::sqrt(odometry.covariance()(8, 8)), 0.0015);
    } else {
      EXPECT_GT(odometry.covariance()(8, 8), variance);
    }
  }
}

TEST(LegOdometry, UpdatesWithoutAllocating) {
  Case c(swaying::OnPoints(), AllFeet(4), Hobby(2));
  for (int k = 0; k < 10; ++k) c.Step();
  c.robot.MoveTo(0.011, kStep);
  const ImuReading imu = c.imu.Read(c.robot.q, c.robot.v);
  const JointReading joints = c.encoders.Read(c.robot.q.tail(12));
  const long before = Allocations();
  c.odometry.Update(imu, joints, c.feet);
  EXPECT_EQ(Allocations(), before);
}

}  // namespace
}  // namespace gaitwright
