// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "cli/flags.h"
#include "cli/interruptible.h"
#include "cli/paths.h"
#include "cli/program.h"
#include "cli/progress_bar.h"
#include "workflows/grade/grade.h"

namespace gaitwright::cli {
namespace {

namespace fs = std::filesystem;

struct Arguments {
  Common common;
  std::string folder, rubric, out = "grades", python, inputs;
  bool unconfined = false;

  std::string InOut(const std::string& name) const { return (fs::path(out) / name).string(); }
};

void PrintInputs(const std::vector<OutputFile>& files, const Common& common) {
  if (common.json) {
    nlohmann::ordered_json paths = nlohmann::ordered_json::object();
    for (const OutputFile& file : files) paths[fs::path(file.path).stem().string()] = file.path;
    fmt::print("{}\n", nlohmann::ordered_json{{"files", paths}}.dump(2));
    return;
  }
  for (const OutputFile& file : files) fmt::print("inputs  {}\n", file.path);
}

/// Writes what a class is to work out, and marks nothing.
int WriteInputs(const Arguments& a, const Rubric& rubric) {
  std::vector<OutputFile> files;
  for (const RubricPart& part : rubric.parts) {
    if (part.kind == PartKind::kAnswers)
      files.push_back({(fs::path(a.inputs) / (part.name + "_inputs.csv")).string(),
                       InputsCsv(part, static_cast<std::uint64_t>(a.common.seed))});
  }
  if (files.empty())
    throw InvalidArgument(
        fmt::format("--write-inputs: '{}' has no part of kind 'answers', which inputs are for", a.rubric));
  const auto written = WriteFilesTogether(files);
  if (!written) return Report(written.failure(), a.common);
  PrintInputs(files, a.common);
  return kPass;
}

void Print(const Arguments& a, const ClassMarks& marks) {
  if (a.common.json) {
    auto json = nlohmann::ordered_json::parse(GradesJson(marks));
    json["files"] = {{"grades", a.InOut("grades.csv")}, {"index", a.InOut("index.html")}};
    fmt::print("{}\n", json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace));
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

Result<ClassMarks> GradeWithBar(const Arguments& a, const GradeRequest& request) {
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

int Grade(const Arguments& a, Rubric rubric) {
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
    return marks.failure().code == "interrupted" ? kInterrupted : status;
  }
  const auto written =
      WriteFilesTogether({{a.InOut("grades.csv"), GradesCsv(*marks)}, {a.InOut("index.html"), ClassPage(*marks)}});
  if (!written) return Report(written.failure(), a.common);
  Print(a, *marks);
  return kPass;
}

int Run(const Arguments& a) {
  Paths paths{{{"--rubric", a.rubric}}, {}, ""};
  if (a.inputs.empty()) {
    if (a.folder.empty()) throw InvalidArgument("DIR is missing: the folder that has a folder for each student");
    paths.written = {{"the table", a.InOut("grades.csv")}, {"the page", a.InOut("index.html")}};
  } else if (!a.folder.empty()) {
    throw InvalidArgument(fmt::format("--write-inputs marks nothing, and needs no DIR: '{}'", a.folder));
  }
  if (!a.common.sets.empty())
    throw InvalidArgument("--set: 'grade' has no options; the rubric says how motions are played");
  CheckPaths(paths);
  Result<Rubric> rubric = LoadRubric(a.rubric);
  if (!rubric) return Report(rubric.failure(), a.common);
  return a.inputs.empty() ? Grade(a, std::move(*rubric)) : WriteInputs(a, *rubric);
}

}  // namespace

void AddGrade(CLI::App& app, int& status) {
  auto a = std::make_shared<Arguments>();
  CLI::App& verb = *app.add_subcommand("grade", "Mark a class's submissions against a rubric");
  AddText(verb, "DIR", "DIR", a->folder, "A folder with a folder for each student.");
  AddText(verb, "--rubric", "FILE", a->rubric, "What is handed in and what it is worth, a YAML: see docs/grading.md.")
      ->required();
  verb.option_defaults()->group("How code is run");
  AddText(verb, "--python", "PROGRAM", a->python,
          "The Python that submissions are run with; default: /usr/bin/python3, else the one on PATH.");
  verb.add_flag("--unconfined", a->unconfined,
                "Run submissions where the machine cannot confine them; they may then do all that your user may.");
  verb.option_defaults()->group("What is written");
  AddText(verb, "--out-dir", "DIR", a->out, "Folder of grades.csv and the pages, made if need be; default grades.");
  AddText(verb, "--write-inputs", "DIR", a->inputs,
          "Write the inputs of the parts of kind 'answers' for this seed, to be handed out, and mark nothing.");
  AddCommon(verb, a->common,
            {"grade submissions --rubric rubric.yaml --seed 7",
             "grade --rubric rubric.yaml --seed 7 --write-inputs handout"});
  verb.callback([a, &status] { status = Guarded(a->common, [&] { return Run(*a); }); });
}

}  // namespace gaitwright::cli
