// SPDX-License-Identifier: BSD-3-Clause
#include "optimisation/centroidal/rigid_body_rows.h"

#include <algorithm>

#include "kinematics/spatial/rotation.h"
#include "optimisation/centroidal/rigid_body_terms.h"

namespace gaitwright {
namespace {

/// Times at which a stance's foot must be within reach: at nodes, halfway between them, and shortly before touch-down
/// and after lift-off. If swings are given, their own reach checks replace the latter.
std::vector<double> ReachTimes(const RigidBodyProblem& problem, std::size_t number, const std::vector<double>& nodes,
                               double lead_s) {
  const RigidStance& stance = problem.stances[number];
  constexpr double kSame = 1e-4;
  std::vector<double> times;
  for (std::size_t k = 0; k < nodes.size(); ++k) {
    if (nodes[k] < stance.start_s - kSame || nodes[k] > stance.end_s + kSame) continue;
    times.push_back(nodes[k]);
    if (k + 1 < nodes.size() && nodes[k + 1] < stance.end_s + kSame) times.push_back(0.5 * (nodes[k] + nodes[k + 1]));
  }
  const auto swings = [&](auto end) {
    return std::any_of(problem.swings.begin(), problem.swings.end(),
                       [&](const RigidSwing& swing) { return swing.*end == number; });
  };
  if (stance.start_s - lead_s > 0.0 && !swings(&RigidSwing::to)) times.push_back(stance.start_s - lead_s);
  if (stance.end_s + lead_s < nodes.back() && !swings(&RigidSwing::from)) times.push_back(stance.end_s + lead_s);
  return times;
}

/// Initial guess of the centre of mass: the mean of the positions for which each stance foot is at its nominal
/// position.
Vector3 GuessCentreOfMass(const RigidBodyProblem& problem, double time_s) {
  Vector3 sum = Vector3::Zero();
  double weights = 0.0;
  const Matrix3 heading = YawRotation(WantedAngles(problem, time_s).z());
  for (std::size_t f = 0; f < problem.feet.size(); ++f) {
    const RigidStance *before = nullptr, *after = nullptr;
    for (const RigidStance& stance : problem.stances) {
      if (stance.foot != static_cast<int>(f)) continue;
      if (stance.start_s <= time_s) before = &stance;
      if (after == nullptr && stance.end_s >= time_s) after = &stance;
    }
    if (before == nullptr) before = after;
    if (after == nullptr) after = before;
    if (before == nullptr) continue;
    const double span = after->start_s - before->end_s;
    const double u = before == after || span <= 0.0 ? 0.0 : std::clamp((time_s - before->end_s) / span, 0.0, 1.0);
    const Vector3 p = (1.0 - u) * before->X_WF.translation() + u * after->X_WF.translation();
    sum += p - heading * problem.feet[f].p_CF_nominal_B;
    weights += 1.0;
  }
  return sum / weights;
}

Vector3 GuessPlace(const RigidBodyProblem& problem, double t) {
  return problem.path.time_s.empty() ? GuessCentreOfMass(problem, t) : problem.path.PlaceAt(t);
}

Vector3 GuessAngles(const RigidBodyProblem& problem, double t) {
  return problem.path.time_s.empty() ? WantedAngles(problem, t) : problem.path.AnglesAt(t);
}

}  // namespace

std::vector<MissedReach> MissedReaches(const RigidBodyProblem& problem, const RigidBodyMotion& motion,
                                       double tolerance_m) {
  std::vector<double> worst(problem.stances.size(), tolerance_m), at(worst.size(), -1.0);
  for (const RigidBodySample& sample : Sample(motion, 1e-3)) {
    const Matrix3 R_BW = RotationOf(sample.angles_rad).transpose();
    for (const RigidBodyInterval::Force& f : motion.intervals[sample.interval].forces) {
      const RigidFoot& foot = problem.feet[static_cast<std::size_t>(problem.stances[f.stance].foot)];
      const Vector3 p_B = R_BW * (motion.X_WF[f.stance].translation() - sample.p_WC);
      for (const WorkspaceSide& side : foot.workspace_B) {
        const double out = side.normal.dot(p_B) - side.offset;
        if (out <= worst[f.stance]) continue;
        worst[f.stance] = out;
        at[f.stance] = sample.time_s;
      }
    }
  }
  std::vector<MissedReach> missed;
  for (std::size_t s = 0; s < at.size(); ++s) {
    if (at[s] >= 0.0) missed.push_back({s, at[s]});
  }
  return missed;
}

namespace {

/// Fractions at which a swing foot is checked.
std::vector<double> SharesOf(const RigidSwing& swing) {
  if (!swing.shares.empty()) return swing.shares;
  return {0.05, 0.1, 0.2, 0.35, 0.5, 0.65, 0.8, 0.9, 0.95};
}

}  // namespace

ConstrainedProblem RigidBodyRows(const RigidBodyProblem& problem, const RigidBodyUnknowns& unknowns,
                                 const RigidBodyOptions& options, const std::vector<MissedReach>& missed) {
  const RigidBodyTerms terms(problem, unknowns);
  ConstrainedProblem rows;
  // A constraint without unknowns is constant, so it is left out.
  const auto add = [&](Constraint constraint) {
    if (!constraint.variables.empty()) rows.constraints.push_back(std::move(constraint));
  };
  for (std::size_t i = 0; i < unknowns.intervals() && options.turns_by_forces; ++i) add(terms.Turning(i));
  for (const std::size_t k : unknowns.FreeNodes()) add(terms.Free(k));
  const std::vector<BoundForce>& forces = unknowns.BoundForces();
  for (const BoundForce& force : forces) add(terms.Friction(force, options.friction_sides, options.force_margin));
  for (auto from = forces.begin(); from != forces.end();) {
    const auto to = std::find_if(from, forces.end(), [&](const BoundForce& f) {
      return f.stance != from->stance || f.at_node != from->at_node;
    });
    if (problem.stances[from->stance].MotorsAt(0.0) != nullptr) add(terms.Motors({from, to}));
    from = to;
  }
  for (std::size_t s = 0; s < problem.stances.size(); ++s) {
    for (const double t : ReachTimes(problem, s, unknowns.nodes_s(), options.swing_lead_s))
      add(terms.Reach(s, t, options.reach_margin_m));
  }
  for (std::size_t i = 0; i < problem.swings.size(); ++i) {
    for (const double share : SharesOf(problem.swings[i])) add(terms.SwingReach(i, share, options.reach_margin_m));
    if (!problem.swings[i].planes.empty()) add(terms.SwingClearance(i));
  }
  for (std::size_t i = 0; i < unknowns.intervals() && problem.rise_max_m_s > 0.0; ++i) {
    if (unknowns.Forces(i).empty()) continue;
    const double from = unknowns.nodes_s()[i], to = unknowns.nodes_s()[i + 1];
    for (const double time_s : {from, 0.5 * (from + to)}) add(terms.Rise(time_s));
  }
  for (const RigidClearance& clearance : problem.clearances) add(terms.Clearance(clearance));
  for (const MissedReach& m : missed) add(terms.Reach(m.stance, m.time_s, options.reach_margin_m));
  for (std::size_t s = 0; s < problem.stances.size(); ++s) {
    if (!problem.stances[s].held && !problem.stances[s].region_F.empty()) add(terms.Region(s));
  }
  rows.residuals = RigidBodyCost(problem, unknowns, options.weights);
  return rows;
}

VectorX GuessRigidBody(const RigidBodyProblem& problem, const RigidBodyUnknowns& unknowns) {
  VectorX x = VectorX::Zero(unknowns.size());
  const std::vector<double>& t = unknowns.nodes_s();
  // A control point belongs to the mean of its three knots (Greville abscissa).
  const auto knot = [&](std::size_t j) { return t[std::clamp<std::size_t>(j, 3, t.size() + 2) - 3]; };
  for (std::size_t i = 2; i < t.size(); ++i) {
    const int place = unknowns.ControlPoint(i);
    if (place >= 0) x.segment<3>(place) = GuessPlace(problem, (knot(i + 1) + knot(i + 2) + knot(i + 3)) / 3.0);
  }
  for (std::size_t k = 1; k + 1 < t.size(); ++k) {
    const std::vector<AffineVector::Part>& angles = unknowns.Angles(k).parts;
    if (!angles.empty()) x.segment<3>(angles.front().start) = GuessAngles(problem, t[k]);
  }
  std::vector<int> sharing(t.size(), 0);
  for (const BoundForce& force : unknowns.BoundForces()) ++sharing[force.at_node];
  for (const BoundForce& force : unknowns.BoundForces()) {
    const std::vector<AffineVector::Part>& parts = force.force.parts;
    if (parts.size() == 1 && parts.front().coefficient == 1.0)
      x[parts.front().start + 2] = 1.0 / sharing[force.at_node];
  }
  for (std::size_t i = 0; i < problem.swings.size(); ++i) {
    const RigidSwing& swing = problem.swings[i];
    for (int k = 0; k < swing.unknowns(); ++k)
      x[unknowns.Detour(i) + k] = swing.detour_W[static_cast<std::size_t>(k / 3)][k % 3];
  }
  return x;
}

}  // namespace gaitwright
