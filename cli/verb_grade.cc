// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "cli/flags.h"
#include "cli/interruptible.h"
#include "cli/json_text_internal.h"
#include "cli/paths.h"
#include "cli/program.h"
#include "cli/progress_bar.h"
#include "workflows/grade/grade.h"

namespace gaitwright::cli {
namespace {

namespace fs = std::filesystem;

struct GradeSettings {
  Common common;
  std::string folder, rubric, out = "grades", python, inputs, engine;
  bool unconfined = false;

  std::string InOut(const std::string& name) const { return (fs::path(out) / name).string(); }
};

void PrintClassInputs(const std::vector<OutputFile>& files, const Common& common) {
  if (common.json) {
    nlohmann::ordered_json paths = nlohmann::ordered_json::object();
    for (const OutputFile& file : files) paths[fs::path(file.path).stem().string()] = file.path;
    PrintJson(nlohmann::ordered_json{{"files", paths}});
    return;
  }
  for (const OutputFile& file : files) fmt::print("inputs  {}\n", file.path);
}

/// Writes the inputs of the questions for a class, and marks nothing.
int WriteClassInputs(const GradeSettings& a, const Rubric& rubric) {
  std::vector<OutputFile> files;
  for (const RubricPart& part : rubric.parts) {
    if (part.kind == RubricPartKind::kAnswers)
      files.push_back({(fs::path(a.inputs) / (part.name + "_inputs.csv")).string(),
                       InputsCsv(part, static_cast<std::uint64_t>(a.common.seed))});
  }
  if (files.empty())
    throw InvalidArgument(
        fmt::format("--write-inputs: '{}' has no part of kind 'answers', so there are no inputs to write", a.rubric));
  const auto written = WriteFilesTogether(files);
  if (!written) return Report(written.failure(), a.common);
  PrintClassInputs(files, a.common);
  return kPass;
}

void PrintGrades(const GradeSettings& a, const ClassMarks& marks) {
  if (a.common.json) {
    auto json = ParsedJson(GradesJson(marks));
    json["files"] = {{"grades", a.InOut("grades.csv")}, {"index", a.InOut("index.html")}};
    PrintJson(json);
    return;
  }
  for (const StudentMarks& student : marks.students) {
    if (!a.common.quiet)
      fmt::print("{:<24} {} of {}\n", student.student, PointsText(student.points()), PointsText(student.of()));
  }
  if (!marks.confined) fmt::print("submissions were run unconfined\n");
  fmt::print("grades  {}\n", a.InOut("grades.csv"));
  if (!a.common.quiet) fmt::print("pages   {}\n", a.InOut("index.html"));
}

Result<ClassMarks> GradeWithBar(const GradeSettings& a, const GradeRequest& request) {
  const Interruptible interruptible;
  ProgressBar bar(!a.common.quiet, "parts");
  GradeHooks hooks;
  hooks.stop = [] { return Interruptible::asked(); };
  hooks.progress = [&](int done, int all, const std::string& student) { bar.Show({done, all, 0}, student); };
  return GradeClass(request, hooks, [&](const std::vector<OutputFile>& pages) -> Result<std::string> {
    std::vector<OutputFile> files;
    for (const OutputFile& page : pages) files.push_back({a.InOut(page.path), page.text});
    const auto written = WriteFilesTogether(files);
    if (!written) return written.failure();
    return a.out;
  });
}

int MarkClass(const GradeSettings& a, Rubric rubric) {
  GradeRequest request;
  request.rubric = std::move(rubric);
  request.rubric_file = a.rubric;
  request.folder = a.folder;
  request.out_folder = a.out;
  request.python = a.python;
  request.seed = static_cast<std::uint64_t>(a.common.seed);
  request.unconfined = a.unconfined;
  const Result<ClassMarks> marks = GradeWithBar(a, request);
  if (!marks) {
    const int status = Report(marks.failure(), a.common);
    return marks.failure().code == FailureCode::kInterrupted ? kInterrupted : status;
  }
  const auto written =
      WriteFilesTogether({{a.InOut("grades.csv"), GradesCsv(*marks)}, {a.InOut("index.html"), ClassPage(*marks)}});
  if (!written) return Report(written.failure(), a.common);
  PrintGrades(a, *marks);
  return kPass;
}

int RunGrade(const GradeSettings& a) {
  Paths paths;
  paths.Read("--rubric", a.rubric);
  if (a.inputs.empty()) {
    if (a.folder.empty()) throw InvalidArgument("DIR is missing: the folder with one folder for each student");
    paths.Write("the table", a.InOut("grades.csv"));
    paths.Write("the page", a.InOut("index.html"));
  } else if (!a.folder.empty()) {
    throw InvalidArgument(fmt::format("--write-inputs marks nothing; leave out DIR '{}'", a.folder));
  }
  CheckPaths(paths);
  Result<Rubric> rubric = LoadRubric(a.rubric);
  if (!rubric) return Report(rubric.failure(), a.common);
  if (!a.engine.empty()) {
    for (RubricPart& part : rubric->parts) part.motion.play_words.emplace_back("play.engine", a.engine);
  }
  return a.inputs.empty() ? MarkClass(a, std::move(*rubric)) : WriteClassInputs(a, *rubric);
}

}  // namespace

void AddGrade(Verb program, int& status) {
  auto a = std::make_shared<GradeSettings>();
  const Verb verb = program.AddVerb("grade", "Mark a class's submissions against a rubric");
  AddText(verb, "DIR", "DIR", a->folder, "Folder that has one folder for each student.");
  AddText(verb, "--rubric", "FILE", a->rubric, "Rubric: expected files and their marks, as YAML; see docs/grading.md.")
      .Require();
  AddText(verb, "--engine", "NAME", a->engine,
          "Physics engine of all motions: bullet, mujoco, or both (the worse result counts); default: the rubric's "
          "engine, otherwise bullet.")
      .AcceptOnly({"bullet", "mujoco", "both"});
  verb.SetGroup("Running code");
  AddText(verb, "--python", "PROGRAM", a->python,
          "Python interpreter for submissions; default: /usr/bin/python3, otherwise the one on PATH.");
  verb.AddSwitch(
      "--unconfined", a->unconfined,
      "Run submissions without confinement, with all rights of your user; for machines that cannot confine them.");
  verb.SetGroup("Output");
  AddText(verb, "--out-dir", "DIR", a->out, "Folder for grades.csv and the pages, created if missing; default grades.");
  AddText(verb, "--write-inputs", "DIR", a->inputs,
          "Only write the inputs of 'answers' parts for this seed, to hand out to students.");
  AddCommon(verb, a->common,
            {"grade submissions --rubric rubric.yaml --seed 7",
             "grade --rubric rubric.yaml --seed 7 --write-inputs handout"});
  SetWork(verb, a->common, status, [a] { return RunGrade(*a); });
}

}  // namespace gaitwright::cli
