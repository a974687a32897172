// SPDX-License-Identifier: BSD-3-Clause
#include "workflows/exchange/derive_base.h"

#include <fmt/format.h>

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

#include "kinematics/dynamics/dynamics.h"
#include "kinematics/dynamics/foot_contact.h"
#include "kinematics/spatial/rotation.h"
#include "planning/plan/support_plane.h"
#include "workflows/exchange/foot_track.h"
#include "workflows/exchange/knot_spline.h"

namespace gaitwright {
namespace {

/// Computes the base pose row by row from the stance feet.
class BaseFollower {
 public:
  BaseFollower(const RobotModel& model, const Terrain& terrain, const ImportOptions& options, bool turned)
      : model_(model),
        terrain_(terrain),
        height_m_(options.contact_height * model.leg_length_m()),
        turned_(turned),
        scratch_(model),
        places_W_(model.feet.size()),
        R_WF_(model.feet.size(), Matrix3::Identity()) {}

  /// Sets the base of every row. @param contact by row, or empty. @param flies without a stance foot, true: the base is
  /// in flight; false: its lowest feet stand.
  void Follow(const std::vector<FootSet>& contact, bool flies, EvenMotion& motion) {
    constexpr double kLate = 0.05;  // [s]
    up_B_ = BaseRotation(StandingConfiguration(model_)).transpose().col(2);
    R_WB_ = BaseRotation(StandingConfiguration(model_));
    p_WB_.setZero();
    velocity_W_.setZero();
    R_late_ = R_WB_;
    for (int k = 0; k < motion.size(); ++k) {
      VectorX& q = motion.q[static_cast<std::size_t>(k)];
      if (turned_) R_WB_ = BaseRotation(q);
      LookAtFeet(q);
      const Vector3 before_W = p_WB_;
      if (k == 0) p_WB_.z() -= LowestFoot(R_WB_);
      FootSet stance = contact.empty() ? 0 : contact[static_cast<std::size_t>(k)];
      if (stance == 0 && !flies) stance = LowFeet();
      if (k == 0) {
        for (std::size_t f = 0; f < places_W_.size(); ++f) PutDown(f, true);
        was_ = stance;
      }
      Move(stance, motion.step_s);
      if (k > 0) NoteVelocity((p_WB_ - before_W) / motion.step_s, stance & was_, motion.step_s);
      Settle(stance, motion.step_s);
      R_late_ = Quaternion(R_late_).slerp(1.0 - std::exp(-motion.step_s / kLate), Quaternion(R_WB_)).toRotationMatrix();
      q.head<3>() = p_WB_;
      q.segment<4>(3) = Quaternion(R_WB_).coeffs();
    }
  }

 private:
  /// Computes the feet in the base's frame.
  void LookAtFeet(const VectorX& q) {
    VectorX at_origin = q;
    at_origin.head<7>() << 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0;
    ForwardKinematics(model_, at_origin, scratch_);
    X_BF_.clear();
    for (const Foot& foot : model_.feet) X_BF_.push_back(FramePose(scratch_, foot.body, foot.X_BF));
  }

  /// The contact points of a foot in W.
  std::vector<Vector3> PointsOf(std::size_t f, const Matrix3& R_WB) const {
    const Foot& foot = model_.feet[f];
    Pose X_WF = Pose::Identity();
    X_WF.linear() = R_WB * X_BF_[f].linear();
    X_WF.translation() = R_WB * X_BF_[f].translation() + p_WB_;
    if (foot.radius > 0.0)
      X_WF.translation() -= foot.radius * GroundAt(terrain_, X_WF.translation().head<2>()).normal_W;
    return ContactPoints(foot, X_WF);
  }

  double HeightOf(std::size_t f, const Matrix3& R_WB) const {
    double least = 1e9;
    for (const Vector3& p : PointsOf(f, R_WB))
      least = std::min(least, p.z() - GroundAt(terrain_, p.head<2>()).height_m);
    return least;
  }
  double LowestFoot(const Matrix3& R_WB) const {
    double least = 1e9;
    for (std::size_t f = 0; f < X_BF_.size(); ++f) least = std::min(least, HeightOf(f, R_WB));
    return least;
  }

  /// The feet near the lowest one, with the base orientation of a short time before. With the current one, feet that
  /// lift off but still count as stance would rotate the base with them, so that after the first detected lift-off the
  /// others would seem to stay on the ground.
  FootSet LowFeet() const {
    const double lowest = LowestFoot(R_late_);
    FootSet low = 0;
    for (std::size_t f = 0; f < X_BF_.size(); ++f) {
      if (HeightOf(f, R_late_) <= lowest + height_m_) low |= FootBit(static_cast<int>(f));
    }
    return low;
  }

  void PutDown(std::size_t f, bool on_ground) {
    places_W_[f] = PointsOf(f, R_WB_);
    R_WF_[f] = R_WB_ * X_BF_[f].linear();
    if (!on_ground) return;
    for (Vector3& p : places_W_[f]) p.z() = GroundAt(terrain_, p.head<2>()).height_m;
  }

  /// Distance that a sphere has rolled since the previous row.
  Vector3 RollOf(std::size_t f) const {
    const Foot& foot = model_.feet[f];
    if (foot.radius == 0.0) return Vector3::Zero();
    const Vector3 normal_W = GroundAt(terrain_, places_W_[f].front().head<2>()).normal_W;
    return foot.radius * RotationLog(R_WB_ * X_BF_[f].linear() * R_WF_[f].transpose()).cross(normal_W);
  }

  /// Filters the base velocity, which is used while no foot determines it. It is averaged over a short time, since feet
  /// that change in one row do not agree exactly on the base position.
  void NoteVelocity(const Vector3& seen_W, FootSet held, double step_s) {
    constexpr double kTime = 0.02;  // [s]
    if (held != 0) velocity_W_ += (1.0 - std::exp(-step_s / kTime)) * (seen_W - velocity_W_);
  }

  /// Finds the base pose for which the feet in stance before and now keep their positions, by Gauss-Newton steps.
  void Move(FootSet stance, double step_s) {
    const FootSet held = stance & was_;
    if (held == 0) {
      p_WB_ += step_s * velocity_W_;
      if (stance == 0) {  // only in flight, not when other feet take over
        p_WB_ -= 0.5 * step_s * step_s * kGravity * Vector3::UnitZ();
        velocity_W_ -= step_s * kGravity * Vector3::UnitZ();
      }
      return;
    }
    constexpr int kSteps = 4;
    const Matrix3 R_before = R_WB_;
    for (int i = 0; i < kSteps; ++i) Step(held, R_before);
  }

  void Step(FootSet held, const Matrix3& R_before) {
    const double upright = 1e-3 * model_.leg_length_m(), still = 1e-4 * model_.leg_length_m();  // weights [m]
    Eigen::Matrix<double, 6, 6> H = Eigen::Matrix<double, 6, 6>::Zero();
    Vector6 g = Vector6::Zero();
    const auto add = [&](const Eigen::Matrix<double, 3, 6>& J, const Vector3& r) {
      H += J.transpose() * J;
      g += J.transpose() * r;
    };
    Eigen::Matrix<double, 3, 6> J;
    for (std::size_t f = 0; f < X_BF_.size(); ++f) {
      if (!Contains(held, static_cast<int>(f))) continue;
      const Vector3 roll = RollOf(f);
      const std::vector<Vector3> points = PointsOf(f, R_WB_);
      for (std::size_t i = 0; i < points.size(); ++i) {
        J << Matrix3::Identity(), -Skew(points[i] - p_WB_);
        add(J, points[i] - places_W_[f][i] - roll);
      }
    }
    const Vector3 up_W = R_WB_ * up_B_;
    J << Matrix3::Zero(), -upright * Skew(up_W);
    add(J, upright * (up_W - Vector3::UnitZ()));
    J << Matrix3::Zero(), still * Matrix3::Identity();
    add(J, still * RotationLog(R_WB_ * R_before.transpose()));
    Vector6 move = Vector6::Zero();
    if (turned_) {
      move.head<3>() = -H.topLeftCorner<3, 3>().ldlt().solve(Vector3(g.head<3>()));
    } else {
      move = -H.ldlt().solve(g);
    }
    p_WB_ += move.head<3>();
    R_WB_ = Quaternion(RotationExp(move.tail<3>()) * R_WB_).normalized().toRotationMatrix();
  }

  /// Stores the positions of feet that touched down, and moves stance feet towards the ground.
  void Settle(FootSet stance, double step_s) {
    constexpr double kTime = 0.03;  // [s]
    const double share = 1.0 - std::exp(-step_s / kTime);
    for (std::size_t f = 0; f < X_BF_.size(); ++f) {
      const int foot = static_cast<int>(f);
      if (Contains(stance, foot) && Contains(was_, foot)) {
        const Vector3 roll = RollOf(f);
        for (Vector3& p : places_W_[f]) p += roll;
        R_WF_[f] = R_WB_ * X_BF_[f].linear();
      } else {
        PutDown(f, false);
      }
      for (Vector3& p : places_W_[f]) {
        const GroundPoint ground = GroundAt(terrain_, p.head<2>());
        if (ground.patch >= 0) p.z() += share * (ground.height_m - p.z());
      }
    }
    was_ = stance;
  }

  const RobotModel& model_;
  const Terrain& terrain_;
  const double height_m_;
  const bool turned_;
  DynamicsScratch scratch_;
  Vector3 up_B_ = Vector3::UnitZ(), p_WB_ = Vector3::Zero(), velocity_W_ = Vector3::Zero();
  Matrix3 R_WB_ = Matrix3::Identity(), R_late_ = Matrix3::Identity();
  std::vector<Pose> X_BF_;
  std::vector<std::vector<Vector3>> places_W_;
  std::vector<Matrix3> R_WF_;
  FootSet was_ = 0;
};

/// Default cut-off frequency of the smoothing of the base [Hz]. It is needed because feet that take over from each
/// other do not agree exactly on the base position.
constexpr double kUsualSmoothing = 10.0;

/// Adds the rates of the base, from splines through its rows.
void AddRates(const ImportOptions& options, EvenMotion& motion) {
  std::vector<double> time_s;
  for (int k = 0; k < motion.size(); ++k) time_s.push_back(motion.TimeOf(k));
  MotionTable base;
  base.time_s = time_s;
  for (const VectorX& q : motion.q) {
    base.base_m.emplace_back(q.head<3>());
    base.quaternion.emplace_back(q.segment<4>(3));
  }
  base.q.assign(time_s.size(), VectorX());
  RobotModel no_joints;
  ImportOptions as_is = options;
  as_is.grid_step_s = motion.step_s;
  as_is.lift_m = 0.0;
  if (as_is.smoothing_hz == 0.0) as_is.smoothing_hz = kUsualSmoothing;
  std::vector<DerivedPart> unsaid;
  std::vector<std::string> unwarned;
  const EvenMotion smooth = Resample(no_joints, base, as_is, unsaid, unwarned);
  for (std::size_t k = 0; k < motion.q.size(); ++k) {
    motion.q[k].head<7>() = smooth.q[k].head<7>();
    motion.v[k].head<6>() = smooth.v[k].head<6>();
    motion.a[k].head<6>() = smooth.a[k].head<6>();
  }
}

/// The stance feet of a schedule by row.
std::vector<FootSet> RowsOf(const ContactSchedule& schedule, const EvenMotion& motion) {
  std::vector<FootSet> rows;
  for (int k = 0; k < motion.size(); ++k)
    rows.push_back(schedule.phases[static_cast<std::size_t>(PhaseAt(schedule, motion.TimeOf(k)))].stance);
  return rows;
}

}  // namespace

void DeriveBase(const RobotModel& model, const Terrain& terrain, const ImportOptions& options, bool turned,
                EvenMotion& motion, std::vector<DerivedPart>& derived) {
  constexpr int kPasses = 2;
  const bool given = !motion.contact.empty();
  BaseFollower follower(model, terrain, options, turned);
  follower.Follow(motion.contact, given, motion);
  AddRates(options, motion);
  for (int pass = 0; pass < kPasses && !given; ++pass) {
    std::vector<DerivedPart> unsaid;
    const ContactSchedule schedule = ScheduleOf(model, motion, FeetOf(model, terrain, motion), options, unsaid);
    follower.Follow(RowsOf(schedule, motion), false, motion);
    AddRates(options, motion);
  }
  if (options.lift_m != 0.0) {
    for (VectorX& q : motion.q) q[2] += options.lift_m;
  }
  derived.push_back(
      {turned ? "position of the base" : "pose of the base",
       fmt::format("from the stance feet, smoothed above {:.4g} Hz; it starts above the origin in the standing posture",
                   options.smoothing_hz > 0.0 ? options.smoothing_hz : kUsualSmoothing)});
}

}  // namespace gaitwright
