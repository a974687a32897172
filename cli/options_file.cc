// SPDX-License-Identifier: BSD-3-Clause
#include "cli/options_file.h"

#include <fmt/format.h>

#include <algorithm>

#include "cli/flags.h"
#include "kinematics/base/options_file.h"
#include "workflows/walk/walk.h"

namespace gaitwright::cli {

void OptionsFile::AddTo(Verb verb) {
  AddText(verb, "--options", "FILE", path,
          "YAML file of options (KEY: VALUE, the keys of --set), as written by 'tune'. It overrides flags; --set "
          "overrides it. Default: none.");
}

void OptionsFile::AddPathTo(Paths& paths) const {
  if (!path.empty()) paths.Read("--options", path);
}

Result<OptionTexts> OptionsFile::Apply(OptionFields fields, const Common& common) const {
  if (path.empty()) return OptionTexts{};
  WalkRequest walk;
  PlayRequest play;
  Result<OptionTexts> texts = LoadOptionsFile(path, Joined({walk.Fields(), play.Fields()}));
  if (!texts) return texts;
  std::string others;
  for (const auto& [key, value] : *texts) {
    const bool has = std::any_of(fields.begin(), fields.end(), [&key = key](const auto& f) { return f.key == key; });
    if (has) {
      SetOption(fields, key, value);
    } else {
      others += (others.empty() ? "" : ", ") + key;
    }
  }
  if (!others.empty() && !common.quiet)
    fmt::print(stderr, "gaitwright: note: this verb ignores these keys of --options '{}': {}\n", path, others);
  return texts;
}

}  // namespace gaitwright::cli
