// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "cli/paths.h"
#include "cli/program.h"
#include "kinematics/base/options.h"

namespace gaitwright::cli {

/// The flag --options: options from a file, as `tune` writes it.
struct OptionsFile {
  std::string path;  ///< "" for none

  void AddTo(Verb verb);
  void AddPathTo(Paths& paths) const;
  /// Sets the options of the file that `fields` has. The file may hold any option of `walk`; keys for other verbs are
  /// reported on standard error, unless quiet. Call it before ApplySets, which overrides it. Does nothing without a
  /// file.
  Result<OptionTexts> Apply(OptionFields fields, const Common& common) const;
};

}  // namespace gaitwright::cli
