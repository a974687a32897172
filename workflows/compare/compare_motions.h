// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "workflows/compare/time_alignment.h"
#include "workflows/exchange/compared_motion.h"

namespace gaitwright {

/// How two motions are set side by side.
struct CompareOptions {
  std::string align = "auto";  ///< "none", "start", "best"; "auto" is best where one is a table, whose clock is its own
  double tolerance = 0.05;     ///< share of each figure's scale (docs/compare.md) up to which it is the same

  /// The fields, for flags and range checks.
  OptionFields Fields();
};

/// How one figure differs over the time that two motions share.
struct SeriesDifference {
  std::string quantity, unit;                   ///< "position of FL_hip_joint", "rad"
  int samples = 0;                              ///< at which both have it; 0 for none
  double rms = 0.0, largest = 0.0, at_s = 0.0;  ///< largest magnitude, and when on A's clock
  double tolerance = 0.0;                       ///< beyond it the two differ, where noise is as in most rows
  double noise = 0.0;                           ///< standard deviation of what is measured; it widens the tolerance
  bool derived = false;                         ///< a speed that is worked out from positions
  std::optional<double> first_s = {};           ///< when it first differs; nothing where it never does
  double first_a = 0.0, first_b = 0.0, first_tolerance = 0.0;  ///< what both have then, and what is let pass there
};

/// A joint that both have.
struct JointDifference {
  std::string joint;
  SeriesDifference position, speed, torque;
};

/// The times of contact of a foot that both have.
struct FootDifference {
  std::string foot;
  int stances_a = 0, stances_b = 0;  ///< within the time that both share
  int unmatched = 0;                 ///< that overlap none of the other's
  SeriesDifference timing;           ///< of touch-downs and lift-offs, B - A [s]
};

/// What differed first: of several at one time what is measured before what is worked out from it, then the one
/// furthest beyond its tolerance.
struct FirstDifference {
  std::string quantity, unit;
  double time_s = 0.0;  ///< on A's clock
  double a = 0.0, b = 0.0, tolerance = 0.0;
  bool derived = false;  ///< a speed that is worked out from positions
};

/// A figure of each side; nothing where a side has none.
struct FigurePair {
  std::string key, unit;
  std::optional<double> a, b;
};

/// Something that is told in words and is not the same.
struct WordDifference {
  std::string key, a, b;
  /// 'a' or 'b' for one of the options of a group (their keys up to the last dot) of which only that side has any.
  char only = ' ';
};

/// Two motions side by side. Differences are B - A.
struct MotionComparison {
  std::string name_a, name_b, kind_a, kind_b, robot_a, robot_b;
  std::string aligned_by;                       ///< "none", "start" or "best"
  double offset_s = 0.0;                        ///< time of B minus time of A at the same moment, as compared
  std::optional<ClockOffset> best_offset = {};  ///< what the joints' motion says, whether it was taken or not
  double start_s = 0.0, end_s = 0.0;            ///< what both share, on A's clock
  int samples = 0;
  std::vector<JointDifference> joints;
  std::vector<std::string> joints_only_a, joints_only_b;
  std::vector<SeriesDifference> base;     ///< x, y, z, and the angle between the two attitudes
  std::vector<SeriesDifference> balance;  ///< centre of mass; of two plans the zero-moment point too
  std::vector<FootDifference> feet;
  std::vector<FigurePair> figures;
  std::vector<WordDifference> words;      ///< robots, gaits, options, provenance
  std::vector<FirstDifference> in_order;  ///< what differed first, and then; each quantity once
  std::vector<std::string> notes;

  /// Nothing is beyond its tolerance.
  bool same() const { return in_order.empty(); }
};

/// Sets two motions side by side at the times of the measured one, of two plans at the finer grid of both, as far as
/// they share time. A torque that is a mean over a log's interval is held against the plan's at the middle of it.
/// @throws InvalidArgument for options out of range, a motion of more than an hour, and motions that share no time.
MotionComparison CompareMotions(const ComparedMotion& a, const ComparedMotion& b, const CompareOptions& options = {});

}  // namespace gaitwright
