// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "kinematics/model/load_robot.h"
#include "planning/gait/load_gaits.h"
#include "workflows/grade/student_python.h"
#include "workflows/render/run_program.h"

namespace gaitwright {
namespace {

namespace fs = std::filesystem;

/// Python program that prints data about its interpreter on standard error; its argument is a folder that may contain
/// the package, or "".
constexpr char kTell[] = R"(
import json, os, sys, sysconfig
def package(folders):
    for folder in folders:
        if folder and os.path.isdir(os.path.join(folder, "gaitwright")):
            return folder
    return ""
found = package([sys.argv[1]] + sys.path)
try:
    import numpy
    numpy_there = True
except ImportError:
    numpy_there = False
own = [p for p in sys.path if os.path.exists(p)]
own += [sys.executable, os.path.realpath(sys.executable), os.path.join(sys.prefix, "pyvenv.cfg")]
own += [os.path.join(p, "lib") for p in (sys.prefix, sys.base_prefix)]
print(json.dumps({"version": list(sys.version_info[:3]), "path": sys.executable, "readable": own,
                  "package": found, "numpy": numpy_there}), file=sys.stderr)
)";

Failure NoPython(const std::string& why) {
  return {FailureKind::kBadInput, FailureCode::kPython, "LookOver", why, {"give one with --python PROGRAM"}};
}

/// The package beside the running program, in a build tree or under its prefix; "" if there is none.
std::string PackageBesideProgram() {
  std::error_code error;
  const fs::path folder = fs::read_symlink("/proc/self/exe", error).parent_path();
  for (const fs::path& tree : {folder, folder.parent_path()}) {
    if (fs::is_directory(tree / "python/gaitwright", error)) return (tree / "python").string();
  }
  for (fs::directory_iterator at(folder.parent_path() / "lib", error), end; !error && at != end; at.increment(error)) {
    if (!at->path().filename().string().starts_with("python")) continue;
    for (const char* packages : {"dist-packages", "site-packages"}) {
      std::error_code missing;
      if (fs::is_directory(at->path() / packages / "gaitwright", missing)) return (at->path() / packages).string();
    }
  }
  return "";
}

/// The shared libraries of the package in a release archive; "" if it needs only those of the system.
std::string LibrariesOf(const std::string& package) {
  std::error_code error;
  const fs::path folder = (fs::path(package) / "../../gaitwright").lexically_normal();
  return !package.empty() && fs::is_directory(folder, error) ? folder.string() : "";
}

std::string ChosenProgram(const std::string& program) {
  constexpr char kUsual[] = "/usr/bin/python3";
  std::error_code error;
  if (program.empty() && fs::exists(kUsual, error)) return kUsual;
  const std::string name = program.empty() ? "python3" : program;
  return name.find('/') == std::string::npos ? FindProgram({name}) : name;
}

/// Files that dynamic libraries and every Python need.
const std::vector<std::string> kSystem = {"/usr/lib",       "/usr/lib64",       "/lib",
                                          "/lib64",         "/usr/local/lib",   "/dev/urandom",
                                          "/etc/localtime", "/etc/ld.so.cache", "/usr/share/zoneinfo"};

PythonProgram FromJson(const nlohmann::ordered_json& report) {
  PythonProgram python;
  const std::vector<int> version = report.at("version").get<std::vector<int>>();
  python.path = report.at("path").get<std::string>();
  python.version = fmt::format("{}.{}.{}", version.at(0), version.at(1), version.at(2));
  python.readable = report.at("readable").get<std::vector<std::string>>();
  python.readable.insert(python.readable.end(), kSystem.begin(), kSystem.end());
  python.package = report.at("package").get<std::string>();
  if (const std::string libraries = LibrariesOf(python.package); !libraries.empty())
    python.readable.push_back(libraries);
  python.has_numpy = report.at("numpy").get<bool>();
  return python;
}

}  // namespace

Result<PythonProgram> LookOver(const std::string& program) {
  const std::string path = ChosenProgram(program);
  if (path.empty()) return NoPython(fmt::format("there is no Python '{}'", program.empty() ? "python3" : program));
  const Result<std::string> output = RunProgram(path, {"-I", "-B", "-c", kTell, PackageBesideProgram()});
  if (!output) return NoPython(output.failure().message);
  const std::size_t last = output->find("{\"version\"");
  const auto json =
      nlohmann::ordered_json::parse(last == std::string::npos ? "" : output->substr(last), nullptr, false);
  if (json.is_discarded()) return NoPython(fmt::format("'{}' is not Python 3: it printed '{}'", path, *output));
  PythonProgram python = FromJson(json);
  if (json.at("version").at(0) != 3 || json.at("version").at(1) < 9)
    return NoPython(fmt::format("'{}' is Python {}; 3.9 or newer is needed", path, python.version));
  return python;
}

std::string UnreadableForNobody(const PythonProgram& python) {
  if (geteuid() != 0 || python.package.empty()) return "";
  const auto allows = [](const fs::path& path, mode_t right) {
    struct stat what {};
    return stat(path.c_str(), &what) == 0 && (what.st_mode & right) != 0;
  };
  for (const std::string& needed : {(fs::path(python.package) / "gaitwright").string(), RobotsFolder()}) {
    std::error_code error;
    const fs::path path = fs::canonical(needed, error);
    if (error || !allows(path, S_IROTH)) return needed;
    for (fs::path at = path; at != at.root_path(); at = at.parent_path()) {
      if (fs::is_directory(at, error) && !allows(at, S_IXOTH)) return at.string();
    }
  }
  return "";
}

}  // namespace gaitwright
