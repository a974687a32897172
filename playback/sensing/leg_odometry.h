// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "kinematics/dynamics/dynamics.h"
#include "planning/plan/terrain.h"
#include "playback/sensing/contact_sensors.h"
#include "playback/sensing/encoders.h"
#include "playback/sensing/imu.h"
#include "playback/sensing/odometry_options.h"

namespace gaitwright {

/// Estimate of the base's pose and velocity from IMU, encoders and contacts: an extended Kalman filter with
/// right-invariant errors, so that the unobservable states (place and heading) stay unobservable in its covariance for
/// any motion.
///
/// = Notation =
///   W world, B base (the IMU's axes), F frame of a foot; X^ is the estimate of X. State: R_WB, v_WB, p_WB, biases b_g,
///   b_a, and of each foot on the ground p_WF (of a sphere its centre) and, of a sole, R_WF.
///   Errors, true values without hat:  R^ = exp(phi) R,  v^ = exp(phi) v + nu,  p^ = exp(phi) p + rho,
///   p_WF^ = exp(phi) p_WF + delta,  R_WF^ = exp(psi) R_WF,  b^ = b + beta;  order phi nu rho beta_g beta_a, then by
///   foot delta and psi.
///
///   Prediction     R^ <- R^ exp(h (rate - b_g)),  v^ <- v^ + h (R^ (force - b_a) + g),  p^ <- p^ + h v^
///     phi' = -R^ beta_g,  nu' = g x phi - R^ beta_a - v^ x R^ beta_g,  rho' = nu - p^ x R^ beta_g,
///     delta' = -p_WF^ x R^ beta_g
///   Measurement    z_p = p^ + R^ p_BF(joints) - p_WF^ = rho - delta,  z_R = log(R^ R_BF(joints) R_WF^^T) = phi - psi
///     with noise J Q J^T from the encoders. These Jacobians hold at any state.
/// A sphere rolls: its centre moves by w_WF x r n, n the normal of the terrain where it landed (up without terrain). A
/// foot that has just landed, or carries little load, may slide (see OdometryOptions). A foot that is farther from its
/// place than the gate has slipped, and its state is initialised again.
///
/// Hartley, Ghaffari, Eustice and Grizzle, Contact-aided invariant extended Kalman filtering for robot state
/// estimation, IJRR 39(4), 2020, doi:10.1177/0278364919894385; Bloesch et al., State estimation for legged robots, RSS
/// 2012, doi:10.15607/RSS.2012.VIII.003. Update allocates nothing.
class LegOdometry {
 public:
  /// Known data of the sensors and of the ground.
  struct Setup {
    OdometryOptions options;
    SensorOptions data_sheet;  ///< its noise and biases; delays are not compensated
    double step_s = 0.001;
  };

  /// Model and terrain must outlive it. @throws InvalidArgument for an option out of its range.
  LegOdometry(const RobotModel& model, const Terrain& terrain, const Setup& setup);

  /// Starts at rest at the base pose of q, with all feet in the air.
  void Start(const VectorX& q);

  /// Call once per step: updates the state of the last step with the readings since.
  void Update(const ImuReading& imu, const JointReading& joints, const ContactReading& contact);

  /// The two halves of Update.
  void Predict(const ImuReading& imu);
  void Correct(const JointReading& joints, const ContactReading& contact);

  const Matrix3& R_WB() const { return R_WB_; }
  const Vector3& v_WB() const { return v_WB_; }  ///< [m/s]
  const Vector3& p_WB() const { return p_WB_; }  ///< [m]
  Vector3 w_WB() const { return R_WB_ * rate_B_; }
  const Vector3& gyroscope_bias() const { return gyroscope_bias_; }          ///< [rad/s]
  const Vector3& accelerometer_bias() const { return accelerometer_bias_; }  ///< [m/s^2]

  /// Whether the foot is part of the state, and its place (of a sphere, its centre) [m].
  bool Holds(int foot) const { return feet_[static_cast<std::size_t>(foot)].is_held; }
  const Vector3& p_WF(int foot) const { return feet_[static_cast<std::size_t>(foot)].p_WF; }

  /// Covariance of phi, nu, rho, beta_g, beta_a (15), then by foot of delta and, for soles, psi; zero for feet in the
  /// air.
  const MatrixX& covariance() const { return P_; }

  /// phi, nu, rho of the estimate relative to the truth: the errors that the covariance describes.
  Eigen::Matrix<double, 9, 1> ErrorAgainst(const VectorX& q, const VectorX& v) const;

  /// Number of detected slips of feet.
  int slips() const { return slips_; }

 private:
  static constexpr int kPhi = 0, kNu = 3, kRho = 6, kRateBias = 9, kForceBias = 12, kFeet = 15;
  using Rows = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, 6, 1>;
  using Square = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, 6, 6>;

  struct FootState {
    int at = 0, rows = 3;  // in the covariance
    bool is_held = false;
    double held_s = 0.0, missing_s = 0.0;
    Vector3 p_WF = Vector3::Zero();
    Matrix3 R_WF = Matrix3::Identity();
    Vector3 w_WF = Vector3::Zero();
    Vector3 normal_W = Vector3::UnitZ();  // of the ground under it
    Vector3 p_BF = Vector3::Zero();       // from the joint readings
    Matrix3 R_BF = Matrix3::Identity();
  };

  void PredictCovariance(double h);
  void AddNoise(double h);
  void Creep(FootState& foot, double trust);
  double TrustOf(const FootState& foot, double load_n) const;
  void ReadFeet(const JointReading& joints);
  Square NoiseOf(std::size_t foot);
  void PutDown(std::size_t foot);
  void UseTerrain(std::size_t foot);
  void LiftOff(FootState& foot);
  void CorrectBy(std::size_t foot);
  void Apply();

  const RobotModel& model_;
  const Terrain& terrain_;
  const OdometryOptions options_;
  const SensorOptions sheet_;
  const double step_s_;
  std::vector<FootState> feet_;
  Matrix3 R_WB_ = Matrix3::Identity();
  Vector3 v_WB_ = Vector3::Zero(), p_WB_ = Vector3::Zero();
  Vector3 gyroscope_bias_ = Vector3::Zero(), accelerometer_bias_ = Vector3::Zero();
  Vector3 rate_B_ = Vector3::Zero();  // without bias
  MatrixX P_;
  int slips_ = 0;
  // Scratch variables.
  DynamicsScratch scratch_;
  VectorX q_, v_;
  MatrixX jacobian_;
  Eigen::Matrix<double, Eigen::Dynamic, 3> shape_;  // of the gyroscope's noise
  Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, Eigen::Dynamic, 6> PH_, gain_;
  VectorX correction_;
};

}  // namespace gaitwright
