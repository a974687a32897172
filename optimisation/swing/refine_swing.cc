// SPDX-License-Identifier: BSD-3-Clause
#include "optimisation/swing/refine_swing.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

#include "kinematics/base/non_finite.h"
#include "kinematics/spatial/dense_solvers.h"
#include "kinematics/trajectory/bspline.h"
#include "kinematics/trajectory/swing_curve.h"
#include "optimisation/numerics/constrained_problem.h"
#include "optimisation/numerics/elastic_interior.h"
#include "optimisation/swing/swing_profile.h"
#include "planning/audit/swing_depth.h"

namespace gaitwright {
namespace {

/// Initial guesses for a path down: (lead of the foot as a share of the path, earlier arrival as a share of the swing).
constexpr std::array<std::pair<double, double>, 6> kGuesses = {
    {{0.0, 0.0}, {0.15, 0.0}, {0.35, 0.0}, {-0.35, 0.0}, {0.0, 0.2}, {0.0, 0.3}}};
constexpr int kReach = 1;  // Constraint::family

/// Values or accelerations of the free control points' basis at fractions of the swing.
MatrixX BasisAt(const std::vector<double>& fractions, int free, bool acceleration) {
  MatrixX rows = MatrixX::Zero(static_cast<Eigen::Index>(fractions.size()), free);
  for (std::size_t k = 0; k < fractions.size(); ++k) {
    const QuinticBasis basis = EvaluateQuinticBasis(free + 2 * kFixedSwingPoints, fractions[k]);
    for (int i = 0; i < 6; ++i) {
      const int point = basis.first + i - kFixedSwingPoints;
      if (point < 0 || point >= free) continue;
      const auto at = static_cast<std::size_t>(i);
      rows(static_cast<Eigen::Index>(k), point) = acceleration ? basis.acceleration[at] : basis.value[at];
    }
  }
  return rows;
}

std::vector<double> Fractions(int count) {
  std::vector<double> fractions;
  for (int k = 1; k <= count; ++k) fractions.push_back(k / (count + 1.0));
  return fractions;
}

/// The problem in the free control points: forward components first, then upward.
class Detour {
 public:
  Detour(const SwingCurve& swing, const SwingProfile& profile, const RefineChoice& choice)
      : profile_(profile),
        free_(choice.control_points - 2 * kFixedSwingPoints),
        sideways_W_(choice.sideways_m * profile.left_W()),
        variables_(choice.reach.empty() ? 2 * free_ : 3 * free_),
        start_z_(swing.X_WF_start.translation().z()),
        rise_m_(swing.X_WF_end.translation().z() - start_z_),
        cruise_(swing.cruise),
        firmness_(choice.reach.empty() ? 1.0 : 10.0) {
    fractions_ = Fractions(choice.samples);
    basis_ = BasisAt(fractions_, free_, false);
    const double step = 1.0 / (choice.samples + 1);
    for (const double u : fractions_) {
      wanted_m_.push_back(choice.clearance_m * ClearanceRamp(u) - kDepth * SwingEndShare(u));
      const Vector3 roll_W = choice.roll.At(u);
      straight_s_.push_back(Gone(u) * profile.length_m() + profile.along_W().dot(roll_W.head<2>()));
      straight_z_.push_back(start_z_ + Gone(u) * rise_m_ + roll_W.z());
      // Up to the neighbours on both sides, so that the samples together cover the whole ground between them.
      const double reach = std::max(Gone(u + step) - Gone(u), Gone(u) - Gone(u - step));
      reach_m_.push_back(reach * profile.length_m());
    }
    AddReach(swing, choice);
  }

  /// @param lead  share of the path by which the initial guess leads in mid swing; negative: lags.
  /// @param wait  share of the swing before the foot starts forward; negative: it arrives that much before the end.
  ConstrainedProblem Problem(double lead, double wait) const {
    ConstrainedProblem problem;
    problem.start = VectorX::Zero(variables_);
    problem.start.head(free_) = Waiting(wait).array() + lead * profile_.length_m();
    const VectorX forward_m = basis_ * problem.start.head(free_);
    double lift = 0.0;
    for (std::size_t k = 0; k < fractions_.size(); ++k) {
      lift =
          std::max(lift, profile_.Highest(straight_s_[k] + forward_m[static_cast<Eigen::Index>(k)], reach_m_[k]).first +
                             wanted_m_[k] - straight_z_[k]);
    }
    problem.start.segment(free_, free_).setConstant(lift);
    AddJerk(problem);
    const auto rows = static_cast<Eigen::Index>(fractions_.size());
    problem.constraints.push_back({"the clearance",
                                   [this](const VectorX& x, VectorX& value, MatrixX* J) { Clearance(x, value, J); },
                                   VectorX::Zero(rows), VectorX::Constant(rows, kInfinity)});
    if (within_.rows() == 0) return problem;
    problem.constraints.push_back({"the reach",
                                   [this](const VectorX& x, VectorX& value, MatrixX* J) {
                                     value.noalias() = within_ * x;
                                     if (J != nullptr) *J = within_;
                                   },
                                   VectorX::Constant(within_.rows(), -kInfinity),
                                   room_m_,
                                   {},
                                   true,
                                   kReach});
    return problem;
  }

  std::vector<Vector3> ControlPoints(const VectorX& x) const {
    std::vector<Vector3> points;
    for (int i = 0; i < free_; ++i) {
      Vector2 along = x[i] * profile_.along_W() + sideways_W_;
      if (variables_ > 2 * free_) along += x[2 * free_ + i] * profile_.left_W();
      points.emplace_back(along.x(), along.y(), x[free_ + i]);
    }
    return points;
  }

 private:
  /// Share of the straight path at a fraction of the swing.
  double Gone(double u) const { return SmoothStep(u, cruise_).value; }

  /// Forward control points of a foot that waits.
  VectorX Waiting(double wait) const {
    VectorX forward_m(basis_.rows());
    for (Eigen::Index k = 0; k < forward_m.size(); ++k) {
      const double u = fractions_[static_cast<std::size_t>(k)];
      const double gone = Gone((u - std::max(wait, 0.0)) / (1.0 - std::abs(wait)));
      forward_m[k] = (gone - Gone(u)) * profile_.length_m();
    }
    return SolveLeastSquares(basis_, forward_m);
  }

  /// Adds the jerk, forward and upward: its mean between neighbouring samples; the acceleration at both ends is zero.
  void AddJerk(ConstrainedProblem& problem) const {
    constexpr int kSamples = 40;
    constexpr double kCheap = 1e-5;  // so that the penalty on reach always exceeds the gain in jerk
    const double scale = std::sqrt(kSamples + 1.0) * (variables_ > 2 * free_ ? kCheap : 1.0);
    const std::vector<double> fractions = Fractions(kSamples);
    const MatrixX accelerations = BasisAt(fractions, free_, true);
    MatrixX basis = MatrixX::Zero(kSamples + 1, free_);
    basis.topRows(kSamples) += scale * accelerations;
    basis.bottomRows(kSamples) -= scale * accelerations;
    VectorX step = VectorX::Zero(kSamples + 1);
    for (int k = 0; k < kSamples; ++k) {
      const double acceleration = scale * SmoothStep(fractions[static_cast<std::size_t>(k)], cruise_).acceleration;
      step[k] += acceleration;
      step[k + 1] -= acceleration;
    }
    const auto add = [&](int first, double travel_m) {
      std::vector<int> variables;
      for (int i = 0; i < free_; ++i) variables.push_back(first + i);
      problem.residuals.push_back(
          {[basis, of_step = VectorX(travel_m * step)](const VectorX& x, VectorX& value, MatrixX* J) {
             value = of_step;
             value.noalias() += basis * x;
             if (J != nullptr) *J = basis;
           },
           variables});
    };
    add(0, profile_.length_m());
    add(free_, rise_m_);
    if (variables_ > 2 * free_) add(2 * free_, 0.0);
  }

  /// within_ x <= room_m_: half-spaces at fractions of the swing.
  void AddReach(const SwingCurve& swing, const RefineChoice& choice) {
    const SwingCurve straight = StraightMoveOf(swing);
    std::vector<double> fractions;
    for (const ReachAt& at : choice.reach) fractions.insert(fractions.end(), at.sides.size(), at.u);
    const MatrixX basis = BasisAt(fractions, free_, false);
    within_.resize(basis.rows(), variables_);
    room_m_.resize(basis.rows());
    Eigen::Index row = 0;
    for (const ReachAt& at : choice.reach) {
      const double time_s = swing.start_s + at.u * (swing.end_s - swing.start_s);
      const Vector3 p_W = Evaluate(straight, time_s).X_WF.translation() + choice.roll.At(at.u);
      for (const ReachSide& side : at.sides) {
        const Vector2 level_W = side.normal_W.head<2>();
        within_.row(row).head(free_) = level_W.dot(profile_.along_W()) * basis.row(row);
        within_.row(row).segment(free_, free_) = side.normal_W.z() * basis.row(row);
        within_.row(row).tail(free_) = level_W.dot(profile_.left_W()) * basis.row(row);
        room_m_[row] = side.offset_m - side.normal_W.dot(p_W) - level_W.dot(sideways_W_) * basis.row(row).sum();
        ++row;
      }
    }
  }

  void Clearance(const VectorX& x, VectorX& value, MatrixX* J) const {
    value.resize(basis_.rows());
    for (Eigen::Index k = 0; k < basis_.rows(); ++k) {
      const auto at = static_cast<std::size_t>(k);
      const double s = straight_s_[at] + basis_.row(k).dot(x.head(free_));
      const auto [height, slope] = profile_.Highest(s, reach_m_[at]);
      const double z = straight_z_[at] + basis_.row(k).dot(x.segment(free_, free_));
      value[k] = firmness_ * (z - height - wanted_m_[at]);
      if (J == nullptr) continue;
      J->row(k).setZero();
      J->row(k).head(free_) = -firmness_ * slope * basis_.row(k);
      J->row(k).segment(free_, free_) = firmness_ * basis_.row(k);
    }
  }

  static constexpr double kDepth = 0.8 * kDepthMargin;

  const SwingProfile& profile_;
  const int free_;
  const Vector2 sideways_W_;
  const int variables_;                                // forward, upward and, with a reach, to the left
  const double start_z_, rise_m_, cruise_, firmness_;  // firmness_: of the clearance, relative to the reach
  std::vector<double> fractions_, wanted_m_, reach_m_;
  std::vector<double> straight_s_, straight_z_;  // progress and height without a detour, by sample
  MatrixX basis_, within_;
  VectorX room_m_;
};

/// The path of least cost. With a reach an interior-point method is used, because many sides are active at once.
Result<ConstrainedSolution> LeastJerk(const ConstrainedProblem& problem, bool has_reach, ConstrainedSolution& last) {
  ElasticOptions elastic;
  elastic.tolerance = 1e-5;
  elastic.cost_tolerance = 1e-4;
  if (has_reach) return SolveElastic(problem, elastic, &last);
  ConstrainedOptions options;
  options.tolerance = 1e-5;
  options.cost_tolerance = 1e-6;
  options.trust_radius = 1e8;
  return Solve(problem, options, &last);
}

/// Failure with the missing clearance, or the distance out of reach, of the best path.
Failure Unmet(double by_m, double out_m) {
  const std::string why =
      out_m < by_m
          ? fmt::format("no swing stays within reach; the smallest violation is {:.1f} mm", 1e3 * out_m)
          : fmt::format("no swing has the required clearance; the smallest violation is {:.1f} mm", 1e3 * by_m);
  return {FailureKind::kInfeasible,
          out_m < by_m ? FailureCode::kOutOfReach : FailureCode::kNoClearance,
          "RefineSwing",
          why,
          {"lower the clearance, allow more time, or place the footholds farther from edges"}};
}

void Check(const RefineChoice& choice) {
  if (choice.control_points < 9 || choice.control_points > 30)
    throw InvalidArgument(fmt::format("RefineSwing: {} control points; accepted: 9 to 30", choice.control_points));
  if (choice.samples < 20 || choice.samples > 40)
    throw InvalidArgument(fmt::format("RefineSwing: {} samples; accepted: 20 to 40", choice.samples));
}

}  // namespace

Result<RefinedSwing> RefineSwing(const SwingCurve& swing, const std::vector<Vector3>& underside_F,
                                 const GroundHeight& ground, const RefineChoice& choice) {
  Check(choice);
  const SwingProfile profile(swing, underside_F, ground, choice);
  const Detour detour(swing, profile, choice);
  // A riser has a gradient only when the foot is at it. So several initial guesses are tried: straight, rising first,
  // and descending last, by different amounts, with the likelier ones for a path up or down first. The result with the
  // least jerk is used.
  const double rise_m = swing.X_WF_end.translation().z() - swing.X_WF_start.translation().z();
  const double side = rise_m > 0.0 ? -1.0 : 1.0;
  const double rounding_m = 1e-4 + 0.05 * choice.clearance_m;
  std::optional<RefinedSwing> best;
  double least_cost = kInfinity, least_missed_m = kInfinity, least_out_m = kInfinity;
  for (const auto& [lead, wait] : kGuesses) {
    ConstrainedSolution last;
    const Result<ConstrainedSolution> solution =
        LeastJerk(detour.Problem(side * lead, -side * wait), !choice.reach.empty(), last);
    double& least_m = last.worst_family == kReach ? least_out_m : least_missed_m;
    if (!solution) least_m = std::min(least_m, last.violation);
    constexpr double kOut = 1e12;  // more than any jerk
    const double cost = solution ? solution->cost : kOut * last.violations;
    if ((!solution && !choice.may_stray) || cost >= least_cost) continue;
    RefinedSwing refined{swing, 0.0, last.brief};
    refined.curve.detour_W = detour.ControlPoints(last.x);
    refined.margin_m = ClearanceMargin(refined.curve, underside_F, ground, choice.clearance_m, choice.roll);
    least_missed_m = std::min(least_missed_m, -refined.margin_m);
    if (refined.margin_m < -rounding_m) continue;
    least_cost = cost;
    best = std::move(refined);
    if (!choice.reach.empty() && solution.ok()) break;
  }
  return best ? Result<RefinedSwing>(*best) : Unmet(least_missed_m, least_out_m);
}

}  // namespace gaitwright
