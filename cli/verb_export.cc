// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>

#include "cli/flags.h"
#include "cli/json_text_internal.h"
#include "cli/motion_input.h"
#include "cli/paths.h"
#include "cli/program.h"
#include "workflows/exchange/export_motion.h"

namespace gaitwright::cli {
namespace {

struct ExportSettings {
  Common common;
  MotionRobot robot;
  std::string motion, format = "csv", out;
  double rate_hz = 0.0;
  bool cycle = false;
};

/// Default of --out.
std::string UsualOut(ExportFormat format) {
  switch (format) {
    case ExportFormat::kCsv:
      return "motion.csv";
    case ExportFormat::kTrajectoryYaml:
      return "trajectory.yaml";
    case ExportFormat::kTrajectoryJson:
      return "trajectory.json";
    case ExportFormat::kNpz:
    case ExportFormat::kFramesNpz:
      return "motion.npz";
    case ExportFormat::kFramesCsv:
      return "motion.csv";
    case ExportFormat::kFramesJson:
      return "motion.json";
    case ExportFormat::kMcap:
      return "motion.mcap";
    case ExportFormat::kMjcf:
      return "model.xml";
    case ExportFormat::kSvg:
      break;
  }
  return "plots";
}

void CheckExportPaths(const ExportSettings& a, ExportFormat format) {
  const bool plots = format == ExportFormat::kSvg;
  const std::string file = plots ? (std::filesystem::path(a.out) / "top_view.svg").string() : a.out;
  const std::string ending = EndingOf(plots ? file : UsualOut(format));
  Paths paths;
  paths.Read("the motion", a.motion);
  paths.Read("--plan", a.robot.plan);
  paths.Write("--out", file, {ending});
  a.robot.robot.AddTo(paths);
  CheckPaths(paths);
}

/// Key of the output in the JSON result.
const char* KindOfFile(const std::string& format) {
  if (format == "svg") return "plots";
  return format == "mjcf" ? "model" : "motion";
}

void PrintExported(const ExportSettings& a, const std::string& kind, const std::string& robot,
                   const ExportedMotion& done) {
  if (a.common.json) {
    nlohmann::ordered_json json = {{"format", a.format},
                                   {"from", kind},
                                   {"robot", robot},
                                   {"rows", done.rows},
                                   {"rate_hz", done.rate_hz},
                                   {"start_s", done.start_s},
                                   {"end_s", done.end_s},
                                   {"notes", done.notes},
                                   {"files", nlohmann::ordered_json::object()}};
    json["files"][KindOfFile(a.format)] = a.out;
    PrintJson(json);
    return;
  }
  if (a.common.quiet) {
    fmt::print("{}\n", a.out);
    return;
  }
  fmt::print("{} of {} as {}", kind, robot, a.format);
  if (done.rows > 0)
    fmt::print(": {} rows at {:.6g} Hz, {:.3f} to {:.3f} s", done.rows, done.rate_hz, done.start_s, done.end_s);
  fmt::print("\n");
  for (const std::string& note : done.notes) fmt::print("note: {}\n", note);
  for (const OutputFile& file : done.files)
    fmt::print("{:<7} {}\n", a.format == "svg" ? "plot" : KindOfFile(a.format), file.path);
}

Result<ExportedMotion> ExportInput(const ExportSettings& a, const MotionInput& input, ExportFormat format) {
  const ExportPart part = a.cycle ? ExportPart::kCycle : ExportPart::kAll;
  if (input.plan) return ExportPlan(*input.model, *input.plan, format, a.rate_hz, a.out, part);
  if (a.cycle) throw InvalidArgument("--cycle is for plans; a log has no cycle that repeats exactly");
  return ExportLog(*input.model, *input.log, input.played ? &*input.played : nullptr, format, a.rate_hz, a.out);
}

int RunExport(ExportSettings& a) {
  const ExportFormat format = ExportFormatOf(a.format);
  if (a.out.empty()) a.out = UsualOut(format);
  CheckExportPaths(a, format);
  const Result<MotionInput> input = ReadMotionInput(a.motion, a.robot);
  if (!input) return Report(input.failure(), a.common);
  const Result<ExportedMotion> done = ExportInput(a, *input, format);
  if (!done) return Report(done.failure(), a.common);
  const auto written = WriteFilesTogether(done->files);
  if (!written) return Report(written.failure(), a.common);
  PrintExported(a, input->plan ? "plan" : "log", input->model->name, *done);
  return kPass;
}

}  // namespace

void AddExport(Verb program, int& status) {
  auto a = std::make_shared<ExportSettings>();
  const Verb verb =
      program.AddVerb("export", "Convert a plan or a log for other programs: CSV, ROS, MCAP, NumPy, plots, MuJoCo");
  AddText(verb, "MOTION", "FILE", a->motion, "A plan or a log, as written by 'plan', 'walk' and 'play'.").Require();
  AddText(verb, "--format", "NAME", a->format,
          "csv, joint-trajectory-yaml, joint-trajectory-json (trajectory_msgs/JointTrajectory of ROS 2), npz (NumPy), "
          "frames-csv, frames-json, frames-npz (frames as retargeted data sets, motion_imitation and frameworks for "
          "imitation learning have them), mcap (a recording of ROS 2), svg (plots) or mjcf (MuJoCo's model of robot, "
          "ground, first posture and "
          "gains); default csv.");
  AddNumber(verb, "--rate-hz", "Hz", a->rate_hz,
            "Rows per second, from 0.1 to 10000, for a log at most its own rate; default 0: the motion's own rate, for "
            "a plan at least 200.");
  verb.AddSwitch("--cycle", a->cycle,
                 "Export one cycle of a plan's steady walk, whose last row continues with the first.");
  AddText(
      verb, "--out", "PATH", a->out,
      "Output file, or folder of plots; default motion.csv, trajectory.yaml, trajectory.json, motion.npz, motion.json, "
      "motion.mcap, plots or model.xml.");
  a->robot.AddTo(verb);
  AddCommon(verb, a->common,
            {"export plan.json --format csv --rate-hz 500 --out motion.csv",
             "export plan.json --format joint-trajectory-yaml --out trajectory.yaml",
             "export out/log.json --plan out/plan.json --format npz --out motion.npz"});
  SetWork(verb, a->common, status, [a] { return RunExport(*a); });
}

}  // namespace gaitwright::cli
