// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>

#include "playback/score/contact_timing.h"
#include "workflows/compare/compare_parts_internal.h"

namespace gaitwright {
namespace {

double Overlap(const ContactInterval& a, const ContactInterval& b) {
  return std::min(a.end_s, b.end_s) - std::max(a.start_s, b.start_s);
}

/// The intervals that overlap with the shared time range, moved to A's clock.
std::vector<ContactInterval> Shared(const std::vector<ContactInterval>& stances, double offset_s,
                                    const SharedTime& shared) {
  std::vector<ContactInterval> within;
  for (const ContactInterval& stance : stances) {
    const ContactInterval moved{stance.start_s - offset_s, stance.end_s - offset_s};
    if (moved.end_s > shared.start_s + kSameTime_s && moved.start_s < shared.end_s - kSameTime_s)
      within.push_back(moved);
  }
  return within;
}

/// The stance with the largest overlap, or null.
const ContactInterval* Partner(const ContactInterval& stance, const std::vector<ContactInterval>& others) {
  const ContactInterval* best = nullptr;
  for (const ContactInterval& other : others) {
    if (Overlap(stance, other) > (best == nullptr ? 0.0 : Overlap(stance, *best))) best = &other;
  }
  return best;
}

/// Compares the contact times of one foot.
class FootTimes {
 public:
  FootTimes(const SharedTime& shared, double tolerance_s, FootDifference& foot, std::vector<FirstDifference>& beyond)
      : shared_(shared), tolerance_s_(tolerance_s), foot_(foot), beyond_(beyond) {
    foot_.timing.quantity = "contact of " + foot_.foot;
    foot_.timing.unit = "s";
    foot_.timing.tolerance = tolerance_s;
  }

  void Match(const std::vector<ContactInterval>& a, const std::vector<ContactInterval>& b) {
    foot_.stances_a = static_cast<int>(a.size());
    foot_.stances_b = static_cast<int>(b.size());
    for (const ContactInterval& stance : a) {
      const ContactInterval* partner = Partner(stance, b);
      if (partner == nullptr) {
        Missing(stance, 1.0, 0.0);
        continue;
      }
      Event("touch-down", stance.start_s, partner->start_s);
      Event("lift-off", stance.end_s, partner->end_s);
    }
    for (const ContactInterval& stance : b) {
      if (Partner(stance, a) == nullptr) Missing(stance, 0.0, 1.0);
    }
    SeriesDifference& timing = foot_.timing;
    if (timing.samples > 0) timing.rms = std::sqrt(timing.rms / timing.samples);
  }

 private:
  bool Inside(double time_s) const {
    return time_s > shared_.start_s + tolerance_s_ && time_s < shared_.end_s - tolerance_s_;
  }

  /// Whether the rows determine the time of an event: false in a gap of either side and at the end of a gap, where it
  /// may be late.
  bool Known(double time_s) const {
    return std::none_of(shared_.gaps.begin(), shared_.gaps.end(), [&](const TimeGap& gap) {
      return time_s > gap.start_s - kSameTime_s && time_s < gap.end_s + kSameTime_s;
    });
  }

  /// Duration of the part of a stance for which both sides have rows.
  double KnownPart(const ContactInterval& stance) const {
    double part_s = stance.end_s - stance.start_s;
    for (const TimeGap& gap : shared_.gaps) part_s -= std::max(0.0, Overlap(stance, {gap.start_s, gap.end_s}));
    return part_s;
  }

  void Event(const char* what, double a_s, double b_s) {
    if ((!Inside(a_s) && !Inside(b_s)) || !Known(a_s) || !Known(b_s)) return;
    SeriesDifference& timing = foot_.timing;
    const double late_s = b_s - a_s;
    ++timing.samples;
    timing.rms += late_s * late_s;
    if (std::abs(late_s) > std::abs(timing.largest)) {
      timing.largest = late_s;
      timing.at_s = a_s;
    }
    if (std::abs(late_s) > tolerance_s_) Beyond(std::string(what) + " of " + foot_.foot, "s", a_s, b_s);
  }

  /// Adds a stance that the other side does not have.
  void Missing(const ContactInterval& stance, double a, double b) {
    if (KnownPart(stance) < std::max(TimingGate(), tolerance_s_)) return;
    ++foot_.unmatched;
    const double at_s = std::max(stance.start_s, shared_.start_s);
    beyond_.push_back({"contact of " + foot_.foot, "1", at_s, a, b, 0.0});
    Note(at_s);
  }

  void Beyond(const std::string& quantity, const char* unit, double a_s, double b_s) {
    const double at_s = std::max(std::min(a_s, b_s), shared_.start_s);
    beyond_.push_back({quantity, unit, at_s, a_s, b_s, tolerance_s_});
    Note(at_s);
  }

  void Note(double at_s) {
    if (!foot_.timing.first_s || at_s < *foot_.timing.first_s) foot_.timing.first_s = at_s;
  }

  const SharedTime& shared_;
  double tolerance_s_;
  FootDifference& foot_;
  std::vector<FirstDifference>& beyond_;
};

}  // namespace

std::vector<FootDifference> FeetDifferences(const ComparedMotion& a, const ComparedMotion& b, const SharedTime& shared,
                                            double tolerance, std::vector<FirstDifference>& beyond) {
  std::vector<FootDifference> feet;
  if (a.stances.empty() || b.stances.empty()) return feet;
  const double tolerance_s = std::max(tolerance * shared.cycle_s, kSameTime_s);
  for (const NamedPair& pair : shared.feet) {
    feet.emplace_back();
    feet.back().foot = pair.name;
    FootTimes(shared, tolerance_s, feet.back(), beyond)
        .Match(Shared(a.stances[static_cast<std::size_t>(pair.a)], 0.0, shared),
               Shared(b.stances[static_cast<std::size_t>(pair.b)], shared.offset_s, shared));
  }
  return feet;
}

double CycleOf(const ComparedMotion& motion) {
  double sum = 0.0;
  int count = 0;
  for (const std::vector<ContactInterval>& stances : motion.stances) {
    for (std::size_t i = 2; i < stances.size(); ++i) {  // the first stance began before the motion
      sum += stances[i].start_s - stances[i - 1].start_s;
      ++count;
    }
  }
  return count > 0 ? sum / count : 1.0;
}

}  // namespace gaitwright
