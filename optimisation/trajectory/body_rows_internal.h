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
///   dense rows of a knot: six of the dynamics, then efforts of the motors, then their powers if these are weighed
///   posture rows of a knot: of feet, then distances of links, then of points near places; all else is linear in y,
///   but for rows of jerk, which are linear in the accelerations of a knot and of the one before it
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
  /// Solves for each column.
  MatrixX SolvedAll(const MatrixX& right) const;

  /// Times of knots at which constraints are violated by more than a tolerance where Evaluate was last, in order.
  std::vector<double> TimesUnmet(double tolerance) const;

  /// From the next Evaluate on, knots are passed at these rates, and feet are to be at their goals plus these shifts:
  /// by knot, then by goal. Both are constant in all derivatives.
  void SetChosen(const std::vector<KnotPace>& paces, const std::vector<std::vector<Vector3>>& shifts_W);
  /// Change of the rows of a knot by a change of its pace or of the shift of a goal where Differentiate was last; other
  /// rows of `rows` are left as they are.
  void MovedByPace(std::size_t k, const KnotPace& by, VectorX& rows) const;
  void MovedByShift(std::size_t k, std::size_t goal, const Vector3& by_W, VectorX& rows) const;
  /// From the next Evaluate on, knots that are tied repeat these states, by cycle: coordinates, rates, accelerations.
  /// At first all are zero. Constant in all derivatives.
  void SetCycles(std::vector<VectorX> states);
  /// Likewise, by a change of the state of the knot's cycle. The knot is tied.
  void MovedByCycle(std::size_t k, const VectorX& by_state, VectorX& rows) const;
  /// Whether limits of jerk are among the rows. They hold for the problem's own pace.
  bool HasJerks() const { return !jerked_.empty(); }
  /// How many cycles the problem has.
  int cycles() const { return static_cast<int>(cycles_.size()); }
  /// Coordinates, rates and accelerations of a knot at z, at the problem's own pace.
  VectorX StateAt(std::size_t k, const VectorX& z) const;
  /// First and last row of a knot's residuals, and of its constraints.
  std::array<std::pair<Eigen::Index, Eigen::Index>, 2> RowsOf(std::size_t k) const;
  /// Adds J^T * by of the rows of a knot.
  void AddGradient(std::size_t k, const VectorX& by, VectorX& gradient) const;

  /// How many unknowns there are.
  Eigen::Index size() const { return points_size_ + forces_size_; }
  const ChainSpline& spline() const { return spline_; }
  /// The reverse of Unknowns.
  MatrixX PointsOf(const VectorX& z) const;
  std::vector<VectorX> ForcesOf(const VectorX& z) const;

 private:
  /// Kinds of rows of a knot, in their order: residuals first.
  enum Kind {
    kNear,
    kNearAcceleration,
    kEffort,
    kForce,
    kPower,
    kPoint,
    kDynamics,
    kFeet,
    kEffortLimit,
    kCurve,
    kAcceleration,
    kRange,
    kCone,
    kApart,
    kPinnedPlace,
    kPinnedMotion,
    kTied,
    kJerk,
    kKinds
  };
  struct Knot {
    Eigen::Index force = 0, forces = 0;  // first of z, and how many
    Eigen::Index row[kKinds + 1] = {};   // first of each kind; residuals and constraints are apart
    Eigen::Index residual_end = 0;
    VectorX y;
    VectorX dense, posture;          // values
    std::vector<RowBounds> of_feet;  // bounds of rows of feet [m], [rad]
    std::vector<Vector3> shift_W;    // of goals of feet, or empty
    KnotPace pace;
    MatrixX D;     // dense rows by y
    MatrixX J;     // posture rows by coordinates
    MatrixX L, E;  // factors of the forces' own block, and of their coupling
    std::vector<KnotContact> contacts;
  };

  void ListRows();
  template <class Right>
  void Substitute(Right& solved, bool forward) const;
  Eigen::Index CountOf(const Knot& knot, const BodyKnot& asked, Kind kind) const;
  void SetState(Knot& knot, ChartedState& state);
  void EvaluatePosture(Knot& knot, const BodyKnot& asked, const ChartedState* with_derivatives);
  Eigen::Index EvaluateFeet(Knot& knot, const BodyKnot& asked, const ChartedState* with_derivatives);
  void EvaluateApart(Knot& knot, const BodyKnot& asked, const ChartedState* with_derivatives, Eigen::Index first);
  void EvaluatePoints(Knot& knot, const BodyKnot& asked, const ChartedState* with_derivatives, Eigen::Index first);
  VectorX OfPosture(std::size_t k, const VectorX& of_rows, double of_points) const;
  void FillRows(std::size_t k, const VectorX& y, const VectorX& dense, const VectorX& posture, bool constants,
                VectorX& rows) const;
  VectorX StateOfTie(const CycleTie& tie, const VectorX& state, double constant) const;
  void FillPins(const Knot& knot, const BodyKnot& asked, const VectorX& y, double constant, VectorX& rows) const;
  void Flat(std::size_t k, const VectorX& z, VectorX& y) const;
  void EvaluatePower(Knot& knot);
  void DifferentiatePower(Knot& knot);
  Eigen::Index AddDense(std::size_t k, const VectorX& of_rows) const;
  Eigen::Index powers() const { return problem_.weights.power > 0.0 ? motors_.count() : 0; }
  void FlatGradient(std::size_t k, const VectorX& by, VectorX& g) const;
  void AddSquares(std::size_t k, const VectorX& weights);
  void AddDiagonal(std::size_t k, const VectorX& weights);
  bool EliminateForces(std::size_t k, double damping);
  void AddToChain(std::size_t k);
  const BodyKnot& Asked(std::size_t k) const { return problem_.knots[k]; }
  double MostAcceleration(int dof) const;
  double JerkScale(std::size_t k, int dof) const;
  void FillJerks(std::size_t k, const Eigen::Ref<const VectorX>& before, const Eigen::Ref<const VectorX>& now,
                 VectorX& rows) const;
  void AddJerkGradient(std::size_t k, const VectorX& by, VectorX& gradient) const;
  void AddJerkSquares(std::size_t k, const VectorX& weights);
  const ApartPair& PairOf(const BodyKnot& asked, Eigen::Index apart_row) const;
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
  std::vector<KnotBasis> basis_;         // by knot, for its pace
  std::vector<double> share_, of_knot_;  // by knot: root of its share of time over 10 ms; of the problem's time
  std::vector<int> ranged_;              // joints with a range
  std::vector<int> accelerated_;         // joints with a limit of acceleration
  std::vector<int> jerked_;              // joints with a limit of jerk
  std::vector<VectorX> cycles_;          // states
  VectorX tie_unit_;                     // of rows that tie a state
  VectorX effort_factor_;                // of the weights of efforts, by motor
  VectorX value_;
  ChainMatrix chain_;
  // Work space
  MatrixX square_, yy_, coupled_, mixed_, chain_square_, scaled_;
  KnotForces forces_;
  KnotFoot foot_;
  std::vector<ConvexDistance> apart_points_;
  mutable VectorX flat_, dense_, posture_, before_;
};

/// z of control points (columns) and forces by knot.
VectorX Unknowns(const MatrixX& points, const std::vector<VectorX>& forces);

/// Rows of distances of links are in dm, so that their multipliers are about as large as those of others.
inline constexpr double kApartUnit = 10.0;
/// Rows of feet are in cm, so that their multipliers are as large as those of others.
inline constexpr double kFootUnit = 100.0;

/// Tangential directions of a friction pyramid: inside the cone by 3.4 %.
inline constexpr int kPyramidSides = 12;

}  // namespace gaitwright
