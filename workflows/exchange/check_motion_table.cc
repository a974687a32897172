// SPDX-License-Identifier: BSD-3-Clause
#include "workflows/exchange/check_motion_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "kinematics/dynamics/dynamics.h"
#include "kinematics/dynamics/foot_contact.h"

namespace gaitwright {
namespace {

double MedianOf(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

void CheckTimes(const MotionTable& table, const ImportOptions& options) {
  constexpr double kLongest = 3600.0, kCoarse = 0.5, kLatest = 1e10;  // [s]; a clock's seconds since 1970 are 2e9
  const bool waypoints = table.format == "joint-trajectory";
  const int least = waypoints ? 2 : 5;
  if (table.rows() < least)
    throw InvalidArgument(fmt::format("has {} rows; {} or more make a motion", table.rows(), least));
  const double duration = table.time_s.back() - table.time_s.front();
  const double step = duration / (table.rows() - 1);
  if (!waypoints && step >= kCoarse && options.time_unit == "s") {
    throw InvalidArgument(fmt::format(
        "its rows are {:.6g} s apart, which is too far for a motion: times are likely in milliseconds; --time-unit ms "
        "takes them so",
        step));
  }
  if (!(duration <= kLongest))
    throw InvalidArgument(fmt::format("lasts {:.6g} s; at most {:.0f} s are taken", duration, kLongest));
  if (std::abs(table.time_s.front()) > kLatest) {
    throw InvalidArgument(
        fmt::format("begins at {:.6g} s; a start within {:.0e} s is taken", table.time_s.front(), kLatest));
  }
}

/// What no robot's motion has, in whatever unit: sums over it would lose the rest, or would not be finite.
void CheckSizes(const MotionTable& table) {
  constexpr double kMost = 1e8;
  const auto check = [&](const char* what, std::size_t row, const auto& values) {
    for (const double value : values) {
      if (!(std::abs(value) > kMost)) continue;  // what a file lacks is not a number
      throw InvalidArgument(
          fmt::format("{} of row {} ({:.6g} s) is {:.6g}; at most {:.0e} up or down is taken for a motion", what,
                      row + 1, table.time_s[row], value, kMost));
    }
  };
  for (std::size_t row = 0; row < table.time_s.size(); ++row) {
    if (!table.base_m.empty()) check("the base's position", row, table.base_m[row]);
    if (!table.q.empty()) check("a joint's position", row, table.q[row]);
    if (!table.v.empty()) check("a joint's speed", row, table.v[row]);
    if (!table.tau.empty()) check("a joint's torque", row, table.tau[row]);
    if (table.force_W.empty()) continue;
    for (const Vector3& force : table.force_W[row]) check("a foot's force", row, force);
  }
}

/// Joints past their limits by far that are within them as degrees.
void CheckAngles(const RobotModel& model, const MotionTable& table, const ImportOptions& options) {
  constexpr double kFar = 0.5, kNear = 0.1, kDegree = std::numbers::pi / 180.0;  // [rad]
  if (options.angle_unit != "rad") return;
  int farthest = -1, farthest_row = 0;
  double most = kFar;
  for (int d = 0; d < model.num_dofs(); ++d) {
    if (model.LeaderOf(d).is_prismatic()) continue;
    const double lower = model.dof_lower(d), upper = model.dof_upper(d);
    for (int row = 0; row < table.rows(); ++row) {
      const double q = table.q[static_cast<std::size_t>(row)][d];
      if (q * kDegree < lower - kNear || q * kDegree > upper + kNear) return;
      const double past = std::max(lower - q, q - upper);
      if (past > most) most = past, farthest = d, farthest_row = row;
    }
  }
  if (farthest < 0) return;
  throw InvalidArgument(fmt::format(
      "joint '{}' is at {:.4g} rad in row {}, its limits are {:.4g} and {:.4g} rad, and all joints would be within "
      "theirs as degrees: --angle-unit deg takes them so",
      model.dof_names[static_cast<std::size_t>(farthest)], table.q[static_cast<std::size_t>(farthest_row)][farthest],
      farthest_row + 1, model.dof_lower(farthest), model.dof_upper(farthest)));
}

void CheckLengths(const RobotModel& model, const MotionTable& table, const ImportOptions& options) {
  constexpr double kTall = 10.0, kLow = 0.2, kHigh = 3.0;  // of the standing height
  if (table.base_m.empty() || options.length_unit != "m") return;
  std::vector<double> heights;
  for (const Vector3& p : table.base_m) heights.push_back(p.z());
  const double height = MedianOf(std::move(heights)), standing = model.standing_base_height_m;
  if (height < kTall * standing || 1e-3 * height < kLow * standing || 1e-3 * height > kHigh * standing) return;
  throw InvalidArgument(fmt::format(
      "the base is {:.6g} m high, robot '{}' stands with it at {:.3f} m: lengths are likely in millimetres; "
      "--length-unit mm takes them so",
      height, model.name, standing));
}

/// How a motion looks with its quaternions in one order.
struct Look {
  double tilt_rad = 0.0;   ///< of the robot's up axis, median
  double height_m = 0.0;   ///< of the lowest foot over the ground, median; 0 where the base's place is not known
  double slide_m_s = 0.0;  ///< of the lowest foot, mean
  bool plausible = false;
};

class Looker {
 public:
  Looker(const RobotModel& model, const Terrain& terrain, const MotionTable& table)
      : model_(model), terrain_(terrain), table_(table), scratch_(model) {
    up_B_ = BaseRotation(StandingConfiguration(model)).transpose().col(2);
  }

  Look At(bool w_first) {
    constexpr double kUpright = 1.0, kNear = 0.25;  // [rad], of the leg
    constexpr int kLooks = 300;
    const int every = std::max(1, table_.rows() / kLooks);
    std::vector<double> tilts, heights;
    double slid_m = 0.0, time_s = 0.0;
    for (int row = 0; row + 1 < table_.rows(); row += every) {
      Place(row, w_first);
      tilts.push_back(std::acos(std::clamp((R_WB_ * up_B_).z(), -1.0, 1.0)));
      if (table_.base_m.empty()) continue;
      const std::vector<Vector3> before = Feet();
      std::size_t lowest = 0;
      for (std::size_t f = 1; f < before.size(); ++f) lowest = Height(before[f]) < Height(before[lowest]) ? f : lowest;
      heights.push_back(Height(before[lowest]));
      Place(row + 1, w_first);
      slid_m += (Feet()[lowest] - before[lowest]).head<2>().norm();
      const auto k = static_cast<std::size_t>(row);
      time_s += table_.time_s[k + 1] - table_.time_s[k];
    }
    Look look;
    look.tilt_rad = MedianOf(std::move(tilts));
    if (!heights.empty()) {
      look.height_m = MedianOf(std::move(heights));
      look.slide_m_s = slid_m / time_s;
    }
    look.plausible = look.tilt_rad < kUpright && std::abs(look.height_m) < kNear * model_.leg_length_m();
    return look;
  }

 private:
  void Place(int row, bool w_first) {
    const auto k = static_cast<std::size_t>(row);
    const Eigen::Vector4d& c = table_.quaternion[k];
    VectorX q(model_.nq());
    q << (table_.base_m.empty() ? Vector3(Vector3::Zero()) : table_.base_m[k]), c, table_.q[k];
    if (w_first) q.segment<4>(3) << c[1], c[2], c[3], c[0];
    R_WB_ = BaseRotation(q);
    ForwardKinematics(model_, q, scratch_);
  }
  double Height(const Vector3& p_W) const { return p_W.z() - GroundAt(terrain_, p_W.head<2>()).height_m; }
  /// The lowest contact point of each foot.
  std::vector<Vector3> Feet() const {
    std::vector<Vector3> feet;
    for (int f = 0; f < static_cast<int>(model_.feet.size()); ++f) {
      const std::vector<Vector3> points = ContactPoints(model_, scratch_, f);
      feet.push_back(*std::min_element(points.begin(), points.end(),
                                       [](const Vector3& a, const Vector3& b) { return a.z() < b.z(); }));
    }
    return feet;
  }

  const RobotModel& model_;
  const Terrain& terrain_;
  const MotionTable& table_;
  DynamicsScratch scratch_;
  Vector3 up_B_;
  Matrix3 R_WB_;
};

std::string Said(const Look& look) {
  return fmt::format("leaning by {:.2f} rad, its lowest foot {:.3f} m over the ground and sliding at {:.3f} m/s",
                     look.tilt_rad, look.height_m, look.slide_m_s);
}

void CheckQuaternions(const RobotModel& model, const Terrain& terrain, const ImportOptions& options,
                      MotionTable& table) {
  constexpr double kUnit = 0.01, kClearly = 3.0, kSlightly = 1.2, kStill = 0.02;  // [1], [1], [1], [m/s]
  if (table.quaternion.empty()) return;
  for (std::size_t k = 0; k < table.quaternion.size(); ++k) {
    const double norm = table.quaternion[k].norm();
    if (!(std::abs(norm - 1.0) <= kUnit)) {
      throw InvalidArgument(
          fmt::format("the quaternion of row {} ({:.6g} s) has length {:.4g}; a rotation's is 1, to {} at the most",
                      k + 1, table.time_s[k], norm, kUnit));
    }
  }
  if (options.quaternion_order == "detect") {
    Looker looker(model, terrain, table);
    const Look named = looker.At(false), other = looker.At(true);
    const std::string both = fmt::format(
        "with x, y, z, w as they are named the robot is {}; with the four as w, x, y, z {}", Said(named), Said(other));
    const bool better = other.plausible && (!named.plausible || named.slide_m_s > kClearly * other.slide_m_s + kStill);
    if (better) {
      throw InvalidArgument("the base's quaternion likely has w first: " + both +
                            ". --quaternion-order wxyz takes it so, --quaternion-order xyzw as it is named");
    }
    if (!named.plausible) {
      throw InvalidArgument("the robot stands upright on the ground in no order of the base's quaternion: " + both +
                            ". --quaternion-order xyzw takes it as it is named");
    }
    if (other.plausible && named.slide_m_s > kSlightly * other.slide_m_s + kStill) {
      throw InvalidArgument("the base's quaternion may have w first or last: " + both +
                            ". Say which: --quaternion-order xyzw or wxyz");
    }
  }
  if (options.quaternion_order != "wxyz") return;
  for (Eigen::Vector4d& c : table.quaternion) c = Eigen::Vector4d(c[1], c[2], c[3], c[0]);
}

}  // namespace

void CheckMotionTable(const RobotModel& model, const Terrain& terrain, const ImportOptions& options,
                      MotionTable& table) {
  CheckTimes(table, options);
  CheckSizes(table);
  CheckAngles(model, table, options);
  CheckLengths(model, table, options);
  CheckQuaternions(model, terrain, options, table);
}

}  // namespace gaitwright
