// SPDX-License-Identifier: BSD-3-Clause
// A solution of assignment 5. SI units; x is forward, y to the left, z up.
//   ik INPUTS ANSWERS    reads PART_inputs.csv from INPUTS, writes PART.csv to ANSWERS
#include <fmt/format.h>

#include <Eigen/Cholesky>
#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <utility>
#include <vector>

#include "kinematics/spatial/rotation.h"
#include "workflows/grade/answer_table.h"

namespace {

using gaitwright::AnswerCase;
using gaitwright::Matrix3;
using gaitwright::Pose;
using gaitwright::Vector2;
using gaitwright::Vector3;
using gaitwright::Vector6;

// The A1: legs FL, FR, RL, RR are 0, 1, 2, 3.
constexpr double kA1Side = 0.0838, kA1Thigh = 0.2, kA1Shank = 0.2;                          // [m]
const Vector3 kA1Lower(-0.80285, -1.04719, -2.69653), kA1Upper(0.80285, 4.18879, -0.9163);  // [rad]

/// Position of the hip in the base.
Vector3 A1Hip(int leg) { return {leg < 2 ? 0.1805 : -0.1805, leg % 2 == 0 ? 0.047 : -0.047, 0.0}; }

// NAO: the left leg is 0, the right one 1. The right leg is the mirror image of the left one.
struct NaoJoint {
  Vector3 place_m, axis;        // of the left leg, in the frame of the previous joint
  Vector2 left_rad, right_rad;  // limits
};
const std::array<NaoJoint, 6> kNaoJoints = {{
    {{0.0, 0.05, -0.085}, {0.0, M_SQRT1_2, -M_SQRT1_2}, {-1.14529, 0.74071}, {-1.14529, 0.74071}},
    {{0.0, 0.0, 0.0}, {1.0, 0.0, 0.0}, {-0.37943, 0.79046}, {-0.79046, 0.37943}},
    {{0.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {-1.53589, 0.48398}, {-1.53589, 0.48398}},
    {{0.0, 0.0, -0.1}, {0.0, 1.0, 0.0}, {-0.09232, 2.11255}, {-0.09232, 2.11255}},
    {{0.0, 0.0, -0.1029}, {0.0, 1.0, 0.0}, {-1.18944, 0.92258}, {-1.1863, 0.932}},
    {{0.0, 0.0, 0.0}, {1.0, 0.0, 0.0}, {-0.39776, 0.76899}, {-0.76899, 0.39776}},
}};
const Vector3 kNaoSole(0.0315, 0.006, -0.04511);  // [m], centre of the sole in the frame of the last joint

Vector3 Mirrored(const Vector3& vector, int leg) {
  return {vector.x(), leg == 0 ? vector.y() : -vector.y(), vector.z()};
}

/// Hip yaw and pitch are one joint. It rotates both legs by the same angle, about axes that mirror each other.
Vector3 NaoAxis(std::size_t joint, int leg) {
  const Vector3& axis = kNaoJoints[joint].axis;
  return leg == 1 && joint == 0 ? Vector3(axis.x(), axis.y(), -axis.z()) : axis;
}

/// Pose of the centre of NAO's sole in the base.
Pose NaoFoot(int leg, const Vector6& joints_rad) {
  Pose X = Pose::Identity();
  for (std::size_t i = 0; i < 6; ++i) {
    X.translate(Mirrored(kNaoJoints[i].place_m, leg));
    X.rotate(gaitwright::RotationExp(joints_rad[static_cast<Eigen::Index>(i)] * NaoAxis(i, leg)));
  }
  X.translate(Mirrored(kNaoSole, leg));
  return X;
}

/// Hip and knee move the leg in a plane, and abduction rotates this plane about x.
Vector3 A1LegFk(int leg, const Vector3& joints_rad) {
  const double thigh = joints_rad[1], shank = joints_rad[1] + joints_rad[2];
  const Vector3 unturned(-kA1Thigh * std::sin(thigh) - kA1Shank * std::sin(shank), leg % 2 == 0 ? kA1Side : -kA1Side,
                         -kA1Thigh * std::cos(thigh) - kA1Shank * std::cos(shank));
  return A1Hip(leg) + gaitwright::RotationExp(joints_rad[0] * Vector3::UnitX()) * unturned;
}

/// Largest violation of the joint limits [rad]; negative if all limits are kept.
double Beyond(const Vector3& joints_rad) {
  return std::max((kA1Lower - joints_rad).maxCoeff(), (joints_rad - kA1Upper).maxCoeff());
}

/// The same posture, with each angle moved by whole turns as close as possible to the middle of its range.
Vector3 IntoLimits(Vector3 joints_rad) {
  for (int i = 0; i < 3; ++i) {
    const double middle = 0.5 * (kA1Lower[i] + kA1Upper[i]);
    joints_rad[i] -= 2.0 * M_PI * std::round((joints_rad[i] - middle) / (2.0 * M_PI));
  }
  return joints_rad;
}

/// The knee has one bending direction, and the leg can point down from the hip or up. Returns the solution that keeps
/// the limits.
Vector3 A1LegIk(int leg, const Vector3& place_m) {
  const Vector3 p = place_m - A1Hip(leg);
  const double side = leg % 2 == 0 ? kA1Side : -kA1Side;
  const double depth = std::sqrt(std::max(p.y() * p.y() + p.z() * p.z() - kA1Side * kA1Side, 0.0));
  const double cosine =
      (p.x() * p.x() + depth * depth - kA1Thigh * kA1Thigh - kA1Shank * kA1Shank) / (2.0 * kA1Thigh * kA1Shank);
  const double knee = -std::acos(std::clamp(cosine, -1.0, 1.0));
  const double within = std::atan2(kA1Shank * std::sin(knee), kA1Thigh + kA1Shank * std::cos(knee));
  const auto posture = [&](double down) {
    return IntoLimits({std::atan2(p.z(), p.y()) - std::atan2(down, side), std::atan2(-p.x(), -down) - within, knee});
  };
  const Vector3 under = posture(-depth), above = posture(depth);
  return Beyond(under) <= Beyond(above) ? under : above;
}

using Matrix6 = Eigen::Matrix<double, 6, 6>;

/// Jacobian of position and rotation of the sole in the base; each column is (axis x arm, axis).
Matrix6 NaoJacobian(int leg, const Vector6& joints_rad) {
  const Vector3 p_BS = NaoFoot(leg, joints_rad).translation();
  Matrix6 J;
  Pose X = Pose::Identity();
  for (std::size_t i = 0; i < 6; ++i) {
    const auto column = static_cast<Eigen::Index>(i);
    X.translate(Mirrored(kNaoJoints[i].place_m, leg));
    const Vector3 axis = X.linear() * NaoAxis(i, leg);
    J.col(column) << axis.cross(p_BS - X.translation()), axis;
    X.rotate(gaitwright::RotationExp(joints_rad[column] * NaoAxis(i, leg)));
  }
  return J;
}

/// Lower and upper limits of NAO's leg.
std::pair<Vector6, Vector6> NaoLimits(int leg) {
  Vector6 lower, upper;
  for (std::size_t i = 0; i < 6; ++i) {
    const Vector2& limits = leg == 0 ? kNaoJoints[i].left_rad : kNaoJoints[i].right_rad;
    lower[static_cast<Eigen::Index>(i)] = limits.x();
    upper[static_cast<Eigen::Index>(i)] = limits.y();
  }
  return {lower, upper};
}

/// Damped least squares, clipped to the limits; the damping decreases with the error. Changes `joints_rad`.
/// @return the norm of the remaining error, in metres and radians together.
double NaoSearch(int leg, const Pose& sole, Vector6& joints_rad) {
  const auto [lower, upper] = NaoLimits(leg);
  Vector6 left = Vector6::Zero();
  for (int i = 0; i < 100; ++i) {
    const Pose at = NaoFoot(leg, joints_rad);
    left << sole.translation() - at.translation(), gaitwright::RotationLog(sole.linear() * at.linear().transpose());
    if (left.norm() < 1e-11) break;
    const Matrix6 J = NaoJacobian(leg, joints_rad);
    const double damping = 1e-3 * std::min(left.squaredNorm(), 1.0) + 1e-14;
    const Matrix6 normal = J.transpose() * J + damping * Matrix6::Identity();
    joints_rad += normal.ldlt().solve(J.transpose() * left);
    joints_rad = joints_rad.cwiseMax(lower).cwiseMin(upper);
  }
  return left.norm();
}

/// Searches from the middle of the limits; if this fails, from random postures between them.
Vector6 NaoLegIk(int leg, const Pose& sole) {
  const auto [lower, upper] = NaoLimits(leg);
  std::mt19937 random(1);
  std::uniform_real_distribution<double> share(0.1, 0.9);
  Vector6 best = Vector6::Zero();
  double least = HUGE_VAL;
  for (int attempt = 0; attempt < 60 && least > 1e-9; ++attempt) {
    Vector6 shares = Vector6::Constant(0.5);
    if (attempt > 0) std::generate(shares.begin(), shares.end(), [&] { return share(random); });
    Vector6 joints_rad = lower + shares.cwiseProduct(upper - lower);
    const double left = NaoSearch(leg, sole, joints_rad);
    if (left < least) best = joints_rad;
    least = std::min(least, left);
  }
  return best;
}

int LegOf(const AnswerCase& asked) { return static_cast<int>(asked.Number("leg")); }

std::vector<double> AnswerA1Fk(const AnswerCase& asked) {
  const Vector3 foot_m = A1LegFk(LegOf(asked), asked.Vector("joints_rad"));
  return {foot_m.begin(), foot_m.end()};
}

std::vector<double> AnswerA1Ik(const AnswerCase& asked) {
  const Vector3 joints_rad = A1LegIk(LegOf(asked), asked.Vector("foot_m"));
  return {joints_rad.begin(), joints_rad.end()};
}

std::vector<double> AnswerNaoIk(const AnswerCase& asked) {
  Pose sole = Pose::Identity();
  sole.translation() = asked.Vector("foot_m");
  sole.linear() = asked.Matrix("rotation");
  const Vector6 joints_rad = NaoLegIk(LegOf(asked), sole);
  return {joints_rad.begin(), joints_rad.end()};
}

/// Position error of the sole when NaoLegIk is asked for the pose of the sole at `joints_rad` [m].
double NaoMiss(int leg, const Vector6& joints_rad) {
  const Pose sole = NaoFoot(leg, joints_rad);
  return (NaoFoot(leg, NaoLegIk(leg, sole)).translation() - sole.translation()).norm();
}

}  // namespace

int main(int argc, char** argv) {
  const Vector6 posture = (Vector6() << -0.2, 0.1, -0.6, 1.1, -0.5, -0.1).finished();
  fmt::print("NAO's left sole: forward of inverse kinematics is off by {:.2g} m\n", NaoMiss(0, posture));
  const auto written =
      gaitwright::WriteAnswers(argc > 1 ? argv[1] : ".", argc > 2 ? argv[2] : ".",
                               {{"a1_leg_fk", AnswerA1Fk}, {"a1_leg_ik", AnswerA1Ik}, {"nao_leg_ik", AnswerNaoIk}});
  if (!written) fmt::print(stderr, "ik: {}\n", written.failure().message);
  return written ? 0 : 1;
}
