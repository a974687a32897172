// SPDX-License-Identifier: BSD-3-Clause
#include "workflows/exchange/check_motion_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "kinematics/base/result.h"
#include "kinematics/model/likely_degrees.h"
#include "workflows/exchange/median_internal.h"
#include "workflows/exchange/quaternion_order.h"

namespace gaitwright {
namespace {

/// The time unit in which this step between rows is nearest to 5 ms.
const char* LikelyTimeUnit(double step) {
  constexpr double kUsual = 0.005;  // [s]
  const std::array<std::pair<const char*, double>, 3> units = {{{"ms", 1e-3}, {"us", 1e-6}, {"ns", 1e-9}}};
  const auto off = [&](const auto& unit) { return std::abs(std::log(step * unit.second / kUsual)); };
  return std::min_element(units.begin(), units.end(), [&](const auto& a, const auto& b) { return off(a) < off(b); })
      ->first;
}

void CheckTimes(const MotionTable& table, const ImportOptions& options) {
  constexpr double kCoarse = 0.5;  // [s]
  const bool waypoints = HasWaypoints(table.format), detect = options.time_unit == "detect";
  const int least = waypoints ? 2 : 5;
  if (table.rows() < least)
    throw InvalidArgument(fmt::format("has {} rows; a motion needs {} or more", table.rows(), least));
  const double duration = table.time_s.back() - table.time_s.front();
  const double step = duration / (table.rows() - 1);
  if (!waypoints && step >= kCoarse && detect) {
    throw InvalidArgument(
        fmt::format("its rows are {:.6g} s apart, which is unusual: times are probably in another unit; use "
                    "--time-unit {} for that unit, or --time-unit s for seconds",
                    step, LikelyTimeUnit(step)));
  }
  if (!(duration <= kLongestMotion)) {
    throw InvalidArgument(fmt::format("lasts {:.6g} s; at most {:.0f} s are accepted{}", duration, kLongestMotion,
                                      detect ? "; if times are in ms, us or ns, use --time-unit" : ""));
  }
  if (!(std::abs(table.time_s.front()) <= kLatestStart)) {
    throw InvalidArgument(
        fmt::format("begins at {:.6g} s; accepted: within {:.0e} s of 0", table.time_s.front(), kLatestStart));
  }
}

/// Refuses values that no robot has in any unit, because sums with them would lose the other values or overflow.
void CheckSizes(const MotionTable& table) {
  constexpr double kMost = 1e8;
  const auto check = [&](const char* what, std::size_t row, const auto& values) {
    for (const double value : values) {
      if (!(std::abs(value) > kMost)) continue;  // missing values are NaN
      throw InvalidArgument(fmt::format("{} of row {} ({:.6g} s) is {:.6g}; at most +-{:.0e} is accepted", what,
                                        row + 1, table.time_s[row], value, kMost));
    }
  };
  for (std::size_t row = 0; row < table.time_s.size(); ++row) {
    if (!table.base_m.empty()) check("the base's position", row, table.base_m[row]);
    if (!table.q.empty()) check("a joint's position", row, table.q[row]);
    if (!table.v.empty()) check("a joint's speed", row, table.v[row]);
    if (!table.a.empty()) check("a joint's acceleration", row, table.a[row]);
    if (!table.base_rate.empty()) check("the base's speed", row, table.base_rate[row]);
    if (!table.base_acceleration.empty()) check("the base's acceleration", row, table.base_acceleration[row]);
    if (!table.tau.empty()) check("a joint's torque", row, table.tau[row]);
    if (table.force_W.empty()) continue;
    for (const Vector3& force : table.force_W[row]) check("a foot's force", row, force);
  }
}

void CheckAngles(const RobotModel& model, const MotionTable& table, const ImportOptions& options) {
  if (options.angle_unit != "detect") return;
  const std::optional<PastLimit> past = LikelyDegrees(model, table.q);
  if (!past) return;
  throw InvalidArgument(fmt::format(
      "joint '{}' is at {:.4g} rad in row {}, outside its limits of {:.4g} and {:.4g} rad, but as degrees all joints "
      "would be within their limits: use --angle-unit deg for degrees, or --angle-unit rad for radians",
      model.dof_names[static_cast<std::size_t>(past->dof)], table.q[static_cast<std::size_t>(past->row)][past->dof],
      past->row + 1, model.dof_lower(past->dof), model.dof_upper(past->dof)));
}

void CheckLengths(const RobotModel& model, const MotionTable& table, const ImportOptions& options) {
  constexpr double kTall = 10.0, kLow = 0.2, kHigh = 3.0;  // multiples of the standing height
  if (table.base_m.empty() || options.length_unit != "detect") return;
  std::vector<double> heights;
  for (const Vector3& p : table.base_m) heights.push_back(p.z());
  const double height = MedianOf(std::move(heights)), standing = model.standing_base_height_m;
  if (height < kTall * standing || 1e-3 * height < kLow * standing || 1e-3 * height > kHigh * standing) return;
  throw InvalidArgument(
      fmt::format("the base is {:.6g} m high, but robot '{}' stands with it at {:.3f} m: lengths are probably in "
                  "millimetres; use --length-unit mm for millimetres, or --length-unit m for metres",
                  height, model.name, standing));
}

void CheckNorms(const MotionTable& table) {
  constexpr double kUnit = 0.01;
  for (std::size_t k = 0; k < table.quaternion.size(); ++k) {
    const double norm = table.quaternion[k].norm();
    if (std::abs(norm - 1.0) <= kUnit) continue;
    throw InvalidArgument(fmt::format("the quaternion of row {} ({:.6g} s) has length {:.4g}; it must be 1 within {}",
                                      k + 1, table.time_s[k], norm, kUnit));
  }
}

/// A text that names the joints beyond their limits in most rows; empty if there are none.
std::string JointsPastLimits(const RobotModel& model, const MotionTable& table) {
  constexpr double kPast = 0.01;  // [rad], [m]
  std::vector<std::string> past;
  for (int d = 0; d < model.num_dofs(); ++d) {
    const auto rows = std::count_if(table.q.begin(), table.q.end(), [&](const VectorX& q) {
      return q[d] < model.dof_lower(d) - kPast || q[d] > model.dof_upper(d) + kPast;
    });
    if (2 * rows > table.rows()) past.push_back(model.dof_names[static_cast<std::size_t>(d)]);
  }
  if (past.empty()) return "";
  const bool one = past.size() == 1;
  return fmt::format(
      "joint '{}'{} past {} limits in most rows: check signs, zero offsets and units; a --columns file can change "
      "signs ('scale'). Result: ",
      past[0], one ? " is" : fmt::format(" and {} more are", past.size() - 1), one ? "its" : "their");
}

void Check(const RobotModel& model, const Terrain* ground, const ImportOptions& options, const MotionTable& table) {
  CheckTimes(table, options);
  CheckSizes(table);
  CheckAngles(model, table, options);
  CheckLengths(model, table, options);
  CheckNorms(table);
  const bool asked = options.quaternion_order == "detect" && !table.quaternion.empty() && !table.turned_by_angles;
  if (asked) BlameJoints(model, table, [&] { CheckQuaternionOrder(model, ground, options.lift_m, table); });
}

}  // namespace

void CheckMotionTable(const RobotModel& model, const Terrain& terrain, const ImportOptions& options,
                      const MotionTable& table) {
  Check(model, &terrain, options, table);
}

void CheckComparedTable(const RobotModel& model, const ImportOptions& options, const MotionTable& table) {
  Check(model, nullptr, options, table);
}

void BlameJoints(const RobotModel& model, const MotionTable& table, const std::function<void()>& work) {
  try {
    work();
  } catch (const InvalidArgument& error) {
    throw InvalidArgument(JointsPastLimits(model, table) + error.what());
  }
}

}  // namespace gaitwright
