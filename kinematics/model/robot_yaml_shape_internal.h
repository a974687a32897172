// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>

#include "kinematics/base/data_shape.h"

namespace gaitwright {

inline constexpr double kLongestPart = 1e3;   ///< [m]
inline constexpr double kLargestValue = 1e9;  ///< of a limit, a gain or a value of a motor, in its unit
inline constexpr std::size_t kMaxSoleCorners = 100;
inline constexpr std::size_t kMostShared = 8;  ///< joints of one transmission
inline constexpr double kLargestRatio = 1e6;
inline constexpr double kFastestWalk = 100.0;  ///< [m/s]

// Keys of the parts of a robot.yaml.
DataShape FootYamlShape();
DataShape LegYamlShape();
DataShape LimitsYamlShape();
DataShape GainsYamlShape();
DataShape MotorYamlShape();
DataShape TransmissionYamlShape();
DataShape TransmissionMotorYamlShape();

}  // namespace gaitwright
