// SPDX-License-Identifier: BSD-3-Clause
#include "workflows/exchange/quaternion_order.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "kinematics/base/result.h"
#include "kinematics/dynamics/dynamics.h"
#include "kinematics/dynamics/foot_contact.h"
#include "workflows/exchange/median_internal.h"

namespace gaitwright {
namespace {

/// Properties of a motion with its quaternions in one order.
struct Look {
  double tilt_rad = 0.0;   ///< tilt of the robot's up axis, median
  bool placed = false;     ///< the base position is known; otherwise the following are not set
  double height_m = 0.0;   ///< height of the lowest foot above the ground, median; 0 without ground
  double slide_m_s = 0.0;  ///< speed of the lowest foot, mean
};

class Looker {
 public:
  Looker(const RobotModel& model, const Terrain* ground, double lift_m, const MotionTable& table)
      : model_(model), ground_(ground), lift_m_(lift_m), table_(table), scratch_(model) {
    up_B_ = BaseRotation(StandingConfiguration(model)).transpose().col(2);
  }

  Look At(bool w_first) {
    constexpr int kLooks = 300;
    const int every = std::max(1, table_.rows() / kLooks);
    std::vector<double> tilts, heights;
    double slid_m = 0.0, time_s = 0.0;
    for (int row = 0; row + 1 < table_.rows(); row += every) {
      Place(row, w_first);
      tilts.push_back(std::acos(std::clamp((R_WB_ * up_B_).z(), -1.0, 1.0)));
      if (table_.base_m.empty()) continue;
      const Lowest before = LowestPoint();
      heights.push_back(Height(before.p_W));
      Place(row + 1, w_first);
      slid_m += (PointOf(before) - before.p_W).head<2>().norm();
      const auto k = static_cast<std::size_t>(row);
      time_s += table_.time_s[k + 1] - table_.time_s[k];
    }
    Look look{.tilt_rad = MedianOf(std::move(tilts)), .placed = !heights.empty()};
    if (!look.placed) return look;
    look.slide_m_s = slid_m / time_s;
    if (ground_ != nullptr) look.height_m = MedianOf(std::move(heights));
    return look;
  }

 private:
  void Place(int row, bool w_first) {
    const auto k = static_cast<std::size_t>(row);
    const Eigen::Vector4d& c = table_.quaternion[k];
    Vector3 p_WB = Vector3::Zero();
    if (!table_.base_m.empty()) p_WB = table_.base_m[k] + lift_m_ * Vector3::UnitZ();
    VectorX q(model_.nq());
    // A joint without data is in its standing position.
    q << p_WB, c, table_.q[k].array().isFinite().select(table_.q[k], model_.standing_joints);
    if (w_first) q.segment<4>(3) << c[1], c[2], c[3], c[0];
    R_WB_ = BaseRotation(q);
    ForwardKinematics(model_, q, scratch_);
  }
  double Height(const Vector3& p_W) const {
    return ground_ == nullptr ? p_W.z() : p_W.z() - GroundAt(*ground_, p_W.head<2>()).height_m;
  }
  /// The lowest contact point of all feet. All corners of a flat sole are lowest, so that it is kept by its index.
  struct Lowest {
    int foot = 0;
    std::size_t point = 0;
    Vector3 p_W = Vector3::Zero();
  };
  Lowest LowestPoint() const {
    Lowest lowest;
    bool first = true;
    for (int f = 0; f < static_cast<int>(model_.feet.size()); ++f) {
      const std::vector<Vector3> points = ContactPoints(model_, scratch_, f);
      for (std::size_t i = 0; i < points.size(); ++i) {
        if (!first && !(Height(points[i]) < Height(lowest.p_W))) continue;
        lowest = {f, i, points[i]};
        first = false;
      }
    }
    return lowest;
  }
  Vector3 PointOf(const Lowest& lowest) const { return ContactPoints(model_, scratch_, lowest.foot)[lowest.point]; }

  const RobotModel& model_;
  const Terrain* ground_;
  const double lift_m_;
  const MotionTable& table_;
  DynamicsScratch scratch_;
  Vector3 up_B_;
  Matrix3 R_WB_;
};

bool IsUpright(const Look& look) {
  constexpr double kUpright = 1.0;  // [rad]
  return look.tilt_rad < kUpright;
}

std::string Said(const Look& look, const Terrain* ground) {
  std::string text = fmt::format("leaning by {:.2f} rad", look.tilt_rad);
  if (!look.placed) return text;
  if (ground == nullptr) return text + fmt::format(", its lowest foot sliding at {:.3f} m/s", look.slide_m_s);
  return text + fmt::format(", its lowest foot {:.3f} m over the ground and sliding at {:.3f} m/s", look.height_m,
                            look.slide_m_s);
}

}  // namespace

void CheckQuaternionOrder(const RobotModel& model, const Terrain* ground, double lift_m, const MotionTable& table) {
  constexpr double kNear = 0.25, kClearly = 3.0, kSlightly = 1.2, kStill = 0.02;  // share of the leg, [1], [1], [m/s]
  Looker looker(model, ground, lift_m, table);
  const Look named = looker.At(false), other = looker.At(true);
  const auto stands = [&](const Look& look) {
    return IsUpright(look) && std::abs(look.height_m) < kNear * model.leg_length_m();
  };
  const bool height_tells = stands(named) || stands(other);
  const auto plausible = [&](const Look& look) { return height_tells ? stands(look) : IsUpright(look); };
  const std::string both = fmt::format("read as x, y, z, w (as named) the robot is {}; read as w, x, y, z {}",
                                       Said(named, ground), Said(other, ground));
  if (plausible(other) && (!plausible(named) || named.slide_m_s > kClearly * other.slide_m_s + kStill)) {
    throw InvalidArgument("the base's quaternion probably has w first: " + both +
                          ". Use --quaternion-order wxyz for w first, or --quaternion-order xyzw for the named order");
  }
  if (!plausible(named)) {
    throw InvalidArgument("the robot is not upright with either order of the base's quaternion: " + both +
                          ". Use --quaternion-order xyzw for the named order");
  }
  if (plausible(other) && named.slide_m_s > kSlightly * other.slide_m_s + kStill) {
    throw InvalidArgument("the base's quaternion may have w first or last: " + both +
                          ". Set the order: --quaternion-order xyzw or wxyz");
  }
}

}  // namespace gaitwright
