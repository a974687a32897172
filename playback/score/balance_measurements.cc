// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>

#include "playback/score/capture.h"
#include "playback/score/energy_margin.h"
#include "playback/score/measurements.h"

namespace gaitwright {
namespace {

const char* const kNoZmp = "no sample has a coplanar support with enough normal force";
const char* const kNoSupport = "no foot is scheduled to stand";

double Percentile(std::vector<double> values, double share) {
  std::sort(values.begin(), values.end());
  const double rank = share * static_cast<double>(values.size() - 1);
  const std::size_t below = static_cast<std::size_t>(rank);
  const std::size_t above = std::min(below + 1, values.size() - 1);
  return values[below] + (rank - static_cast<double>(below)) * (values[above] - values[below]);
}

struct ZmpMargins {
  Extreme smallest{Extreme::Kind::kSmallest};
  std::optional<double> p05, outside;
};

ZmpMargins MarginsOf(const std::vector<MotionSample>& samples) {
  ZmpMargins margins;
  std::vector<double> values;
  double outside = 0.0;
  for (const MotionSample& sample : samples) {
    if (!sample.has_zmp) continue;
    values.push_back(sample.zmp_margin_m());
    margins.smallest.See(values.back(), sample.time_s);
    outside += values.back() < 0.0 ? 1.0 : 0.0;
  }
  if (values.empty()) return margins;
  margins.outside = outside / static_cast<double>(values.size());
  margins.p05 = Percentile(std::move(values), 0.05);
  return margins;
}

/// Mean, root mean square and largest of a sequence.
class Statistics {
 public:
  void See(double value, double time_s) {
    sum_ += value;
    squares_ += value * value;
    ++count_;
    largest_.See(value, time_s);
  }
  std::optional<double> Mean() const { return Over(sum_); }
  std::optional<double> Rms() const {
    const auto mean = Over(squares_);
    return mean ? std::optional(std::sqrt(*mean)) : std::nullopt;
  }
  const Extreme& largest() const { return largest_; }

 private:
  std::optional<double> Over(double sum) const {
    return count_ == 0 ? std::nullopt : std::optional(sum / static_cast<double>(count_));
  }
  double sum_ = 0.0, squares_ = 0.0;
  int count_ = 0;
  Extreme largest_{Extreme::Kind::kLargest};
};

Measurement Row(const std::string& key, std::optional<double> value, const Extreme& worst, const std::string& missing) {
  return {key, value, {}, value ? worst.at_s : std::nullopt, value ? "" : missing};
}

void AddErrors(const std::string& name, const Statistics& errors, bool with_rms, std::vector<Measurement>& rows) {
  rows.push_back(Row(name + "_mean_m", errors.Mean(), errors.largest(), kNoZmp));
  if (with_rms) rows.push_back(Row(name + "_rms_m", errors.Rms(), errors.largest(), kNoZmp));
  rows.push_back(Row(name + "_max_m", errors.largest().value, errors.largest(), kNoZmp));
}

/// The smallest capture margin over the touch-downs of the schedule.
Extreme CaptureMargins(const ScoreInputs& in, const std::vector<MotionSample>& samples, bool measured) {
  Extreme smallest(Extreme::Kind::kSmallest);
  const double reach = StepReach(in.model, in.options.stretch);
  DynamicsScratch scratch(in.model);
  for (const double touchdown : TouchdownTimes(in.plan.schedule)) {
    const auto at = std::partition_point(samples.begin(), samples.end(),
                                         [&](const MotionSample& s) { return s.time_s < touchdown - 1e-9; });
    if (at == samples.end()) break;
    const std::size_t k = static_cast<std::size_t>(at - samples.begin());
    ForwardKinematics(in.model, measured ? in.log.samples[k].q : in.series.plan[k].q, scratch);
    const auto stages = StagesToNextTouchdown(in.plan, touchdown);
    const auto margin = CaptureMargin(in.model, scratch, in.plan.terrain, stages, *at, reach);
    if (margin) smallest.See(*margin, at->time_s);
  }
  return smallest;
}

Extreme SmallestOf(const std::vector<MotionSample>& samples, double (*margin)(const MotionSample&)) {
  Extreme smallest(Extreme::Kind::kSmallest);
  for (const MotionSample& sample : samples) {
    if (!sample.support.empty()) smallest.See(margin(sample), sample.time_s);
  }
  return smallest;
}

Measurement TrackingRow(const std::string& key, const MotionSeries& series, Vector3 (*point)(const MotionSample&)) {
  Statistics errors;
  for (std::size_t k = 0; k < series.measured.size(); ++k) {
    errors.See((point(series.measured[k]) - point(series.planned[k])).norm(), series.measured[k].time_s);
  }
  return Row(key, errors.Rms(), errors.largest(), "no samples");
}

Measurement JointTrackingRow(const ScoreInputs& in) {
  Statistics errors;
  const Eigen::Index n = in.model.num_dofs();
  for (std::size_t k = 0; k < in.series.plan.size(); ++k) {
    const LogSample& sample = in.log.samples[k];
    for (Eigen::Index i = 0; i < n; ++i) {
      errors.See(std::abs(sample.q[7 + i] - in.series.plan[k].q[7 + i]), sample.time_s);
    }
  }
  return Row("tracking_joint_rms_rad", errors.Rms(), errors.largest(), "the robot has no joints");
}

}  // namespace

std::vector<Measurement> ZmpMeasurements(const ScoreInputs& in) {
  const ZmpMargins measured = MarginsOf(in.series.measured), planned = MarginsOf(in.series.planned);
  std::vector<Measurement> rows;
  rows.push_back(FromExtremes("zmp_margin_min_m", measured.smallest, planned.smallest, kNoZmp));
  rows.push_back({"zmp_margin_p05_m", measured.p05, planned.p05, measured.smallest.at_s, measured.p05 ? "" : kNoZmp});
  rows.push_back(
      {"zmp_outside_fraction", measured.outside, planned.outside, measured.smallest.at_s, measured.p05 ? "" : kNoZmp});
  Statistics errors;
  for (std::size_t k = 0; k < in.series.measured.size(); ++k) {
    const MotionSample &actual = in.series.measured[k], &wanted = in.series.planned[k];
    if (!actual.has_zmp || !wanted.has_zmp) continue;
    errors.See((MotionBetween(wanted.support, actual.support).Back(actual.p_WZ) - wanted.p_WZ).norm(), actual.time_s);
  }
  AddErrors("zmp_error", errors, true, rows);
  return rows;
}

std::vector<Measurement> BalanceMeasurements(const ScoreInputs& in) {
  const auto& [planned, measured, plan] = in.series;
  std::vector<Measurement> rows;
  Statistics errors;
  for (std::size_t k = 0; k < measured.size(); ++k) {
    if (measured[k].support.empty()) continue;
    const SupportMotion motion = MotionBetween(planned[k].support, measured[k].support);
    errors.See((motion.Back(measured[k].dcm_W) - planned[k].dcm_W).norm(), measured[k].time_s);
  }
  AddErrors("dcm_error", errors, false, rows);
  rows.push_back(FromExtremes("dcm_capture_margin_min_m", CaptureMargins(in, measured, true),
                              CaptureMargins(in, planned, false), "no touch-down came"));
  const auto static_margin = [](const MotionSample& s) { return s.static_margin_m(); };
  rows.push_back(FromExtremes("static_margin_min_m", SmallestOf(measured, static_margin),
                              SmallestOf(planned, static_margin), kNoSupport));
  rows.push_back(FromExtremes("energy_margin_min_m", SmallestOf(measured, EnergyMargin),
                              SmallestOf(planned, EnergyMargin), kNoSupport));
  rows.push_back(JointTrackingRow(in));
  const auto base = [](const MotionSample& s) -> Vector3 { return s.X_WB.translation(); };
  const auto com = [](const MotionSample& s) { return s.p_WC; };
  rows.push_back(TrackingRow("tracking_base_rms_m", in.series, base));
  rows.push_back(TrackingRow("tracking_com_rms_m", in.series, com));
  return rows;
}

double ShareWithoutArea(const MotionSeries& series) {
  double standing = 0.0, thin = 0.0;
  for (const MotionSample& sample : series.planned) {
    if (sample.support.empty()) continue;
    standing += 1.0;
    thin += HasArea(sample.support) ? 0.0 : 1.0;
  }
  return standing > 0.0 ? thin / standing : 0.0;
}

}  // namespace gaitwright
