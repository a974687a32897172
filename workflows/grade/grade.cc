// SPDX-License-Identifier: BSD-3-Clause
#include "workflows/grade/grade.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "kinematics/model/load_robot.h"
#include "workflows/grade/mark_apart.h"
#include "workflows/grade/motion_run.h"

namespace gaitwright {
namespace {

namespace fs = std::filesystem;

Failure CannotGrade(FailureCode code, const std::string& message, std::vector<Suggestion> suggestions = {}) {
  return {FailureKind::kBadInput, code, "GradeClass", message, std::move(suggestions)};
}

bool RunsCode(const Rubric& rubric) {
  return std::any_of(rubric.parts.begin(), rubric.parts.end(),
                     [](const RubricPart& part) { return RunsCode(part.kind); });
}

/// Failure if a ground, an option or a command of the rubric does not exist.
std::optional<Failure> ReasonInvalidRequest(const GradeRequest& request) {
  for (const RubricPart& part : request.rubric.parts) {
    if (!PlaysMotions(part.kind)) continue;
    const Result<RobotModel> model = LoadNamedRobot(part.motion.robot);
    if (!model) return model.failure();
    try {
      for (const MotionRun& run : DrawRuns(part, *model, request.seed)) {
        if (part.kind == RubricPartKind::kPlan) (void)GoalOf(*model, run.walk.command);
        if (part.kind == RubricPartKind::kController) (void)GivenPlan(part, *model, run);
      }
    } catch (const InvalidArgument& error) {
      return CannotGrade(FailureCode::kRubric, error.what());
    }
  }
  return std::nullopt;
}

/// Whether a path is a folder or lies below it.
bool LiesIn(const fs::path& path, const fs::path& folder) {
  std::error_code error;
  const fs::path inner = fs::weakly_canonical(path, error), outer = fs::weakly_canonical(folder, error);
  const auto [end, rest] = std::mismatch(outer.begin(), outer.end(), inner.begin(), inner.end());
  (void)rest;
  return end == outer.end() || (std::next(end) == outer.end() && end->empty());
}

/// Failure if the folder of grades is inside the folder of submissions, where it would count as a student.
std::optional<Failure> ReasonMissing(const GradeRequest& request) {
  std::error_code error;
  if (!LiesIn(fs::absolute(request.out_folder, error), fs::absolute(request.folder, error))) return std::nullopt;
  return CannotGrade(
      FailureCode::kOutDir,
      fmt::format(
          "the folder of grades '{}' is inside the folder of submissions '{}', where each folder belongs to a student",
          request.out_folder, request.folder),
      {"give another folder with --out-dir"});
}

/// Failure if the code of a submission could read a file that it must not read.
std::optional<Failure> ReasonReadable(const GradeRequest& request, const PythonProgram& python) {
  std::vector<std::string> readable = python.readable;
  if (!python.package.empty()) readable.push_back((fs::path(python.package) / "gaitwright").string());
  readable.push_back(RobotsFolder());
  std::error_code error;
  for (const std::string& own : readable) {
    if (!fs::is_directory(own, error)) continue;
    for (const std::string& hidden : {request.folder, request.rubric_file, request.out_folder}) {
      if (LiesIn(fs::absolute(hidden, error), own))
        return CannotGrade(
            FailureCode::kReadable,
            fmt::format("'{}' is inside '{}', which submissions may read because Python or the program needs it",
                        hidden, own),
            {"move it elsewhere"});
    }
  }
  return std::nullopt;
}

std::optional<Failure> ReasonNoCode(const GradeRequest& request, const PythonProgram& python) {
  if (!python.has_numpy)
    return CannotGrade(FailureCode::kPython, fmt::format("the Python '{}' has no NumPy", python.path));
  for (const RubricPart& part : request.rubric.parts) {
    if (part.package && RunsCode(part.kind) && python.package.empty())
      return CannotGrade(FailureCode::kPython,
                         fmt::format("part '{}' needs the Python package gaitwright, which is missing in '{}'",
                                     part.name, python.path),
                         {"build it (docs/python.md), or give a Python that has it with --python PROGRAM"});
    if (const std::string path = part.package && RunsCode(part.kind) ? UnreadableForNobody(python) : ""; !path.empty())
      return CannotGrade(FailureCode::kUnreadable,
                         fmt::format("submissions cannot be run safely here: when started by root, they run as user "
                                     "'nobody', who may not read '{}'",
                                     path),
                         {"start it as another user", "install Gaitwright where all users may read it"});
  }
  return ReasonReadable(request, python);
}

/// Runs test code as a submission, so that a problem that affects all submissions is reported first.
std::optional<Failure> ReasonNotRunnable(const PythonProgram& python, const ChildLimits& limits, bool package,
                                         bool confined) {
  const std::string text =
      fmt::format("import numpy\n{}def ready():\n    return 0\n", package ? "import gaitwright\n" : "");
  Result<StudentPython> code = StudentPython::Start(python, {{{"ready.py", text}}, "ready", package}, limits, confined);
  if (code) return std::nullopt;
  return CannotGrade(FailureCode::kPython,
                     fmt::format("submissions cannot be run by '{}'{}: {}", python.path,
                                 package ? " with the package gaitwright" : "", code.failure().message),
                     {"give another Python, readable by all users, with --python PROGRAM", "raise limits.memory_mb"});
}

std::optional<Failure> ReasonNotRunnable(const GradeRequest& request, const MarkingSetup& setup) {
  for (const bool package : {false, true}) {
    for (const RubricPart& part : request.rubric.parts) {
      if (!RunsCode(part.kind) || part.package != package) continue;
      if (auto failure = ReasonNotRunnable(setup.python, part.limits, package, setup.confined)) return failure;
      break;
    }
  }
  return std::nullopt;
}

/// Sets up the tools for marking; looks for Python only if a part runs code.
Result<MarkingSetup> SetUp(const GradeRequest& request) {
  MarkingSetup setup;
  setup.seed = request.seed;
  if (!RunsCode(request.rubric)) return setup;
  const std::string why = ReasonNotConfined();
  setup.confined = why.empty();
  if (!setup.confined && !request.unconfined)
    return CannotGrade(FailureCode::kUnconfinedOnly, fmt::format("submissions cannot be run safely here: {}", why),
                       {"--unconfined runs them without confinement, with all rights of your user"});
  Result<PythonProgram> python = LookOver(request.python);
  if (!python) return python.failure();
  if (auto failure = ReasonNoCode(request, *python)) return *failure;
  setup.python = std::move(*python);
  if (auto failure = ReasonNotRunnable(request, setup)) return *failure;
  return setup;
}

}  // namespace

Result<ClassMarks> GradeClass(const GradeRequest& request, const GradeHooks& hooks,
                              const std::function<Result<std::string>(const std::vector<OutputFile>&)>& written) {
  const Result<std::vector<Student>> students = FindStudents(request.folder);
  if (!students) return students.failure();
  if (auto failure = ReasonMissing(request)) return *failure;
  if (auto failure = ReasonInvalidRequest(request)) return *failure;
  const Result<MarkingSetup> setup = SetUp(request);
  if (!setup) return setup.failure();
  ClassMarks marks{request.rubric.title, request.seed, setup->confined, {}, request.rubric.points(), {}};
  for (const RubricPart& part : request.rubric.parts) marks.parts.push_back(part.name);
  const int all = static_cast<int>(students->size() * request.rubric.parts.size());
  int done = 0;
  for (const Student& student : *students) {
    StudentMarks own{student.name, {}};
    for (const RubricPart& part : request.rubric.parts) {
      if (hooks.stop && hooks.stop())
        return CannotGrade(FailureCode::kInterrupted, "grading was stopped before it was complete");
      if (hooks.progress) hooks.progress(done++, all, student.name);
      own.parts.push_back(MarkApart(part, [&] { return MarkPart(part, student, *setup); }));
    }
    const Result<std::string> pages = written(StudentPages(marks, own, marks.students.size()));
    if (!pages) return pages.failure();
    for (PartMark& part : own.parts) part.pages.clear();
    marks.students.push_back(std::move(own));
  }
  if (hooks.progress) hooks.progress(done, all, "");
  return marks;
}

}  // namespace gaitwright
