// SPDX-License-Identifier: BSD-3-Clause
#include "workflows/formats/documents.h"

#include "kinematics/model/robot_yaml_shape.h"
#include "planning/audit/start_posture_shape.h"
#include "planning/gait/file_shapes.h"
#include "planning/plan/plan_shape.h"
#include "planning/tasks/task_plan_json.h"
#include "planning/terrain/terrain_yaml_shape.h"
#include "playback/log/log_shape.h"
#include "playback/policy/contract_internal.h"
#include "playback/policy/velocity_commands_internal.h"
#include "playback/trials/disturbances_shape.h"
#include "workflows/exchange/file_shapes.h"
#include "workflows/formats/result_shapes_internal.h"
#include "workflows/grade/rubric_shape.h"
#include "workflows/repair/follow_weights_internal.h"
#include "workflows/study/trial.h"
#include "workflows/walk/walk.h"

namespace gaitwright {
namespace {

Document Made(const std::string& name, const std::string& title, const std::string& page, const DataShape& shape) {
  return {name, title, SchemaOf(shape, title, "Described in docs/" + page)};
}

/// Structure of an option file, which may set every option of a walk and its playback.
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
      {"task-plan", "Tasks of a robot, in order", TaskPlanSchema()},
      Made("robot-yaml", "robot.yaml: data that a URDF does not contain", "robot-yaml.md", RobotYamlShape()),
      Made("gaits", "A file of gaits", "gaits.md", GaitFileShape()),
      Made("sequence", "Several gaits in one plan", "gaits.md", SequenceFileShape()),
      Made("terrain", "A ground", "terrain-format.md", TerrainFileShape()),
      Made("disturbances", "Disturbances that trials sample", "trials.md", DisturbancesShape(SensorFields(play))),
      Made("policy-contract", "Contract of a learned policy", "policies.md", ContractShape()),
      Made("policy-commands", "Velocity commands of a learned policy", "policies.md", CommandsFileShape()),
      Made("start-posture", "Measured joint positions before the first command", "audit.md", StartPostureShape()),
      Made("repair-weights", "Weights of a repair", "repair.md", FollowWeightsShape()),
      Made("footsteps", "Footsteps of another planner", "import.md", FootstepFileShape()),
      Made("columns", "Column names of another program's file", "import.md", ColumnNamesShape()),
      Made("options", "An option file", "tune.md", OptionsShape()),
      Made("rubric", "Marking scheme of an assignment", "grading.md", RubricShape()),
      Made("walk-result", "Output of walk and play", "json-output.md", WalkResultShape()),
      Made("do-result", "Output of do", "json-output.md", DoResultShape()),
      Made("plan-result", "Output of plan", "json-output.md", PlanResultShape()),
      Made("audit-result", "Output of audit", "json-output.md", AuditResultShape()),
      Made("preflight-result", "Output of audit --preflight", "json-output.md", PreflightShape()),
      Made("trials-result", "Output and result file of trials", "json-output.md", TrialsResultShape()),
      Made("sweep-result", "Output of sweep", "json-output.md", SweepResultShape()),
      Made("tune-result", "Output and result file of tune", "json-output.md", TuneResultShape()),
      Made("compare-result", "Output of compare", "json-output.md",
           shapes::Either(MotionComparisonShape(), ReportComparisonShape())),
      Made("export-result", "Output of export", "json-output.md", ExportResultShape()),
      Made("import-result", "Output of import", "json-output.md", ImportResultShape()),
      Made("repair-result", "Output of repair", "repair.md", RepairResultShape()),
      Made("repaired-clips", "Output of repair for a folder", "repair.md", RepairedClipsShape()),
      Made("grade-result", "Output of grade", "json-output.md", GradeResultShape()),
      Made("robots-result", "Output of robots", "json-output.md", RobotsResultShape()),
      Made("gaits-result", "Output of gaits", "json-output.md", GaitsResultShape()),
      Made("terrains-result", "Output of terrains", "json-output.md", TerrainsResultShape()),
      Made("view-result", "Output of view", "json-output.md", ViewResultShape()),
      Made("render-result", "Output of render", "json-output.md", RenderResultShape()),
      Made("live-result", "Output of live", "json-output.md", LiveResultShape()),
      Made("bench-result", "Output of bench centroidal", "json-output.md", BenchResultShape()),
      Made("whole-body-bench-result", "Output of bench whole-body", "json-output.md", WholeBodyBenchShape()),
      Made("option-list", "Output of --list-options", "json-output.md", OptionListShape()),
      Made("reference-result", "Output of reference", "json-output.md", ReferenceResultShape()),
      Made("error", "Error output of every verb", "json-output.md", ErrorShape()),
  };
}

}  // namespace gaitwright
