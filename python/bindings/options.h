// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pybind11/pybind11.h>

#include "kinematics/base/options.h"
#include "workflows/walk/walk.h"

namespace gaitwright::python {

/// Options as a Python function takes them: a dictionary with the keys of `--set`, and numbers, truths or texts.
/// @throws InvalidArgument for a value of another kind.
OptionTexts TextsFrom(const pybind11::dict& options);

/// Puts them where their keys belong. @throws InvalidArgument for a key that is not among the fields, the nearest being
/// named, and for a value that is out of range.
void SetOptions(OptionFields fields, const pybind11::dict& options);

/// A playback by its options: those of `play --set`, and "sensors", the name of a ready-made set of their figures.
/// @throws InvalidArgument as SetOptions does.
PlayRequest PlayRequestOf(const pybind11::dict& options);

}  // namespace gaitwright::python
