// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "kinematics/dynamics/dynamics.h"
#include "kinematics/spatial/rotation.h"
#include "kinematics/trajectory/swing_curve.h"
#include "planning/plan/carried_plan.h"
#include "workflows/exchange/blend_posture_internal.h"
#include "workflows/repair/left_out_internal.h"

namespace gaitwright {
namespace {

constexpr double kRamp = 0.3;    // [s] in which the motion comes to rest and begins again
constexpr double kAround = 0.4;  // [s] on either side of a bad time, at least

/// Rows of a motion at which the robot is slow and stands for a while, with the places of its feet.
class StandingRows {
 public:
  StandingRows(const RobotModel& model, const EvenMotion& motion, bool moves) : model_(model), may_move_(moves) {
    const int apart = std::max(1, static_cast<int>(std::lround(kBetween / motion.step_s)));
    const FootSet all = AllFeet(static_cast<int>(model.legs.size()));
    DynamicsScratch scratch(model);
    const int half = static_cast<int>(std::lround(0.5 * kRamp / motion.step_s));
    for (int row = 0; row < motion.size(); row += apart) {
      const auto k = static_cast<std::size_t>(row);
      const auto from = motion.contact.begin() + std::max(0, row - half);
      const auto to = motion.contact.begin() + std::min(motion.size(), row + half + 1);
      const bool stands = std::all_of(from, to, [&](FootSet feet) { return (feet & all) == all; });
      if (!stands || !IsSlow(motion, row)) continue;
      ForwardKinematics(model, motion.q[k], scratch);
      Standing standing{motion.TimeOf(row), {}};
      for (const Leg& leg : model.legs) {
        const Foot& foot = model.feet[static_cast<std::size_t>(leg.foot)];
        const auto b = static_cast<std::size_t>(foot.body);
        standing.feet.push_back(
            {scratch.p_WB[b] + scratch.R_WB[b] * foot.X_BF.translation(), scratch.R_WB[b] * foot.X_BF.linear()});
      }
      rows_.push_back(std::move(standing));
    }
  }

  /// The shortest part around two times. @param duration_s  of the motion.
  std::optional<LeftOutPart> PartAround(double first_s, double last_s, double duration_s) const {
    constexpr double kNone = std::numeric_limits<double>::infinity();
    std::optional<LeftOutPart> best;
    double shortest = kNone;
    const auto after = std::partition_point(rows_.begin(), rows_.end(),
                                            [&](const Standing& one) { return one.at_s < last_s + kAround; });
    auto before = std::partition_point(rows_.begin(), rows_.end(),
                                       [&](const Standing& one) { return one.at_s <= first_s - kAround; });
    const auto latest = before;
    while (before != rows_.begin()) {
      --before;
      if (after == rows_.end() || after->at_s - before->at_s >= shortest) break;
      for (auto end = after; end != rows_.end() && end->at_s - before->at_s < shortest; ++end) {
        const std::optional<Pose> moved = Moved(before->feet, end->feet);
        if (!moved) continue;
        best = LeftOutPart{before->at_s, end->at_s, *moved, ""};
        shortest = end->at_s - before->at_s;
      }
    }
    if (best) return best;
    const double to_start_s = after == rows_.end() ? kNone : after->at_s;
    const double to_end_s = latest == rows_.begin() ? kNone : duration_s - std::prev(latest)->at_s;
    if (std::min(to_start_s, to_end_s) == kNone) return std::nullopt;
    if (to_start_s < to_end_s) return LeftOutPart{0.0, to_start_s, Pose::Identity(), ""};
    return LeftOutPart{duration_s - to_end_s, duration_s, Pose::Identity(), ""};
  }

 private:
  struct PlacedFoot {
    Vector3 p_W;
    Matrix3 R_W;
  };
  struct Standing {
    double at_s;
    std::vector<PlacedFoot> feet;
  };

  bool IsSlow(const EvenMotion& motion, int row) const {
    constexpr double kOver = 0.05, kSlow = 0.1, kSlowTurn = 0.5;  // [s], of sqrt(g l), [rad/s]
    const int half = std::max(1, static_cast<int>(std::lround(0.5 * kOver / motion.step_s)));
    const int from = std::max(0, row - half), to = std::min(motion.size() - 1, row + half);
    const VectorX &a = motion.q[static_cast<std::size_t>(from)], &b = motion.q[static_cast<std::size_t>(to)];
    const double time_s = motion.TimeOf(to - from);
    return (b - a).head<3>().norm() <= kSlow * std::sqrt(kGravity * model_.leg_length_m()) * time_s &&
           RotationLog(BaseRotation(b) * BaseRotation(a).transpose()).norm() <= kSlowTurn * time_s;
  }

  /// The motion in plan view that brings feet to places; nothing if they stand otherwise there.
  std::optional<Pose> Moved(const std::vector<PlacedFoot>& places, const std::vector<PlacedFoot>& feet) const {
    constexpr double kSame = 0.06, kSameTurn = 0.3;    // of the leg length; [rad] of a sole
    constexpr double kStill = 0.02, kStillTurn = 0.1;  // the same, on uneven ground
    const auto count = static_cast<double>(feet.size());
    Vector3 mean = Vector3::Zero(), mean_place = Vector3::Zero();
    for (std::size_t f = 0; f < feet.size(); ++f) {
      mean += feet[f].p_W / count;
      mean_place += places[f].p_W / count;
    }
    double along = 0.0, across = 0.0;
    for (std::size_t f = 0; f < feet.size(); ++f) {
      const Vector3 a = feet[f].p_W - mean, b = places[f].p_W - mean_place;
      along += a.x() * b.x() + a.y() * b.y();
      across += a.x() * b.y() - a.y() * b.x();
    }
    const double turn = feet.size() > 1 ? std::atan2(across, along) : Turn(feet[0], places[0]);
    const Matrix3 R = PoseOf({0.0, 0.0, turn}).linear();
    Vector3 shift = mean_place - R * mean;
    shift.z() = 0.0;
    const double far = (may_move_ ? kSame : kStill) * model_.leg_length_m();
    if (!may_move_ && ((mean_place - mean).norm() > far || std::abs(turn) > kStillTurn)) return std::nullopt;
    for (std::size_t f = 0; f < feet.size(); ++f) {
      if ((R * feet[f].p_W + shift - places[f].p_W).head<2>().norm() > far) return std::nullopt;
      const bool is_flat = model_.feet[static_cast<std::size_t>(model_.legs[f].foot)].type == FootType::kSole;
      if (is_flat && std::abs(WrapAngle(Turn(feet[f], places[f]) - turn)) > kSameTurn) return std::nullopt;
    }
    Pose moved = Pose::Identity();
    moved.linear() = R;
    moved.translation() = shift;
    return moved;
  }

  static double Turn(const PlacedFoot& from, const PlacedFoot& to) {
    return WrapAngle(YawOf(to.R_W) - YawOf(from.R_W));
  }

  static constexpr double kBetween = 0.05;  // [s] between rows that are looked at
  const RobotModel& model_;
  const bool may_move_;
  std::vector<Standing> rows_;
};

/// The posture at a time between rows.
VectorX At(const EvenMotion& motion, double at_s) {
  const double place = std::clamp(at_s / motion.step_s, 0.0, static_cast<double>(motion.size() - 1));
  const auto row = std::min(static_cast<std::size_t>(place), motion.q.size() - 1);
  VectorX q;
  BlendPosture(motion.q[row], motion.q[std::min(row + 1, motion.q.size() - 1)], place - std::floor(place), q);
  return q;
}

/// Time that passes in the motion while its pace falls from 1 to 0 over kRamp.
double Passed(double time_s) {
  const double u = std::clamp(time_s / kRamp, 0.0, 1.0);
  return kRamp * (u - std::pow(u, 4.0) * (2.5 + u * (u - 3.0)));  // of 1 - SmoothStep
}

/// The posture of the robot in a part. @param before, after  by which the motion there is moved.
VectorX Between(const EvenMotion& motion, const LeftOutPart& part, const Pose& before, const Pose& after, double at_s) {
  const double duration_s = motion.TimeOf(motion.size() - 1);
  const bool begins = part.start_s <= 0.0, ends = part.end_s >= duration_s;
  VectorX from = CarriedState(before, At(motion, part.start_s + Passed(at_s - part.start_s)));
  VectorX to = CarriedState(after, At(motion, part.end_s - Passed(part.end_s - at_s)));
  if (begins) return to;
  if (ends) return from;
  VectorX q;
  BlendPosture(from, to, SmoothStep((at_s - part.start_s) / (part.end_s - part.start_s)).value, q);
  return q;
}

}  // namespace

double DurationOf(const std::vector<LeftOutPart>& parts) {
  double duration_s = 0.0;
  for (const LeftOutPart& part : parts) duration_s += part.end_s - part.start_s;
  return duration_s;
}

bool LeaveOut(const RobotModel& model, GroundKind ground, const EvenMotion& motion, std::vector<double> bad_s,
              const std::string& why, std::vector<LeftOutPart>& parts) {
  constexpr double kLeastKept = 1.0;  // [s] between two parts
  if (motion.size() < 2) return false;
  const StandingRows standing(model, motion, ground == GroundKind::kFlat || ground == GroundKind::kLevel);
  const double duration_s = motion.TimeOf(motion.size() - 1);
  std::sort(bad_s.begin(), bad_s.end());
  for (std::size_t i = 0; i < bad_s.size();) {
    double first_s = bad_s[i], last_s = bad_s[i];
    for (; i < bad_s.size() && bad_s[i] <= last_s + kLeastKept; ++i) last_s = bad_s[i];
    std::optional<LeftOutPart> part;
    while (true) {
      part = standing.PartAround(first_s, last_s, duration_s);
      if (!part) return false;
      const auto near = std::find_if(parts.begin(), parts.end(), [&](const LeftOutPart& other) {
        return other.start_s < part->end_s + kLeastKept && other.end_s > part->start_s - kLeastKept;
      });
      if (near == parts.end()) break;
      first_s = std::min(first_s, near->start_s);
      last_s = std::max(last_s, near->end_s);
      parts.erase(near);
    }
    part->why = why;
    parts.push_back(*part);
    std::sort(parts.begin(), parts.end(), [](const auto& a, const auto& b) { return a.start_s < b.start_s; });
  }
  return true;
}

std::string LostText(const std::vector<LeftOutPart>& parts, double duration_s) {
  std::vector<std::string> times;
  for (const LeftOutPart& part : parts) times.push_back(fmt::format("{:.2f} to {:.2f} s", part.start_s, part.end_s));
  return fmt::format(
      "{} of the file would have to be left out; that is {:.0f} % of the motion, more than repair.leave_out "
      "allows",
      fmt::join(times, ", "), 100.0 * DurationOf(parts) / duration_s);
}

EvenMotion WithoutParts(const EvenMotion& motion, const std::vector<LeftOutPart>& parts) {
  EvenMotion kept{motion.step_s, {}, {}, {}, {}, motion.contact, {}};
  Pose before = Pose::Identity();
  const double duration_s = motion.TimeOf(motion.size() - 1);
  std::size_t next = 0;
  for (int k = 0; k < motion.size(); ++k) {
    const auto row = static_cast<std::size_t>(k);
    const double at_s = motion.TimeOf(k);
    while (next < parts.size() && at_s >= parts[next].end_s && parts[next].end_s < duration_s)
      before = before * parts[next++].moved;
    if (next == parts.size() || at_s <= parts[next].start_s) {
      kept.q.push_back(CarriedState(before, motion.q[row]));
      continue;
    }
    const LeftOutPart& part = parts[next];
    kept.q.push_back(Between(motion, part, before, before * part.moved, at_s));
    const double stands_s = part.start_s > 0.0 ? part.start_s : part.end_s;
    kept.contact[row] = motion.contact[static_cast<std::size_t>(std::lround(stands_s / motion.step_s))];
  }
  return kept;
}

VectorX PostureOfFile(const EvenMotion& motion, const std::vector<LeftOutPart>& parts, double file_s,
                      const VectorX& kept) {
  Pose moved = Pose::Identity();
  for (const LeftOutPart& part : parts) {
    if (file_s <= part.start_s) return kept;
    if (file_s < part.end_s) return CarriedState(moved, At(motion, file_s));
    moved = moved * part.moved;
  }
  return kept;
}

}  // namespace gaitwright
