// SPDX-License-Identifier: BSD-3-Clause
#include "playback/sensing/leg_odometry.h"

#include <algorithm>
#include <cmath>

#include "kinematics/base/result.h"
#include "kinematics/spatial/rotation.h"

namespace gaitwright {
namespace {

constexpr double kBridge = 0.004;  // a shorter loss of contact is ignored [s]
// small, because the start defines W; not zero, so that the filter stays regular [rad]
constexpr double kStartYaw = 1e-3;
constexpr double kStartPlace = 1e-4;  // [m]
constexpr double kStartSpeed = 0.01;  // [m/s]
constexpr double kTurnError = 1e-3;   // of a sole relative to the base, in addition to encoder errors [rad]
// Lower bounds on sensor noise: with less, rounding errors would matter in the filter.
constexpr double kBestGyroscope = 1e-5, kBestRateBias = 1e-5;       // [rad/s/sqrt(Hz)], [rad/s]
constexpr double kBestAccelerometer = 1e-4, kBestForceBias = 1e-4;  // [m/s^2/sqrt(Hz)], [m/s^2]
constexpr double kBestWalk = 1e-7;                                  // of both biases, in their units
constexpr double kBestEncoder = 1e-5;                               // [rad]
const Vector3 kGravity_W(0.0, 0.0, -kGravity);

OdometryOptions Checked(OdometryOptions options) {
  CheckOptions(options.Fields());
  return options;
}

/// The data sheet, with no value better than that of the best sensors.
SensorOptions Honest(SensorOptions sheet) {
  CheckOptions(sheet.Fields());
  const double steps = sheet.encoder_resolution_rad / std::sqrt(12.0);
  sheet.encoder_noise_rad = std::max(std::hypot(sheet.encoder_noise_rad, steps, sheet.encoder_bias_rad), kBestEncoder);
  sheet.gyroscope_noise_rad_s_sqrt_hz = std::max(sheet.gyroscope_noise_rad_s_sqrt_hz, kBestGyroscope);
  sheet.gyroscope_bias_rad_s = std::max(sheet.gyroscope_bias_rad_s, kBestRateBias);
  sheet.gyroscope_walk_rad_s2_sqrt_hz = std::max(sheet.gyroscope_walk_rad_s2_sqrt_hz, kBestWalk);
  sheet.accelerometer_noise_m_s2_sqrt_hz = std::max(sheet.accelerometer_noise_m_s2_sqrt_hz, kBestAccelerometer);
  sheet.accelerometer_bias_m_s2 = std::max(sheet.accelerometer_bias_m_s2, kBestForceBias);
  sheet.accelerometer_walk_m_s3_sqrt_hz = std::max(sheet.accelerometer_walk_m_s3_sqrt_hz, kBestWalk);
  return sheet;
}

/// Adds the effect of a first-order error: M times the rows `from` of P to its rows `to`, three rows each.
void AddRows(MatrixX& P, int to, const Matrix3& M, int from) {
  P.middleRows<3>(to).noalias() += M.lazyProduct(P.middleRows<3>(from));
}

void AddColumns(MatrixX& P, int to, const Matrix3& M, int from) {
  P.middleCols<3>(to).noalias() += P.middleCols<3>(from).lazyProduct(M.transpose());
}

}  // namespace

LegOdometry::LegOdometry(const RobotModel& model, const Terrain& terrain, const Setup& setup)
    : model_(model),
      terrain_(terrain),
      options_(Checked(setup.options)),
      sheet_(Honest(setup.data_sheet)),
      step_s_(setup.step_s),
      feet_(model.feet.size()),
      scratch_(model),
      q_(VectorX::Zero(model.nq())),
      v_(VectorX::Zero(model.nv())),
      jacobian_(6, model.nv()) {
  int size = kFeet;
  for (std::size_t f = 0; f < feet_.size(); ++f) {
    feet_[f].at = size;
    feet_[f].rows = model.feet[f].has_sole() ? 6 : 3;
    size += feet_[f].rows;
  }
  P_ = MatrixX::Zero(size, size);
  shape_.setZero(size, 3);
  PH_.setZero(size, 6);
  gain_.setZero(size, 6);
  correction_.setZero(size);
  Start(StandingConfiguration(model));
}

void LegOdometry::Start(const VectorX& q) {
  R_WB_ = BaseRotation(q);
  p_WB_ = q.head<3>();
  v_WB_ = gyroscope_bias_ = accelerometer_bias_ = rate_B_ = Vector3::Zero();
  slips_ = 0;
  P_.setZero();
  for (FootState& foot : feet_) LiftOff(foot);
  const auto set = [this](int at, const Vector3& deviation) { P_.diagonal().segment<3>(at) = deviation.cwiseAbs2(); };
  set(kPhi, {options_.start_tilt_rad, options_.start_tilt_rad, kStartYaw});
  set(kNu, Vector3::Constant(kStartSpeed));
  set(kRho, Vector3::Constant(kStartPlace));
  set(kRateBias, Vector3::Constant(sheet_.gyroscope_bias_rad_s / std::sqrt(3.0)));
  set(kForceBias, Vector3::Constant(sheet_.accelerometer_bias_m_s2 / std::sqrt(3.0)));
  // Rotation about the base, not about the origin of W.
  const Matrix3 arm = Skew(p_WB_);
  const Matrix3 turn = P_.block<3, 3>(kPhi, kPhi);
  P_.block<3, 3>(kRho, kPhi) = arm * turn;
  P_.block<3, 3>(kPhi, kRho) = P_.block<3, 3>(kRho, kPhi).transpose();
  P_.block<3, 3>(kRho, kRho) += arm * turn * arm.transpose();
}

void LegOdometry::Update(const ImuReading& imu, const JointReading& joints, const ContactReading& contact) {
  Predict(imu);
  Correct(joints, contact);
}

void LegOdometry::Predict(const ImuReading& imu) {
  const double h = step_s_;
  rate_B_ = imu.rate_B - gyroscope_bias_;
  PredictCovariance(h);
  AddNoise(h);
  R_WB_ = Quaternion(R_WB_ * RotationExp(h * rate_B_)).normalized().toRotationMatrix();
  v_WB_ += h * (R_WB_ * (imu.force_B - accelerometer_bias_) + kGravity_W);
  p_WB_ += h * v_WB_;
  for (std::size_t f = 0; f < feet_.size(); ++f) {
    FootState& foot = feet_[f];
    if (foot.is_held && foot.rows == 3) foot.p_WF += h * foot.w_WF.cross(model_.feet[f].radius * foot.normal_W);
  }
}

/// P <- F P F^T, F = I + h A; only four block columns of A are not zero.
void LegOdometry::PredictCovariance(double h) {
  const Matrix3 R = h * R_WB_, vR = Skew(v_WB_) * R, pR = Skew(p_WB_) * R;
  const Matrix3 g = h * Skew(kGravity_W), whole = h * Matrix3::Identity();
  const auto multiply = [&](const auto& add) {
    add(P_, kRho, whole, kNu);
    add(P_, kRho, -pR, kRateBias);
    add(P_, kNu, g, kPhi);
    add(P_, kNu, -vR, kRateBias);
    add(P_, kNu, -R, kForceBias);
    for (const FootState& foot : feet_) {
      if (foot.is_held) add(P_, foot.at, -Skew(foot.p_WF) * R, kRateBias);
    }
    add(P_, kPhi, -R, kRateBias);
  };
  multiply(AddRows);
  multiply(AddColumns);
}

void LegOdometry::AddNoise(double h) {
  shape_.setZero();
  shape_.middleRows<3>(kPhi).setIdentity();
  shape_.middleRows<3>(kNu) = Skew(v_WB_);
  shape_.middleRows<3>(kRho) = Skew(p_WB_);
  for (const FootState& foot : feet_) {
    if (foot.is_held) shape_.middleRows<3>(foot.at) = Skew(foot.p_WF);
  }
  shape_ *= sheet_.gyroscope_noise_rad_s_sqrt_hz * std::sqrt(h);
  P_.noalias() += shape_.lazyProduct(shape_.transpose());
  const auto add = [&](int at, double density) { P_.diagonal().segment<3>(at).array() += density * density * h; };
  add(kNu, sheet_.accelerometer_noise_m_s2_sqrt_hz);
  add(kRateBias, sheet_.gyroscope_walk_rad_s2_sqrt_hz);
  add(kForceBias, sheet_.accelerometer_walk_m_s3_sqrt_hz);
  P_.triangularView<Eigen::StrictlyLower>() = P_.transpose();
}

void LegOdometry::Correct(const JointReading& joints, const ContactReading& contact) {
  for (std::size_t f = 0; f < feet_.size(); ++f) {
    FootState& foot = feet_[f];
    foot.missing_s = Contains(contact.contact, static_cast<int>(f)) ? 0.0 : foot.missing_s + step_s_;
    if (foot.is_held && foot.missing_s >= kBridge) LiftOff(foot);
    if (foot.is_held) Creep(foot, TrustOf(foot, contact.load_n[f]));
  }
  if (!joints.is_fresh) return;
  ReadFeet(joints);
  for (std::size_t f = 0; f < feet_.size(); ++f) {
    if (feet_[f].is_held)
      CorrectBy(f);
    else if (Contains(contact.contact, static_cast<int>(f)))
      PutDown(f);
  }
}

/// Trust in a standing foot, from 0 to 1.
double LegOdometry::TrustOf(const FootState& foot, double load_n) const {
  const double by_time = options_.trust_s > 0.0 ? foot.held_s / options_.trust_s : 1.0;
  const double by_load = options_.trust_load > 0.0 ? load_n / (options_.trust_load * model_.weight_n()) : 1.0;
  return std::clamp(std::min(by_time, by_load), 0.0, 1.0);
}

/// Adds the uncertainty of a possible motion of the foot in the step.
void LegOdometry::Creep(FootState& foot, double trust) {
  const auto between = [&](double landing, double standing) {
    return std::pow(landing, 1.0 - trust) * std::pow(standing, trust);
  };
  const double slip = between(options_.landing_slip_m_s_sqrt_hz, options_.stance_slip_m_s_sqrt_hz);
  P_.diagonal().segment<3>(foot.at).array() += slip * slip * step_s_;
  foot.held_s += step_s_;
  if (foot.rows == 3) return;
  const double turn = between(options_.landing_turn_rad_s_sqrt_hz, options_.stance_turn_rad_s_sqrt_hz);
  P_.diagonal().segment<3>(foot.at + 3).array() += turn * turn * step_s_;
}

/// Foot poses relative to the base from the joint readings, and their uncertainty.
void LegOdometry::ReadFeet(const JointReading& joints) {
  q_.head<3>() = p_WB_;
  q_.segment<4>(3) = Quaternion(R_WB_).coeffs();
  q_.tail(model_.num_dofs()) = joints.q_raw;
  v_.head<3>() = v_WB_;
  v_.segment<3>(3) = w_WB();
  v_.tail(model_.num_dofs()) = joints.v;
  ForwardVelocities(model_, q_, v_, scratch_);
  for (std::size_t f = 0; f < feet_.size(); ++f) {
    const Foot& shape = model_.feet[f];
    const Pose X_WF = FramePose(scratch_, shape.body, shape.X_BF);
    feet_[f].p_BF = R_WB_.transpose() * (X_WF.translation() - p_WB_);
    feet_[f].R_BF = R_WB_.transpose() * X_WF.linear();
    feet_[f].w_WF = scratch_.w_WB[static_cast<std::size_t>(shape.body)];
  }
}

/// J Q J^T of the joints between base and foot.
LegOdometry::Square LegOdometry::NoiseOf(std::size_t foot) {
  const Foot& shape = model_.feet[foot];
  const int rows = feet_[foot].rows;
  PointJacobian(model_, scratch_, shape.body, shape.X_BF.translation(), jacobian_);
  const auto J = jacobian_.topRightCorner(rows, model_.num_dofs());
  Square noise = sheet_.encoder_noise_rad * sheet_.encoder_noise_rad * J.lazyProduct(J.transpose());
  noise.diagonal().head<3>().array() += options_.model_error_m * options_.model_error_m;
  if (rows == 6) noise.diagonal().tail<3>().array() += kTurnError * kTurnError;
  return noise;
}

void LegOdometry::LiftOff(FootState& foot) {
  foot.is_held = false;
  P_.middleRows(foot.at, foot.rows).setZero();
  P_.middleCols(foot.at, foot.rows).setZero();
}

/// Sets the foot to its pose from the joint readings: its errors are those of the base and of the readings.
void LegOdometry::PutDown(std::size_t f) {
  FootState& foot = feet_[f];
  foot.is_held = true;
  foot.held_s = 0.0;
  foot.p_WF = p_WB_ + R_WB_ * foot.p_BF;
  foot.R_WF = R_WB_ * foot.R_BF;
  foot.normal_W = GroundAt(terrain_, foot.p_WF.head<2>()).normal_W;
  P_.middleRows<3>(foot.at) = P_.middleRows<3>(kRho);
  P_.middleCols<3>(foot.at) = P_.middleCols<3>(kRho);
  if (foot.rows == 6) {
    P_.middleRows<3>(foot.at + 3) = P_.middleRows<3>(kPhi);
    P_.middleCols<3>(foot.at + 3) = P_.middleCols<3>(kPhi);
  }
  P_.block(foot.at, foot.at, foot.rows, foot.rows) += NoiseOf(f);
  if (options_.terrain_height_m > 0.0) UseTerrain(f);
}

/// z = p_WF^.z - radius / n.z - height of the ground under the centre = delta.z + (phi x p_WF^).z
void LegOdometry::UseTerrain(std::size_t f) {
  const FootState& foot = feet_[f];
  const double radius = foot.rows == 3 ? model_.feet[f].radius : 0.0;
  const double above = foot.p_WF.z() - radius / foot.normal_W.z() - GroundAt(terrain_, foot.p_WF.head<2>()).height_m;
  const Vector3 by_turn = -Skew(foot.p_WF).row(2).transpose();
  auto PH = PH_.col(0);
  PH = P_.col(foot.at + 2);
  PH.noalias() += P_.middleCols<3>(kPhi).lazyProduct(by_turn);
  const double s =
      PH[foot.at + 2] + by_turn.dot(PH.segment<3>(kPhi)) + options_.terrain_height_m * options_.terrain_height_m;
  correction_ = PH * (above / s);
  P_.noalias() -= (PH / s).lazyProduct(PH.transpose());
  Apply();
}

void LegOdometry::CorrectBy(std::size_t f) {
  FootState& foot = feet_[f];
  const int rows = foot.rows;
  Rows z(rows);
  z.head<3>() = p_WB_ + R_WB_ * foot.p_BF - foot.p_WF;
  PH_.leftCols<3>() = P_.middleCols<3>(kRho) - P_.middleCols<3>(foot.at);
  if (rows == 6) {
    z.tail<3>() = RotationLog(R_WB_ * foot.R_BF * foot.R_WF.transpose());
    PH_.rightCols<3>() = P_.middleCols<3>(kPhi) - P_.middleCols<3>(foot.at + 3);
  }
  const auto PH = PH_.leftCols(rows);
  Square S = NoiseOf(f);
  S.topRows<3>() += PH.middleRows<3>(kRho) - PH.middleRows<3>(foot.at);
  if (rows == 6) S.bottomRows<3>() += PH.middleRows<3>(kPhi) - PH.middleRows<3>(foot.at + 3);
  const Square inverse = S.ldlt().solve(Square::Identity(rows, rows));
  if (z.dot(inverse * z) > options_.gate * options_.gate * rows / 3.0) {
    ++slips_;
    LiftOff(foot);
    PutDown(f);
    return;
  }
  auto gain = gain_.leftCols(rows);
  gain.noalias() = PH.lazyProduct(inverse);
  correction_.noalias() = gain.lazyProduct(z);
  P_.noalias() -= gain.lazyProduct(PH.transpose());
  Apply();
}

/// Removes the errors in `correction_` from the estimate.
void LegOdometry::Apply() {
  const Vector3 phi = correction_.segment<3>(kPhi);
  const Matrix3 turn = RotationExp(-phi), J = Matrix3::Identity() + 0.5 * Skew(phi);
  const auto corrected = [&](const Vector3& value, int at) -> Vector3 {
    return turn * (value - J * correction_.segment<3>(at));
  };
  R_WB_ = turn * R_WB_;
  v_WB_ = corrected(v_WB_, kNu);
  p_WB_ = corrected(p_WB_, kRho);
  gyroscope_bias_ -= correction_.segment<3>(kRateBias);
  rate_B_ += correction_.segment<3>(kRateBias);
  accelerometer_bias_ -= correction_.segment<3>(kForceBias);
  for (FootState& foot : feet_) {
    if (!foot.is_held) continue;
    foot.p_WF = corrected(foot.p_WF, foot.at);
    if (foot.rows == 6) foot.R_WF = RotationExp(-correction_.segment<3>(foot.at + 3)) * foot.R_WF;
  }
}

Eigen::Matrix<double, 9, 1> LegOdometry::ErrorAgainst(const VectorX& q, const VectorX& v) const {
  const Matrix3 turn = R_WB_ * BaseRotation(q).transpose();
  Eigen::Matrix<double, 9, 1> error;
  error << RotationLog(turn), v_WB_ - turn * v.head<3>(), p_WB_ - turn * q.head<3>();
  return error;
}

}  // namespace gaitwright
