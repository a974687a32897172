// SPDX-License-Identifier: BSD-3-Clause
#include "optimisation/centroidal/rigid_body_motion.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <utility>

#include "kinematics/spatial/rotation.h"
#include "kinematics/trajectory/bspline.h"
#include "optimisation/centroidal/rigid_body_terms.h"

namespace gaitwright {
namespace {

/// Longest integration steps of the angles [s]; shorter with leg angular momentum, whose third derivative has jumps.
constexpr double kMotionStep_s = 4e-3, kMotionStepWithLegs_s = 1e-3;

Vector3 PowersAt(const std::array<Vector3, 4>& c, double t) { return c[0] + t * (c[1] + t * (c[2] + t * c[3])); }

/// Point of application of a force at a share of its interval.
Vector3 PointAt(const RigidBodyInterval::Force& force, double u) { return force.p_W + u * force.moves_W; }

/// Angular momentum of the body over an interval: its initial value plus the integral of sum (p_i - p) x f_i, minus the
/// change of the legs' momentum. The integral is a polynomial of degree five, because p is cubic and forces are linear.
class MomentumOver {
 public:
  MomentumOver(const RigidBodyInterval& in, const LegMomentum& inner)
      : inner_(&inner), start_s_(in.start_s), inner_W_(inner.At(in.start_s)) {
    const double h = in.end_s - in.start_s;
    Vector3 from = Vector3::Zero(), rate = Vector3::Zero();  // sum of the forces at the start, and its rate
    std::array<Vector3, 5> torque;
    torque.fill(Vector3::Zero());
    for (const RigidBodyInterval::Force& f : in.forces) {
      const Vector3 change = (f.to_W - f.from_W) / h;
      torque[0] += f.p_W.cross(f.from_W);
      torque[1] += f.p_W.cross(change) + f.moves_W.cross(f.from_W) / h;
      torque[2] += f.moves_W.cross(change) / h;
      from += f.from_W;
      rate += change;
    }
    for (std::size_t i = 0; i < 4; ++i) {
      torque[i] -= in.com[i].cross(from);
      torque[i + 1] -= in.com[i].cross(rate);
    }
    powers_[0] = in.momentum_W;
    for (std::size_t i = 0; i < 5; ++i) powers_[i + 1] = torque[i] / static_cast<double>(i + 1);
  }

  double step_s() const { return inner_->empty() ? kMotionStep_s : kMotionStepWithLegs_s; }

  /// At a time since the start of the interval.
  Vector3 At(double t) const {
    Vector3 l = powers_[5];
    for (std::size_t i = 5; i-- > 0;) l = powers_[i] + t * l;
    return l - (inner_->At(start_s_ + t) - inner_W_);
  }

 private:
  const LegMomentum* inner_;
  double start_s_;
  Vector3 inner_W_;  // at the start
  std::array<Vector3, 6> powers_;
};

/// The angles at time `to` of an interval, integrated from those at time `from`.
Vector3 Turned(const MomentumOver& momentum, const Matrix3& inverse_B, double from, double to, Vector3 angles) {
  const int steps = std::max(1, static_cast<int>(std::ceil((to - from) / momentum.step_s() - 1e-9)));
  const double h = (to - from) / steps;
  if (h <= 0.0) return angles;
  for (int i = 0; i < steps; ++i) {
    const double at = from + i * h;
    const Vector3 l_mid = momentum.At(at + 0.5 * h);
    const Vector3 k1 = AngleRates(inverse_B, angles, momentum.At(at));
    const Vector3 k2 = AngleRates(inverse_B, angles + 0.5 * h * k1, l_mid);
    const Vector3 k3 = AngleRates(inverse_B, angles + 0.5 * h * k2, l_mid);
    const Vector3 k4 = AngleRates(inverse_B, angles + h * k3, momentum.At(at + h));
    angles += h / 6.0 * (k1 + 2.0 * k2 + 2.0 * k3 + k4);
  }
  return angles;
}

std::array<Vector3, 4> PowersOf(const RigidBodyUnknowns& unknowns, const VectorX& x, std::size_t i) {
  const double h = unknowns.nodes_s()[i + 1] - unknowns.nodes_s()[i];
  const Vector3 a_from = kGravity * (unknowns.WholeForce(i).At(x) - Vector3::UnitZ());
  const Vector3 a_to = kGravity * (unknowns.WholeForce(i + 1).At(x) - Vector3::UnitZ());
  const Vector3 from = unknowns.CentreOfMass(unknowns.nodes_s()[i]).At(x);
  const Vector3 to = unknowns.CentreOfMass(unknowns.nodes_s()[i + 1]).At(x);
  return {from, (to - from) / h - h * (2.0 * a_from + a_to) / 6.0, 0.5 * a_from, (a_to - a_from) / (6.0 * h)};
}

/// A sample without its angles and the values that follow from them.
RigidBodySample At(const RigidBodyMotion& motion, const MomentumOver& momentum, std::size_t interval, double time_s) {
  const RigidBodyInterval& in = motion.intervals[interval];
  const double t = time_s - in.start_s, u = t / (in.end_s - in.start_s);
  RigidBodySample s;
  s.time_s = time_s;
  s.interval = interval;
  s.p_WC = PowersAt(in.com, t);
  s.v_WC = in.com[1] + t * (2.0 * in.com[2] + 3.0 * t * in.com[3]);
  s.a_WC = 2.0 * in.com[2] + 6.0 * t * in.com[3];
  s.momentum_W = momentum.At(t);
  s.torque_W = -motion.inner.RateAt(time_s);
  for (const RigidBodyInterval::Force& f : in.forces) {
    s.force_W.push_back((1.0 - u) * f.from_W + u * f.to_W);
    s.torque_W += (PointAt(f, u) - s.p_WC).cross(s.force_W.back());
  }
  return s;
}

/// Distance of a point outside of a polygon in its plane; 0 for an unbounded polygon.
double OutOf(const std::vector<Vector2>& region, const Vector2& p) {
  double out = 0.0;
  for (std::size_t i = 0; i < region.size(); ++i) {
    const Vector2 along = region[(i + 1) % region.size()] - region[i];
    out = std::max(out, Vector2(along.y(), -along.x()).normalized().dot(p - region[i]));
  }
  return out;
}

/// Compares, step by step, the momentum of the sampled rotation (every other sample) with that of the forces.
double TorqueBalance(const RigidBodyMotion& motion, const std::vector<RigidBodySample>& samples) {
  if (samples.size() < 3) return 0.0;  // a motion of less than a millisecond
  const double h = samples[2].time_s - samples[0].time_s;
  double worst = 0.0;
  Vector3 last = Vector3::Zero();
  for (std::size_t k = 1; k + 1 < samples.size(); k += 2) {
    const Matrix3 R_WB = RotationOf(samples[k - 1].angles_rad);
    const Vector3 turn_B = RotationLog(R_WB.transpose() * RotationOf(samples[k + 1].angles_rad));
    const Vector3 momentum_W = R_WB * RotationExp(0.5 * turn_B) * motion.inertia_B * turn_B / h;
    const Vector3 mean_W = (samples[k - 1].momentum_W + 4.0 * samples[k].momentum_W + samples[k + 1].momentum_W) / 6.0;
    const Vector3 off = momentum_W - mean_W;
    if (k > 1) worst = std::max(worst, (off - last).norm() / h);
    last = off;
  }
  return worst / (motion.mass_kg * kGravity);
}

void AddForceFaults(const RigidBodyProblem& problem, const RigidBodyMotion& motion, const RigidBodySample& sample,
                    RigidBodyFaults& faults) {
  const double weight = motion.mass_kg * kGravity;
  Vector3 rest = motion.mass_kg * (sample.a_WC + kGravity * Vector3::UnitZ());
  const std::vector<RigidBodyInterval::Force>& forces = motion.intervals[sample.interval].forces;
  for (std::size_t i = 0; i < forces.size(); ++i) {
    const RigidStance& stance = problem.stances[forces[i].stance];
    const Vector3 f_F = stance.X_WF.linear().transpose() * sample.force_W[i];
    const double most = problem.feet[static_cast<std::size_t>(stance.foot)].force_max_n;
    faults.friction = std::max(faults.friction, (f_F.head<2>().norm() - stance.friction * f_F.z()) / weight);
    faults.unilateral = std::max({faults.unilateral, -f_F.z() / weight, (f_F.z() - most) / weight});
    rest -= sample.force_W[i];
  }
  faults.force_balance = std::max(faults.force_balance, rest.norm() / weight);
}

}  // namespace

double RigidBodyFaults::Largest() const {
  return std::max({force_balance, torque_balance, friction, unilateral, reach_m, foothold_m, goal});
}

std::string RigidBodyFaults::Worst() const {
  const std::initializer_list<std::pair<double, const char*>> all = {{force_balance, "the balance of forces"},
                                                                     {torque_balance, "the balance of torques"},
                                                                     {friction, "friction"},
                                                                     {unilateral, "the force of a contact"},
                                                                     {reach_m, "the reach of a foot"},
                                                                     {foothold_m, "a foothold"},
                                                                     {goal, "the goal"}};
  return std::max(all, [](const auto& a, const auto& b) { return a.first < b.first; }).second;
}

RigidBodyMotion MotionOf(const RigidBodyProblem& problem, const RigidBodyUnknowns& unknowns, const VectorX& x) {
  RigidBodyMotion motion{problem.mass_kg, problem.inertia_B, LegMomentum(problem), {}, {}};
  const double weight = problem.mass_kg * kGravity;
  for (std::size_t s = 0; s < problem.stances.size(); ++s) {
    motion.X_WF.push_back(problem.stances[s].X_WF);
    motion.X_WF.back().translation() = unknowns.Foothold(s).At(x);
  }
  for (std::size_t i = 0; i < problem.swings.size(); ++i) {
    motion.detours_W.emplace_back();
    for (int k = 0; k < problem.swings[i].unknowns(); k += 3)
      motion.detours_W.back().emplace_back(x.segment<3>(unknowns.Detour(i) + k));
  }
  const Matrix3 inverse_B = problem.inertia_B.inverse();
  Vector3 angles = problem.start.angles_rad;
  Vector3 momentum = RotationOf(angles) * problem.inertia_B * problem.start.w_WB_B;
  for (std::size_t i = 0; i < unknowns.intervals(); ++i) {
    RigidBodyInterval in{
        unknowns.nodes_s()[i], unknowns.nodes_s()[i + 1], PowersOf(unknowns, x, i), angles, momentum, {}};
    for (const ContactForce& f : unknowns.Forces(i)) {
      const RigidStance& stance = problem.stances[f.stance];
      const Vector3 moved = stance.MovedAt(in.start_s);
      in.forces.push_back({f.stance, unknowns.ContactPoint(f.stance, f.point).At(x) + moved,
                           stance.MovedAt(in.end_s) - moved, weight * f.from.At(x), weight * f.to.At(x)});
    }
    const MomentumOver turning(in, motion.inner);
    angles = Turned(turning, inverse_B, 0.0, in.end_s - in.start_s, angles);
    momentum = turning.At(in.end_s - in.start_s);
    motion.intervals.push_back(std::move(in));
  }
  return motion;
}

std::vector<RigidBodySample> Sample(const RigidBodyMotion& motion, double step_s) {
  const int steps = std::max(1, static_cast<int>(std::lround(motion.duration_s() / step_s)));
  const Matrix3 inverse_B = motion.inertia_B.inverse();
  std::vector<RigidBodySample> samples;
  samples.reserve(static_cast<std::size_t>(steps) + 1);
  MomentumOver momentum(motion.intervals.front(), motion.inner);
  for (int k = 0; k <= steps; ++k) {
    const double t = motion.duration_s() * k / steps;
    std::size_t interval = k > 0 ? samples.back().interval : 0;
    while (interval + 1 < motion.intervals.size() && t >= motion.intervals[interval].end_s) ++interval;
    const RigidBodyInterval& in = motion.intervals[interval];
    const bool goes_on = k > 0 && samples.back().interval == interval;
    if (!goes_on) momentum = MomentumOver(in, motion.inner);
    RigidBodySample s = At(motion, momentum, interval, t);
    s.angles_rad = goes_on ? Turned(momentum, inverse_B, samples.back().time_s - in.start_s, t - in.start_s,
                                    samples.back().angles_rad)
                           : Turned(momentum, inverse_B, 0.0, t - in.start_s, in.angles_rad);
    s.w_WB_B = inverse_B * RotationOf(s.angles_rad).transpose() * s.momentum_W;
    samples.push_back(std::move(s));
  }
  return samples;
}

RigidBodyFaults FaultsOf(const RigidBodyProblem& problem, const RigidBodyMotion& motion, double step_s) {
  RigidBodyFaults faults;
  const std::vector<RigidBodySample> samples = Sample(motion, step_s);
  for (const RigidBodySample& sample : samples) {
    AddForceFaults(problem, motion, sample, faults);
    const Matrix3 R_BW = RotationOf(sample.angles_rad).transpose();
    for (const RigidBodyInterval::Force& f : motion.intervals[sample.interval].forces) {
      const RigidFoot& foot = problem.feet[static_cast<std::size_t>(problem.stances[f.stance].foot)];
      const Vector3 p_B = R_BW * (motion.X_WF[f.stance].translation() - sample.p_WC);
      for (const WorkspaceSide& side : foot.workspace_B)
        faults.reach_m = std::max(faults.reach_m, side.normal.dot(p_B) - side.offset);
    }
  }
  faults.torque_balance = TorqueBalance(motion, Sample(motion, 0.5 * step_s));
  for (std::size_t s = 0; s < problem.stances.size(); ++s) {
    const Pose X_FF = problem.stances[s].X_WF.inverse() * motion.X_WF[s];
    faults.foothold_m = std::max(faults.foothold_m, OutOf(problem.stances[s].region_F, X_FF.translation().head<2>()));
  }
  const RigidBodySample& end = samples.back();
  faults.goal = std::max({(end.p_WC - problem.goal.p_WC).norm(), (end.angles_rad - problem.goal.angles_rad).norm(),
                          (end.v_WC - problem.goal.v_WC).norm(), (end.w_WB_B - problem.goal.w_WB_B).norm()});
  return faults;
}

}  // namespace gaitwright
