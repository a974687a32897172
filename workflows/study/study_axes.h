// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "workflows/walk/walk.h"

namespace gaitwright {

/// Everything that one point of a study may set: the command (`speed`, `lateral_speed`, `yaw_rate`, `step_length`),
/// options of the plan and options of the playback. Keys are those of `walk`.
OptionFields StudyFields(WalkRequest& walk, PlayRequest& play);

/// The fields of StudyFields that belong to the command.
OptionFields CommandFields(WalkRequest& walk);

/// Whether a key belongs to the command.
bool IsOfCommand(const std::string& key);

/// Whether a key affects the plan; otherwise it affects only the playback.
bool ShapesThePlan(const std::string& key);

/// A varied option of a study and its values. Invariant: the option accepts every value; a range has low < high and no
/// values.
struct StudyAxis {
  std::string key, unit;
  std::vector<std::string> values;  ///< in their order; empty for a range
  double low = 0.0, high = 0.0;     ///< ends of a range, or extremes of a list of numbers
  bool numbers = true;              ///< the option is a number
  bool whole = false;               ///< the option is a whole number

  bool is_range() const { return values.empty(); }
  bool operator==(const StudyAxis&) const = default;
};

/// Layout of a study's points.
enum class StudyLayout {
  kGrid,     ///< every combination: KEY=FROM:TO:COUNT or KEY=a,b,c
  kSamples,  ///< points of a Halton sequence: KEY=FROM:TO or KEY=a,b,c
  kTuning,   ///< a search: KEY=FROM:TO
};

/// Reads an axis such as `gait.cycle_s=0.3:0.8:10`, `speed=0.1:1.2` or `stabilised.dcm_gain=1,1.3,2`.
/// @throws InvalidArgument that names the axis if it is malformed, its key is unknown (with the nearest), the option
/// does not accept a value, a range is empty or reversed, or its form does not fit the layout.
StudyAxis ParseAxis(const std::string& text, StudyLayout layout);

/// The axes of a study. @throws InvalidArgument as ParseAxis does, and if there is no axis or a key is given twice.
std::vector<StudyAxis> ParseAxes(const std::vector<std::string>& texts, StudyLayout layout);

/// Keys that the axes vary.
std::vector<std::string> KeysOf(const std::vector<StudyAxis>& axes);

/// One value for each axis, as text that the option reads.
using StudyPoint = std::vector<std::string>;

/// Largest number of points of a grid or a sample.
inline constexpr std::size_t kMostStudyPoints = 1000000;

/// Every combination; the last axis varies fastest. @throws InvalidArgument for more than kMostStudyPoints.
std::vector<StudyPoint> GridPoints(const std::vector<StudyAxis>& axes);

/// The first `count` points of the Halton sequence for this seed, between the ends of each axis; each value of a list
/// gets an equal share. @throws InvalidArgument for more axes than HaltonPoint accepts.
std::vector<StudyPoint> SampledPoints(const std::vector<StudyAxis>& axes, std::size_t count, std::uint64_t seed);

/// The value at a fraction from 0 to 1 between the ends of the axis, to 6 digits.
std::string ValueAt(const StudyAxis& axis, double share);

/// A value of an axis of numbers, as a number. @throws InvalidArgument for text that is not a number.
double NumberOfValue(const std::string& value);

/// Puts a point into the requests. @throws InvalidArgument as SetOption does.
void ApplyPoint(const std::vector<StudyAxis>& axes, const StudyPoint& point, WalkRequest& walk, PlayRequest& play);

/// "speed=0.5, gait.cycle_s=0.4"
std::string PointText(const std::vector<StudyAxis>& axes, const StudyPoint& point);

}  // namespace gaitwright
