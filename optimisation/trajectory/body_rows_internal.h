// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "optimisation/numerics/elastic_rows_internal.h"
#include "optimisation/trajectory/body_problem_internal.h"
#include "optimisation/trajectory/chain_matrix_internal.h"
#include "optimisation/trajectory/motor_rows_internal.h"

namespace gaitwright {

/// The rows of a BodyProblem with a factorisation along the chain of its knots, whose cost is linear in them: forces
/// are local to a knot and eliminated there, and what is left of knot k meets control points k to k + 2.
///
/// = Notation =
///   z     unknowns: control points one after the other, then forces knot by knot
///   y     of a knot, "flat": coordinates, their rates, their accelerations, and forces: size 3 n + f
///   dense rows of a knot: six of the dynamics, then efforts of the motors
///   posture rows of a knot: of feet, then distances of links, then of points near places; all else is linear in y
class BodyRows : public ElasticRows {
 public:
  /// Keeps a reference to the problem. @param start  z, where the rows are evaluated and differentiated first.
  BodyRows(const BodyProblem& problem, const VectorX& start);

  Eigen::Index count() const override { return value_.size(); }
  Eigen::Index residuals() const override { return residuals_; }
  const VectorX& value() const override { return value_; }
  RowBounds BoundsOf(Eigen::Index row) const override;
  std::string NameOf(Eigen::Index row) const override;
  double unnoticed() const override { return 1e-6; }
  void Evaluate(const VectorX& z) override;
  void Differentiate() override;
  VectorX Gradient(const VectorX& by) const override;
  VectorX Moved(const VectorX& by) const override;
  bool Factor(const VectorX& weights, double damping) override;
  VectorX Solved(const VectorX& right) const override;

  /// Times of knots at which constraints are violated by more than a tolerance where Evaluate was last, in order.
  std::vector<double> TimesUnmet(double tolerance) const;

  /// How many unknowns there are.
  Eigen::Index size() const { return points_size_ + forces_size_; }
  const ChainSpline& spline() const { return spline_; }
  /// z of control points (columns) and forces by knot, and the reverse.
  VectorX Joined(const MatrixX& points, const std::vector<VectorX>& forces) const;
  MatrixX PointsOf(const VectorX& z) const;
  std::vector<VectorX> ForcesOf(const VectorX& z) const;

 private:
  /// Kinds of rows of a knot, in their order: residuals first.
  enum Kind {
    kNear,
    kNearAcceleration,
    kEffort,
    kForce,
    kPoint,
    kDynamics,
    kFeet,
    kEffortLimit,
    kCurve,
    kRange,
    kCone,
    kApart,
    kPinnedPlace,
    kPinnedMotion,
    kKinds
  };
  struct Knot {
    Eigen::Index force = 0, forces = 0;  // first of z, and how many
    Eigen::Index row[kKinds + 1] = {};   // first of each kind; residuals and constraints are apart
    Eigen::Index residual_end = 0;
    VectorX y;
    VectorX dense, posture;  // values
    VectorX feet_within;     // what rows of feet may be off by
    MatrixX D;               // dense rows by y
    MatrixX J;               // posture rows by coordinates
    MatrixX L, E;            // factors of the forces' own block, and of their coupling
    std::vector<KnotContact> contacts;
  };

  void ListRows();
  Eigen::Index CountOf(const Knot& knot, const BodyKnot& asked, Kind kind) const;
  void SetState(Knot& knot, ChartedState& state);
  void EvaluatePosture(Knot& knot, const BodyKnot& asked, const ChartedState* with_derivatives);
  Eigen::Index EvaluateFeet(Knot& knot, const BodyKnot& asked, const ChartedState* with_derivatives);
  void EvaluateApart(Knot& knot, const BodyKnot& asked, bool with_derivatives, Eigen::Index first);
  void EvaluatePoints(Knot& knot, const BodyKnot& asked, const ChartedState* with_derivatives, Eigen::Index first);
  VectorX OfPosture(std::size_t k, const VectorX& of_rows, double of_points) const;
  void FillRows(std::size_t k, const VectorX& y, const VectorX& dense, const VectorX& posture, bool constants,
                VectorX& rows) const;
  void FillPins(const Knot& knot, const BodyKnot& asked, const VectorX& y, double constant, VectorX& rows) const;
  void Flat(std::size_t k, const VectorX& z, VectorX& y) const;
  Eigen::Index AddDense(std::size_t k, const VectorX& of_rows) const;
  void FlatGradient(std::size_t k, const VectorX& by, VectorX& g) const;
  void AddSquares(std::size_t k, const VectorX& weights);
  bool EliminateForces(std::size_t k, double damping);
  void AddToChain(std::size_t k);
  const BodyKnot& Asked(std::size_t k) const { return problem_.knots[k]; }
  double StillnessOf(Eigen::Index coordinate) const;
  double NearWeight(std::size_t k, Eigen::Index coordinate) const;
  double AccelerationWeight(Eigen::Index coordinate) const;

  const BodyProblem& problem_;
  const RobotModel& model_;
  ChainSpline spline_;
  MotorRows motors_;
  KnotModel knot_model_;
  Eigen::Index n_;  // coordinates
  Eigen::Index points_size_ = 0, forces_size_ = 0, residuals_ = 0;
  std::vector<Knot> knots_;
  std::vector<double> share_;  // by knot: root of its share of time over 10 ms
  std::vector<int> ranged_;    // joints with a range
  VectorX value_;
  ChainMatrix chain_;
  // Work space
  MatrixX square_, yy_, coupled_, mixed_, chain_square_, scaled_;
  KnotForces forces_;
  KnotFoot foot_;
  mutable VectorX flat_, dense_, posture_;
};

/// Rows of distances of links are in dm, so that their multipliers are about as large as those of others.
inline constexpr double kApartUnit = 10.0;
/// Rows of feet are in cm, so that their multipliers are as large as those of others.
inline constexpr double kFootUnit = 100.0;

/// Tangential directions of a friction pyramid: inside the cone by 3.4 %.
inline constexpr int kPyramidSides = 12;

}  // namespace gaitwright
