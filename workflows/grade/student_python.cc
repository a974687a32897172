// SPDX-License-Identifier: BSD-3-Clause
#include "workflows/grade/student_python.h"

#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <nlohmann/json.hpp>
#include <regex>

#include "kinematics/base/text.h"
#include "kinematics/model/load_robot.h"
#include "planning/gait/load_gaits.h"
#include "workflows/grade/student_loop_internal.h"
#include "workflows/render/temporary_folder_internal.h"

namespace gaitwright {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMostWords = 400, kShortAnswer = 4096;
constexpr mode_t kMayPass = 0711, kMayRead = 0755, kOwn = 0700;

Failure CannotRun(const std::string& why) {
  return {FailureKind::kBadInput, FailureCode::kChild, "StudentPython", "a submission cannot be run: " + why, {}};
}

}  // namespace

/// The folders of a submission: one to read, and one to write to. They outlive the process.
struct StudentPython::Parts {
  TemporaryFolder base;
  std::unique_ptr<ChildProcess> child;

  std::string Code() const { return base.In("code"); }
  std::string Work() const { return base.In("work"); }

  /// Makes the folders. Failure if they cannot be made.
  std::optional<Failure> Make(const std::vector<OutputFile>& files) const {
    if (!base.there()) return CannotRun("a temporary folder cannot be made");
    const bool made = chmod(base.path().c_str(), kMayPass) == 0 && mkdir(Code().c_str(), kMayRead) == 0 &&
                      mkdir(Work().c_str(), kOwn) == 0 && chmod(Code().c_str(), kMayRead) == 0 &&
                      (geteuid() != 0 || chown(Work().c_str(), kNobody, kNobody) == 0);
    if (!made) return CannotRun(fmt::format("cannot create its folders in '{}'", base.path()));
    for (const OutputFile& file : files) {
      const Result<std::string> lent = Lend(file.path, file.text);
      if (!lent) return lent.failure();
    }
    return std::nullopt;
  }

  Result<std::string> Lend(const std::string& name, const std::string& text) const {
    const std::string path = (fs::path(Code()) / name).string();
    Result<std::string> written = WriteFileAtomically(path, text);
    if (written) chmod(path.c_str(), kMayRead);
    return written;
  }
};

namespace {

std::vector<std::string> EnvironmentOf(const std::string& work) {
  return {"HOME=" + work,
          "TMPDIR=" + work,
          "LANG=C.UTF-8",
          "PYTHONHASHSEED=0",
          "PYTHONDONTWRITEBYTECODE=1",
          "OPENBLAS_NUM_THREADS=1",
          "OMP_NUM_THREADS=1",
          "MKL_NUM_THREADS=1",
          "GAITWRIGHT_ROBOTS=" + RobotsFolder(),
          "GAITWRIGHT_GAITS=" + BuiltInGaitsFile()};
}

ChildSetup SetupOf(const PythonProgram& python, const StudentCode& code, const std::string& code_folder,
                   const std::string& work_folder) {
  ChildSetup setup;
  setup.program = python.path;
  setup.arguments = {"-s", "-B", "-c", std::string(StudentLoop())};
  setup.environment = EnvironmentOf(work_folder);
  setup.work_folder = work_folder;
  setup.readable = python.readable;
  setup.readable.push_back(code_folder);
  if (code.package) {
    const std::vector<std::string> more = {(fs::path(python.package) / "gaitwright").string(), RobotsFolder(),
                                           BuiltInGaitsFile()};
    setup.readable.insert(setup.readable.end(), more.begin(), more.end());
  }
  return setup;
}

}  // namespace

Result<StudentPython> StudentPython::Start(const PythonProgram& python, const StudentCode& code,
                                           const ChildLimits& limits, bool confined) {
  auto parts = std::make_unique<Parts>();
  if (auto failure = parts->Make(code.files)) return *failure;
  ChildSetup setup = SetupOf(python, code, parts->Code(), parts->Work());
  setup.limits = limits;
  setup.confined = confined;
  Result<ChildProcess> child = ChildProcess::Start(setup);
  if (!child) return child.failure();
  parts->child = std::make_unique<ChildProcess>(std::move(*child));
  const nlohmann::ordered_json load = {{"load",
                                        {{"code", parts->Code()},
                                         {"file", code.files.front().path},
                                         {"function", code.function},
                                         {"package", code.package ? python.package : ""}}}};
  StudentPython started(std::move(parts));
  const Result<std::string> loaded = started.Ask(load.dump(), kShortAnswer);
  if (!loaded) return loaded.failure();
  return started;
}

StudentPython::StudentPython(std::unique_ptr<Parts> parts) : parts_(std::move(parts)) {}
StudentPython::StudentPython(StudentPython&&) noexcept = default;

namespace {

Failure Said(const std::string& words) {
  return {FailureKind::kBadInput, FailureCode::kSubmission, "StudentPython", words, {}};
}

/// The text without any `part`: the folder has a different name in each run.
std::string Without(const std::string& part, std::string text) {
  for (std::size_t at = 0; (at = text.find(part, at)) != std::string::npos;) text.erase(at, part.size());
  return text;
}

}  // namespace

/// Ends the process before its folders are removed.
StudentPython::~StudentPython() {
  if (parts_) parts_->child.reset();
}

Result<std::string> StudentPython::Lend(const std::string& name, const std::string& text) const {
  return parts_->Lend(name, text);
}

Result<std::string> StudentPython::Ask(const std::string& request, std::size_t longest) {
  Result<std::string> line = parts_->child->Ask(request, longest);
  if (!line) return line;
  constexpr std::string_view kAnswer = "{\"answer\": ", kError = "{\"error\": ";
  if (line->starts_with(kAnswer)) return line;
  const auto json =
      nlohmann::ordered_json::parse(line->substr(0, line->starts_with(kError) ? std::string::npos : 0), nullptr, false);
  if (json.is_object() && json.contains("error") && json["error"].is_string()) {
    return Said(ShownWords(Without(parts_->base.path() + "/", json["error"].get<std::string>())));
  }
  return Said("its answer cannot be read");
}

bool EndedIt(const Failure& failure) { return failure.code != FailureCode::kSubmission; }

std::string ShownWords(const std::string& words) {
  static const std::regex kAddress("0x[0-9a-fA-F]{6,}");
  std::string shown = FirstBytes(words, kMostWords);
  if (!IsPlainText(shown)) {
    for (char& c : shown) {
      if (c < ' ' || c > '~') c = '?';
    }
  }
  for (char& c : shown) {
    if (c == '\n' || c == '\r' || c == '\t') c = ' ';
  }
  return std::regex_replace(shown, kAddress, "0x...");
}

}  // namespace gaitwright
