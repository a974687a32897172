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
  kValue,   ///< replaces it; only one such key may be given
};

/// A quantity that can be disturbed: meaning of its key and accepted values.
struct DisturbanceRule {
  std::string key;     ///< ends in its SI unit; keys of start.*, sensors.* and pushes are given without the group
  std::string option;  ///< option of the playback that it changes; "" if it changes several
  std::string unit;
  double lowest = 0.0, highest = 0.0;
  std::string meaning;
  DisturbanceEffect effect = DisturbanceEffect::kValue;
  bool whole = false;  ///< a whole number
};

/// All quantities except those of pushes and sensors, in the order of output.
const std::vector<DisturbanceRule>& DisturbanceRules();

/// Quantities of one push, without the push's name. `place` is a word.
const std::vector<DisturbanceRule>& PushRules();

/// Key and distribution of one quantity.
struct Disturbance {
  std::string key;
  Distribution distribution;

  bool operator==(const Disturbance&) const = default;
};

/// A push that acts in every trial: distributions by key of PushRules(); omitted keys have the default of their rule.
using DisturbedPush = std::vector<Disturbance>;

/// Whether the push has a quantity with this key.
bool HasFigure(const DisturbedPush& push, const std::string& key);

/// Disturbances that trials sample. Omitted quantities are as in the plan.
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

/// YAML text that ReadDisturbances reads back to the same value. Deterministic to the byte.
std::string DisturbancesText(const Disturbances& disturbances);

/// Options of a playback that a trial may change from zero.
std::vector<std::string> DrawnOptions(const Disturbances& disturbances);

/// Keys of the sampled quantities that replace one of these options of the playback.
std::vector<std::string> DrawnInPlaceOf(const Disturbances& disturbances, const std::vector<std::string>& options);

/// The default disturbances of trials: uncertainties of the robot, and pushes, scaled to its leg length and weight.
///   mass, inertia, gains within 10 %, motors down to 90 %, centre of mass of the base within 3 % of the leg length,
///   friction 0.5 to 1.0, slope up to 2 degrees in any direction, bumps up to 1 % of the leg length, commands delayed
///   by up to 4 ms, start within 1 % of the leg length and 0.02 rad, joints within 0.01 rad; one push of up to 10 % of
///   the weight in any direction, for 0.1 s, at a time between 10 % and 90 % of the plan.
Disturbances StandardDisturbances(const RobotModel& model);

/// A sampled value.
struct SampledValue {
  std::string name = {};  ///< the key; "push1.size_n" for a push, "start.joint.NAME_rad" for a joint's start
  std::string unit = {};
  double value = 0.0;
  std::string word = {};  ///< instead of the value, for words

  bool operator==(const SampledValue&) const = default;
};

/// A sampled value and the option of the playback that it changes.
struct DrawnOption {
  std::string key;
  double value = 0.0;
  DisturbanceEffect effect = DisturbanceEffect::kValue;

  bool operator==(const DrawnOption&) const = default;
};

/// Disturbances of one trial.
struct SampledTrial {
  std::uint64_t seed = 0;
  std::vector<SampledValue> values;  ///< all sampled values, for the record
  std::vector<DrawnOption> options;
  double sensor_noise_scale = 1.0;  ///< factor on noise, bias and bias random walk of the sensors
  std::vector<TimedPush> pushes;
  VectorX start_joints;  ///< see PlayOptions; empty if no joint is moved
  int noise_seed = 0;    ///< of bumps and sensors
};

/// Draws a trial: a pure function of its arguments. Directions of pushes are relative to the planned heading of the
/// base when they begin. A sampled direction is also recorded by its components, which can be ranked, unlike an angle:
/// `ahead_n` and `left_n` of pushes, and `ground_slope_x_deg` and `ground_slope_y_deg` of the ground, its slope along x
/// and y of W. If only the direction of a slope is sampled, its cosine and sine are recorded.
/// @throws InvalidArgument if a push is on a link that the robot does not have, or could exceed 1e5 N.
SampledTrial SampleTrial(const Disturbances& disturbances, const RobotModel& model, const MotionPlan& plan,
                         std::uint64_t seed);

/// End of the ranges of all distributions.
enum class RangeEnd { kLowest, kHighest };

/// The trial with all values at one end of their ranges. If both such trials can be played, any seed can be played. For
/// a plan without motion, relative push times are zero.
/// @throws InvalidArgument as SampleTrial does.
SampledTrial ExtremeTrial(const Disturbances& disturbances, const RobotModel& model, const MotionPlan& plan,
                          RangeEnd end);

}  // namespace gaitwright
