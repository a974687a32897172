// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// Tolerances of the audit; the docstring of Audit describes them for users.
namespace gaitwright::tolerance {

inline constexpr double kPosition = 1e-3;        ///< [m] of points that should coincide
inline constexpr double kRotation = 1e-3;        ///< [rad] of frames that should coincide
inline constexpr double kTime = 1e-6;            ///< [s] of times that should be equal
inline constexpr double kRelative = 1e-6;        ///< share of a limit, for rounding
inline constexpr double kSpeed = 0.01;           ///< [m/s] of a position's change against its rate, mean over a step
inline constexpr double kRate = 0.02;            ///< [rad/s] for angles
inline constexpr double kAcceleration = 1.0;     ///< [m/s^2] of the base velocity's change against its rate
inline constexpr double kAngular = 100.0;        ///< [rad/s^2] for angles and joints
inline constexpr double kComAcceleration = 0.1;  ///< [m/s^2] of the centre of mass
inline constexpr double kZmp = 2e-3;             ///< [m] of the reference against the multibody ZMP
inline constexpr double kFrequency = 0.02;       ///< share of sqrt(g / h)
inline constexpr double kGoalShare = 0.03;       ///< of the leg's length: accepted distance of the base from its start
inline constexpr double kGoalHeading = 0.02;     ///< [rad]
inline constexpr double kResidualShare = 0.02;   ///< share of m g, and of m g h
inline constexpr double kCertain = 1e-3;         ///< share of m g, and of m g h: negligible force and moment
inline constexpr double kEffortShare = 0.05;     ///< share of a joint's effort limit
inline constexpr double kSupportLine = 2e-3;     ///< [m] tolerance of a ZMP at a line
inline constexpr double kCoplanar = 2e-3;        ///< [m] of contacts from a plane, for a meaningful ZMP
inline constexpr double kOnPatchShare = 0.6;     ///< share of a sole that must be on its surface
inline constexpr double kOnField = 5e-3;         ///< [m] of a sole from the highest point of the height field under it
inline constexpr double kFieldTilt = 0.2;        ///< [rad] of a foothold against the height field around it
inline constexpr double kReferenceSlack = 5e-3;  ///< [m] for feet that roll after the reference was planned
inline constexpr double kPressureSlack = 1e-4;   ///< [m] of a centre of pressure outside of its sole
inline constexpr double kTouching = 1e-4;        ///< [m] below which a clearance counts as zero
inline constexpr double kLeastLoad = 0.05;       ///< share of m g: below it, centre of pressure and ZMP are not checked
inline constexpr double kSwingLoad = 5e-3;       ///< share of m g: accepted load of a foot in its swing

}  // namespace gaitwright::tolerance
