// SPDX-License-Identifier: BSD-3-Clause
#include "tests/workflows/exchange/other_software.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace gaitwright {
namespace {

const std::array<const char*, 4> kLegs = {"FR", "FL", "RR", "RL"};

double Ease(double u) {
  const double c = std::clamp(u, 0.0, 1.0);
  return c * c * c * (10.0 + c * (6.0 * c - 15.0));
}

/// Thigh and calf angles of two links of 0.2 m whose end is at (x, z) from the hip, by the law of cosines.
std::array<double, 2> TwoLinks(double x, double z) {
  constexpr double kLink = 0.2;
  const double reach = std::min(std::hypot(x, z), 1.999 * kLink);
  const double inner = std::acos((2.0 * kLink * kLink - reach * reach) / (2.0 * kLink * kLink));
  const double knee = -(std::numbers::pi - inner);
  return {std::atan2(-x, -z) - 0.5 * knee, knee};
}

struct Span {
  double start, end;
};

/// Data of one leg in a row.
struct LegRow {
  double thigh = 0.0, calf = 0.0;
  bool stands = true;
};

class Writer {
 public:
  explicit Writer(const OtherWalk& walk) : walk_(walk) {
    const double half = 0.5 * walk.cycle_s;
    for (int i = 0; i < walk.half_cycles; ++i) {
      const double begin = walk.stand_s + i * half, rest = 0.5 * (1.0 - walk.swing_share) * half;
      const Span whole = {begin + rest, begin + half - rest};
      const int first = i % 2 == 0 ? 0 : 1;  // FR with RL, FL with RR
      if (walk.pairs) {
        swings_[static_cast<std::size_t>(first)].push_back(whole);
        swings_[static_cast<std::size_t>(3 - first)].push_back(whole);
      } else {
        const double middle = 0.5 * (whole.start + whole.end);
        swings_[static_cast<std::size_t>(3 - first)].push_back({whole.start, middle - rest});
        swings_[static_cast<std::size_t>(first)].push_back({middle + rest, whole.end});
      }
    }
    end_s_ = 2.0 * walk.stand_s + walk.half_cycles * half;
  }

  int rows() const { return 1 + static_cast<int>(std::lround(end_s_ / walk_.step_s)); }
  double TimeOf(int row) const { return row * walk_.step_s; }
  double Base(double t) const {
    const double distance = walk_.speed_m_s * (end_s_ - 2.0 * walk_.stand_s);
    return distance * Ease((t - walk_.stand_s) / (end_s_ - 2.0 * walk_.stand_s));
  }

  LegRow Leg(std::size_t leg, double t) const {
    constexpr double kRadius = 0.02;
    LegRow row;
    std::size_t done = 0;
    double x = 0.0, z = 0.0;
    while (done < swings_[leg].size() && t >= swings_[leg][done].end - 1e-9) ++done;
    x = Place(leg, done);
    if (done < swings_[leg].size() && t > swings_[leg][done].start + 1e-9) {
      const Span& swing = swings_[leg][done];
      const double u = (t - swing.start) / (swing.end - swing.start);
      x += (Place(leg, done + 1) - x) * Ease(u);
      z = walk_.lift_m * 64.0 * std::pow(u * (1.0 - u), 3);
      row.stands = false;
    }
    const auto [thigh, calf] = TwoLinks(x - Base(t), z + kRadius - walk_.height_m);
    row.thigh = thigh;
    row.calf = calf;
    return row;
  }

 private:
  /// Position of a foot after a number of swings: that of its hip in the middle of the stance.
  double Place(std::size_t leg, std::size_t swings) const {
    if (swings == 0) return 0.0;
    if (swings == swings_[leg].size()) return Base(end_s_);
    return Base(0.5 * (swings_[leg][swings - 1].end + swings_[leg][swings].start));
  }

  const OtherWalk walk_;
  std::array<std::vector<Span>, 4> swings_;
  double end_s_ = 0.0;
};

}  // namespace

std::string CsvOf(const OtherWalk& walk) {
  const Writer writer(walk);
  std::string text = "time_s";
  if (walk.with_base) text += ",base_x_m,base_y_m,base_z_m,base_qx,base_qy,base_qz,base_qw";
  for (const char* leg : kLegs)
    text += fmt::format(",q_{0}_hip_joint_rad,q_{0}_thigh_joint_rad,q_{0}_calf_joint_rad", leg);
  for (const char* leg : kLegs) text += walk.with_contacts ? fmt::format(",contact_{}_foot", leg) : "";
  text += "\n";
  for (int row = 0; row < writer.rows(); ++row) {
    const double t = writer.TimeOf(row), scale = walk.length_scale;
    text += fmt::format("{:.9g}", walk.time_scale * t);
    if (walk.with_base)
      text += fmt::format(",{:.9g},0,{:.9g},{}", scale * writer.Base(t), scale * walk.height_m,
                          walk.w_first ? "1,0,0,0" : "0,0,0,1");
    for (std::size_t leg = 0; leg < kLegs.size(); ++leg) {
      const LegRow at = writer.Leg(leg, t);
      text += fmt::format(",0,{:.9g},{:.9g}", walk.joint_scale * at.thigh, walk.joint_scale * at.calf);
    }
    for (std::size_t leg = 0; leg < kLegs.size() && walk.with_contacts; ++leg)
      text += writer.Leg(leg, t).stands ? ",1" : ",0";
    text += "\n";
  }
  return text;
}

std::string CsvOf(const RobotModel& model, const OtherStance& stance) {
  std::string text = "time_s,base_x_m,base_y_m,base_z_m," + stance.turn_columns;
  for (const std::string& name : model.dof_names) text += "," + name;
  for (int row = 0; row < stance.rows; ++row) {
    text += fmt::format("\n{:.12g},0,0,{},{}", row * stance.step_s, stance.base_z_m, stance.turn);
    for (int d = 0; d < model.num_dofs(); ++d) {
      const auto said = stance.joints.find(model.dof_names[static_cast<std::size_t>(d)]);
      text += fmt::format(",{}", said == stance.joints.end() ? model.standing_joints[d] : said->second);
    }
  }
  return text + "\n";
}

std::string TrajectoryOf(const OtherWalk& walk) {
  const Writer writer(walk);
  std::string text = "header: {frame_id: ''}\njoint_names:\n";
  for (const char* leg : kLegs) text += fmt::format("- {0}_hip_joint\n- {0}_thigh_joint\n- {0}_calf_joint\n", leg);
  text += "points:\n";
  for (int row = 0; row < writer.rows(); ++row) {
    const double t = writer.TimeOf(row);
    const auto nanoseconds = std::llround(1e9 * t);
    text += "- positions: [";
    for (std::size_t leg = 0; leg < kLegs.size(); ++leg) {
      const LegRow at = writer.Leg(leg, t);
      text += fmt::format("{}0.0, {:.9g}, {:.9g}", leg == 0 ? "" : ", ", at.thigh, at.calf);
    }
    text += fmt::format("]\n  velocities: []\n  time_from_start: {{sec: {}, nanosec: {}}}\n",
                        nanoseconds / 1'000'000'000, nanoseconds % 1'000'000'000);
  }
  return text;
}

}  // namespace gaitwright
