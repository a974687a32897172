// SPDX-License-Identifier: BSD-3-Clause
#include "workflows/exchange/even_motion.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "kinematics/base/result.h"
#include "kinematics/model/dof_units.h"
#include "workflows/exchange/knot_spline.h"
#include "workflows/exchange/median_internal.h"
#include "workflows/exchange/missing_rows.h"

namespace gaitwright {
namespace {

constexpr double kUsualStep = 0.005;  // [s]
constexpr double kOnGrid = 1e-3;      // share of a step: times nearer to a row of the grid are on the grid

/// The quintic over unit time with given value, rate and acceleration at both ends, in that unit of time.
Motion1 Quintic(const Motion1& a, const Motion1& b, double u) {
  const double rise = b.value - a.value - a.rate - 0.5 * a.acceleration;
  const double turn = b.rate - a.rate - a.acceleration, bend = b.acceleration - a.acceleration;
  const double c3 = 10.0 * rise - 4.0 * turn + 0.5 * bend, c4 = -15.0 * rise + 7.0 * turn - bend,
               c5 = 6.0 * rise - 3.0 * turn + 0.5 * bend;
  return {a.value + u * (a.rate + u * (0.5 * a.acceleration + u * (c3 + u * (c4 + u * c5)))),
          a.rate + u * (a.acceleration + u * (3.0 * c3 + u * (4.0 * c4 + u * 5.0 * c5))),
          a.acceleration + u * (6.0 * c3 + u * (12.0 * c4 + u * 20.0 * c5))};
}

class Resampler {
 public:
  Resampler(const RobotModel& model, const MotionTable& table, const ImportOptions& options,
            std::vector<DerivedPart>& derived, std::vector<std::string>& warnings)
      : model_(model), table_(table), options_(options), derived_(derived), warnings_(warnings) {}

  EvenMotion Run() {
    for (const double t : table_.time_s) time_s_.push_back(t - table_.time_s.front());
    even_.step_s = GridStepOf(table_.time_s, options_);
    const int rows = RowsOfGrid();
    for (int k = 0; k < rows; ++k) {
      even_.q.push_back(VectorX::Zero(model_.nq()));
      even_.v.push_back(VectorX::Zero(model_.nv()));
      even_.a.push_back(VectorX::Zero(model_.nv()));
    }
    ReportGrid();
    ReportTimesOfRows();
    MoveBase();
    TurnBase();
    for (int d = 0; d < model_.num_dofs(); ++d) MoveJoint(d);
    TakeRates();
    ReportRates();
    TakeLoads();
    return std::move(even_);
  }

 private:
  double TimeOf(int row) const { return std::min(row * even_.step_s, time_s_.back()); }

  int RowsOfGrid() const {
    const double rows = 1.0 + std::floor(time_s_.back() / even_.step_s + kOnGrid);
    if (rows <= kMostGridRows) return static_cast<int>(rows);
    throw InvalidArgument(
        fmt::format("its {:.6g} s at steps of {} s would need {:.0f} rows; at most {} are accepted; raise grid_step_s",
                    time_s_.back(), even_.step_s, rows, kMostGridRows));
  }

  void ReportGrid() {
    if (table_.time_s.front() != 0.0)
      derived_.push_back({"time", fmt::format("time 0 is the file's {:.6g} s", table_.time_s.front())});
    if (!on_grid()) {
      derived_.push_back({"rows", fmt::format("{} rows every {:.3g} ms, interpolated smoothly from the file's {}",
                                              even_.size(), 1e3 * even_.step_s, table_.rows())});
    } else if (even_.size() < table_.rows()) {
      derived_.push_back(
          {"end",
           fmt::format("the last {:.3g} ms are left out, because this step is shorter than the others of {:.3g} ms",
                       1e3 * (time_s_.back() - even_.TimeOf(even_.size() - 1)), 1e3 * even_.step_s)});
    }
  }

  /// Notes on times; points of a joint trajectory may be far apart, because a controller interpolates between them.
  void ReportTimesOfRows() {
    if (HasWaypoints(table_.format) || time_s_.size() < 3) return;
    std::vector<double> steps;
    for (std::size_t i = 1; i < time_s_.size(); ++i) steps.push_back(time_s_[i] - time_s_[i - 1]);
    const double usual = MedianOf(steps);
    if (const std::string missing = MissingRowsText(table_.time_s); !missing.empty())
      warnings_.push_back(missing + "; the motion in the gap is interpolated, not measured");
    ReportUneven(steps, usual);
  }

  /// Warns of rows that are far apart, or whose times are probably times of arrival of messages.
  void ReportUneven(const std::vector<double>& steps, double usual) {
    constexpr double kFew = 0.04, kUneven = 0.05;  // [s], of the usual step
    if (usual > kFew) {
      warnings_.push_back(
          fmt::format("rows are {:.3g} ms apart; the motion between them is interpolated, not measured", 1e3 * usual));
    }
    std::vector<double> off;
    for (const double step : steps) off.push_back(std::abs(step - usual));
    if (const double uneven = MedianOf(std::move(off)); uneven > kUneven * usual) {
      warnings_.push_back(fmt::format(
          "rows are uneven, {:.3g} ms apart in the median, with a median deviation of {:.2g} ms: if these are times of "
          "arrival rather than of measurement, speeds and accelerations are noisy; use even times or smoothing_hz",
          1e3 * usual, 1e3 * uneven));
    }
  }

  /// Whether the rows of the grid are those of the file, which may have one more row at the end.
  bool on_grid() const {
    if (even_.size() != table_.rows() && even_.size() + 1 != table_.rows()) return false;
    for (int k = 0; k < even_.size(); ++k) {
      if (std::abs(time_s_[static_cast<std::size_t>(k)] - k * even_.step_s) > kOnGrid * even_.step_s) return false;
    }
    return true;
  }

  template <class Part>
  std::vector<double> ColumnOf(const Part& part) const {
    std::vector<double> values;
    for (int row = 0; row < table_.rows(); ++row) values.push_back(part(static_cast<std::size_t>(row)));
    return values;
  }

  KnotSpline SplineOf(std::vector<double> values) const {
    if (options_.smoothing_hz > 0.0) values = Smoothed(time_s_, values, options_.smoothing_hz);
    return KnotSpline(time_s_, std::move(values));
  }

  /// Warns if the noise of a column degrades accelerations.
  void Watch(const std::string& what, const std::vector<double>& values, double most, const std::string& unit) {
    if (options_.smoothing_hz > 0.0 || time_s_.size() < 9) return;
    const double step = time_s_.back() / static_cast<double>(time_s_.size() - 1);
    const double rough = std::sqrt(6.0) * NoiseOf(values) / (step * step);
    if (rough <= most || rough <= roughest_) return;
    roughest_ = rough;
    roughest_text_ = fmt::format(
        "{} is noisy: its accelerations have a noise of {:.3g} {}; set smoothing_hz to three times the fastest step "
        "frequency",
        what, rough, unit);
  }

  void MoveBase() {
    constexpr double kMost = 1.0;  // [m/s^2]
    for (int i = 0; i < 3; ++i) {
      const auto values = ColumnOf([&](std::size_t row) { return table_.base_m[row][i]; });
      Watch("the base's position", values, kMost, "m/s^2");
      const KnotSpline spline = SplineOf(values);
      for (int k = 0; k < even_.size(); ++k) {
        const Motion1 at = spline.At(TimeOf(k));
        Set(k, i, i, at);
      }
    }
    for (VectorX& q : even_.q) q[2] += options_.lift_m;
  }

  void Set(int k, int i_q, int i_v, const Motion1& at) {
    const auto row = static_cast<std::size_t>(k);
    even_.q[row][i_q] = at.value;
    even_.v[row][i_v] = at.rate;
    even_.a[row][i_v] = at.acceleration;
  }

  /// Angular velocity and acceleration of a quaternion Q interpolated by splines, whose length is not exactly 1: the
  /// vector parts of w = 2 (Q' Q^-1) and alpha = 2 (Q'' Q^-1 - (Q' Q^-1)^2).
  void TurnBase() {
    std::vector<Eigen::Vector4d> turns = table_.quaternion;
    for (std::size_t i = 0; i < turns.size(); ++i) {
      turns[i].normalize();
      if (i > 0 && turns[i].dot(turns[i - 1]) < 0.0) turns[i] = -turns[i];
    }
    std::vector<KnotSpline> parts;
    for (int i = 0; i < 4; ++i) parts.push_back(SplineOf(ColumnOf([&](std::size_t row) { return turns[row][i]; })));
    for (int k = 0; k < even_.size(); ++k) {
      Eigen::Vector4d value, rate, bend;
      for (int i = 0; i < 4; ++i) {
        const Motion1 at = parts[static_cast<std::size_t>(i)].At(TimeOf(k));
        value[i] = at.value;
        rate[i] = at.rate;
        bend[i] = at.acceleration;
      }
      const auto as = [](const Eigen::Vector4d& c) { return Quaternion(c[3], c[0], c[1], c[2]); };
      const Quaternion inverse = as(value).inverse(), spin = as(rate) * inverse, square = spin * spin;
      const auto row = static_cast<std::size_t>(k);
      even_.q[row].segment<4>(3) = value.normalized();
      even_.v[row].segment<3>(3) = 2.0 * spin.vec();
      even_.a[row].segment<3>(3) = 2.0 * ((as(bend) * inverse).vec() - square.vec());
    }
  }

  bool HasRates(int dof) const {
    return !table_.v.empty() && options_.velocities == "given" && std::isfinite(table_.v.front()[dof]);
  }

  void MoveJoint(int dof) {
    constexpr double kMost = 50.0;  // [rad/s^2], [m/s^2]
    const auto values = ColumnOf([&](std::size_t row) { return table_.q[row][dof]; });
    if (!HasRates(dof)) {
      const std::string& name = model_.dof_names[static_cast<std::size_t>(dof)];
      Watch("joint '" + name + "'", values, kMost, std::string(SpeedUnit(model_, dof)) + "^2");
      const KnotSpline spline = SplineOf(values);
      for (int k = 0; k < even_.size(); ++k) Set(k, 7 + dof, 6 + dof, spline.At(TimeOf(k)));
      return;
    }
    const auto rates = ColumnOf([&](std::size_t row) { return table_.v[row][dof]; });
    NoteDisagreement(dof, values, rates);
    const KnotSpline rate = SplineOf(rates);
    const std::vector<double> smooth =
        options_.smoothing_hz > 0.0 ? Smoothed(time_s_, values, options_.smoothing_hz) : values;
    std::size_t i = 0;
    for (int k = 0; k < even_.size(); ++k) {
      const double t = TimeOf(k);
      while (i + 2 < time_s_.size() && time_s_[i + 1] <= t) ++i;
      const double h = time_s_[i + 1] - time_s_[i];
      const auto knot = [&](std::size_t at) {
        const Motion1 motion = rate.At(time_s_[at]);
        return Motion1{smooth[at], h * motion.value, h * h * motion.rate};
      };
      const Motion1 at = Quintic(knot(i), knot(i + 1), (t - time_s_[i]) / h);
      Set(k, 7 + dof, 6 + dof, {at.value, at.rate / h, at.acceleration / (h * h)});
    }
  }

  /// Warns if the velocities of the file differ from the derivatives of its positions.
  void NoteDisagreement(int dof, const std::vector<double>& values, const std::vector<double>& rates) {
    constexpr double kShare = 0.2, kSlight = 0.05;
    const KnotSpline spline(time_s_, values);
    double fastest = 0.0, apart = 0.0;
    std::size_t row = 0;
    for (std::size_t i = 0; i < rates.size(); ++i) {
      const double rate = spline.At(time_s_[i]).rate;
      fastest = std::max(fastest, std::abs(rate));
      if (std::abs(rate - rates[i]) <= apart) continue;
      apart = std::abs(rate - rates[i]);
      row = i;
    }
    if (apart <= kSlight + kShare * fastest || apart <= farthest_) return;
    farthest_ = apart;
    farthest_text_ = fmt::format(
        "the velocities of joint '{0}' differ from the derivatives of its positions by up to {1:.3g} {4}, at {2:.6g} "
        "s; its largest speed is {3:.3g} {4}; velocities=derived uses the positions",
        model_.dof_names[static_cast<std::size_t>(dof)], apart, table_.time_s[row], fastest, SpeedUnit(model_, dof));
  }

  /// Takes base rates and accelerations from the file if its rows are on the grid and the motion agrees with them.
  /// Curves through positions and speeds would smooth the jumps of accelerations at touch-down and lift-off.
  void TakeRates() {
    if (options_.velocities != "given" || options_.smoothing_hz > 0.0 || !on_grid()) return;
    const bool linear = TakeRate("velocity of the base", table_.base_rate, even_.v, {0, 1, 2}, 0);
    const bool angular = TakeRate("angular velocity of the base", table_.base_rate, even_.v, {3, 4, 5}, 0);
    rates_of_base_ = linear && angular;
    accelerations_ = linear && TakeRate("acceleration of the base", table_.base_acceleration, even_.a, {0, 1, 2}, 0);
    accelerations_ &=
        angular && TakeRate("angular acceleration of the base", table_.base_acceleration, even_.a, {3, 4, 5}, 0);
    for (int d = 0; d < model_.num_dofs(); ++d) {
      const std::string& name = model_.dof_names[static_cast<std::size_t>(d)];
      accelerations_ &= HasRates(d) && TakeRate("acceleration of joint '" + name + "'", table_.a, even_.a, {d}, 6);
    }
  }

  /// @param worked_out  values computed from curves, which are replaced by the file's. @return whether they were
  ///                    replaced.
  template <class Row>
  bool TakeRate(const std::string& what, const std::vector<Row>& given, std::vector<VectorX>& worked_out,
                const std::vector<int>& columns, int behind) {
    constexpr double kAgrees = 0.5, kSlight = 0.1;  // share of the root mean square; in the unit of the rate
    if (given.empty()) return false;
    double apart = 0.0, size = 0.0;
    for (std::size_t k = 0; k < worked_out.size(); ++k) {
      for (const int i : columns) {
        if (!std::isfinite(given[k][i])) return false;
        const double curve = worked_out[k][behind + i];
        apart += std::pow(given[k][i] - curve, 2), size += std::pow(curve, 2);
      }
    }
    const double rows = static_cast<double>(worked_out.size());
    if (std::sqrt(apart / rows) > kSlight + kAgrees * std::sqrt(size / rows)) {
      not_of_motion_.push_back(what);
      return false;
    }
    for (std::size_t k = 0; k < worked_out.size(); ++k) {
      for (const int i : columns) worked_out[k][behind + i] = given[k][i];
    }
    return true;
  }

  void ReportRates() {
    if (!roughest_text_.empty()) warnings_.push_back(roughest_text_);
    if (!farthest_text_.empty()) warnings_.push_back(farthest_text_);
    const std::string smoothly =
        options_.smoothing_hz > 0.0 ? fmt::format(", smoothed above {:.4g} Hz", options_.smoothing_hz) : "";
    int given = 0;
    for (int d = 0; d < model_.num_dofs(); ++d) given += HasRates(d) ? 1 : 0;
    if (given < model_.num_dofs()) {
      derived_.push_back(
          {given == 0 ? "joint velocities" : fmt::format("{} of the joint velocities", model_.num_dofs() - given),
           "cubic splines through the positions" + smoothly});
    }
    if (!rates_of_base_)
      derived_.push_back({"velocities of the base", "cubic splines through its positions and quaternions" + smoothly});
    if (!accelerations_) {
      derived_.push_back({"accelerations", given == 0 ? "second derivatives of the splines of the positions"
                                                      : "splines through positions and velocities"});
    }
    if (not_of_motion_.empty()) return;
    warnings_.push_back(
        fmt::format("the {}{} in the file {} inconsistent with the positions, and {} ignored", not_of_motion_.front(),
                    not_of_motion_.size() == 1 ? "" : fmt::format(" and {} more rates", not_of_motion_.size() - 1),
                    not_of_motion_.size() == 1 ? "is" : "are", not_of_motion_.size() == 1 ? "is" : "are"));
  }

  void TakeLoads() {
    std::size_t i = 0;
    for (int k = 0; k < even_.size(); ++k) {
      const double t = TimeOf(k), slack = kOnGrid * even_.step_s;
      while (i + 2 < time_s_.size() && time_s_[i + 1] <= t) ++i;
      const double u = (t - time_s_[i]) / (time_s_[i + 1] - time_s_[i]);
      if (!table_.tau.empty()) even_.tau.push_back((1.0 - u) * table_.tau[i] + u * table_.tau[i + 1]);
      // Contacts of a row of the grid are those of the file's row at or before it.
      if (!table_.contact.empty()) even_.contact.push_back(table_.contact[time_s_[i + 1] <= t + slack ? i + 1 : i]);
      if (table_.force_W.empty()) continue;
      std::vector<Vector3> forces;
      for (std::size_t f = 0; f < model_.feet.size(); ++f)
        forces.emplace_back((1.0 - u) * table_.force_W[i][f] + u * table_.force_W[i + 1][f]);
      even_.force_W.push_back(std::move(forces));
    }
  }

  const RobotModel& model_;
  const MotionTable& table_;
  const ImportOptions& options_;
  std::vector<DerivedPart>& derived_;
  std::vector<std::string>& warnings_;
  std::vector<double> time_s_;
  bool rates_of_base_ = false, accelerations_ = false;  ///< true if all were taken from the file
  std::vector<std::string> not_of_motion_;
  double roughest_ = 0.0, farthest_ = 0.0;
  std::string roughest_text_, farthest_text_;
  EvenMotion even_;
};

/// Whether the last step is shorter than the one before, for example because a writer of uniform rows added the end of
/// the motion.
bool EndsShort(const std::vector<double>& time_s) {
  const std::size_t n = time_s.size();
  return n > 3 && time_s[n - 1] - time_s[n - 2] < (1.0 - kOnGrid) * (time_s[n - 2] - time_s[n - 3]);
}

}  // namespace

double GridStepOf(const std::vector<double>& time_s, const ImportOptions& options) {
  constexpr double kFinest = 0.001, kCoarsest = 0.01, kRounding = 1e-9;  // [s]
  if (options.grid_step_s > 0.0) return options.grid_step_s;
  if (time_s.size() < 2) return kUsualStep;
  const std::size_t last = time_s.size() - 1 - (EndsShort(time_s) ? 1 : 0);
  const double step = (time_s[last] - time_s.front()) / static_cast<double>(last);
  if (step < kFinest * (1.0 - kOnGrid) || step > kCoarsest + kRounding) return kUsualStep;
  for (std::size_t i = 0; i <= last; ++i) {
    if (std::abs(time_s[i] - time_s.front() - static_cast<double>(i) * step) > kOnGrid * step) return kUsualStep;
  }
  // A step that is round except for rounding of the times' last digits is made round.
  const double round = 1e-6 * std::round(1e6 * step);
  return std::min(kCoarsest, std::abs(round - step) * static_cast<double>(last + 1) < kOnGrid * step ? round : step);
}

EvenMotion Resample(const RobotModel& model, const MotionTable& table, const ImportOptions& options,
                    std::vector<DerivedPart>& derived, std::vector<std::string>& warnings) {
  CheckImportOptions(options);
  return Resampler(model, table, options, derived, warnings).Run();
}

}  // namespace gaitwright
