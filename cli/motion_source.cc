// SPDX-License-Identifier: BSD-3-Clause
#include "cli/flags.h"
#include "cli/motion_source_internal.h"

namespace gaitwright::cli {

void AddMotionSource(Verb verb, std::string_view name, std::string_view help, ImportRequest& request,
                     RobotFlags& robot) {
  AddText(verb, name, "FILE", request.file, help).Require();
  verb.SetGroup("Robot and ground");
  robot.AddTo(verb);
  AddText(verb, "--terrain", "NAME", request.terrain,
          "Ground of the motion, by name or file, see 'gaitwright terrains'; default flat.");
  verb.SetGroup("Reading the file");
  AddText(verb, "--columns", "FILE", request.columns_file,
          "YAML file that maps the CSV's columns, see docs/import.md; default: by its first line.");
  const OptionFields fields = request.options.Fields();
  AddField(verb, "--rate-hz", fields, "rate_hz");
  AddText(verb, "--topic", "NAME", request.options.topics,
          "Topics of a recording to read, separated by commas; default: the only topic of each type.");
  AddField(verb, "--quaternion-order", fields, "quaternion_order");
  AddField(verb, "--angle-unit", fields, "angle_unit");
  AddField(verb, "--length-unit", fields, "length_unit");
  AddField(verb, "--time-unit", fields, "time_unit");
}

void AddSourcePaths(const ImportRequest& request, const RobotFlags& robot, Paths& paths) {
  paths.Read("the motion", request.file);
  paths.Read("--columns", request.columns_file);
  robot.AddTo(paths);
  paths.AddTerrain(request.terrain);
}

}  // namespace gaitwright::cli
