// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Cholesky>
#include <Eigen/Sparse>
#include <array>
#include <string>
#include <vector>

#include "optimisation/trajectory/body_rows_internal.h"

namespace gaitwright {

/// A foothold that is chosen with the motion: it may be shifted along two directions.
struct ShiftedFoothold {
  struct Share {
    int knot = 0;
    std::size_t goal = 0;  ///< of the knot's feet
    double share = 1.0;    ///< of the shift that moves the goal
  };

  std::string name;  ///< of its foot, for messages
  std::array<Vector3, 2> along_W = {Vector3::UnitX(), Vector3::UnitY()};
  std::array<double, 2> lower_m = {-0.05, -0.05}, upper_m = {0.05, 0.05};
  std::vector<Share> shares;
};

/// What is chosen together with the motion of a BodyProblem.
///
/// = Notation =
///   s      the problem's time, t the time of the motion that is found
///   p_j    control points of a uniform cubic B-spline over s:  ln(ds/dt) = sum_j p_j B_j(s)
struct BodyChoices {
  std::vector<ShiftedFoothold> footholds;
  int pace_points = 0;                   ///< control points of the pace; 0: the problem's times are kept
  double slowest = 0.8, fastest = 1.25;  ///< pace at control points
  double longest = 1.0;                  ///< total duration over the problem's, which it may reach but not undercut
  double foothold_weight = 3.0;          ///< of a shift [1/m]
  double pace_weight = 0.3;              ///< of a control point of the pace

  Eigen::Index count() const { return pace_points + 2 * static_cast<Eigen::Index>(footholds.size()); }
};

/// The pace of a motion over a problem's time.
class PaceSpline {
 public:
  /// @param points  control points; fewer than four: the problem's own pace.
  PaceSpline(double start_s, double end_s, VectorX points);

  KnotPace At(double problem_s) const;
  /// B_j and its rate at a time, for the four points from `first` on.
  struct Basis {
    Eigen::Index first = 0;
    std::array<double, 4> value{}, rate{};
  };
  Basis BasisAt(double problem_s) const;

 private:
  double start_s_, step_s_;
  VectorX points_;
};

/// BodyRows whose paces, footholds and states of cycles are unknowns too: their Jacobian has a border of dense columns,
/// which is eliminated last.
class ChosenRows : public ElasticRows {
 public:
  /// Keeps references. @param start  of BodyRows; nothing is shifted there, at the problem's pace.
  ChosenRows(const BodyProblem& problem, const BodyChoices& choices, const VectorX& start);

  Eigen::Index count() const override { return value_.size(); }
  Eigen::Index residuals() const override { return inner_.residuals() + chosen_; }
  const VectorX& value() const override { return value_; }
  RowBounds BoundsOf(Eigen::Index row) const override;
  std::string NameOf(Eigen::Index row) const override;
  double unnoticed() const override { return inner_.unnoticed(); }
  void Evaluate(const VectorX& z) override;
  void Differentiate() override;
  VectorX Gradient(const VectorX& by) const override;
  VectorX Moved(const VectorX& by) const override;
  bool Factor(const VectorX& weights, double damping) override;
  VectorX Solved(const VectorX& right) const override;

  /// Unknowns: those of BodyRows, then pace points, then two shifts a foothold, then the states of cycles. The paces
  /// are the problem's own there, nothing is shifted, and cycles have the states of their first knots.
  VectorX StartOf(const VectorX& inner) const;
  const BodyRows& inner() const { return inner_; }
  VectorX InnerOf(const VectorX& z) const { return z.head(inner_.size()); }
  PaceSpline PaceOf(const VectorX& z) const;
  /// By foothold [m].
  std::vector<Vector3> ShiftsOf(const VectorX& z) const;

 private:
  VectorX InnerRows(const VectorX& rows) const;
  VectorX Joined(const VectorX& inner, const VectorX& near, const VectorX& bounded, double longer) const;
  double DurationOf(const PaceSpline& pace) const;
  bool HasPace() const { return choices_.pace_points > 0; }

  const BodyProblem& problem_;
  const BodyChoices& choices_;
  BodyRows inner_;
  Eigen::Index chosen_, state_size_, free_;  // how many choices, values of a state, and unknowns beside the inner ones
  std::vector<double> share_s_;              // by knot: time that it stands for
  VectorX value_, z_;
  VectorX weight_;                      // of a choice
  Eigen::SparseMatrix<double> border_;  // of the inner rows
  VectorX longer_by_;                   // duration's row by choices
  MatrixX eliminated_;                  // inner factors' solution of the border
  Eigen::LLT<MatrixX> factors_;         // of what is left of the choices
};

}  // namespace gaitwright
