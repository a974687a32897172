// SPDX-License-Identifier: BSD-3-Clause
// What CompareMotions is made of.
#pragma once

#include <string>
#include <vector>

#include "workflows/compare/compare_motions.h"

namespace gaitwright {

/// [s] Times nearer than this are one time.
inline constexpr double kSameTime_s = 1e-9;

/// What the tolerance of a series scales with.
enum class SeriesScale { kPosition, kSpeed, kTorque, kLength, kAngle };

/// A figure of both motions at the same moments; not a number where one has none.
struct ComparedSeries {
  std::string quantity, unit;
  SeriesScale scale = SeriesScale::kLength;
  std::vector<double> a, b;
  double resolution = 0.0;              ///< the coarser of the two sides', of a position that is measured
  std::vector<double> noise_gain = {};  ///< of a speed that is worked out: by what the noise of positions counts [1/s]
};

/// The moments at which two motions are compared, and which joints and feet are held against each other.
struct SharedTime {
  double offset_s = 0.0, start_s = 0.0, end_s = 0.0, cycle_s = 1.0;  ///< on A's clock; a cycle of the gait
  std::vector<double> time_s;
  std::vector<TimeGap> gaps;  ///< in which a side has no rows, on A's clock, in order
  std::vector<NamedPair> joints, feet;
};

/// The series of a pair of motions in this order: position, speed, torque of each joint; base x, y, z, attitude; centre
/// of mass x, y, z; zero-moment point x, y.
std::vector<ComparedSeries> SeriesOf(const ComparedMotion& a, const ComparedMotion& b, const SharedTime& shared);

/// How each series differs; tolerances are `tolerance` times scales that docs/compare.md names.
/// @param noisy  a side was measured: what noise does within kNoiseWidth standard deviations of it is no difference.
std::vector<SeriesDifference> DifferencesOf(const std::vector<ComparedSeries>& series, const SharedTime& shared,
                                            double leg_length_m, double tolerance, bool noisy);

/// By how many standard deviations of the noise tolerances are widened.
inline constexpr double kNoiseWidth = 5.0;

/// How the times of contact differ, by foot; appends what is beyond the tolerance.
std::vector<FootDifference> FeetDifferences(const ComparedMotion& a, const ComparedMotion& b, const SharedTime& shared,
                                            double tolerance, std::vector<FirstDifference>& beyond);

/// Mean time between touch-downs of one foot; 1 s where no foot touches down twice.
double CycleOf(const ComparedMotion& motion);

/// Figures of each, and what is told in words and differs.
std::vector<FigurePair> FiguresOf(const ComparedMotion& a, const ComparedMotion& b);
std::vector<WordDifference> WordsOf(const ComparedMotion& a, const ComparedMotion& b);

}  // namespace gaitwright
