// SPDX-License-Identifier: BSD-3-Clause
#include "workflows/compare/compare_motions.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "kinematics/base/options.h"
#include "kinematics/base/result.h"
#include "workflows/compare/compare_parts_internal.h"

namespace gaitwright {
namespace {

constexpr double kLittleAgreement = 0.5;  // an offset with less agreement is doubtful

std::vector<std::string> FootNames(const RobotModel& model) {
  std::vector<std::string> names;
  for (const Foot& foot : model.feet) names.push_back(foot.name);
  return names;
}

std::vector<std::string> OnlyIn(const std::vector<std::string>& names, const std::vector<std::string>& others) {
  std::vector<std::string> only;
  for (const std::string& name : names) {
    if (std::find(others.begin(), others.end(), name) == others.end()) only.push_back(name);
  }
  return only;
}

/// The joints whose positions a motion contains.
std::vector<std::string> JointNames(const ComparedMotion& motion) {
  std::vector<std::string> names;
  for (int d = 0; d < motion.model.num_dofs(); ++d) {
    if (motion.HasJoint(d)) names.push_back(motion.model.dof_names[static_cast<std::size_t>(d)]);
  }
  return names;
}

std::vector<NamedPair> CommonJoints(const ComparedMotion& a, const ComparedMotion& b) {
  std::vector<NamedPair> joints = CommonNames(a.model.dof_names, b.model.dof_names);
  std::erase_if(joints, [&](const NamedPair& joint) { return !a.HasJoint(joint.a) || !b.HasJoint(joint.b); });
  return joints;
}

/// Chooses the clock offset and records how it was chosen.
void Align(const ComparedMotion& a, const ComparedMotion& b, const CompareOptions& options,
           const std::vector<NamedPair>& joints, MotionComparison& comparison) {
  comparison.best_offset = BestOffset(a, b, joints);
  const bool foreign = a.foreign() || b.foreign();
  comparison.aligned_by = options.align != "auto" ? options.align : foreign ? "best" : "none";
  if (comparison.aligned_by == "start") comparison.offset_s = b.start_s() - a.start_s();
  if (comparison.aligned_by != "best") return;
  if (!comparison.best_offset) {
    comparison.aligned_by = "start";
    comparison.offset_s = b.start_s() - a.start_s();
    comparison.notes.emplace_back(
        "the clocks are aligned by start time, because no shared joint moves in both motions");
    return;
  }
  comparison.offset_s = comparison.best_offset->offset_s;
  if (comparison.best_offset->agreement >= kLittleAgreement) return;
  comparison.notes.push_back(
      fmt::format("the clock offset is uncertain: at the best one, the joint speeds correlate by only {:.2f} (1 is "
                  "identical); --align none or start does not use the motion",
                  comparison.best_offset->agreement));
}

/// Refuses motions that are too long: clocks are aligned on a uniform time grid, which would need too many points.
void CheckDuration(const ComparedMotion& motion) {
  const double duration_s = motion.end_s() - motion.start_s();
  if (duration_s <= kLongestMotion) return;
  throw InvalidArgument(
      fmt::format("'{}' lasts {:.6g} s; at most {:.0f} s can be compared", motion.name, duration_s, kLongestMotion));
}

double StepOf(const ComparedMotion& motion) {
  return motion.rows.size() > 1 ? (motion.end_s() - motion.start_s()) / (motion.rows.size() - 1) : 1.0;
}

/// The gaps of both sides on A's clock; overlapping gaps are merged.
std::vector<TimeGap> GapsOf(const ComparedMotion& a, const ComparedMotion& b, double offset_s) {
  std::vector<TimeGap> both = a.gaps, gaps;
  for (const TimeGap& gap : b.gaps) both.push_back({gap.start_s - offset_s, gap.end_s - offset_s});
  std::sort(both.begin(), both.end(), [](const TimeGap& x, const TimeGap& y) { return x.start_s < y.start_s; });
  for (const TimeGap& gap : both) {
    if (gaps.empty() || gap.start_s >= gaps.back().end_s) {
      gaps.push_back(gap);
    } else {
      gaps.back().end_s = std::max(gaps.back().end_s, gap.end_s);
    }
  }
  return gaps;
}

/// The times of the measured side's rows; for two plans, a grid with the step of the finer one. Without the times at
/// which a side has no rows.
std::vector<double> MomentsOf(const ComparedMotion& a, const ComparedMotion& b, const SharedTime& shared) {
  std::vector<double> times;
  if (a.plan && b.plan) {
    const double rate_hz = std::clamp(1.0 / std::min(StepOf(a), StepOf(b)), kLowestRate, kHighestRate);
    times = TimesAtRate(shared.start_s, shared.end_s, rate_hz);
    if (shared.end_s - times.back() > kSameTime_s) times.push_back(shared.end_s);
    return times;
  }
  const bool by_b = a.plan.has_value();
  for (const double own_s : by_b ? b.rows.time_s : a.rows.time_s) {
    const double time_s = by_b ? own_s - shared.offset_s : own_s;
    const bool within = time_s > shared.start_s - kSameTime_s && time_s < shared.end_s + kSameTime_s;
    if (within && !InGap(shared.gaps, time_s)) times.push_back(time_s);
  }
  return times;
}

SharedTime Share(const ComparedMotion& a, const ComparedMotion& b, double offset_s) {
  SharedTime shared;
  shared.offset_s = offset_s;
  shared.start_s = std::max(a.start_s(), b.start_s() - offset_s);
  shared.end_s = std::min(a.end_s(), b.end_s() - offset_s);
  shared.gaps = GapsOf(a, b, offset_s);
  shared.cycle_s = a.stances.empty() ? CycleOf(b) : CycleOf(a);
  if (shared.end_s > shared.start_s - kSameTime_s) shared.time_s = MomentsOf(a, b, shared);
  if (!shared.time_s.empty()) return shared;
  throw InvalidArgument(
      fmt::format("the motions do not overlap in time: '{}' is from {:.3f} to {:.3f} s, '{}' from {:.3f} to {:.3f} s, "
                  "and the second clock is {:.3f} s ahead; align them by 'start' or 'best'",
                  a.name, a.start_s(), a.end_s(), b.name, b.start_s(), b.end_s(), offset_s));
}

/// Adds a difference if one motion ends before the other. A log may continue after the end of its plan.
void CompareEnds(const ComparedMotion& a, const ComparedMotion& b, const SharedTime& shared, double tolerance,
                 std::vector<FirstDifference>& beyond) {
  const double end_a = a.end_s(), end_b = b.end_s() - shared.offset_s,
               least = std::max(tolerance * shared.cycle_s, kSameTime_s);
  const bool a_stops = end_a < end_b - least && (a.kind == b.kind || b.plan);
  const bool b_stops = end_b < end_a - least && (a.kind == b.kind || a.plan);
  if (a_stops || b_stops) beyond.push_back({"end of the motion", "s", shared.end_s, end_a, end_b, least});
}

void Order(const std::vector<SeriesDifference>& differences, std::vector<FirstDifference>& beyond) {
  for (const SeriesDifference& one : differences) {
    if (!one.first_s) continue;
    beyond.push_back(
        {one.quantity, one.unit, *one.first_s, one.first_a, one.first_b, one.first_tolerance, one.derived});
  }
  const auto ratio = [](const FirstDifference& one) {
    return one.tolerance > 0.0 ? std::abs(one.b - one.a) / one.tolerance : INFINITY;
  };
  std::stable_sort(beyond.begin(), beyond.end(), [&](const FirstDifference& one, const FirstDifference& other) {
    if (std::abs(one.time_s - other.time_s) > kSameTime_s) return one.time_s < other.time_s;
    if (one.derived != other.derived) return other.derived;
    return ratio(one) > ratio(other);
  });
  std::vector<FirstDifference> once;
  for (FirstDifference& one : beyond) {
    const bool known = std::any_of(once.begin(), once.end(), [&](const auto& o) { return o.quantity == one.quantity; });
    if (!known) once.push_back(std::move(one));
  }
  beyond = std::move(once);
}

/// Sorts the differences, given in the order of SeriesOf, into joints, base and balance. Quantities without values on
/// both sides are left out.
void TakeApart(const std::vector<SeriesDifference>& differences, const SharedTime& shared,
               MotionComparison& comparison) {
  std::size_t next = 0;
  for (const NamedPair& joint : shared.joints) {
    comparison.joints.push_back({joint.name, differences[next], differences[next + 1], differences[next + 2]});
    next += 3;
  }
  for (; next < differences.size(); ++next) {
    if (differences[next].samples == 0) continue;
    (differences[next].of_base ? comparison.base : comparison.balance).push_back(differences[next]);
  }
}

/// Adds a note on how computed speeds are compared.
void NoteDerivedSpeeds(const ComparedMotion& a, const ComparedMotion& b, MotionComparison& comparison) {
  const JointDifference* noisiest = nullptr;
  for (const JointDifference& joint : comparison.joints) {
    if (joint.speed.derived && (noisiest == nullptr || joint.speed.noise > noisiest->speed.noise)) noisiest = &joint;
  }
  if (noisiest == nullptr) return;
  const auto derives = [](const ComparedMotion& motion) {
    return std::find(motion.derived_speeds.begin(), motion.derived_speeds.end(), true) != motion.derived_speeds.end();
  };
  const SeriesDifference& speed = noisiest->speed;
  std::string note =
      fmt::format("speeds of {} are computed from positions", !derives(b) ? "A" : (derives(a) ? "A and B" : "B"));
  if (speed.noise > 0.0) {
    note += fmt::format(", whose noise adds {:.0f} standard deviations, up to {:.3g} {} ('{}'), to the tolerance",
                        kNoiseWidth, kNoiseWidth * speed.noise, speed.unit, noisiest->joint);
  }
  comparison.notes.push_back(std::move(note));
}

/// Adds a note on the feet that only one of the sides has.
void NoteFeetOfOneSide(const ComparedMotion& a, const ComparedMotion& b, std::vector<std::string>& notes) {
  const std::vector<std::string> feet_a = FootNames(a.model), feet_b = FootNames(b.model);
  for (const auto& [only, side] : {std::pair(OnlyIn(feet_a, feet_b), 'A'), std::pair(OnlyIn(feet_b, feet_a), 'B')}) {
    if (!only.empty())
      notes.push_back(
          fmt::format("contacts of feet that are only in {} are not compared: {}", side, fmt::join(only, ", ")));
  }
}

/// Adds the notes of one side, each once, since both sides may be the same file.
void AddNotes(const ComparedMotion& motion, std::vector<std::string>& notes) {
  for (const std::string& note : motion.notes) {
    if (std::find(notes.begin(), notes.end(), note) == notes.end()) notes.push_back(note);
  }
}

}  // namespace

OptionFields CompareOptions::Fields() {
  return {{"align",
           &align,
           "",
           0.0,
           0.0,
           "Alignment of the clocks: none, by start time, or by best match of the joint motions; auto: none "
           "between plans and logs, else best.",
           {"auto", "none", "start", "best"}},
          {"tolerance", &tolerance, "1", 0.0, 10.0,
           "Largest difference that counts as equal, as a share of each quantity's scale."}};
}

MotionComparison CompareMotions(const ComparedMotion& a, const ComparedMotion& b, const CompareOptions& options) {
  CompareOptions checked = options;
  CheckOptions(checked.Fields());
  CheckDuration(a);
  CheckDuration(b);
  MotionComparison comparison;
  comparison.name_a = a.name;
  comparison.name_b = b.name;
  comparison.kind_a = ComparedKindName(a.kind);
  comparison.kind_b = ComparedKindName(b.kind);
  comparison.robot_a = a.model.name;
  comparison.robot_b = b.model.name;
  const std::vector<NamedPair> joints = CommonJoints(a, b);
  comparison.joints_only_a = OnlyIn(JointNames(a), JointNames(b));
  comparison.joints_only_b = OnlyIn(JointNames(b), JointNames(a));
  Align(a, b, options, joints, comparison);
  SharedTime shared = Share(a, b, comparison.offset_s);
  shared.joints = joints;
  shared.feet = CommonNames(FootNames(a.model), FootNames(b.model));
  comparison.start_s = shared.start_s;
  comparison.end_s = shared.end_s;
  comparison.samples = static_cast<int>(shared.time_s.size());
  const double leg_m = std::max(a.model.leg_length_m(), b.model.leg_length_m());
  const std::vector<SeriesDifference> differences =
      DifferencesOf(SeriesOf(a, b, shared), shared, leg_m, options.tolerance, a.foreign() || b.foreign());
  TakeApart(differences, shared, comparison);
  comparison.feet = FeetDifferences(a, b, shared, options.tolerance, comparison.in_order);
  CompareEnds(a, b, shared, options.tolerance, comparison.in_order);
  Order(differences, comparison.in_order);
  comparison.figures = FiguresOf(a, b);
  comparison.words = WordsOf(a, b);
  AddNotes(a, comparison.notes);
  AddNotes(b, comparison.notes);
  NoteDerivedSpeeds(a, b, comparison);
  if (comparison.joints.empty()) comparison.notes.emplace_back("no joint is compared: no joint name is on both sides");
  if (comparison.base.empty()) comparison.notes.emplace_back("the base is not compared: one side has no data of it");
  if (comparison.feet.empty()) comparison.notes.emplace_back("contacts are not compared: one side has no data of them");
  if (!comparison.feet.empty()) NoteFeetOfOneSide(a, b, comparison.notes);
  return comparison;
}

}  // namespace gaitwright
