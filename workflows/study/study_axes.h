// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "workflows/walk/walk.h"

namespace gaitwright {

/// All that one point of a study may set: the command (`speed`, `lateral_speed`, `yaw_rate`, `step_length`), what
/// shapes the plan, and how it is played. Keys are those of `walk`.
OptionFields StudyFields(WalkRequest& walk, PlayRequest& play);

/// The keys of the command among them.
OptionFields CommandFields(WalkRequest& walk);

/// Whether a key is of the command.
bool IsOfCommand(const std::string& key);

/// Whether a key shapes the plan; otherwise it is of the playback alone.
bool ShapesThePlan(const std::string& key);

/// What a study varies: an option and the values that it takes.
/// Always true: every value is one that the option accepts; a range has low < high and no values.
struct StudyAxis {
  std::string key, unit;
  std::vector<std::string> values;  ///< in their order; empty for a range
  double low = 0.0, high = 0.0;     ///< of a range, and of numbers
  bool numbers = true;              ///< the option is a number
  bool whole = false;               ///< a whole one

  bool is_range() const { return values.empty(); }
  bool operator==(const StudyAxis&) const = default;
};

/// How the points of a study are laid.
enum class StudyLayout {
  kGrid,     ///< every combination: KEY=FROM:TO:COUNT or KEY=a,b,c
  kSamples,  ///< points of a Halton sequence: KEY=FROM:TO or KEY=a,b,c
  kTuning,   ///< a search: KEY=FROM:TO
};

/// Reads an axis such as `gait.cycle_s=0.3:0.8:10`, `speed=0.1:1.2` or `stabilised.dcm_gain=1,1.3,2`.
/// @throws InvalidArgument naming the axis when it is none, the key is unknown (with the nearest), a value is not
/// accepted by the option, a range is empty or backward, or it has no form of the layout.
StudyAxis ParseAxis(const std::string& text, StudyLayout layout);

/// The axes of a study. @throws InvalidArgument as ParseAxis, when there is none, or a key is given twice.
std::vector<StudyAxis> ParseAxes(const std::vector<std::string>& texts, StudyLayout layout);

/// What the axes vary.
std::vector<std::string> KeysOf(const std::vector<StudyAxis>& axes);

/// One value for each axis, as text that the option reads.
using StudyPoint = std::vector<std::string>;

/// Most points of a grid or a sample.
inline constexpr std::size_t kMostStudyPoints = 1000000;

/// Every combination, the last axis running fastest. @throws InvalidArgument when they are over kMostStudyPoints.
std::vector<StudyPoint> GridPoints(const std::vector<StudyAxis>& axes);

/// The first `count` points of the Halton sequence of that seed between the ends of each axis; of a list each value
/// gets an equal share. @throws InvalidArgument for more axes than HaltonPoint takes.
std::vector<StudyPoint> SampledPoints(const std::vector<StudyAxis>& axes, std::size_t count, std::uint64_t seed);

/// The value at a share, from 0 to 1, of the way from one end of the axis to the other, to 6 digits.
std::string ValueAt(const StudyAxis& axis, double share);

/// A value of an axis of numbers, as a number. @throws InvalidArgument for what is none.
double NumberOfValue(const std::string& value);

/// Puts a point into the requests. @throws InvalidArgument as SetOption.
void ApplyPoint(const std::vector<StudyAxis>& axes, const StudyPoint& point, WalkRequest& walk, PlayRequest& play);

/// "speed=0.5, gait.cycle_s=0.4"
std::string PointText(const std::vector<StudyAxis>& axes, const StudyPoint& point);

}  // namespace gaitwright
