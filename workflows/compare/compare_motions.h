// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "workflows/compare/time_alignment.h"
#include "workflows/exchange/compared_motion.h"

namespace gaitwright {

/// Options of a comparison of two motions.
struct CompareOptions {
  std::string align = "auto";  ///< "none", "start", "best"; "auto" is best if one is a table, which has its own clock
  double tolerance = 0.05;     ///< share of each quantity's scale (docs/compare.md) up to which values count as equal

  /// The fields, for flags and range checks.
  OptionFields Fields();
};

/// Difference of one quantity over the time that two motions share.
struct SeriesDifference {
  std::string quantity, unit;                   ///< "position of FL_hip_joint", "rad"
  int samples = 0;                              ///< samples with values on both sides; 0 for none
  double rms = 0.0, largest = 0.0, at_s = 0.0;  ///< largest magnitude and its time on A's clock
  double tolerance = 0.0;                       ///< tolerance for rows with typical noise
  double noise = 0.0;                           ///< standard deviation of the measurement, which widens the tolerance
  bool derived = false;                         ///< a speed computed from positions
  bool of_base = false;                         ///< place or attitude of the base
  std::optional<double> first_s = {};           ///< time of the first difference; nothing if there is none
  double first_a = 0.0, first_b = 0.0, first_tolerance = 0.0;  ///< both values at that time, and the tolerance there
};

/// A joint on both sides.
struct JointDifference {
  std::string joint;
  SeriesDifference position, speed, torque;
};

/// Contact times of a foot on both sides.
struct FootDifference {
  std::string foot;
  int stances_a = 0, stances_b = 0;  ///< within the time that both share
  int unmatched = 0;                 ///< stances that overlap with none of the other side
  SeriesDifference timing;           ///< times of touch-down and lift-off, B - A [s]
};

/// The first difference: at equal times, measured quantities before computed ones, then the one farthest beyond its
/// tolerance.
struct FirstDifference {
  std::string quantity, unit;
  double time_s = 0.0;  ///< on A's clock
  double a = 0.0, b = 0.0, tolerance = 0.0;
  bool derived = false;  ///< a speed computed from positions
};

/// A value of each side; nothing if a side has none.
struct FigurePair {
  std::string key, unit;
  std::optional<double> a, b;
};

/// A difference in a text value.
struct WordDifference {
  std::string key, a, b;
  /// 'a' or 'b' for an option of a group (keys up to the last dot) that only this side has.
  char only = ' ';
};

/// Comparison of two motions. Differences are B - A.
struct MotionComparison {
  std::string name_a, name_b, kind_a, kind_b, robot_a, robot_b;
  std::string aligned_by;                       ///< "none", "start" or "best"
  double offset_s = 0.0;                        ///< time of B minus time of A at the same moment, as used
  std::optional<ClockOffset> best_offset = {};  ///< offset by the joint motion, even if it is not used
  double start_s = 0.0, end_s = 0.0;            ///< shared time range, on A's clock
  int samples = 0;
  std::vector<JointDifference> joints;
  std::vector<std::string> joints_only_a, joints_only_b;
  std::vector<SeriesDifference> base;     ///< x, y, z, and the angle between the two attitudes
  std::vector<SeriesDifference> balance;  ///< centre of mass; for two plans also the zero-moment point
  std::vector<FootDifference> feet;
  std::vector<FigurePair> figures;
  std::vector<WordDifference> words;      ///< robots, gaits, options, provenance
  std::vector<FirstDifference> in_order;  ///< first difference of each quantity, in order of time
  std::vector<std::string> notes;

  /// True if all differences are within tolerance.
  bool same() const { return in_order.empty(); }
};

/// Compares two motions at the times of the measured one (two plans: at the finer grid) within their shared time. A
/// mean torque over a log's interval is compared with the plan's torque at the middle of the interval.
/// @throws InvalidArgument for options out of range, a motion of more than an hour, and motions without shared time.
MotionComparison CompareMotions(const ComparedMotion& a, const ComparedMotion& b, const CompareOptions& options = {});

}  // namespace gaitwright
