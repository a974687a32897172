// SPDX-License-Identifier: BSD-3-Clause
#include "optimisation/whole_body/solve_whole_body.h"

#include <fmt/format.h>

#include <algorithm>

#include "kinematics/ik/whole_body_ik.h"
#include "kinematics/spatial/rotation.h"
#include "kinematics/trajectory/swing_curve.h"
#include "planning/plan/sample_plan.h"

namespace gaitwright {
namespace {

/// Follows one foot through its footholds and swings, and integrates its rolling.
///
/// A sphere's contact point is `path + roll`. The path is constant in stance and is the swing curve in swing; the roll
/// always changes with the foot's rotation. A swing's path therefore ends short of its foothold by the expected roll.
/// expected there.
class FootPath {
 public:
  FootPath(const RobotModel& model, const WholeBodyProblem& problem, int foot,
           const std::vector<Vector3>& expected_roll)
      : foot_(&model.feet[static_cast<std::size_t>(foot)]), expected_roll_(&expected_roll) {
    const auto& all = problem.footsteps->footholds;
    for (std::size_t i = 0; i < all.size(); ++i) {
      if (all[i].foot == foot) {
        footholds_.push_back(&all[i]);
        index_.push_back(i);
      }
    }
    for (const SwingTrajectory& swing : *problem.swings) {
      if (swing.foot == foot) swings_.push_back(&swing);
    }
    path_ = footholds_.front()->X_WF;
  }

  /// The target at a time; times must not decrease.
  FootTarget At(double time_s) {
    Advance(time_s);
    FootTarget target;
    FrameMotion motion;
    motion.X_WF = path_;
    if (in_swing_) motion = Evaluate(curve_, time_s);
    // The curve's own z changes from the normal of the first ground to that of the second.
    target.normal_W = motion.X_WF.linear().col(2);
    target.normal_rate_W = motion.w_WF.cross(target.normal_W);
    target.normal_anchor_W = started_ ? Vector3(0.5 * (normal_last_ + target.normal_W)) : target.normal_W;
    const Vector3 centre = foot_->radius * target.normal_W, moves = foot_->radius * target.normal_rate_W;
    target.p_WF = motion.X_WF.translation() + centre + roll_;
    target.R_WF = motion.X_WF.linear();
    target.R_anchor = R_last_;
    target.v_WF = motion.v_WF + moves;
    target.w_WF = motion.w_WF;
    target.a_WF = motion.a_WF + motion.alpha_WF.cross(centre) + motion.w_WF.cross(moves);
    target.alpha_WF = motion.alpha_WF;
    normal_ = target.normal_W;
    normal_anchor_ = target.normal_anchor_W;
    return target;
  }

  /// Stores the foot's rotation after the sample is solved.
  void Settle(const Matrix3& R_WF) {
    if (started_) roll_ += foot_->radius * RotationLog(R_WF * R_last_.transpose()).cross(normal_anchor_);
    started_ = true;
    normal_last_ = normal_;
    R_last_ = R_WF;
  }
  void Start(const Matrix3& R_WF) { R_last_ = R_WF; }

  const Vector3& roll() const { return roll_; }
  std::size_t foothold_index() const { return index_[stance_]; }
  bool in_swing() const { return in_swing_; }

 private:
  static constexpr double kTiny = 1e-9;

  void Advance(double time_s) {
    if (!in_swing_ && stance_ + 1 < footholds_.size() && time_s > footholds_[stance_]->liftoff_s + kTiny) {
      in_swing_ = true;
      const Foothold& next = *footholds_[stance_ + 1];
      curve_ = CurveOf(*swings_[stance_]);
      curve_.X_WF_start = path_;
      curve_.X_WF_end = next.X_WF;
      if (foot_->radius > 0.0) curve_.X_WF_end.translation() -= (*expected_roll_)[index_[stance_ + 1]];
    }
    if (in_swing_ && time_s > curve_.end_s - kTiny) {
      in_swing_ = false;
      ++stance_;
      path_ = curve_.X_WF_end;
    }
  }

  const Foot* foot_;
  const std::vector<Vector3>* expected_roll_;
  std::vector<const Foothold*> footholds_;
  std::vector<std::size_t> index_;
  std::vector<const SwingTrajectory*> swings_;
  std::size_t stance_ = 0;
  bool in_swing_ = false, started_ = false;
  Pose path_ = Pose::Identity();
  SwingCurve curve_;
  Vector3 roll_ = Vector3::Zero(), normal_ = Vector3::UnitZ();
  Vector3 normal_anchor_ = Vector3::UnitZ(), normal_last_ = Vector3::UnitZ();
  Matrix3 R_last_ = Matrix3::Identity();
};

/// Sets the body's target without its feet.
void SetBodyTarget(const RobotModel& model, const WholeBodyProblem& problem, int sample, BodyTarget& target) {
  const CentroidalTrajectory& c = *problem.centroidal;
  const auto k = static_cast<std::size_t>(sample);
  target.p_WC = c.p_WC[k];
  target.v_WC = c.v_WC[k];
  target.a_WC = c.a_WC[k];
  const VectorX standing = StandingConfiguration(model);
  const BaseTurning turning = problem.turning(c.start_s + sample * c.step_s);
  target.R_WB = turning.R_WB * BaseRotation(standing);
  target.w_WB = turning.w_WB;
  target.alpha_WB = turning.alpha_WB;
  if (problem.posture) problem.posture(c.start_s + sample * c.step_s, target.posture);
}

/// Initial guess for the next sample: the last solution extrapolated by its velocity.
void Extrapolate(const VectorX& v, double step_s, VectorX& q) {
  q.head<3>() += step_s * v.head<3>();
  const Matrix3 R = RotationExp(step_s * v.segment<3>(3)) * Quaternion(q[6], q[3], q[4], q[5]).toRotationMatrix();
  q.segment<4>(3) = Quaternion(R).coeffs();
  q.tail(q.size() - 7) += step_s * v.tail(v.size() - 6);
}

/// The standing configuration, rotated and moved under the first centre of mass.
VectorX FirstGuess(const RobotModel& model, const BodyTarget& target, DynamicsScratch& scratch) {
  VectorX q = StandingConfiguration(model);
  const Quaternion R(target.R_WB);
  q.segment<4>(3) = R.coeffs();
  ForwardKinematics(model, q, scratch);
  q.head<3>() += target.p_WC - CentreOfMass(model, scratch);
  return q;
}

/// Solves the first sample. Spheres start on their footholds without roll, independent of the initial guess: the roll
/// is measured from the rotations of each solution, until these converge.
Result<int> SolveStart(WholeBodyIk& ik, double time_s, std::vector<FootPath>& paths, BodyTarget& target, VectorX& q) {
  constexpr int kPasses = 50;
  constexpr double kSettled = 1e-10;  // [rad]
  Result<int> solved = 0;
  for (int pass = 0; pass < kPasses; ++pass) {
    for (std::size_t f = 0; f < paths.size(); ++f) target.feet[f] = paths[f].At(time_s);
    solved = ik.SolvePosition(target, q);
    if (!solved) return solved;
    double turned = 0.0;
    for (std::size_t f = 0; f < paths.size(); ++f) {
      const Matrix3 R_WF = ik.FootPose(static_cast<int>(f)).linear();
      turned = std::max(turned, RotationLog(R_WF * target.feet[f].R_anchor.transpose()).norm());
      paths[f].Start(R_WF);
    }
    if (turned < kSettled) break;
  }
  return solved;
}

void NoteRolls(const std::vector<FootPath>& paths, double time_s, const FootstepPlan& footsteps,
               WholeBodySolution& solution) {
  constexpr double kTiny = 1e-9;
  for (const FootPath& path : paths) {
    if (path.in_swing()) continue;
    const std::size_t i = path.foothold_index();
    const Foothold& foothold = footsteps.footholds[i];
    if (std::abs(time_s - foothold.touchdown_s) < kTiny) solution.roll_at_touchdown_W[i] = path.roll();
    if (time_s <= foothold.liftoff_s + kTiny) solution.roll_at_liftoff_W[i] = path.roll();
  }
}

}  // namespace

Result<WholeBodySolution> SolveWholeBody(const RobotModel& model, const WholeBodyProblem& problem,
                                         const std::vector<Vector3>& expected_roll_W, const WholeBodyOptions& options,
                                         double* unreached_s) {
  const CentroidalTrajectory& centroidal = *problem.centroidal;
  WholeBodyIk ik(model);
  DynamicsScratch scratch(model);
  std::vector<FootPath> paths;
  for (int f = 0; f < static_cast<int>(model.legs.size()); ++f) paths.emplace_back(model, problem, f, expected_roll_W);
  WholeBodySolution solution;
  solution.roll_at_touchdown_W.assign(problem.footsteps->footholds.size(), Vector3::Zero());
  solution.roll_at_liftoff_W = solution.roll_at_touchdown_W;
  WholeBodyTrajectory& out = solution.trajectory;
  out.start_s = centroidal.start_s;
  out.step_s = centroidal.step_s;
  BodyTarget target;
  target.feet.resize(model.legs.size());
  VectorX q, v, a;
  for (int k = 0; k < centroidal.size(); ++k) {
    const double time_s = centroidal.start_s + k * centroidal.step_s;
    SetBodyTarget(model, problem, k, target);
    if (k == 0) {
      q = FirstGuess(model, target, scratch);
      ForwardKinematics(model, q, scratch);
      for (std::size_t f = 0; f < paths.size(); ++f) {
        paths[f].Start(FramePose(scratch, model.feet[f].body, model.feet[f].X_BF).linear());
      }
    } else {
      Extrapolate(v, out.step_s, q);
    }
    for (std::size_t f = 0; f < paths.size(); ++f) target.feet[f] = paths[f].At(time_s);
    const Result<int> solved = k == 0 ? SolveStart(ik, time_s, paths, target, q) : ik.SolvePosition(target, q);
    if (!solved) {
      Failure failure = solved.failure();
      failure.stage = "SolveWholeBody";
      if (unreached_s != nullptr) *unreached_s = time_s;
      failure.message = fmt::format("at {:.3f} s: {}", time_s, failure.message);
      return failure;
    }
    for (std::size_t f = 0; f < paths.size(); ++f) paths[f].Settle(ik.FootPose(static_cast<int>(f)).linear());
    NoteRolls(paths, time_s, *problem.footsteps, solution);
    ik.SolveRates(target, q, v, a);
    out.q.push_back(q);
    out.v.push_back(v);
    out.a.push_back(a);
  }
  AddContactForces(model, problem, options, solution);
  return solution;
}

}  // namespace gaitwright
