// SPDX-License-Identifier: BSD-3-Clause
#include "workflows/formats/documents.h"

#include "kinematics/model/robot_yaml_shape.h"
#include "planning/audit/start_posture_shape.h"
#include "planning/gait/file_shapes.h"
#include "planning/plan/plan_shape.h"
#include "planning/tasks/task_plan_json.h"
#include "planning/terrain/terrain_yaml_shape.h"
#include "playback/log/log_shape.h"
#include "playback/trials/disturbances_shape.h"
#include "workflows/exchange/file_shapes.h"
#include "workflows/formats/result_shapes_internal.h"
#include "workflows/grade/rubric_shape.h"
#include "workflows/study/trial.h"
#include "workflows/walk/walk.h"

namespace gaitwright {
namespace {

Document Made(const std::string& name, const std::string& title, const std::string& page, const DataShape& shape) {
  return {name, title, SchemaOf(shape, title, "What it means: docs/" + page)};
}

/// Files of options may set whatever a walk and its playback have.
DataShape OptionsShape() {
  WalkRequest walk;
  PlayRequest play;
  DataShape shape = shapes::Object({});
  for (const OptionField& field : Joined({walk.Fields(), play.Fields()})) shape.members.push_back(shapes::Field(field));
  shape.least = 1;
  return shape;
}

}  // namespace

std::vector<Document> Documents() {
  PlayRequest play;
  return {
      Made("motion-plan", "A motion plan", "plan-format.md", PlanShape()),
      Made("playback-log", "The log of a playback", "log-format.md", LogShape()),
      {"task-plan", "What a robot is to do, one task after the other", TaskPlanSchema()},
      Made("robot-yaml", "robot.yaml, what a URDF does not say", "robot-yaml.md", RobotYamlShape()),
      Made("gaits", "A file of gaits", "gaits.md", GaitFileShape()),
      Made("sequence", "Several gaits in one plan", "gaits.md", SequenceFileShape()),
      Made("terrain", "A ground", "terrain-format.md", TerrainFileShape()),
      Made("disturbances", "What trials sample", "trials.md", DisturbancesShape(SensorFields(play))),
      Made("start-posture", "Where the joints are before the first command", "audit.md", StartPostureShape()),
      Made("footsteps", "Footsteps of another planner", "import.md", FootstepFileShape()),
      Made("columns", "How the columns of somebody else's file are called", "import.md", ColumnNamesShape()),
      Made("options", "A file of options", "tune.md", OptionsShape()),
      Made("rubric", "What an assignment is marked by", "grading.md", RubricShape()),
      Made("walk-result", "What walk and play print", "json-output.md", WalkResultShape()),
      Made("do-result", "What do prints", "json-output.md", DoResultShape()),
      Made("plan-result", "What plan prints", "json-output.md", PlanResultShape()),
      Made("audit-result", "What audit prints", "json-output.md", AuditResultShape()),
      Made("preflight-result", "What audit --preflight prints", "json-output.md", PreflightShape()),
      Made("trials-result", "What trials prints, and its file", "json-output.md", TrialsResultShape()),
      Made("sweep-result", "What sweep prints", "json-output.md", SweepResultShape()),
      Made("tune-result", "What tune prints, and its file", "json-output.md", TuneResultShape()),
      Made("compare-result", "What compare prints", "json-output.md",
           shapes::Either(MotionComparisonShape(), ReportComparisonShape())),
      Made("export-result", "What export prints", "json-output.md", ExportResultShape()),
      Made("import-result", "What import prints", "json-output.md", ImportResultShape()),
      Made("grade-result", "What grade prints", "json-output.md", GradeResultShape()),
      Made("robots-result", "What robots prints", "json-output.md", RobotsResultShape()),
      Made("gaits-result", "What gaits prints", "json-output.md", GaitsResultShape()),
      Made("terrains-result", "What terrains prints", "json-output.md", TerrainsResultShape()),
      Made("view-result", "What view prints", "json-output.md", ViewResultShape()),
      Made("render-result", "What render prints", "json-output.md", RenderResultShape()),
      Made("live-result", "What live prints", "json-output.md", LiveResultShape()),
      Made("bench-result", "What bench centroidal prints", "json-output.md", BenchResultShape()),
      Made("option-list", "What --list-options prints", "json-output.md", OptionListShape()),
      Made("reference-result", "What reference prints", "json-output.md", ReferenceResultShape()),
      Made("error", "What every verb prints where it cannot go on", "json-output.md", ErrorShape()),
  };
}

}  // namespace gaitwright
