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
  /// Sets those options of the file that `fields` has. The file may hold any option of `walk`: keys that are for other
  /// verbs are told of on standard error, unless quiet. Call it before ApplySets, which wins. Nothing for no file.
  Result<OptionTexts> Apply(OptionFields fields, const Common& common) const;
};

}  // namespace gaitwright::cli
