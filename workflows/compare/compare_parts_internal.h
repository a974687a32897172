// SPDX-License-Identifier: BSD-3-Clause
// Parts of CompareMotions.
#pragma once

#include <string>
#include <vector>

#include "workflows/compare/compare_motions.h"

namespace gaitwright {

/// [s] Times that differ by less are equal.
inline constexpr double kSameTime_s = 1e-9;

/// The quantity that sets the scale of a series' tolerance.
enum class SeriesScale { kPosition, kSpeed, kTorque, kLength, kAngle };

/// A quantity of both motions at the same times; NaN where a motion has no value.
struct ComparedSeries {
  std::string quantity, unit;
  SeriesScale scale = SeriesScale::kLength;
  std::vector<double> a, b;
  double resolution = 0.0;              ///< of a measured position: the coarser resolution of the two sides
  std::vector<double> noise_gain = {};  ///< of a computed speed: its noise per position noise [1/s]
  bool of_base = false;
};

/// The times at which two motions are compared, and the joints and feet that both have.
struct SharedTime {
  double offset_s = 0.0, start_s = 0.0, end_s = 0.0, cycle_s = 1.0;  ///< on A's clock; a cycle of the gait
  std::vector<double> time_s;
  std::vector<TimeGap> gaps;  ///< time ranges in which a side has no rows, on A's clock, in order
  std::vector<NamedPair> joints, feet;
};

/// The series of a pair of motions in this order: position, speed, torque of each joint; base x, y, z, attitude; centre
/// of mass x, y, z; zero-moment point x, y.
std::vector<ComparedSeries> SeriesOf(const ComparedMotion& a, const ComparedMotion& b, const SharedTime& shared);

/// The difference of each series; tolerances are `tolerance` times the scales in docs/compare.md.
/// @param noisy  a side was measured: tolerances are widened by kNoiseWidth standard deviations of its noise.
std::vector<SeriesDifference> DifferencesOf(const std::vector<ComparedSeries>& series, const SharedTime& shared,
                                            double leg_length_m, double tolerance, bool noisy);

/// Number of standard deviations of the noise by which tolerances are widened.
inline constexpr double kNoiseWidth = 5.0;

/// The differences of contact times, by foot; appends those beyond the tolerance.
std::vector<FootDifference> FeetDifferences(const ComparedMotion& a, const ComparedMotion& b, const SharedTime& shared,
                                            double tolerance, std::vector<FirstDifference>& beyond);

/// Mean time between touch-downs of one foot; 1 s if no foot touches down twice.
double CycleOf(const ComparedMotion& motion);

/// The numbers of both sides, and the texts that differ.
std::vector<FigurePair> FiguresOf(const ComparedMotion& a, const ComparedMotion& b);
std::vector<WordDifference> WordsOf(const ComparedMotion& a, const ComparedMotion& b);

}  // namespace gaitwright
