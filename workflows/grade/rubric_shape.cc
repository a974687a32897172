// SPDX-License-Identifier: BSD-3-Clause
#include "workflows/grade/rubric_shape.h"

#include "workflows/grade/motion_measures.h"
#include "workflows/grade/questions.h"
#include "workflows/study/trial.h"
#include "workflows/walk/walk.h"

namespace gaitwright {
namespace {

constexpr double kMostPoints = 1e6, kLargestValue = 1e12, kLargestError = 1e6, kMostSeed = 2147483647.0;
constexpr double kMostCases = 10000, kMostSize = 64, kMostRuns = 100, kMostTrials = 10000, kLongestLimit = 36000.0;
constexpr std::size_t kMostParts = 200;

using Members = std::vector<ShapeMember>;

void Add(const Members& more, Members& members) { members.insert(members.end(), more.begin(), more.end()); }

/// A number, or the range from which it is drawn.
DataShape RangeShape() { return shapes::Either(shapes::Number(), shapes::Numbers(2)); }

Members QuestionMembers() {
  using namespace shapes;
  return {{"reference", Text(QuestionNames()), "Reference that answers are compared with."},
          Optional("cases", Whole(1, kMostCases), "Number of random cases."),
          Optional("tolerance", Number(0.0, kLargestError), "Largest accepted error."),
          Optional("size", Whole(3, kMostSize), "Number of points or steps, if the reference needs it."),
          Optional("robot", Text(), "Robot name, if the reference needs a robot."),
          Optional("inputs", MapOf(RangeShape()), "Ranges that replace the default ones, by input.")};
}

Members MotionMembers() {
  using namespace shapes;
  Members command;
  for (const std::string& key : CommandKeys()) command.push_back(Optional(key, RangeShape()));
  const DataShape value = Either(Either(RangeShape(), Text()), Truth());
  return {{"robot", Text(), "Name of the robot."},
          Optional("terrain", Either(Text(), MapOf(Either(RangeShape(), Text()), 1)),
                   "A built-in ground, or a map of its name and parameters."),
          Optional("command", Object(command), "Command: goal, distance and speed."),
          Optional("runs", Whole(1, kMostRuns), "Number of random runs; all are played."),
          Optional("play", MapOf(value), "Options of the playback."),
          Optional("trials", Whole(0, kMostTrials), "Playbacks of each run under disturbances."),
          Optional("disturbances", Either(Text({"standard"}), MapOf(Anything())),
                   "Disturbances of the trials, see their schema.")};
}

/// Keys that only parts of one kind have.
Members OwnMembers(RubricPartKind kind) {
  using namespace shapes;
  Members own;
  if (RunsCode(kind)) {
    own.push_back(Optional("function", Text(), "Function to call in the file."));
    own.push_back(Optional("package", Truth(), "True if the code may import gaitwright."));
  }
  if (kind == RubricPartKind::kAnswers)
    own.push_back(Optional("seed", Whole(0, kMostSeed), "Seed of inputs that are always the same."));
  if (PlaysMotions(kind) && kind != RubricPartKind::kController)
    own.push_back(Optional("controller", Text(ControllerNames()), "Controller that plays the motion."));
  if (kind == RubricPartKind::kParameters || kind == RubricPartKind::kController)
    own.push_back(Optional("gait", Text(), "Gait that the program plans with."));
  if (kind == RubricPartKind::kParameters)
    own.push_back(Optional("options", List(Text(), 1), "Keys that the file may set, such as gait.cycle_s or swing.*."));
  if (kind == RubricPartKind::kPlanner) {
    own.push_back(Optional("swing_s", Number(0.05, 10.0), "Duration of a swing."));
    own.push_back(Optional("pause_s", Number(0.0, 10.0), "Time on the ground after a swing."));
  }
  return own;
}

}  // namespace

std::vector<std::string> MeasuresOf(RubricPartKind kind) {
  return PlaysMotions(kind) ? MotionMeasureNames() : std::vector<std::string>{"share_right", "largest_error"};
}

DataShape CheckShape(RubricPartKind kind) {
  using namespace shapes;
  return Object({{"measure", Text(MeasuresOf(kind))},
                 {"points", Number(0.0, kMostPoints)},
                 Optional("full_at", Number(-kLargestValue, kLargestValue), "Value from which all points are given."),
                 Optional("none_at", Number(-kLargestValue, kLargestValue), "Value from which no points are given.")});
}

DataShape LimitsShape(RubricPartKind kind) {
  using namespace shapes;
  ChildLimits limits;
  Members members;
  for (const OptionField& field : limits.Fields()) members.push_back(Field(field));
  members.push_back(Optional("judge_s", Number(0.1, kLongestLimit), "CPU time limit of marking [s]."));
  if (PlaysMotions(kind))
    members.push_back(Optional("motion_s", Number(0.1, kLongestLimit), "Longest motion that is played [s]."));
  return Object(members);
}

DataShape PartShape(RubricPartKind kind) {
  using namespace shapes;
  Members members = {{"name", Text(), "Name of the part and of its column in the table of marks."},
                     Optional("title", Text(), "Title for readers."),
                     {"kind", Text({PartKindNames()[static_cast<std::size_t>(kind)]})},
                     {"file", Text(), "File name in the student's folder."},
                     {"points", Positive(kMostPoints), "Points of all its checks."},
                     Optional("limits", LimitsShape(kind))};
  const DataShape checks = List(CheckShape(kind));
  members.push_back(PlaysMotions(kind) ? ShapeMember{"checks", checks} : Optional("checks", checks));
  Add(PlaysMotions(kind) ? MotionMembers() : QuestionMembers(), members);
  Add(OwnMembers(kind), members);
  return Object(members);
}

DataShape RubricShape() {
  using namespace shapes;
  DataShape part = PartShape(static_cast<RubricPartKind>(0));
  for (std::size_t kind = 1; kind < PartKindNames().size(); ++kind)
    part = Either(part, PartShape(static_cast<RubricPartKind>(kind)));
  return Object({{"title", Text(), "Title of the assignment."}, {"parts", List(part, 1, kMostParts)}});
}

}  // namespace gaitwright
