// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// What the audit lets pass, in one place; the words above Audit say it to its users.
namespace gaitwright::tolerance {

inline constexpr double kPosition = 1e-3;        ///< [m] of points that should be one
inline constexpr double kRotation = 1e-3;        ///< [rad] of frames that should be one
inline constexpr double kTime = 1e-6;            ///< [s] of times that should be one
inline constexpr double kRelative = 1e-6;        ///< of a limit, for rounding
inline constexpr double kSpeed = 0.01;           ///< [m/s] of a position against its rate, mean over a step
inline constexpr double kRate = 0.02;            ///< [rad/s] for angles
inline constexpr double kAcceleration = 1.0;     ///< [m/s^2] of the base's velocity against its rate
inline constexpr double kAngular = 100.0;        ///< [rad/s^2] for angles and joints
inline constexpr double kComAcceleration = 0.1;  ///< [m/s^2]
inline constexpr double kZmp = 2e-3;             ///< [m] of the reference against the multibody's
inline constexpr double kFrequency = 0.02;       ///< of sqrt(g / h)
inline constexpr double kGoalShare = 0.03;       ///< of the leg's length: accepted distance of the base from its start
inline constexpr double kGoalHeading = 0.02;     ///< [rad]
inline constexpr double kResidualShare = 0.02;   ///< of m g, and of m g h
inline constexpr double kCertain = 1e-3;         ///< of m g, and of m g h: below it contact forces give a wrench
inline constexpr double kEffortShare = 0.05;     ///< of a joint's effort limit
inline constexpr double kSupportLine = 2e-3;     ///< [m] within which a ZMP is on a line
inline constexpr double kCoplanar = 2e-3;        ///< [m] of contacts from the plane that makes them have a ZMP
inline constexpr double kOnPatchShare = 0.6;     ///< of a sole that must be on its surface
inline constexpr double kOnField = 5e-3;         ///< [m] of a sole from the highest of the height field under it
inline constexpr double kFieldTilt = 0.2;        ///< [rad] of a foothold against the height field around it
inline constexpr double kReferenceSlack = 5e-3;  ///< [m] for feet that roll after the reference was planned
inline constexpr double kPressureSlack = 1e-4;   ///< [m] of a centre of pressure outside of its sole
inline constexpr double kTouching = 1e-4;        ///< [m] below which a clearance counts as none
inline constexpr double kLeastLoad = 0.05;       ///< of m g: below it a centre of pressure or ZMP means nothing
inline constexpr double kSwingLoad = 5e-3;       ///< of m g: accepted load of a foot in its swing

}  // namespace gaitwright::tolerance
