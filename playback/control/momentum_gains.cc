// SPDX-License-Identifier: BSD-3-Clause
#include "playback/control/momentum_gains.h"

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "kinematics/dynamics/dynamics.h"
#include "kinematics/dynamics/foot_contact.h"
#include "kinematics/spatial/rotation.h"
#include "planning/plan/sample_plan.h"
#include "playback/control/situation.h"

namespace gaitwright {
namespace {

constexpr Eigen::Index kFeet = MomentumGains::kFeet;

/// A standing foot, in the middle of an interval of the plan's grid.
struct Standing {
  Eigen::Index foot = 0;
  Pose X_WF = Pose::Identity();
  Vector3 force_W = Vector3::Zero();
  double load_n = 0.0;
  MatrixX choices;  ///< 6 x (3 points): wrench about the contact per chosen variable and per newton of load
};

/// The robot in the middle of the interval.
struct Moment {
  Vector3 p_WC = Vector3::Zero(), w_WB = Vector3::Zero();
  Matrix3 inverse_W = Matrix3::Identity();  ///< of the locked inertia
  std::vector<Standing> feet;
};

double Squared(double x) { return x * x; }

/// The Riccati recursion, backwards along a plan.
class Backwards {
 public:
  Backwards(const RobotModel& model, const MotionPlan& plan, const MomentumErrors& errors)
      : model_(model),
        plan_(plan),
        swings_(model, plan),
        scratch_(model),
        num_feet_(static_cast<Eigen::Index>(model.feet.size())),
        size_(kFeet + 2 * num_feet_),
        share_(plan.whole_body.step_s / std::sqrt(std::max(model.leg_length_m(), 1e-3) / kGravity)),
        step_weight_(1.0 / Squared(errors.step_m)),
        cost_(MatrixX::Zero(size_, size_)),
        steps_(MatrixX::Zero(2 * num_feet_, size_)) {
    const double sizes[4] = {errors.position_m, errors.velocity_m_s, errors.turn_rad, errors.rate_rad_s};
    for (Eigen::Index i = 0; i < 4; ++i) cost_.diagonal().segment<3>(3 * i).setConstant(1.0 / Squared(sizes[i]));
    value_ = cost_;  // for the time unit after the plan's end
  }

  MomentumGains Run() {
    const WholeBodyTrajectory& body = plan_.whole_body;
    MomentumGains gains{body.start_s, body.step_s, {}};
    gains.rows.resize(static_cast<std::size_t>(std::max(body.size() - 1, 0)));
    FootSet after = 0;
    for (int k = body.size() - 2; k >= 0; --k) {
      const double middle_s = body.start_s + (k + 0.5) * body.step_s;
      const FootSet stance = plan_.schedule.phases[static_cast<std::size_t>(PhaseAt(plan_.schedule, middle_s))].stance;
      PassTouchdowns(after & ~stance);
      PassInterval(MomentAt(middle_s, stance), gains.rows[static_cast<std::size_t>(k)]);
      after = stance;
    }
    return gains;
  }

 private:
  Moment MomentAt(double time_s, FootSet stance) {
    SampleWholeBody(plan_.whole_body, time_s, sample_);
    ForwardVelocities(model_, sample_.q, sample_.v, scratch_);
    Moment moment{CentreOfMass(model_, scratch_), scratch_.w_WB[0], LockedInertia(model_, scratch_).inverse(), {}};
    for (int f = 0; f < static_cast<int>(num_feet_); ++f) {
      if (!Contains(stance, f)) continue;
      const GroundUnder& ground = swings_.Under(f, time_s);
      Standing foot;
      foot.foot = f;
      foot.X_WF = ContactFrame(model_, scratch_, f, ground.normal_W);
      foot.force_W = sample_.wrenches[static_cast<std::size_t>(f)].force_W;
      foot.load_n = std::max(foot.force_W.dot(ground.normal_W), 0.0);
      foot.choices = ChoicesOf(foot.X_WF.linear(), ground);
      moment.feet.push_back(foot);
    }
    return moment;
  }

  static MatrixX ChoicesOf(const Matrix3& R_WF, const GroundUnder& ground) {
    const auto points = static_cast<Eigen::Index>(ground.support_F.size());
    const Matrix3 along = ground.normal_W * ground.normal_W.transpose();
    const Matrix3 force = (along + ground.friction * (Matrix3::Identity() - along)) / static_cast<double>(points);
    MatrixX choices(6, 3 * points);
    for (Eigen::Index i = 0; i < points; ++i) {
      const Vector2& p_F = ground.support_F[static_cast<std::size_t>(i)];
      choices.block<3, 3>(0, 3 * i) = force;
      choices.block<3, 3>(3, 3 * i) = Skew(R_WF * Vector3(p_F.x(), p_F.y(), 0.0)) * force;
    }
    return choices;
  }

  /// A of x' = A x + B u.
  MatrixX DriftOf(const Moment& now) const {
    MatrixX A = MatrixX::Zero(size_, size_);
    A.block<3, 3>(0, 3).setIdentity();
    A.block<3, 3>(6, 6) = Skew(now.w_WB);
    A.block<3, 3>(6, 9).setIdentity();
    for (const Standing& foot : now.feet) {
      const Matrix3 turned = now.inverse_W * Skew(foot.force_W);
      A.block<3, 3>(9, 0) += turned;
      A.block<3, 2>(9, kFeet + 2 * foot.foot) = -turned.leftCols<2>();
    }
    return A;
  }

  /// B of x' = A x + B u.
  MatrixX PushOf(const Moment& now) const {
    Eigen::Index columns = 0;
    for (const Standing& foot : now.feet) columns += foot.choices.cols();
    MatrixX B = MatrixX::Zero(size_, columns);
    Eigen::Index column = 0;
    for (const Standing& foot : now.feet) {
      const Eigen::Index n = foot.choices.cols();
      const MatrixX wrench = foot.load_n * foot.choices;
      const Matrix3 arm = Skew(foot.X_WF.translation() - now.p_WC);
      B.block(3, column, 3, n) = wrench.topRows<3>() / model_.total_mass_kg;
      B.block(9, column, 3, n) = now.inverse_W * (arm * wrench.topRows<3>() + wrench.bottomRows<3>());
      column += n;
    }
    return B;
  }

  void PassInterval(const Moment& now, MomentumGains::Row& row) {
    const double h = plan_.whole_body.step_s;
    const MatrixX A = DriftOf(now), B = PushOf(now);
    const MatrixX drift = MatrixX::Identity(size_, size_) + h * A + 0.5 * h * h * A * A;
    const MatrixX push = h * B + 0.5 * h * h * A * B;
    MatrixX K = MatrixX::Zero(B.cols(), size_);
    if (B.cols() > 0) {
      MatrixX weight = push.transpose() * value_ * push;
      weight.diagonal().array() += share_;
      K = -weight.llt().solve(push.transpose() * value_ * drift);
    }
    const MatrixX closed = drift + push * K;
    SetValue(share_ * (cost_ + K.transpose() * K) + closed.transpose() * value_ * closed);
    steps_ = (steps_ * closed).eval();
    row.steps = steps_;
    row.wrench_per_n.assign(static_cast<std::size_t>(num_feet_), MatrixX::Zero(6, size_));
    Eigen::Index column = 0;
    for (const Standing& foot : now.feet) {
      const Eigen::Index n = foot.choices.cols();
      row.wrench_per_n[static_cast<std::size_t>(foot.foot)] = foot.choices * K.middleRows(column, n);
      column += n;
    }
  }

  void PassTouchdowns(FootSet down) {
    for (Eigen::Index f = 0; f < num_feet_; ++f) {
      if (!Contains(down, static_cast<int>(f))) continue;
      MatrixX under = MatrixX::Zero(2, size_);  // horizontal place of the body
      under.leftCols<2>().setIdentity();
      MatrixX landed = MatrixX::Identity(size_, size_);
      landed.middleRows<2>(kFeet + 2 * f) = under;
      const MatrixX by_place = value_.middleRows<2>(kFeet + 2 * f);
      MatrixX weight = by_place.middleCols<2>(kFeet + 2 * f);
      weight.diagonal().array() += step_weight_;
      const MatrixX away = -weight.llt().solve(by_place * landed);
      landed.middleRows<2>(kFeet + 2 * f) += away;
      SetValue(step_weight_ * away.transpose() * away + landed.transpose() * value_ * landed);
      steps_ = (steps_ * landed).eval();
      steps_.middleRows<2>(2 * f) = under + away;
    }
  }

  void SetValue(const MatrixX& value) { value_ = (0.5 * (value + value.transpose())).eval(); }

  const RobotModel& model_;
  const MotionPlan& plan_;
  const Swings swings_;
  DynamicsScratch scratch_;
  WholeBodySample sample_;
  const Eigen::Index num_feet_, size_;
  const double share_;        // duration of an interval in time units
  const double step_weight_;  // [1/m^2]
  MatrixX cost_, value_;      // quadratic forms in x: cost of a time unit, and cost of all that follows
  MatrixX steps_;             // see MomentumGains::Row
};

}  // namespace

const MomentumGains::Row& MomentumGains::At(double time_s) const {
  constexpr double kTiny = 1e-6;  // of a step
  const double last = static_cast<double>(rows.size()) - 1.0;
  return rows[static_cast<std::size_t>(std::clamp(std::floor((time_s - start_s) / step_s + kTiny), 0.0, last))];
}

MomentumGains DeriveMomentumGains(const RobotModel& model, const MotionPlan& plan, const MomentumErrors& errors) {
  return Backwards(model, plan, errors).Run();
}

}  // namespace gaitwright
