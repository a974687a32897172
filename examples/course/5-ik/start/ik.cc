// SPDX-License-Identifier: BSD-3-Clause
// Assignment 5: inverse kinematics of a leg. See ../README.md. SI units; x is forward, y to the left, z up.
//   ik INPUTS ANSWERS    reads PART_inputs.csv from INPUTS, writes PART.csv to ANSWERS
#include <fmt/format.h>

#include <array>
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
[[maybe_unused]] constexpr double kA1Side = 0.0838, kA1Thigh = 0.2, kA1Shank = 0.2;         // [m]
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

/// Centre of the A1's foot in the base [m] for joint positions [rad]: abduction, hip, knee.
Vector3 A1LegFk(int leg, const Vector3& /*joints_rad*/) { return A1Hip(leg); }

/// Joint positions [rad] within their limits, for which the foot is at a given position in the base [m].
Vector3 A1LegIk(int /*leg*/, const Vector3& /*place_m*/) { return {0.0, 0.9, -1.8}; }  // always the same posture

/// Joint positions [rad] within their limits, for which the sole has a given pose in the base.
Vector6 NaoLegIk(int /*leg*/, const Pose& /*sole*/) {
  return (Vector6() << 0.0, 0.0, -0.4, 0.9, -0.5, 0.0).finished();  // always the same posture
}

// Do not change the code below: it reads the inputs and writes the answers.

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
