// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "workflows/exchange/motion_rows.h"

namespace gaitwright {

/// An array as NumPy's `.npy` of version 1.0: little-endian doubles (`<f8`), row-major.
/// https://numpy.org/doc/stable/reference/generated/numpy.lib.format.html @throws InvalidArgument unless the number of
/// values fits the shape.
std::string NpyOfNumbers(const std::vector<double>& values, const std::vector<std::size_t>& shape);

/// A list of texts as a `.npy`, in code points of one width (`<U12`). @throws InvalidArgument for invalid UTF-8.
std::string NpyOfTexts(const std::vector<std::string>& texts);

/// The rows as NumPy's `.npz`, which `numpy.load` opens (docs/export.md): time_s, q, v, a, tau, contact (0 or 1),
/// contact_wrench (rows x feet x 6), base_position_m, base_quaternion_xyzw, base_velocity_m_s,
/// base_angular_velocity_rad_s, joint_names, foot_names, robot. Missing arrays are left out.
std::string MotionNpz(const RobotModel& model, const MotionRows& rows);

}  // namespace gaitwright
