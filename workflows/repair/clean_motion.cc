// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "kinematics/dynamics/foot_contact.h"
#include "kinematics/spatial/rotation.h"
#include "kinematics/trajectory/swing_curve.h"
#include "workflows/exchange/knot_spline.h"
#include "workflows/exchange/median_internal.h"
#include "workflows/repair/clean_motion_internal.h"
#include "workflows/repair/nearest_posture_internal.h"
#include "workflows/repair/part_feet_internal.h"

namespace gaitwright {
namespace {

constexpr double kFeetApart = 0.01;  // of the leg's length, at least between feet that stand

std::size_t At(int i) { return static_cast<std::size_t>(i); }

/// Mean of rotations that are near each other.
Matrix3 MeanRotation(const std::vector<Pose>& X, const RowRange& rows) {
  const Matrix3& middle = X[At((rows.first + rows.last) / 2)].linear();
  Vector3 turn = Vector3::Zero();
  for (int k = rows.first; k <= rows.last; ++k) turn += RotationLog(X[At(k)].linear() * middle.transpose());
  return RotationExp(turn / (rows.last - rows.first + 1)) * middle;
}

class Cleaner {
 public:
  Cleaner(const RobotModel& model, const Terrain& terrain, const EvenMotion& motion, const std::vector<FootSet>& stance,
          const RepairOptions& options)
      : model_(model), terrain_(terrain), motion_(motion), options_(options), tracks_(FeetOf(model, terrain, motion)) {
    clean_.motion.contact = stance;
  }

  CleanMotion Run() {
    for (int f = 0; f < static_cast<int>(model_.legs.size()); ++f) {
      stances_.emplace_back();
      for (const RowRange& rows : StancesOf(clean_.motion.contact, f)) Pin(f, rows);
      if (stances_.back().empty()) {
        throw InvalidArgument(fmt::format("foot '{}' never stands: it is never low, slow and flat for {} s",
                                          model_.feet[At(f)].name, options_.least_stance_s));
      }
    }
    PartFeet(model_, terrain_, kFeetApart * model_.leg_length_m(), stances_);
    for (int f = 0; f < static_cast<int>(model_.legs.size()); ++f) {
      const std::vector<RowRange> rows = StancesOf(clean_.motion.contact, f);
      for (std::size_t i = 0; i < rows.size(); ++i) Describe(f, rows[i], stances_[At(f)][i]);
    }
    ShiftBase();
    for (int f = 0; f < static_cast<int>(model_.legs.size()); ++f) LayCourse(f);
    FollowFeet();
    return std::move(clean_);
  }

 private:
  int last_row() const { return motion_.size() - 1; }

  /// Position of a foot less what it has rolled.
  Vector3 Unrolled(int f, int k) const {
    return tracks_[At(f)].X_WF[At(k)].translation() - tracks_[At(f)].rolled_W[At(k)];
  }

  void Pin(int f, const RowRange& rows) {
    PinnedPlace stance{{rows.first, std::min(rows.last + 1, last_row())}};
    const std::vector<Pose>& X = tracks_[At(f)].X_WF;
    Vector3 mean = Vector3::Zero();
    for (int k = rows.first; k <= rows.last; ++k) mean += X[At(k)].translation() / (rows.last - rows.first + 1);
    const GroundPoint ground = GroundAt(terrain_, mean.head<2>());
    if (ground.patch < 0) {
      throw InvalidArgument(
          fmt::format("foot '{}' stands at {:.3f} s at x = {:.3f} m, y = {:.3f} m, where there is no "
                      "ground",
                      model_.feet[At(f)].name, motion_.TimeOf(rows.first), mean.x(), mean.y()));
    }
    const Matrix3 R = MeanRotation(X, rows);
    stance.X_WF.linear() = RotationBetween(R.col(2), ground.normal_W).toRotationMatrix() * R;
    Vector3 unrolled = Vector3::Zero();
    for (int k = rows.first; k <= rows.last; ++k) unrolled += Unrolled(f, k) / (rows.last - rows.first + 1);
    unrolled += (ground.height_m - mean.z()) * Vector3::UnitZ();
    stance.X_WF.translation() = unrolled;
    stances_.back().push_back(stance);
  }

  void Describe(int f, const RowRange& rows, const PinnedPlace& stance) {
    PinnedStance pinned{f, motion_.TimeOf(stance.rows.first), motion_.TimeOf(stance.rows.last)};
    pinned.parted_m = stance.parted_m;
    std::vector<double> heights;
    for (int k = rows.first; k <= rows.last; ++k) {
      pinned.slid_m = std::max(pinned.slid_m, (Unrolled(f, k) - stance.X_WF.translation()).head<2>().norm());
      heights.push_back(tracks_[At(f)].height_m[At(k)]);
      if (!model_.feet[At(f)].has_sole()) continue;
      const Vector3 up = tracks_[At(f)].X_WF[At(k)].linear().col(2);
      pinned.tilt_rad = std::max(pinned.tilt_rad, std::acos(std::min(1.0, up.dot(stance.X_WF.linear().col(2)))));
    }
    pinned.height_m = MedianOf(std::move(heights));
    clean_.stances.push_back(pinned);
  }

  /// By how much a foot has to move to where it is pinned, and between stances: a smooth step from one to the next.
  Vector3 OffsetOf(int f, int k) const {
    const std::vector<PinnedPlace>& all = stances_[At(f)];
    const auto offset = [&](const PinnedPlace& stance, int row) {
      return Vector3(stance.X_WF.translation() - Unrolled(f, row));
    };
    std::size_t next = 0;
    while (next < all.size() && all[next].rows.first <= k) ++next;
    if (next > 0 && k <= all[next - 1].rows.last) return offset(all[next - 1], k);
    if (next == 0) return offset(all.front(), all.front().rows.first);
    const PinnedPlace& before = all[next - 1];
    if (next == all.size()) return offset(before, before.rows.last);
    const double u = static_cast<double>(k - before.rows.last) / (all[next].rows.first - before.rows.last);
    const double s = SmoothStep(u).value;
    return (1.0 - s) * offset(before, before.rows.last) + s * offset(all[next], all[next].rows.first);
  }

  /// The base moves by the mean of what its standing feet move by.
  void ShiftBase() {
    constexpr double kCutoff = 2.0;  // [Hz]
    const int feet = static_cast<int>(model_.legs.size());
    std::vector<double> time_s;
    std::vector<std::vector<double>> shift(3);
    for (int k = 0; k < motion_.size(); ++k) {
      const FootSet stance = clean_.motion.contact[At(k)];
      Vector3 sum = Vector3::Zero();
      int count = 0;
      for (int f = 0; f < feet; ++f) {
        if (stance != 0 && !Contains(stance, f)) continue;
        sum += OffsetOf(f, k);
        ++count;
      }
      time_s.push_back(motion_.TimeOf(k));
      for (std::size_t i = 0; i < 3; ++i) shift[i].push_back(sum[static_cast<Eigen::Index>(i)] / count);
    }
    for (auto& axis : shift) axis = Smoothed(time_s, axis, kCutoff);
    for (int k = 0; k < motion_.size(); ++k) shift_W_.emplace_back(shift[0][At(k)], shift[1][At(k)], shift[2][At(k)]);
    clean_.lift_m = MedianOf(shift[2]);
  }

  /// Contact frames of a foot by row. In swings, the path keeps its offset from that of the file, and rotates as swings
  /// of plans do.
  void LayCourse(int f) {
    const std::vector<PinnedPlace>& all = stances_[At(f)];
    std::vector<Pose> course(motion_.q.size());
    std::size_t next = 0;
    for (int k = 0; k < motion_.size(); ++k) {
      while (next < all.size() && all[next].rows.first <= k) ++next;
      const PinnedPlace& before = all[next == 0 ? 0 : next - 1];
      Pose& X_WF = course[At(k)];
      X_WF.linear() = before.X_WF.linear();
      const Vector3& rolled_W = tracks_[At(f)].rolled_W[At(k)];
      X_WF.translation() = Unrolled(f, k) + OffsetOf(f, k) + rolled_W;
      if (next == 0 || next == all.size() || k <= before.rows.last) continue;
      const double u = static_cast<double>(k - before.rows.last) / (all[next].rows.first - before.rows.last);
      BeginAtRest(u, before.X_WF.translation() + rolled_W, all[next].X_WF.translation() + rolled_W, X_WF);
      const Matrix3 turn = all[next].X_WF.linear() * before.X_WF.linear().transpose();
      X_WF.linear() = RotationExp(SmoothStep(u).value * RotationLog(turn)) * before.X_WF.linear();
      KeepClear(f, SmoothBump(u).value * options_.clearance * model_.leg_length_m(), X_WF);
    }
    courses_.push_back(std::move(course));
  }

  /// Foot tracks move already where stances end, and still where they begin. A swing leaves the place of a stance from
  /// rest, joins the file's path within a share of its time, and comes to rest likewise.
  static void BeginAtRest(double u, const Vector3& from_W, const Vector3& to_W, Pose& X_WF) {
    constexpr double kJoins = 0.25;
    const bool first = u < 0.5;
    const double near = (first ? u : 1.0 - u) / kJoins;
    if (near >= 1.0) return;
    const Vector3& rest_W = first ? from_W : to_W;
    X_WF.translation() = rest_W + SmoothStep(near).value * (X_WF.translation() - rest_W);
  }

  void KeepClear(int f, double least_m, Pose& X_WF) const {
    double lacking = 0.0;
    for (const Vector3& p : ContactPoints(model_.feet[At(f)], X_WF)) {
      const GroundPoint ground = GroundAt(terrain_, p.head<2>());
      if (ground.patch >= 0) lacking = std::max(lacking, ground.height_m + least_m - p.z());
    }
    X_WF.translation().z() += lacking;
  }

  void FollowFeet() {
    NearestPosture nearest(model_, options_);
    std::vector<Pose> X_WF(courses_.size());
    clean_.motion.step_s = motion_.step_s;
    for (int k = 0; k < motion_.size(); ++k) {
      for (std::size_t f = 0; f < courses_.size(); ++f) X_WF[f] = courses_[f][At(k)];
      VectorX q_given = motion_.q[At(k)], q;
      q_given.head<3>() += shift_W_[At(k)];
      const double off = nearest.Solve(q_given, X_WF, q);
      if (off > clean_.unreached_m) {
        clean_.unreached_m = off;
        clean_.unreached_s = motion_.TimeOf(k);
      }
      clean_.shift_m.push_back((q.head<3>() - motion_.q[At(k)].head<3>()).norm());
      clean_.motion.q.push_back(std::move(q));
    }
  }

  const RobotModel& model_;
  const Terrain& terrain_;
  const EvenMotion& motion_;
  const RepairOptions& options_;
  const std::vector<FootTrack> tracks_;
  std::vector<std::vector<PinnedPlace>> stances_;  // by foot
  std::vector<Vector3> shift_W_;                   // of the base, by row
  std::vector<std::vector<Pose>> courses_;         // by foot, by row
  CleanMotion clean_;
};

}  // namespace

CleanMotion CleanContacts(const RobotModel& model, const Terrain& terrain, const EvenMotion& motion,
                          const std::vector<FootSet>& stance, const RepairOptions& options) {
  return Cleaner(model, terrain, motion, stance, options).Run();
}

}  // namespace gaitwright
