// SPDX-License-Identifier: BSD-3-Clause
#include "optimisation/centroidal/rigid_body_cost.h"

#include <cmath>

#include "kinematics/spatial/rotation.h"

namespace gaitwright {
namespace {

/// Adds weight times the squared deviation of a vector along some directions (rows).
void AddRowsAlong(const MatrixX& directions, const AffineVector& vector, double weight, const Vector3& wanted,
                  std::vector<Residual>& cost) {
  if (vector.parts.empty() || weight <= 0.0) return;
  SeenUnknowns seen;
  const MatrixX weighted = std::sqrt(weight) * directions;
  VectorFunction rows = AffineRows(vector, weighted, weighted * wanted, seen);
  cost.emplace_back(std::move(rows), seen.variables());
  cost.back().affine = true;
}

void AddRows(const AffineVector& vector, double weight, const Vector3& wanted, std::vector<Residual>& cost) {
  AddRowsAlong(Matrix3::Identity(), vector, weight, wanted, cost);
}

/// Position of a stance foot relative to the centre of mass, minus its nominal position.
void AddStance(const FootPlace& place, const AffineVector& com, double weight, const Vector3& wanted,
               std::vector<Residual>& cost) {
  SeenUnknowns seen;
  FootPlace own = place;
  for (FootPlace::Part& part : own.parts) part.start = seen.See(part.start, 2);
  const AffineVector own_com = seen.See(com);
  const double root = std::sqrt(weight);
  const auto rows = [own, own_com, wanted, root](const VectorX& x, VectorX& value, MatrixX* J) {
    value = root * (own.At(x) - own_com.At(x) - wanted);
    if (J == nullptr) return;
    for (const FootPlace::Part& part : own.parts) J->block<3, 2>(0, part.start) += root * part.axes;
    own_com.AddTo(Matrix3(-root * Matrix3::Identity()), *J, 0);
  };
  if (seen.variables().empty()) return;
  cost.emplace_back(rows, seen.variables());
  cost.back().affine = true;
}

/// Mean jerk of a free swing between uniform fractions; the acceleration is zero at both ends.
void AddSwing(const RigidBodyUnknowns& unknowns, std::size_t swing, double weight, std::vector<Residual>& cost) {
  constexpr int kSamples = 40;
  const double root = std::sqrt(weight * (kSamples + 1.0));
  FootPlace before;
  for (int k = 1; k <= kSamples + 1; ++k) {
    const FootPlace at = k > kSamples ? FootPlace{} : unknowns.InSwingAcceleration(swing, k / (kSamples + 1.0));
    SeenUnknowns seen;
    FootPlace change = at;
    change = change.Add(-1.0, before).SeenBy(seen);
    const auto rows = [change, root](const VectorX& x, VectorX& value, MatrixX* J) {
      value = root * change.At(x);
      if (J != nullptr) change.AddTo(root * Matrix3::Identity(), *J, 0);
    };
    cost.emplace_back(rows, seen.variables());
    cost.back().affine = true;
    before = at;
  }
}

}  // namespace

Vector3 WantedAngles(const RigidBodyProblem& problem, double time_s) {
  if (problem.follows_yaw && !problem.path.time_s.empty()) return {0.0, 0.0, problem.path.AnglesAt(time_s).z()};
  const double u = time_s / problem.duration_s;
  return {0.0, 0.0, (1.0 - u) * problem.start.angles_rad.z() + u * problem.goal.angles_rad.z()};
}

std::vector<Residual> RigidBodyCost(const RigidBodyProblem& problem, const RigidBodyUnknowns& unknowns,
                                    const RigidBodyWeights& weights) {
  const std::vector<double>& t = unknowns.nodes_s();
  std::vector<Residual> cost;
  for (std::size_t i = 0; i < unknowns.intervals(); ++i) {
    const double h = t[i + 1] - t[i];
    for (const ContactForce& force : unknowns.Forces(i)) {
      AffineVector change = force.to;
      AddRows(change.Add(-1.0, force.from), weights.force_rate / h, Vector3::Zero(), cost);
    }
    for (const std::size_t k : {i, i + 1}) {
      AddRows(unknowns.Momentum(k), 0.5 * h * weights.momentum, Vector3::Zero(), cost);
      AddRows(unknowns.Angles(k), 0.5 * h * weights.tilt, WantedAngles(problem, t[k]), cost);
      const Matrix3 heading = YawRotation(WantedAngles(problem, t[k]).z());
      if (!problem.path.time_s.empty()) {
        const MatrixX across = heading.col(1).transpose();
        AddRowsAlong(across, unknowns.CentreOfMass(t[k]), 0.5 * h * weights.path, problem.path.PlaceAt(t[k]), cost);
      }
      for (const ContactForce& force : unknowns.Forces(i)) {
        if (force.point != 0) continue;
        const auto foot = static_cast<std::size_t>(problem.stances[force.stance].foot);
        AddStance(unknowns.Foothold(force.stance), unknowns.CentreOfMass(t[k]), 0.5 * h * weights.stance,
                  heading * problem.feet[foot].p_CF_nominal_B, cost);
      }
    }
  }
  for (std::size_t i = 0; i < problem.swings.size(); ++i) {
    if (problem.swings[i].free) AddSwing(unknowns, i, weights.swing_jerk, cost);
  }
  return cost;
}

}  // namespace gaitwright
