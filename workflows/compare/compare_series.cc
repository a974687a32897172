// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "kinematics/base/non_finite.h"
#include "kinematics/dynamics/dynamics.h"
#include "kinematics/model/dof_units.h"
#include "kinematics/spatial/rotation.h"
#include "planning/plan/sample_plan.h"
#include "workflows/compare/compare_parts_internal.h"
#include "workflows/exchange/knot_spline.h"
#include "workflows/exchange/median_internal.h"

namespace gaitwright {
namespace {

constexpr double kLeastDifference = 1e-9;  // smaller differences are ignored, in any unit
constexpr double kLeastOfSpan = 0.1;       // share of the largest span of a joint, so that a joint at rest has a scale
constexpr double kAttitudeScale = 1.0;     // [rad]

double Weight(SeriesScale scale) {
  if (scale == SeriesScale::kSpeed) return 2.0;
  return scale == SeriesScale::kTorque ? 4.0 : 1.0;
}

bool IsOfAJoint(SeriesScale scale) {
  return scale == SeriesScale::kPosition || scale == SeriesScale::kSpeed || scale == SeriesScale::kTorque;
}

/// One side of a comparison, evaluated at increasing times.
class Side {
 public:
  explicit Side(const ComparedMotion& motion) : motion_(motion), scratch_(motion.model) {}

  /// @param torque_before_s  how much earlier the torque is evaluated.
  void Go(double time_s, double torque_before_s) {
    SampleCompared(motion_, time_s, now_);
    if (torque_before_s > 0.0) {
      SampleCompared(motion_, time_s - torque_before_s, before_);
      now_.tau = before_.tau;
    }
    time_s_ = time_s;
    if (!motion_.derived_speeds.empty()) noise_gain_ = NoiseGain(motion_.rows.time_s, time_s, motion_.longest_step_s);
  }

  double Position(int dof) const { return now_.q[7 + dof]; }
  double Speed(int dof) const { return now_.v[6 + dof]; }
  double Torque(int dof) const { return dof < now_.tau.size() ? now_.tau[dof] : kNaN; }
  /// Noise gain of a computed speed; 0 for a speed from the file.
  double NoiseGainOf(int dof) const { return motion_.derives_speed(dof) ? noise_gain_ : 0.0; }
  const VectorX& q() const { return now_.q; }

  Vector3 Centre() {
    if (!now_.q.allFinite()) return Vector3::Constant(kNaN);
    ForwardKinematics(motion_.model, now_.q, scratch_);
    return CentreOfMass(motion_.model, scratch_);
  }
  Vector2 ZeroMoment() const {
    if (!motion_.plan || motion_.plan->centroidal.size() == 0) return Vector2::Constant(kNaN);
    return SampleCentroidal(motion_.plan->centroidal, time_s_).p_WZ;
  }

 private:
  const ComparedMotion& motion_;
  DynamicsScratch scratch_;
  RowSample now_, before_;
  double time_s_ = 0.0, noise_gain_ = 0.0;
};

std::vector<ComparedSeries> EmptySeries(const ComparedMotion& a, const ComparedMotion& b, const SharedTime& shared) {
  const RobotModel& model = a.model;
  std::vector<ComparedSeries> series;
  for (const NamedPair& joint : shared.joints) {
    series.push_back({"position of " + joint.name, PositionUnit(model, joint.a), SeriesScale::kPosition, {}, {}});
    series.back().resolution = std::max(a.ResolutionOf(joint.a), b.ResolutionOf(joint.b));
    series.push_back({"speed of " + joint.name, SpeedUnit(model, joint.a), SeriesScale::kSpeed, {}, {}});
    series.push_back({"torque of " + joint.name, EffortUnit(model, joint.a), SeriesScale::kTorque, {}, {}});
  }
  for (const char* axis : {"x", "y", "z"})
    series.push_back({fmt::format("{} of the base", axis), "m", SeriesScale::kLength, {}, {}, 0.0, {}, true});
  series.push_back({"attitude of the base", "rad", SeriesScale::kAngle, {}, {}, 0.0, {}, true});
  for (const char* axis : {"x", "y", "z"})
    series.push_back({fmt::format("{} of the centre of mass", axis), "m", SeriesScale::kLength, {}, {}});
  for (const char* axis : {"x", "y"})
    series.push_back({fmt::format("{} of the zero-moment point", axis), "m", SeriesScale::kLength, {}, {}});
  return series;
}

/// The angle between two attitudes.
double AngleBetween(const VectorX& q_a, const VectorX& q_b) {
  if (!q_a.segment<4>(3).allFinite() || !q_b.segment<4>(3).allFinite()) return kNaN;
  return RotationLog(BaseRotation(q_a).transpose() * BaseRotation(q_b)).norm();
}

/// The larger range (largest minus smallest value) of the two sides.
double SpanOf(const ComparedSeries& series) {
  double span = 0.0;
  for (const std::vector<double>* values : {&series.a, &series.b}) {
    double least = INFINITY, most = -INFINITY;
    for (const double value : *values) {
      if (!std::isfinite(value)) continue;
      least = std::min(least, value);
      most = std::max(most, value);
    }
    if (most > least) span = std::max(span, most - least);
  }
  return span;
}

double ScaleOf(const ComparedSeries& one, const std::vector<ComparedSeries>& all, double leg_length_m) {
  if (one.scale == SeriesScale::kLength) return leg_length_m;
  if (one.scale == SeriesScale::kAngle) return kAttitudeScale;
  double largest = 0.0;
  for (const ComparedSeries& other : all) {
    if (other.scale == one.scale && other.unit == one.unit) largest = std::max(largest, SpanOf(other));
  }
  return Weight(one.scale) * std::max(SpanOf(one), kLeastOfSpan * largest);
}

/// The noise on B - A, as far as the two sides agree. At least the rounding error of an encoder, which a joint that
/// mostly rests does not show.
double NoiseBetween(const ComparedSeries& series) {
  std::vector<double> gaps;
  for (std::size_t k = 0; k < series.a.size(); ++k) {
    const double gap = series.b[k] - series.a[k];
    if (std::isfinite(gap)) gaps.push_back(gap);
  }
  return std::max(NoiseOf(gaps), series.resolution / std::sqrt(12.0));
}

/// Time at which a speed that is computed with the next row is known: that of the next row, unless it is missing.
double ShownAt(const SharedTime& shared, std::size_t k) {
  const double now_s = shared.time_s[k];
  if (k + 1 == shared.time_s.size()) return now_s;
  const double next_s = shared.time_s[k + 1];
  return InGap(shared.gaps, 0.5 * (now_s + next_s)) ? now_s : next_s;
}

/// @param noise  standard deviation; for a computed speed, that of the positions.
SeriesDifference DifferenceOf(const ComparedSeries& series, const SharedTime& shared, double tolerance, double noise) {
  const std::vector<double>& time_s = shared.time_s;
  const bool derived = !series.noise_gain.empty();
  SeriesDifference difference{
      .quantity = series.quantity, .unit = series.unit, .derived = derived, .of_base = series.of_base};
  difference.noise = derived ? noise * MedianOf(series.noise_gain) : noise;
  difference.tolerance = tolerance + kNoiseWidth * difference.noise;
  double sum = 0.0;
  for (std::size_t k = 0; k < time_s.size(); ++k) {
    const double gap = std::abs(series.b[k] - series.a[k]);
    if (!std::isfinite(gap)) continue;
    ++difference.samples;
    sum += gap * gap;
    if (gap > difference.largest) {
      difference.largest = gap;
      difference.at_s = time_s[k];
    }
    const double let_pass = tolerance + kNoiseWidth * noise * (derived ? series.noise_gain[k] : 1.0);
    if (gap > let_pass && !difference.first_s) {
      difference.first_s = derived ? ShownAt(shared, k) : time_s[k];
      difference.first_tolerance = let_pass;
      difference.first_a = series.a[k];
      difference.first_b = series.b[k];
    }
  }
  if (difference.samples > 0) difference.rms = std::sqrt(sum / difference.samples);
  return difference;
}

}  // namespace

std::vector<ComparedSeries> SeriesOf(const ComparedMotion& a, const ComparedMotion& b, const SharedTime& shared) {
  std::vector<ComparedSeries> series = EmptySeries(a, b, shared);
  Side of_a(a), of_b(b);
  std::size_t next = 0;
  const auto add = [&](double value_a, double value_b) {
    series[next].a.push_back(value_a);
    series[next++].b.push_back(value_b);
  };
  for (const double time_s : shared.time_s) {
    of_a.Go(time_s, b.torque_age_s - a.torque_age_s);
    of_b.Go(time_s + shared.offset_s, a.torque_age_s - b.torque_age_s);
    next = 0;
    for (const NamedPair& joint : shared.joints) {
      add(of_a.Position(joint.a), of_b.Position(joint.b));
      const bool derived = a.derives_speed(joint.a) || b.derives_speed(joint.b);
      if (derived) series[next].noise_gain.push_back(std::max(of_a.NoiseGainOf(joint.a), of_b.NoiseGainOf(joint.b)));
      add(of_a.Speed(joint.a), of_b.Speed(joint.b));
      add(of_a.Torque(joint.a), of_b.Torque(joint.b));
    }
    for (int axis = 0; axis < 3; ++axis) add(of_a.q()[axis], of_b.q()[axis]);
    add(0.0, AngleBetween(of_a.q(), of_b.q()));
    const Vector3 centre_a = of_a.Centre(), centre_b = of_b.Centre();
    for (int axis = 0; axis < 3; ++axis) add(centre_a[axis], centre_b[axis]);
    const Vector2 zmp_a = of_a.ZeroMoment(), zmp_b = of_b.ZeroMoment();
    for (int axis = 0; axis < 2; ++axis) add(zmp_a[axis], zmp_b[axis]);
  }
  return series;
}

std::vector<SeriesDifference> DifferencesOf(const std::vector<ComparedSeries>& series, const SharedTime& shared,
                                            double leg_length_m, double tolerance, bool noisy) {
  std::vector<SeriesDifference> differences;
  double of_positions = 0.0;  // noise of the positions of the joint whose speeds follow
  for (const ComparedSeries& one : series) {
    const double scale = IsOfAJoint(one.scale) || leg_length_m > 0.0 ? ScaleOf(one, series, leg_length_m) : 1.0;
    const double noise = noisy && tolerance > 0.0 ? NoiseBetween(one) : 0.0;
    if (one.scale == SeriesScale::kPosition) of_positions = noise;
    differences.push_back(DifferenceOf(one, shared, std::max(tolerance * scale, kLeastDifference),
                                       one.noise_gain.empty() ? noise : of_positions));
  }
  return differences;
}

}  // namespace gaitwright
