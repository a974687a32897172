// SPDX-License-Identifier: BSD-3-Clause
#include "optimisation/swing/refine_swing.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <utility>

#include "kinematics/spatial/rotation.h"
#include "kinematics/trajectory/bspline.h"
#include "optimisation/numerics/constrained_problem.h"
#include "planning/audit/swing_depth.h"

namespace gaitwright {
namespace {

constexpr double kInf = std::numeric_limits<double>::infinity();
/// First guesses for a way down, as shares of the way that the foot is ahead and of the swing that it is there sooner.
constexpr std::array<std::pair<double, double>, 6> kGuesses = {
    {{0.0, 0.0}, {0.15, 0.0}, {0.35, 0.0}, {-0.35, 0.0}, {0.0, 0.2}, {0.0, 0.3}}};
constexpr int kFixed = 3;  // control points at each end
/// [m] How deep the underside may be at both ends, half of what the audit lets pass: it is on its foothold's plane, not
/// on what is tilted or curved beside it.
constexpr double kSpareDepth = 0.5 * tolerance::kPosition;

/// Share of the way to the side at a fraction of the swing: what free control points that are all one give.
double SidewaysShare(int control_points, double u) {
  const QuinticBasis basis = EvaluateQuinticBasis(control_points, u);
  double share = 0.0;
  for (int i = 0; i < 6; ++i) {
    const int point = basis.first + i;
    if (point >= kFixed && point < control_points - kFixed) share += basis.value[static_cast<std::size_t>(i)];
  }
  return share;
}

/// The fraction of the swing at which a straight one has gone a share of its way.
double FractionAt(double share, double cruise) {
  double low = 0.0, high = 1.0;
  for (int i = 0; i < 40; ++i) {
    const double middle = 0.5 * (low + high);
    (SmoothStep(middle, cruise).value < share ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

/// The least height of the contact frame at which the underside touches the ground, by progress along the way: a table
/// with straight pieces.
class Profile {
 public:
  Profile(const SwingCurve& swing, const std::vector<Vector3>& underside_F, const GroundHeight& ground,
          const RefineChoice& choice) {
    const Vector3 travel = swing.X_WF_end.translation() - swing.X_WF_start.translation();
    length_m_ = travel.head<2>().norm();
    if (length_m_ > kShortest) along_W_ = travel.head<2>() / length_m_;
    sideways_W_ = choice.sideways_m * left_W();
    const Vector3 turn = RotationLog(swing.X_WF_end.linear() * swing.X_WF_start.linear().transpose());
    constexpr double kDeep = 1.0;  // where there is no ground
    const double floor_m = std::min(swing.X_WF_start.translation().z(), swing.X_WF_end.translation().z()) - kDeep;
    const int count = 1 + static_cast<int>(std::ceil((length_m_ + 2.0 * kBeyond) / kStep));
    for (int i = 0; i < count; ++i) {
      const double s = i * kStep - kBeyond;
      const double share = length_m_ > kShortest ? std::clamp(s / length_m_, 0.0, 1.0) : 0.5;
      const Matrix3 R_WF = RotationExp(share * turn) * swing.X_WF_start.linear();
      const double aside =
          choice.sideways_m == 0.0 ? 0.0 : SidewaysShare(choice.control_points, FractionAt(share, swing.cruise));
      const Vector2 off_W = aside * sideways_W_ + left_W().dot(RollAt(choice, share, swing.cruise)) * left_W();
      const Vector2 p_W = swing.X_WF_start.translation().head<2>() + s * along_W_ + off_W;
      double height = floor_m;
      for (const Vector3& q_F : underside_F) {
        const Vector3 q_W = R_WF * q_F;
        height = std::max(height, ground(p_W + q_W.head<2>()) - q_W.z());
      }
      height_m_.push_back(height);
    }
    Widen();
    LimitSlope(swing.X_WF_start.translation().z(), swing.X_WF_end.translation().z());
  }

  double length_m() const { return length_m_; }
  const Vector2& along_W() const { return along_W_; }
  Vector2 left_W() const { return {-along_W_.y(), along_W_.x()}; }

  /// The greatest height within `reach` of a progress, and the slope there.
  std::pair<double, double> Highest(double s, double reach) const {
    return std::max({At(s - reach), At(s), At(s + reach)});
  }

 private:
  static Vector2 RollAt(const RefineChoice& choice, double share, double cruise) {
    return choice.roll.At(FractionAt(share, cruise)).head<2>();
  }

  static constexpr double kStep = 0.002, kBeyond = 0.1, kShortest = 1e-3;  // [m]

  std::pair<double, double> At(double s) const {
    const double place = std::clamp((s + kBeyond) / kStep, 0.0, static_cast<double>(height_m_.size()) - 1.001);
    const auto i = static_cast<std::size_t>(place);
    const double slope = (height_m_[i + 1] - height_m_[i]) / kStep;
    return {height_m_[i] + (place - static_cast<double>(i)) * kStep * slope, slope};
  }

  /// Whether a row is nearest to the start or the end of the way.
  bool IsEnd(std::size_t row) const {
    const double s = static_cast<double>(row) * kStep - kBeyond;
    return std::min(std::abs(s), std::abs(s - length_m_)) < 0.5 * kStep;
  }

  /// An edge between two rows is taken to be at the farther one, so that nothing is lower in the table than it is.
  void Widen() {
    const std::vector<double> own = height_m_;
    for (std::size_t i = 0; i < own.size(); ++i) {
      if (i > 0 && !IsEnd(i)) height_m_[i] = std::max(height_m_[i], own[i - 1]);
      if (i + 1 < own.size() && !IsEnd(i)) height_m_[i] = std::max(height_m_[i], own[i + 1]);
    }
  }

  /// Raises the table where it climbs or falls faster than a slope that leaves start and end as they are.
  void LimitSlope(double start_z, double end_z) {
    constexpr double kGentle = 2.0, kSteepest = 40.0;
    double slope = kGentle;
    for (const auto& [at_s, z] : {std::pair{0.0, start_z}, std::pair{length_m_, end_z}}) {
      for (std::size_t i = 0; i < height_m_.size(); ++i) {
        const double away = std::abs(static_cast<double>(i) * kStep - kBeyond - at_s), above = height_m_[i] - z;
        if (away > kStep && above > 0.0) slope = std::max(slope, above / (away - kStep));
      }
    }
    const double drop = std::min(slope, kSteepest) * kStep;
    for (std::size_t i = 1; i < height_m_.size(); ++i) height_m_[i] = std::max(height_m_[i], height_m_[i - 1] - drop);
    for (std::size_t i = height_m_.size() - 1; i-- > 0;) height_m_[i] = std::max(height_m_[i], height_m_[i + 1] - drop);
  }

  std::vector<double> height_m_;
  double length_m_ = 0.0;
  Vector2 along_W_ = Vector2::Zero(), sideways_W_ = Vector2::Zero();
};

/// Values or accelerations of the free control points' basis at fractions of the swing.
MatrixX BasisAt(const std::vector<double>& fractions, int free, bool acceleration) {
  MatrixX rows = MatrixX::Zero(static_cast<Eigen::Index>(fractions.size()), free);
  for (std::size_t k = 0; k < fractions.size(); ++k) {
    const QuinticBasis basis = EvaluateQuinticBasis(free + 2 * kFixed, fractions[k]);
    for (int i = 0; i < 6; ++i) {
      const int point = basis.first + i - kFixed;
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

/// The problem in the free control points: along the way first, then upwards.
class Detour {
 public:
  Detour(const SwingCurve& swing, const Profile& profile, const RefineChoice& choice)
      : profile_(profile),
        free_(choice.control_points - 2 * kFixed),
        sideways_W_(choice.sideways_m * profile.left_W()),
        start_z_(swing.X_WF_start.translation().z()),
        rise_m_(swing.X_WF_end.translation().z() - start_z_),
        cruise_(swing.cruise) {
    fractions_ = Fractions(choice.samples);
    basis_ = BasisAt(fractions_, free_, false);
    const double step = 1.0 / (choice.samples + 1);
    for (const double u : fractions_) {
      wanted_m_.push_back(choice.clearance_m * ClearanceRamp(u) - kDepth * SwingEndShare(u));
      const Vector3 roll_W = choice.roll.At(u);
      straight_s_.push_back(Gone(u) * profile.length_m() + profile.along_W().dot(roll_W.head<2>()));
      straight_z_.push_back(start_z_ + Gone(u) * rise_m_ + roll_W.z());
      // To the neighbours on both sides, so that two samples over the ground are over all that is between them.
      const double reach = std::max(Gone(u + step) - Gone(u), Gone(u) - Gone(u - step));
      reach_m_.push_back(reach * profile.length_m());
    }
  }

  /// @param lead  share of the way by which the first guess is ahead in mid swing, or behind.
  /// @param wait  share of the swing that it waits before it goes ahead, or is there before the end where negative.
  ConstrainedProblem Problem(double lead, double wait) const {
    ConstrainedProblem problem;
    problem.start = VectorX::Zero(2 * free_);
    problem.start.head(free_) = Waiting(wait).array() + lead * profile_.length_m();
    const VectorX ahead_m = basis_ * problem.start.head(free_);
    double lift = 0.0;
    for (std::size_t k = 0; k < fractions_.size(); ++k) {
      lift =
          std::max(lift, profile_.Highest(straight_s_[k] + ahead_m[static_cast<Eigen::Index>(k)], reach_m_[k]).first +
                             wanted_m_[k] - straight_z_[k]);
    }
    problem.start.tail(free_).setConstant(lift);
    AddJerk(problem);
    const auto rows = static_cast<Eigen::Index>(fractions_.size());
    problem.constraints.push_back({"the clearance",
                                   [this](const VectorX& x, VectorX& value, MatrixX* J) { Clearance(x, value, J); },
                                   VectorX::Zero(rows), VectorX::Constant(rows, kInf)});
    return problem;
  }

  std::vector<Vector3> ControlPoints(const VectorX& x) const {
    std::vector<Vector3> points;
    for (int i = 0; i < free_; ++i) {
      const Vector2 along = x[i] * profile_.along_W() + sideways_W_;
      points.emplace_back(along.x(), along.y(), x[free_ + i]);
    }
    return points;
  }

 private:
  /// Share of the straight way at a fraction of the swing.
  double Gone(double u) const { return SmoothStep(u, cruise_).value; }

  /// Control points along the way of a foot that waits.
  VectorX Waiting(double wait) const {
    VectorX ahead_m(basis_.rows());
    for (Eigen::Index k = 0; k < ahead_m.size(); ++k) {
      const double u = fractions_[static_cast<std::size_t>(k)];
      const double gone = Gone((u - std::max(wait, 0.0)) / (1.0 - std::abs(wait)));
      ahead_m[k] = (gone - Gone(u)) * profile_.length_m();
    }
    return basis_.colPivHouseholderQr().solve(ahead_m);
  }

  /// Along the way and upwards, by the fraction of the swing: the mean jerk from each sample to the next, from the
  /// acceleration of none at both ends.
  void AddJerk(ConstrainedProblem& problem) const {
    constexpr int kSamples = 40;
    const double scale = std::sqrt(kSamples + 1.0);
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
  }

  void Clearance(const VectorX& x, VectorX& value, MatrixX* J) const {
    value.resize(basis_.rows());
    for (Eigen::Index k = 0; k < basis_.rows(); ++k) {
      const auto at = static_cast<std::size_t>(k);
      const double s = straight_s_[at] + basis_.row(k).dot(x.head(free_));
      const auto [height, slope] = profile_.Highest(s, reach_m_[at]);
      const double z = straight_z_[at] + basis_.row(k).dot(x.tail(free_));
      value[k] = z - height - wanted_m_[at];
      if (J == nullptr) continue;
      J->row(k).head(free_) = -slope * basis_.row(k);
      J->row(k).tail(free_) = basis_.row(k);
    }
  }

  static constexpr double kDepth = 0.8 * kSpareDepth;

  const Profile& profile_;
  const int free_;
  const Vector2 sideways_W_;
  const double start_z_, rise_m_, cruise_;
  std::vector<double> fractions_, wanted_m_, reach_m_;
  std::vector<double> straight_s_, straight_z_;  // progress and height without a detour, by sample
  MatrixX basis_;
};

void Check(const RefineChoice& choice) {
  if (choice.control_points < 9 || choice.control_points > 14)
    throw InvalidArgument(fmt::format("RefineSwing: {} control points; accepted: 9 to 14", choice.control_points));
  if (choice.samples < 20 || choice.samples > 40)
    throw InvalidArgument(fmt::format("RefineSwing: {} samples; accepted: 20 to 40", choice.samples));
}

}  // namespace

std::vector<Vector3> UndersideOf(const Foot& foot) {
  std::vector<Vector3> points = {Vector3::Zero()};
  constexpr int kAround = 8;
  for (int i = 0; foot.radius > 0.0 && i < kAround; ++i) {
    const double angle = 2.0 * std::numbers::pi * i / kAround;
    for (const double share : {0.6, 1.0}) {  // of the radius: 0.2 and 1 of it up
      const Vector2 away = share * foot.radius * Vector2(std::cos(angle), std::sin(angle));
      points.emplace_back(away.x(), away.y(), foot.radius * (1.0 - std::sqrt(1.0 - share * share)));
    }
  }
  if (foot.sole_F.empty()) return points;
  points.clear();
  Vector2 middle = Vector2::Zero();
  for (const Vector2& corner : foot.sole_F) middle += corner / static_cast<double>(foot.sole_F.size());
  constexpr int kPieces = 4;  // of an edge
  for (std::size_t i = 0; i < foot.sole_F.size(); ++i) {
    const Vector2 &corner = foot.sole_F[i], &next = foot.sole_F[(i + 1) % foot.sole_F.size()];
    for (int piece = 0; piece < kPieces; ++piece) {
      const Vector2 edge = corner + (next - corner) * piece / kPieces, inner = 0.5 * (edge + middle);
      points.emplace_back(edge.x(), edge.y(), 0.0);
      points.emplace_back(inner.x(), inner.y(), 0.0);
    }
  }
  points.emplace_back(middle.x(), middle.y(), 0.0);
  return points;
}

double ClearanceRamp(double u) {
  return std::min(SmoothStep(u / kClearanceEnds).value, SmoothStep((1.0 - u) / kClearanceEnds).value);
}

double SpareClearance(const SwingCurve& curve, const std::vector<Vector3>& underside_F, const GroundHeight& ground,
                      double clearance_m, const SwingRoll& roll) {
  constexpr int kSamples = 60;
  double least = kInf;
  for (int k = 1; k < kSamples; ++k) {
    const double u = static_cast<double>(k) / kSamples;
    Pose X_WF = Evaluate(curve, curve.start_s + u * (curve.end_s - curve.start_s)).X_WF;
    X_WF.translation() += roll.At(u);
    const double asked = clearance_m * ClearanceRamp(u) - kSpareDepth * SwingEndShare(u);
    for (const Vector3& q_F : underside_F) {
      const Vector3 q_W = X_WF * q_F;
      least = std::min(least, q_W.z() - ground(q_W.head<2>()) - asked);
    }
  }
  return least;
}

Result<RefinedSwing> RefineSwing(const SwingCurve& swing, const std::vector<Vector3>& underside_F,
                                 const GroundHeight& ground, const RefineChoice& choice) {
  Check(choice);
  const Profile profile(swing, underside_F, ground, choice);
  const Detour detour(swing, profile, choice);
  ConstrainedOptions options;
  options.tolerance = 1e-5;
  options.cost_tolerance = 1e-6;
  options.trust_radius = 1e8;
  const auto unmet = [](double by_m) {
    return Failure{FailureKind::kInfeasible,
                   "no_clearance",
                   "RefineSwing",
                   fmt::format("no swing keeps the clearance; it is missed by {:.1f} mm", 1e3 * by_m),
                   {"ask for less clearance, or place the footholds farther from edges"}};
  };
  // A riser is felt only where the foot is at it: a foot that goes straight up to one, or is behind and rises first, or
  // ahead and comes down last, and more or less so, the likelier ones for a way up or down first. What takes the least
  // jerk of these.
  const double rise_m = swing.X_WF_end.translation().z() - swing.X_WF_start.translation().z();
  const double side = rise_m > 0.0 ? -1.0 : 1.0;
  const double rounding_m = 1e-4 + 0.05 * choice.clearance_m;
  std::optional<RefinedSwing> best;
  double least_cost = kInf, least_missed_m = kInf;
  for (const auto& [lead, wait] : kGuesses) {
    ConstrainedSolution last;
    const Result<ConstrainedSolution> solution = Solve(detour.Problem(side * lead, -side * wait), options, &last);
    if (!solution) least_missed_m = std::min(least_missed_m, last.violation);
    if (!solution || solution->cost >= least_cost) continue;
    RefinedSwing refined{swing, 0.0, solution->brief};
    refined.curve.detour_W = detour.ControlPoints(solution->x);
    refined.spare_m = SpareClearance(refined.curve, underside_F, ground, choice.clearance_m, choice.roll);
    least_missed_m = std::min(least_missed_m, -refined.spare_m);
    if (refined.spare_m < -rounding_m) continue;
    least_cost = solution->cost;
    best = std::move(refined);
  }
  if (!best) return unmet(least_missed_m);
  return *best;
}

}  // namespace gaitwright
