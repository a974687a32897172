// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <iterator>

#include "kinematics/spatial/pose.h"
#include "workflows/exchange/median_internal.h"
#include "workflows/repair/found_contacts_internal.h"

namespace gaitwright {
namespace {

std::size_t Row(int i) { return static_cast<std::size_t>(i); }

/// Speed of the middle of a foot, and tilt of its sole against the vertical.
double MiddleSpeed(const FootTrack& foot, int row, double step_s) {
  const int last = static_cast<int>(foot.X_WF.size()) - 1, a = std::max(0, row - 1), b = std::min(last, row + 1);
  return (foot.X_WF[Row(b)].translation() - foot.X_WF[Row(a)].translation()).norm() / (step_s * std::max(1, b - a));
}

double TiltOf(const Foot& foot, const FootTrack& track, int row) {
  if (!foot.has_sole()) return 0.0;
  return std::acos(std::clamp(track.X_WF[Row(row)].linear()(2, 2), -1.0, 1.0));
}

/// Changes runs of `value` that are shorter than `least` and touch neither end. @return how many.
int TakeOutShort(std::vector<bool>& stands, bool value, int least) {
  int changed = 0;
  for (std::size_t begin = 0; begin < stands.size();) {
    std::size_t end = begin;
    while (end < stands.size() && stands[end] == stands[begin]) ++end;
    if (stands[begin] == value && begin > 0 && end < stands.size() && end - begin < Row(least)) {
      std::fill(stands.begin() + static_cast<std::ptrdiff_t>(begin), stands.begin() + static_cast<std::ptrdiff_t>(end),
                !value);
      ++changed;
    }
    begin = end;
  }
  return changed;
}

class ContactFinder {
 public:
  ContactFinder(const RobotModel& model, const EvenMotion& motion, const std::vector<FootTrack>& feet,
                const RepairOptions& options)
      : model_(model), motion_(motion), feet_(feet), options_(options), legs_(static_cast<int>(model.legs.size())) {}

  FoundContacts Run() {
    const std::vector<double> flat_m = FlatHeights();
    found_.height_m = StandingHeight(flat_m);
    SetLocalHeights(flat_m);
    const auto least = [&](double time_s) { return static_cast<int>(std::ceil(time_s / motion_.step_s)); };
    for (int f = 0; f < legs_; ++f) {
      stands_.push_back(Hysteresis(f));
      found_.short_swings += TakeOutShort(stands_.back(), false, least(options_.least_swing_s));
      found_.short_stances += TakeOutShort(stands_.back(), true, least(options_.least_stance_s));
      TrimStances(f, least(options_.least_stance_s));
      StandAtEnds(f);
    }
    FillFalseFlights();
    found_.stance.assign(motion_.q.size(), 0);
    for (int f = 0; f < legs_; ++f) {
      for (std::size_t k = 0; k < motion_.q.size(); ++k) {
        if (stands_[Row(f)][k]) found_.stance[k] |= FootBit(f);
      }
    }
    return found_;
  }

 private:
  double SpeedUnit() const { return std::sqrt(kGravity * model_.leg_length_m()); }

  int LowestFoot(int row) const {
    int lowest = 0;
    for (int f = 1; f < legs_; ++f) {
      if (feet_[Row(f)].height_m[Row(row)] < feet_[Row(lowest)].height_m[Row(row)]) lowest = f;
    }
    return lowest;
  }

  bool IsSlow(int f, int row) const {
    return MiddleSpeed(feet_[Row(f)], row, motion_.step_s) < options_.stand_speed * SpeedUnit();
  }

  /// By row, the height of the lowest foot among those that are slow and flat; infinite where none is. A toe may be
  /// deep in the ground under a heel that is raised.
  std::vector<double> FlatHeights() const {
    constexpr double kFlat = 0.1;  // [rad]
    std::vector<double> flat_m(motion_.q.size(), INFINITY);
    for (int k = 0; k < motion_.size(); ++k) {
      for (int f = 0; f < legs_; ++f) {
        if (IsSlow(f, k) && TiltOf(model_.feet[Row(f)], feet_[Row(f)], k) < kFlat)
          flat_m[Row(k)] = std::min(flat_m[Row(k)], feet_[Row(f)].height_m[Row(k)]);
      }
    }
    return flat_m;
  }

  /// Median of FlatHeights. Where feet are hardly ever slow and flat, of the lowest foot where it is slow; else over
  /// all rows.
  double StandingHeight(const std::vector<double>& flat_m) const {
    constexpr std::size_t kFew = 10;  // one in so many rows
    std::vector<double> flat, slow, all;
    for (int k = 0; k < motion_.size(); ++k) {
      const int lowest = LowestFoot(k);
      all.push_back(feet_[Row(lowest)].height_m[Row(k)]);
      if (IsSlow(lowest, k)) slow.push_back(all.back());
      if (std::isfinite(flat_m[Row(k)])) flat.push_back(flat_m[Row(k)]);
    }
    const auto enough = [&](const std::vector<double>& some) { return some.size() * kFew >= all.size(); };
    return MedianOf(enough(flat) ? flat : enough(slow) ? slow : all);
  }

  /// Heights drift and jump in long files: by row, the median of FlatHeights over some seconds, near that of the whole
  /// file, which holds where feet are hardly ever slow and flat.
  void SetLocalHeights(const std::vector<double>& flat_m) {
    constexpr double kAround = 1.0, kEvery = 0.05;  // [s]
    constexpr double kFar = 0.1;                    // of the leg length
    constexpr std::size_t kFew = 10;                // one in so many rows
    const int around = std::max(1, static_cast<int>(std::lround(kAround / motion_.step_s))),
              every = std::max(1, static_cast<int>(std::lround(kEvery / motion_.step_s)));
    const double far_m = kFar * model_.leg_length_m();
    std::vector<double> near;
    for (int k = 0; k < motion_.size(); ++k) {
      if (k % every != 0) {
        local_m_.push_back(local_m_.back());
        continue;
      }
      const int from = std::max(0, k - around), to = std::min(motion_.size(), k + around + 1);
      near.clear();
      std::copy_if(flat_m.begin() + from, flat_m.begin() + to, std::back_inserter(near),
                   [](double height_m) { return std::isfinite(height_m); });
      const bool is_known = near.size() * kFew >= Row(to - from);
      local_m_.push_back(is_known ? std::clamp(MedianOf(near), found_.height_m - far_m, found_.height_m + far_m)
                                  : found_.height_m);
    }
  }

  /// Height of a foot over feet that stand.
  double HeightOf(int f, int row) const { return feet_[Row(f)].height_m[Row(row)] - local_m_[Row(row)]; }

  std::vector<bool> Hysteresis(int f) const {
    const FootTrack& foot = feet_[Row(f)];
    const double height_m = options_.stand_height * model_.leg_length_m(), speed = options_.stand_speed * SpeedUnit();
    std::vector<bool> stands;
    for (int k = 0; k < motion_.size(); ++k) {
      const double factor = !stands.empty() && stands.back() ? options_.leave : 1.0;
      stands.push_back(HeightOf(f, k) < factor * height_m && MiddleSpeed(foot, k, motion_.step_s) < factor * speed &&
                       TiltOf(model_.feet[Row(f)], foot, k) < factor * options_.stand_tilt_rad);
    }
    return stands;
  }

  /// Leaves out rows at both ends of a stance in which the foot is not at its usual height or moves: it lands or
  /// leaves.
  void TrimStances(int f, int least) {
    constexpr double kStill = 0.004, kSlow = 0.5;  // of the leg length, of stand_speed
    const FootTrack& foot = feet_[Row(f)];
    std::vector<bool>& stands = stands_[Row(f)];
    const double speed = kSlow * options_.stand_speed * SpeedUnit(), height_m = kStill * model_.leg_length_m();
    for (int begin = 0; begin < motion_.size();) {
      int end = begin;
      while (end < motion_.size() && stands[Row(end)] == stands[Row(begin)]) ++end;
      if (stands[Row(begin)]) {
        std::vector<double> heights_m;
        for (int k = begin; k < end; ++k) heights_m.push_back(HeightOf(f, k));
        const double usual_m = MedianOf(std::move(heights_m));
        const auto moves = [&](int k) {
          return std::abs(HeightOf(f, k) - usual_m) > height_m || MiddleSpeed(foot, k, motion_.step_s) > speed;
        };
        int first = begin, last = end - 1;
        while (first > 0 && last - first >= least && moves(first)) ++first;
        while (last + 1 < motion_.size() && last - first >= least && moves(last)) --last;
        for (int k = begin; k < end; ++k) stands[Row(k)] = k >= first && k <= last;
      }
      begin = end;
    }
  }

  /// Before its first stance and after its last one, a foot that stays low and near the place of that stance stands
  /// too: noise makes it look fast.
  void StandAtEnds(int f) {
    std::vector<bool>& stands = stands_[Row(f)];
    const auto first = std::find(stands.begin(), stands.end(), true);
    if (first == stands.end()) return;
    const int begin = static_cast<int>(first - stands.begin()),
              end = static_cast<int>(stands.rend() - std::find(stands.rbegin(), stands.rend(), true));
    const auto next = static_cast<int>(std::find(first, stands.end(), false) - stands.begin());
    int last = end - 1;
    while (last > 0 && stands[Row(last - 1)]) --last;
    const bool at_start = begin > 0 && Stays(f, {0, begin - 1}, {begin, next - 1}),
               at_end = end < motion_.size() && Stays(f, {end, motion_.size() - 1}, {last, end - 1});
    if (at_start) std::fill(stands.begin(), first, true);
    if (at_end) std::fill(stands.begin() + end, stands.end(), true);
    found_.short_swings += (at_start ? 1 : 0) + (at_end ? 1 : 0);
  }

  /// Whether a foot stays low and near its mean place over a stance.
  bool Stays(int f, const RowRange& rows, const RowRange& stance) const {
    constexpr double kNear = 0.03;  // of the leg length
    const FootTrack& foot = feet_[Row(f)];
    Vector2 mean = Vector2::Zero();
    for (int k = stance.first; k <= stance.last; ++k)
      mean += foot.X_WF[Row(k)].translation().head<2>() / (stance.last - stance.first + 1);
    for (int k = rows.first; k <= rows.last; ++k) {
      if ((foot.X_WF[Row(k)].translation().head<2>() - mean).norm() > kNear * model_.leg_length_m() ||
          HeightOf(f, k) > options_.stand_height * model_.leg_length_m())
        return false;
    }
    return true;
  }

  bool AnyStands(int row) const {
    return std::any_of(stands_.begin(), stands_.end(), [&](const std::vector<bool>& of) { return of[Row(row)]; });
  }

  /// Mean of the base while all feet are clearly over the ground; 0 if they never are.
  double VerticalAcceleration(int begin, int end) const {
    const double height_m = options_.stand_height * model_.leg_length_m();
    double sum = 0.0;
    int rows = 0;
    for (int k = begin; k < end; ++k) {
      if (HeightOf(LowestFoot(k), k) < height_m) continue;
      sum += motion_.a[Row(k)][2];
      ++rows;
    }
    return rows == 0 ? 0.0 : sum / rows;
  }

  /// Where no foot stands although the base does not fall, the foot that stood last keeps standing for half of the
  /// time, and then the foot that stands next does.
  void FillFalseFlights() {
    constexpr double kFalls = 0.3;  // of g
    for (int begin = 0; begin < motion_.size();) {
      int end = begin;
      while (end < motion_.size() && !AnyStands(end)) ++end;
      if (end == begin) {
        ++begin;
        continue;
      }
      const bool whole = begin == 0 && end == motion_.size();
      if (VerticalAcceleration(begin, end) > -kFalls * kGravity && !whole) {
        ++found_.false_flights;
        const int middle = begin == 0 ? begin : end == motion_.size() ? end : (begin + end) / 2;
        Extend(begin - 1, begin, middle);
        Extend(end, middle, end);
      }
      begin = end;
    }
  }

  /// The feet that stand in a row also stand from `first` to before `behind`.
  void Extend(int from, int first, int behind) {
    for (auto& of : stands_) {
      for (int k = first; k < behind && of[Row(from)]; ++k) of[Row(k)] = true;
    }
  }

  const RobotModel& model_;
  const EvenMotion& motion_;
  const std::vector<FootTrack>& feet_;
  const RepairOptions& options_;
  const int legs_;
  std::vector<double> local_m_;            // by row: see SetLocalHeights
  std::vector<std::vector<bool>> stands_;  // by foot, by row
  FoundContacts found_;
};

}  // namespace

FoundContacts FindContacts(const RobotModel& model, const EvenMotion& motion, const std::vector<FootTrack>& feet,
                           const RepairOptions& options) {
  return ContactFinder(model, motion, feet, options).Run();
}

std::vector<RowRange> StancesOf(const std::vector<FootSet>& stance, int foot) {
  std::vector<RowRange> ranges;
  for (int k = 0; k < static_cast<int>(stance.size()); ++k) {
    if (!Contains(stance[Row(k)], foot)) continue;
    if (ranges.empty() || ranges.back().last != k - 1) ranges.push_back({k, k});
    ranges.back().last = k;
  }
  return ranges;
}

}  // namespace gaitwright
