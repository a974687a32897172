// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <Eigen/LU>
#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

#include "kinematics/base/non_finite.h"
#include "kinematics/spatial/rotation.h"
#include "optimisation/centroidal/rigid_body_terms.h"

namespace gaitwright {
namespace {

/// Position and rotation of the body at a time, in local indices of the unknowns. At a node, the interval after it is
/// not needed.
class BodyAt {
 public:
  BodyAt(const RigidBodyProblem& problem, const RigidBodyUnknowns& unknowns, double time_s, SeenUnknowns& seen) {
    constexpr double kAtNode = 1e-9;
    const std::vector<double>& nodes = unknowns.nodes_s();
    const auto after = std::upper_bound(nodes.begin(), nodes.end(), time_s + kAtNode);
    const auto k = static_cast<std::size_t>(after - nodes.begin()) - 1;
    com_ = seen.See(unknowns.CentreOfMass(time_s));
    angles_from_ = seen.See(unknowns.Angles(k));
    if (time_s <= nodes[k] + kAtNode) return;
    inverse_B_ = unknowns.mean_inertia() * problem.inertia_B.inverse();
    h_ = nodes[k + 1] - nodes[k];
    share_ = (time_s - nodes[k]) / h_;
    momentum_from_ = seen.See(unknowns.Momentum(k));
    angles_to_ = seen.See(unknowns.Angles(k + 1));
    momentum_to_ = seen.See(unknowns.Momentum(k + 1));
  }

  /// Angles, and their dependence on the unknowns between nodes.
  struct Turned {
    Vector3 angles;
    std::optional<AnglesBetween> between;
  };

  const AffineVector& com() const { return com_; }

  Turned TurnedAt(const VectorX& x) const {
    if (share_ == 0.0) return {angles_from_.At(x), std::nullopt};
    const AnglesBetween between(inverse_B_, h_, share_, {angles_from_.At(x), momentum_from_.At(x)},
                                {angles_to_.At(x), momentum_to_.At(x)});
    return {between.value, between};
  }

  /// Adds to a Jacobian the part that depends on the angles.
  void AddByAngles(const MatrixX& by_angles, const Turned& turned, MatrixX& J) const {
    if (!turned.between) {
      angles_from_.AddTo(by_angles, J, 0);
      return;
    }
    angles_from_.AddTo(by_angles * turned.between->by_from, J, 0);
    angles_to_.AddTo(by_angles * turned.between->by_to, J, 0);
    momentum_from_.AddTo(by_angles * turned.between->by_l_from, J, 0);
    momentum_to_.AddTo(by_angles * turned.between->by_l_to, J, 0);
  }

 private:
  AffineVector com_;
  Matrix3 inverse_B_ = Matrix3::Zero();
  double h_ = 0.0, share_ = 0.0;
  AffineVector angles_from_, angles_to_, momentum_from_, momentum_to_;
};

/// Rows n . R^T (p - c) of a workspace.
struct ReachTerm {
  MatrixX normals;
  FootPlace place;
  BodyAt body;

  void operator()(const VectorX& x, VectorX& value, MatrixX* J) const {
    const BodyAt::Turned turned = body.TurnedAt(x);
    const Matrix3 R_BW = RotationOf(turned.angles).transpose();
    const Vector3 p_B = R_BW * (place.At(x) - body.com().At(x));
    value = normals * p_B;
    if (J == nullptr) return;
    const MatrixX by_place = normals * R_BW;
    place.AddTo(by_place, *J, 0);
    body.com().AddTo(-by_place, *J, 0);
    body.AddByAngles(normals * Skew(p_B) * BodyRatesByAngleRates(turned.angles), turned, *J);
  }
};

/// The row n . (c + R q).
struct ClearanceTerm {
  Vector3 normal_W, p_CQ_B;
  BodyAt body;

  void operator()(const VectorX& x, VectorX& value, MatrixX* J) const {
    const BodyAt::Turned turned = body.TurnedAt(x);
    const Matrix3 R_WB = RotationOf(turned.angles);
    value.resize(1);
    value[0] = normal_W.dot(body.com().At(x) + R_WB * p_CQ_B);
    if (J == nullptr) return;
    body.com().AddTo(normal_W.transpose(), *J, 0);
    const MatrixX by_turn = -normal_W.transpose() * R_WB * Skew(p_CQ_B);
    body.AddByAngles(by_turn * BodyRatesByAngleRates(turned.angles), turned, *J);
  }
};

/// Bounds of a workspace's rows; also sets its normals.
Constraint WorkspaceOf(const std::vector<WorkspaceSide>& sides, double margin_m, MatrixX& normals) {
  const auto n = static_cast<Eigen::Index>(sides.size());
  Constraint rows{"", {}, VectorX::Constant(n, -kInfinity), VectorX(n)};
  normals.resize(n, 3);
  for (Eigen::Index i = 0; i < n; ++i) {
    const WorkspaceSide& side = sides[static_cast<std::size_t>(i)];
    normals.row(i) = side.normal;
    rows.upper[i] = side.offset - margin_m;
  }
  return rows;
}

}  // namespace

Constraint RigidBodyTerms::Reach(std::size_t stance, double time_s, double margin_m) const {
  const int foot = problem_.stances[stance].foot;
  return ReachOf(foot, problem_.feet[static_cast<std::size_t>(foot)].workspace_B, unknowns_.Foothold(stance), time_s,
                 margin_m);
}

Constraint RigidBodyTerms::SwingReach(std::size_t swing, double share, double margin_m) const {
  const RigidSwing& of = problem_.swings[swing];
  const RigidStance &from = problem_.stances[of.from], &to = problem_.stances[of.to];
  const RigidFoot& foot = problem_.feet[static_cast<std::size_t>(from.foot)];
  return ReachOf(from.foot, foot.workspace_in_air_B.empty() ? foot.workspace_B : foot.workspace_in_air_B,
                 unknowns_.InSwing(swing, share), from.end_s + share * (to.start_s - from.end_s), margin_m);
}

Constraint RigidBodyTerms::SwingClearance(std::size_t swing) const {
  const RigidSwing& of = problem_.swings[swing];
  const RigidStance& from = problem_.stances[of.from];
  const auto n = static_cast<Eigen::Index>(of.planes.size());
  Constraint rows{fmt::format("clearance of foot {} in the air from {:.3f} s on", from.foot, from.end_s),
                  {},
                  VectorX(n),
                  VectorX::Constant(n, kInfinity)};
  SeenUnknowns seen;
  std::vector<std::pair<Vector3, FootPlace>> beyond;
  for (Eigen::Index i = 0; i < n; ++i) {
    const SwingPlane& plane = of.planes[static_cast<std::size_t>(i)];
    beyond.emplace_back(plane.normal_W, unknowns_.InSwing(swing, plane.share).SeenBy(seen));
    rows.lower[i] = plane.offset_m;
  }
  rows.family = static_cast<int>(RigidBodyRowKind::kClearance);
  rows.variables = seen.variables();
  rows.affine = true;
  rows.function = [beyond](const VectorX& x, VectorX& value, MatrixX* J) {
    value.resize(static_cast<Eigen::Index>(beyond.size()));
    for (std::size_t i = 0; i < beyond.size(); ++i) {
      const auto& [normal_W, place] = beyond[i];
      value[static_cast<Eigen::Index>(i)] = normal_W.dot(place.At(x));
      if (J != nullptr) place.AddTo(normal_W.transpose(), *J, static_cast<Eigen::Index>(i));
    }
  };
  return rows;
}

Constraint RigidBodyTerms::ReachOf(int foot, const std::vector<WorkspaceSide>& workspace_B, const FootPlace& place,
                                   double time_s, double margin_m) const {
  MatrixX normals;
  Constraint rows = WorkspaceOf(workspace_B, margin_m, normals);
  SeenUnknowns seen;
  const FootPlace own = place.SeenBy(seen);
  rows.function = ReachTerm{std::move(normals), own, BodyAt(problem_, unknowns_, time_s, seen)};
  rows.family = static_cast<int>(RigidBodyRowKind::kReach);
  rows.name = fmt::format("reach of foot {} at {:.3f} s", foot, time_s);
  rows.variables = seen.variables();
  return rows;
}

Constraint RigidBodyTerms::Clearance(const RigidClearance& clearance) const {
  SeenUnknowns seen;
  const ClearanceTerm term{clearance.normal_W, clearance.p_CQ_B, BodyAt(problem_, unknowns_, clearance.time_s, seen)};
  return OfKind(RigidBodyRowKind::kClearance,
                {fmt::format("clearance of {} at {:.3f} s", clearance.of, clearance.time_s), term,
                 VectorX::Constant(1, clearance.offset_m), VectorX::Constant(1, kInfinity), seen.variables()});
}

}  // namespace gaitwright
