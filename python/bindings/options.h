// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pybind11/pybind11.h>

#include "kinematics/base/options.h"
#include "workflows/walk/walk.h"

namespace gaitwright::python {

/// Reads the options of a Python function: a dictionary with the keys of `--set`, and numbers, truth values or texts.
/// @throws InvalidArgument for a value of another type.
OptionTexts TextsFrom(const pybind11::dict& options);

/// Sets the fields with the keys of `options`. @throws InvalidArgument for an unknown key (the message names the
/// nearest one) and for a value out of range.
void SetOptions(OptionFields fields, const pybind11::dict& options);

/// Makes the request of a playback from options: those of `play --set`, and "sensors", the name of a built-in set of
/// sensor data.
/// @throws InvalidArgument as SetOptions does.
PlayRequest PlayRequestOf(const pybind11::dict& options);

}  // namespace gaitwright::python
