// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "kinematics/base/options.h"
#include "kinematics/base/result.h"
#include "kinematics/model/robot_model.h"
#include "planning/plan/motion_plan.h"
#include "playback/play/play.h"
#include "playback/trials/distribution.h"

namespace gaitwright {

/// How a sampled value is combined with the value of its option.
enum class DisturbanceEffect {
  kFactor,  ///< multiplies it
  kOffset,  ///< is added to it
  kValue,   ///< replaces it; only one of them may be given
};

/// A quantity that can be disturbed: meaning of its key and accepted values.
struct DisturbanceRule {
  std::string key;     ///< ends in its SI unit; start.*, sensors.* and of pushes their own part of it
  std::string option;  ///< option of the playback that it changes; "" if it changes several
  std::string unit;
  double lowest = 0.0, highest = 0.0;
  std::string meaning;
  DisturbanceEffect effect = DisturbanceEffect::kValue;
  bool whole = false;  ///< a whole number
};

/// Every figure but those of pushes and of sensors, in the order in which they are written.
const std::vector<DisturbanceRule>& DisturbanceRules();

/// Those of one push, without the push's name before them. `place` is a word.
const std::vector<DisturbanceRule>& PushRules();

/// One figure's key and how it is drawn.
struct Disturbance {
  std::string key;
  Distribution distribution;

  bool operator==(const Disturbance&) const = default;
};

/// A push of every trial: distributions by key of PushRules(), each that is left out as its rule says.
using DisturbedPush = std::vector<Disturbance>;

/// True when the push has a figure of that key.
bool HasFigure(const DisturbedPush& push, const std::string& key);

/// Disturbances that trials sample. Omitted ones are as in the plan.
struct Disturbances {
  std::vector<Disturbance>
      figures;  ///< in the order of the file, keys such as "mass_scale" or "sensors.encoder_noise_rad"
  std::vector<DisturbedPush> pushes;

  bool operator==(const Disturbances&) const = default;
};

/// Reads disturbances from YAML, see docs/trials.md. Refused with the line: invalid YAML, unknown keys (the nearest is
/// named), duplicate keys, invalid or out-of-range distributions, and pairs of keys that set the same value.
/// @param sensors  fields of the sensors, whose keys may stand under `sensors`
/// @param source   names the text in messages.
Result<Disturbances> ReadDisturbances(const std::string& text, const OptionFields& sensors, const std::string& source);

/// Reads disturbances from a file.
Result<Disturbances> LoadDisturbances(const std::string& path, const OptionFields& sensors);

/// As YAML that ReadDisturbances reads to the same. Deterministic to the byte.
std::string DisturbancesText(const Disturbances& disturbances);

/// The options of a playback that some trial may move off zero.
std::vector<std::string> DrawnOptions(const Disturbances& disturbances);

/// The keys of the figures that are drawn in place of one of these options of the playback.
std::vector<std::string> DrawnInPlaceOf(const Disturbances& disturbances, const std::vector<std::string>& options);

/// The default disturbances of trials: the robot's uncertainties and pushes, scaled to its legs and its weight.
///   mass, inertia, gains within 10 %, motors down to 90 %, centre of mass of the base within 3 % of the leg's length,
///   friction 0.5 to 1.0, slope to 2 degrees any way, bumps to 1 % of the leg's length, commands late by up to 4 ms,
///   start within 1 % of the leg's length, 0.02 rad, joints within 0.01 rad; one push of up to a tenth of the weight,
///   any way, for 0.1 s, at any time between a tenth and nine tenths of the plan.
Disturbances StandardDisturbances(const RobotModel& model);

/// One value that was drawn.
struct SampledValue {
  std::string name = {};  ///< the key; of the i-th push "push1.size_n"; of a start "start.joint.NAME_rad"
  std::string unit = {};
  double value = 0.0;
  std::string word = {};  ///< instead of the value, for words

  bool operator==(const SampledValue&) const = default;
};

/// A drawn value and the option of the playback that it goes into.
struct DrawnOption {
  std::string key;
  double value = 0.0;
  DisturbanceEffect effect = DisturbanceEffect::kValue;

  bool operator==(const DrawnOption&) const = default;
};

/// Disturbances of one trial.
struct SampledTrial {
  std::uint64_t seed = 0;
  std::vector<SampledValue> values;  ///< all that was drawn, for the record
  std::vector<DrawnOption> options;
  double sensor_noise_scale = 1.0;  ///< on noise, bias and walk of the sensors that are set
  std::vector<TimedPush> pushes;
  VectorX start_joints;  ///< see PlayOptions; empty if no joint is moved
  int noise_seed = 0;    ///< of bumps and of sensors
};

/// Draws a trial: a pure function of its arguments. Directions of pushes are as the planned base heads when they begin.
/// A direction that is drawn is told by its parts too, which can be ranked where an angle cannot: of pushes `ahead_n`
/// and `left_n`, of the ground's slope `ground_slope_x_deg` and `ground_slope_y_deg`, how steeply it rises along x and
/// y of W; where only the direction of a slope is drawn, its cosine and sine.
/// @throws InvalidArgument when a push is on a link that the robot does not have, or could be over 1e5 N.
SampledTrial SampleTrial(const Disturbances& disturbances, const RobotModel& model, const MotionPlan& plan,
                         std::uint64_t seed);

/// Which end of all distributions.
enum class RangeEnd { kLowest, kHighest };

/// The trial in which everything is as low, or as high, as it can come out: what can be played with both, can be played
/// with any seed. A plan without motion leaves the times of pushes at their shares of nothing.
/// @throws InvalidArgument as SampleTrial does.
SampledTrial ExtremeTrial(const Disturbances& disturbances, const RobotModel& model, const MotionPlan& plan,
                          RangeEnd end);

}  // namespace gaitwright
