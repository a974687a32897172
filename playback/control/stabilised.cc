// SPDX-License-Identifier: BSD-3-Clause
#include "playback/control/stabilised.h"

#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <set>

#include "kinematics/dynamics/contact_split.h"
#include "kinematics/dynamics/foot_contact.h"
#include "kinematics/spatial/rotation.h"
#include "kinematics/stability/polygon.h"
#include "kinematics/stability/zero_moment_point.h"
#include "kinematics/trajectory/swing_curve.h"
#include "planning/plan/sample_plan.h"
#include "playback/control/joint_pd.h"

namespace gaitwright {
namespace {

/// Where the robot is and where the plan has it, at the same time.
struct BodyState {
  Vector3 p_WC, v_WC;
  Matrix3 R_WB;
  Vector3 w_WB;
  std::vector<Pose> X_WF;  // contact frames
};

/// Feedback carries the balance, so the joints may give way more than under replay alone.
GainOptions SoftGains(const StabilisedOptions& options) {
  GainOptions gains;
  gains.stance_frequency = options.stance_frequency;
  gains.stance_damping = options.stance_damping;
  return gains;
}

class Stabilised final : public Controller {
 public:
  Stabilised(const RobotModel& model, const MotionPlan& plan, const StabilisedOptions& options)
      : model_(model),
        plan_(plan),
        options_(options),
        replay_(model, plan, SoftGains(options)),
        measured_scratch_(model),
        planned_scratch_(model),
        leg_scratch_(model) {
    MatrixX M;
    const VectorX standing = StandingConfiguration(model);
    MassMatrix(model, standing, measured_scratch_, M);
    const Vector3 p_OC = CentreOfMass(model, measured_scratch_) - standing.head<3>();
    for (int i = 0; i < 3; ++i) {
      inertia_[i] = M(3 + i, 3 + i) - model.total_mass_kg * (p_OC.squaredNorm() - p_OC[i] * p_OC[i]);
    }
    ListLegs();
    Reset();
  }

  void Reset() override {
    replay_.Reset();
    offset_W_.assign(model_.feet.size(), Vector2::Zero());
    liftoff_offset_W_ = offset_W_;
    last_offset_W_ = offset_W_;
    wanted_W_ = offset_W_;
    follow_W_.setZero();
    follow_rate_W_.setZero();
    ground_tilt_W_.setZero();
  }

  std::string Name() const override { return "stabilised"; }

  JointCommand Update(const ControlInput& input) override {
    JointCommand command = replay_.Update(input);
    SampleWholeBody(plan_.whole_body, input.time_s, sample_);
    Observe(input.q, input.v, measured_scratch_, measured_);
    Observe(sample_.q, sample_.v, planned_scratch_, planned_);
    stance_ = plan_.schedule.phases[static_cast<std::size_t>(PhaseAt(plan_.schedule, input.time_s))].stance;
    omega_rad_s_ = std::sqrt(kGravity / std::max(planned_.p_WC.z(), 0.05));
    FollowFeet(input);
    FollowGround(input);
    BalanceThroughStance(input.contact, command);
    MoveFootholds(input, command);
    return command;
  }

 private:
  void ListLegs() {
    std::vector<int> users(static_cast<std::size_t>(model_.num_dofs()), 0);
    for (const Leg& leg : model_.legs) {
      std::set<int> dofs;
      for (const int joint : leg.joints) dofs.insert(model_.joints[static_cast<std::size_t>(joint)].dof);
      leg_dofs_.emplace_back(dofs.begin(), dofs.end());
      for (const int dof : dofs) ++users[static_cast<std::size_t>(dof)];
    }
    for (std::vector<int>& dofs : leg_dofs_) {
      // A leg that shares a motor with another, or has too few, keeps to its planned footholds.
      const bool free = dofs.size() >= 3 && std::all_of(dofs.begin(), dofs.end(), [&](int dof) {
                          return users[static_cast<std::size_t>(dof)] == 1;
                        });
      if (!free) dofs.clear();
    }
  }

  void Observe(const VectorX& q, const VectorX& v, DynamicsScratch& scratch, BodyState& body) const {
    ForwardVelocities(model_, q, v, scratch);
    body.p_WC = CentreOfMass(model_, scratch);
    body.v_WC = CentroidalMomentum(model_, scratch).head<3>() / model_.total_mass_kg;
    body.R_WB = scratch.R_WB[0];
    body.w_WB = scratch.w_WB[0];
    body.X_WF.clear();
    for (int f = 0; f < static_cast<int>(model_.feet.size()); ++f)
      body.X_WF.push_back(ContactFrame(model_, scratch, f));
  }

  /// Keeps account of where the feet that stand are against the plan, and lets the targets follow the base.
  void FollowFeet(const ControlInput& input) {
    constexpr double kSettle = 0.02;  // [s]
    const double gain = input.step_s / kSettle;
    for (std::size_t f = 0; f < offset_W_.size(); ++f) {
      if (!Contains(stance_, static_cast<int>(f)) || !Contains(input.contact, static_cast<int>(f))) continue;
      const Vector2 seen = (measured_.X_WF[f].translation() - planned_.X_WF[f].translation()).head<2>();
      offset_W_[f] += std::min(gain, 1.0) * (seen - offset_W_[f]);
      liftoff_offset_W_[f] = offset_W_[f];
    }
    const Vector2 displaced = (measured_scratch_.p_WB[0] - planned_scratch_.p_WB[0]).head<2>();
    const Vector2 follow = std::min(input.step_s / options_.follow_s, 1.0) * (displaced - follow_W_);
    follow_W_ += follow;
    follow_rate_W_ = follow / input.step_s;
  }

  /// Soles that bear load lie flat on the ground: their tilt against the plan is the ground's.
  void FollowGround(const ControlInput& input) {
    constexpr double kBearing = 0.3;  // of the weight
    Vector3 tilt = Vector3::Zero();
    int count = 0;
    for (std::size_t f = 0; f < model_.feet.size(); ++f) {
      if (model_.feet[f].sole_F.empty() || !Contains(stance_, static_cast<int>(f))) continue;
      if (input.wrenches[f].force_W.z() < kBearing * model_.weight_n()) continue;
      tilt += RotationLog(measured_.X_WF[f].linear() * planned_.X_WF[f].linear().transpose());
      ++count;
    }
    if (count == 0) return;
    tilt /= count;
    tilt.z() = 0.0;
    ground_tilt_W_ += std::min(input.step_s / options_.lean_s, 1.0) * (tilt - ground_tilt_W_);
  }

  /// The wrench about the centre of mass that the stance feet shall give, and where that puts the ZMP.
  void BalanceThroughStance(FootSet contact, JointCommand& command) {
    // A foot that is due on the ground and not there yet is pushed down with its share, and so finds it.
    const FootSet pushing = stance_;
    if ((pushing & contact) == 0) return;
    const double mass = model_.total_mass_kg;
    PointWrench planned{planned_.p_WC, Vector3::Zero(), Vector3::Zero()};
    for (std::size_t f = 0; f < sample_.wrenches.size(); ++f) {
      const ContactWrench& wrench = sample_.wrenches[f];
      planned.force_W += wrench.force_W;
      planned.moment_W += wrench.moment_W + (planned_.X_WF[f].translation() - planned_.p_WC).cross(wrench.force_W);
    }
    if (planned.force_W.z() < 0.1 * mass * kGravity) return;
    GatherContacts(pushing, planned.force_W.z());

    const Vector3 turn = RotationLog(RotationExp(ground_tilt_W_) * planned_.R_WB * measured_.R_WB.transpose());
    const double k = options_.attitude_rad_s, kz = options_.height_rad_s;
    Vector3 moment = planned.moment_W;
    for (int i = 0; i < 3; ++i) {
      moment[i] += inertia_[i] * (k * k * turn[i] + 2.0 * k * (planned_.w_WB - measured_.w_WB)[i]);
    }
    const double lift =
        planned.force_W.z() + mass * (kz * kz * HeightError() + 2.0 * kz * (planned_.v_WC - measured_.v_WC).z());
    const double normal = std::clamp(lift, 0.3 * mass * kGravity, 2.0 * mass * kGravity);

    double ground = 0.0;
    for (const ContactPoint& point : contacts_) ground += point.p_W.z() / static_cast<double>(contacts_.size());
    const Vector2 lean = planned_.p_WC.z() * Vector2(ground_tilt_W_.y(), -ground_tilt_W_.x());
    const Vector2 planned_zmp = lean + ZeroMomentPoint(planned_.p_WC, planned.force_W, planned.moment_W, 0.0);
    const Vector2 error = DivergentComponent(measured_.p_WC, measured_.v_WC, omega_rad_s_) -
                          DivergentComponent(planned_.p_WC, planned_.v_WC, omega_rad_s_) - lean;
    const Vector2 home = NearestPoint(support_, planned_zmp + StanceOffset());
    Polygon usable = support_;
    for (Vector2& corner : usable) corner = home + options_.support_use * (corner - home);
    const Vector2 zmp = NearestPoint(usable, planned_zmp + options_.dcm_gain * error);
    zmp_shift_W_ = zmp - planned_zmp;
    dcm_error_W_ = error;
    // The attitude comes first: with the moment given, this is the force that puts the ZMP there.
    const double height = measured_.p_WC.z() - ground;
    const Vector3 force(((measured_.p_WC.x() - zmp.x()) * normal - moment.y()) / height,
                        ((measured_.p_WC.y() - zmp.y()) * normal + moment.x()) / height, normal);
    splitter_.Solve(contacts_, {measured_.p_WC, force, moment}, split_);
    AddTorques(command);
  }

  /// How much higher the centre of mass should be over the feet in stance.
  double HeightError() const {
    double error = (planned_.p_WC - measured_.p_WC).z();
    int count = 0;
    double feet = 0.0;
    for (std::size_t f = 0; f < model_.feet.size(); ++f) {
      if (!Contains(stance_, static_cast<int>(f))) continue;
      feet += (planned_.X_WF[f].translation() - measured_.X_WF[f].translation()).z();
      ++count;
    }
    if (count > 0) error -= feet / count;
    return error;
  }

  /// How far the feet in stance are from their plan, on average.
  Vector2 StanceOffset() const {
    Vector2 sum = Vector2::Zero();
    int count = 0;
    for (std::size_t f = 0; f < offset_W_.size(); ++f) {
      if (!Contains(stance_, static_cast<int>(f))) continue;
      sum += offset_W_[f];
      ++count;
    }
    return count > 0 ? Vector2(sum / count) : sum;
  }

  void GatherContacts(FootSet pushing, double total_normal) {
    constexpr double kLeastShare = 1e-3;
    contacts_.clear();
    contact_foot_.clear();
    std::vector<Vector2> corners;
    for (int f = 0; f < static_cast<int>(model_.feet.size()); ++f) {
      if (!Contains(pushing, f)) continue;
      const double share =
          std::max(sample_.wrenches[static_cast<std::size_t>(f)].force_W.z() / total_normal, kLeastShare);
      const auto points = ContactPoints(model_, measured_scratch_, f);
      for (const Vector3& p_W : points) {
        const GroundPoint ground = GroundAt(plan_.terrain, p_W.head<2>());
        contacts_.push_back({p_W, ground.normal_W, std::max(options_.friction_use * ground.friction, 0.05),
                             static_cast<double>(points.size()) / share});
        contact_foot_.push_back(f);
        corners.push_back(p_W.head<2>());
      }
    }
    support_ = ConvexHull(corners);
  }

  /// tau -= J^T (f - f_planned)
  void AddTorques(JointCommand& command) {
    VectorX tau = VectorX::Zero(model_.nv());
    for (std::size_t c = 0; c < contacts_.size(); ++c) {
      const Foot& foot = model_.feet[static_cast<std::size_t>(contact_foot_[c])];
      AddPointForce(model_, measured_scratch_, foot.body, contacts_[c].p_W, -split_.force_W[c], tau);
    }
    for (std::size_t f = 0; f < model_.feet.size(); ++f) {
      Vector6 wrench;
      wrench << sample_.wrenches[f].force_W, sample_.wrenches[f].moment_W;
      AddPointWrench(model_, planned_scratch_, model_.feet[f].body, planned_.X_WF[f].translation(), wrench, tau);
    }
    command.tau_ff += tau.tail(model_.num_dofs());
  }

  /// Where a swinging foot shall land, against its plan.
  Vector2 FootholdShift(int foot, double time_s, double& progress) const {
    const int index = FootholdAt(plan_.footsteps, foot, time_s);
    const auto& footholds = plan_.footsteps.footholds;
    const Foothold* next = nullptr;
    for (std::size_t i = static_cast<std::size_t>(index) + 1; i < footholds.size() && next == nullptr; ++i) {
      if (footholds[i].foot == foot) next = &footholds[i];
    }
    const Foothold& last = footholds[static_cast<std::size_t>(index)];
    if (next == nullptr || next->touchdown_s <= last.liftoff_s) return Vector2::Zero();
    progress = std::clamp((time_s - last.liftoff_s) / (next->touchdown_s - last.liftoff_s), 0.0, 1.0);
    constexpr double kDecay = 0.2, kLongest = 0.5;  // of the error over the next step; [s]
    const double left = std::min(next->touchdown_s - time_s, kLongest);
    const double growth = std::exp(omega_rad_s_ * std::max(left, 0.0));
    const Vector2 at_touchdown = growth * (dcm_error_W_ - zmp_shift_W_) + zmp_shift_W_;
    const double ahead = std::exp(omega_rad_s_ * std::min(next->liftoff_s - next->touchdown_s, kLongest));
    const Vector2 shift = options_.step_gain * (ahead - kDecay) / (ahead - 1.0) * at_touchdown;
    const double reach = options_.step_reach * model_.leg_length_m();
    return shift.norm() > reach ? Vector2(shift * reach / shift.norm()) : shift;
  }

  /// Shifts the leg's targets by how far each foot is to be from its plan, seen from the base that has moved on.
  void MoveFootholds(const ControlInput& input, JointCommand& command) {
    for (int f = 0; f < static_cast<int>(model_.feet.size()); ++f) {
      const auto i = static_cast<std::size_t>(f);
      if (leg_dofs_[i].empty()) continue;
      if (!Contains(stance_, f)) {
        double progress = 0.0;
        const Vector2 now = FootholdShift(f, input.time_s, progress);
        if (progress <= 1.0 - options_.settle_share) wanted_W_[i] = now;
        offset_W_[i] = liftoff_offset_W_[i] + SmoothStep(progress).value * (wanted_W_[i] - liftoff_offset_W_[i]);
      }
      // A foot on the ground stands still; only a swing moves against the plan, and the base against both.
      const Vector2 moved =
          Contains(stance_, f) ? Vector2::Zero() : Vector2((offset_W_[i] - last_offset_W_[i]) / input.step_s);
      last_offset_W_[i] = offset_W_[i];
      const Vector2 shift = offset_W_[i] - follow_W_;
      const Vector2 rate = moved - follow_rate_W_;
      if (!Contains(stance_, f)) Stiffen(i, command);
      ShiftLeg(f, shift, rate, command);
    }
  }

  void Stiffen(std::size_t leg, JointCommand& command) const {
    for (const int dof : leg_dofs_[leg]) {
      command.stiffness[dof] *= options_.swing_stiffness;
      command.damping[dof] *= std::sqrt(options_.swing_stiffness);
    }
  }

  /// Newton's method on the leg's joints for a foot moved horizontally, from the plan's posture.
  void ShiftLeg(int foot, const Vector2& shift, const Vector2& rate, JointCommand& command) {
    const auto i = static_cast<std::size_t>(foot);
    const std::vector<int>& dofs = leg_dofs_[i];
    const Foot& f = model_.feet[i];
    const bool has_sole = !f.sole_F.empty();
    const Eigen::Index rows = has_sole ? 6 : 3, n = static_cast<Eigen::Index>(dofs.size());
    Pose wanted = FramePose(planned_scratch_, f.body, f.X_BF);
    wanted.translation().head<2>() += shift;
    leg_q_ = sample_.q;
    MatrixX whole(6, model_.nv()), J(rows, n);
    VectorX error(rows);
    for (int iteration = 0; iteration < 3; ++iteration) {
      ForwardKinematics(model_, leg_q_, leg_scratch_);
      const Pose X_WF = FramePose(leg_scratch_, f.body, f.X_BF);
      error.head<3>() = wanted.translation() - X_WF.translation();
      if (has_sole) error.tail<3>() = RotationLog(wanted.linear() * X_WF.linear().transpose());
      PointJacobian(model_, leg_scratch_, f.body, f.X_BF.translation(), whole);
      for (Eigen::Index c = 0; c < n; ++c) J.col(c) = whole.col(6 + dofs[static_cast<std::size_t>(c)]).head(rows);
      const VectorX step = J.colPivHouseholderQr().solve(error);
      for (Eigen::Index c = 0; c < n; ++c) {
        const int dof = dofs[static_cast<std::size_t>(c)];
        leg_q_[7 + dof] =
            std::clamp(leg_q_[7 + dof] + std::clamp(step[c], -0.5, 0.5), model_.dof_lower(dof), model_.dof_upper(dof));
      }
    }
    error.setZero();
    constexpr double kFastest = 3.0;  // [m/s]
    error.head<2>() = rate.cwiseMax(-kFastest).cwiseMin(kFastest);
    const VectorX speed = J.colPivHouseholderQr().solve(error);
    for (Eigen::Index c = 0; c < n; ++c) {
      const int dof = dofs[static_cast<std::size_t>(c)];
      command.q[dof] += leg_q_[7 + dof] - sample_.q[7 + dof];
      command.v[dof] += speed[c];
    }
  }

  const RobotModel& model_;
  const MotionPlan& plan_;
  StabilisedOptions options_;
  JointPd replay_;
  DynamicsScratch measured_scratch_, planned_scratch_, leg_scratch_;
  WholeBodySample sample_;
  BodyState measured_, planned_;
  Vector3 inertia_ = Vector3::Ones();
  FootSet stance_ = 0;
  double omega_rad_s_ = 1.0;
  std::vector<std::vector<int>> leg_dofs_;  // by leg; empty where the foot cannot be moved by itself

  std::vector<Vector2> offset_W_, liftoff_offset_W_, last_offset_W_, wanted_W_;  // by foot, against the plan
  Vector3 ground_tilt_W_ = Vector3::Zero();  // rotation vector, against the plan's ground
  Vector2 follow_W_ = Vector2::Zero(), follow_rate_W_ = Vector2::Zero(), dcm_error_W_ = Vector2::Zero(),
          zmp_shift_W_ = Vector2::Zero();

  std::vector<ContactPoint> contacts_;
  std::vector<int> contact_foot_;
  Polygon support_;
  ContactSplitter splitter_;
  ContactSplit split_;
  VectorX leg_q_;
};

}  // namespace

std::unique_ptr<Controller> MakeStabilised(const RobotModel& model, const MotionPlan& plan,
                                           const StabilisedOptions& options) {
  return std::make_unique<Stabilised>(model, plan, options);
}

}  // namespace gaitwright
