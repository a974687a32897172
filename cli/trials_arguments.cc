// SPDX-License-Identifier: BSD-3-Clause
#include "cli/trials_arguments.h"

#include "workflows/study/trial.h"

namespace gaitwright::cli {

void DisturbanceArguments::AddTo(CLI::App& verb, const std::string& otherwise) {
  AddText(verb, "--disturbances", "FILE", file,
          "What is sampled, as YAML, see docs/trials.md; 'standard' for the standard set; default: " + otherwise + ".");
}

void DisturbanceArguments::AddPathTo(Paths& paths) const {
  if (!file.empty() && file != "standard") paths.read.push_back({"--disturbances", file});
}

Result<Disturbances> DisturbanceArguments::Load(const RobotModel& model, PlayRequest request) const {
  const bool standard = file.empty() || file == "standard";
  Result<Disturbances> disturbances =
      standard ? Result<Disturbances>(StandardDisturbances(model)) : LoadDisturbances(file, SensorFields(request));
  if (!disturbances) return disturbances;
  if (auto failure = WhyNotSampled(model, request, *disturbances)) return *failure;
  return disturbances;
}

}  // namespace gaitwright::cli
