// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <system_error>

#include "cli/flags.h"
#include "cli/helping_rank.h"
#include "cli/interruptible.h"
#include "cli/motion_source_internal.h"
#include "cli/output.h"
#include "cli/paths.h"
#include "cli/program.h"
#include "cli/progress_bar.h"
#include "cli/write_results.h"
#include "kinematics/base/file.h"
#include "planning/plan/plan_json.h"
#include "workflows/exchange/recorded_motion_internal.h"
#include "workflows/repair/kept_solves_internal.h"
#include "workflows/repair/played_repair_internal.h"
#include "workflows/repair/repair_folder_internal.h"
#include "workflows/repair/repair_page_internal.h"

namespace gaitwright::cli {
namespace {

struct RepairSettings {
  Common common;
  RepairRequest request;
  RobotFlags robot;
  std::string out;  ///< "": the usual one
  std::string report;
  int threads = 0;
  bool check = false, no_play = false, resume = false;

  std::string Table() const { return (std::filesystem::path(out) / "clips.csv").string(); }
  /// @param result  the table, or the plan of a single motion.
  static std::string SoFar(const std::string& result) { return result + ".so-far"; }
};

int PrintRepair(const RepairResult& result, const Files& files, const Common& common) {
  if (common.json) {
    fmt::print("{}\n", RepairJson(result, files));
  } else if (common.quiet) {
    fmt::print("{}\n", result.pass() ? "pass" : "fail");
  } else {
    fmt::print("{}", RepairText(result));
    for (const auto& [kind, path] : files) fmt::print("{:<7} {}\n", kind, path);
  }
  return result.pass() ? kPass : kVerdictFail;
}

/// Writes the page of --report, if it is wanted. @param refused  why there is no repair, or "".
Result<std::string> WritePage(const RepairSettings& a, const RepairResult& result, const std::string& refused) {
  if (a.report.empty()) return a.report;
  RepairPageWords words{a.request.source.file, refused};
  if (a.robot.is_file()) words.mesh_folder = a.robot.folder();
  return WriteFileAtomically(a.report, RepairPage(result, words));
}

/// The findings on a motion, kept for its page.
Result<MotionFindings> Examined(const RepairSettings& a, const RobotModel& model) {
  RepairRequest request = a.request;
  request.keeps_plan = !a.report.empty();
  return ExamineMotion(model, request);
}

/// Reports why a motion was refused; if it could be read, also on the page.
int ReportRefusal(const RepairSettings& a, const RobotModel& model, const Failure& failure) {
  if (!a.report.empty()) {
    if (const Result<MotionFindings> findings = Examined(a, model)) {
      const auto written = WritePage(a, {model, *findings}, failure.message);
      if (!written) return Report(written.failure(), a.common);
    }
  }
  return Report(failure, a.common);
}

/// Shows a progress bar over the windows of all solves: two solves are usual, more are added when they come.
Result<PlayedRepair> RepairWithBar(const RobotModel& model, const RepairSettings& a, JobJournal& journal) {
  ProgressBar bar(!a.common.quiet, "windows");
  KeptSolves kept(journal);
  RepairRequest request = a.request;
  request.record = &kept;
  request.progress = [&](const FollowProgress& p) {
    bar.Show({(p.solve - 1) * p.all + p.done, std::max(2, p.solve) * p.all}, fmt::format("solve {}", p.solve));
  };
  try {
    return RepairAndPlay(model, request, !a.no_play);
  } catch (const CannotKeep& error) {
    return Failure{FailureKind::kBadInput, FailureCode::kSoFar, "RepairMotion", error.what(), {}};
  }
}

Files WithReport(const RepairSettings& a, Files files) {
  if (!a.report.empty()) files.emplace_back("report", a.report);
  return files;
}

int RunOne(const RepairSettings& a, const RobotModel& model) {
  if (a.check) {
    const Result<MotionFindings> findings = Examined(a, model);
    if (!findings) return Report(findings.failure(), a.common);
    const RepairResult result{model, *findings};
    const auto written = WritePage(a, result, "");
    if (!written) return Report(written.failure(), a.common);
    return PrintRepair(result, WithReport(a, {}), a.common);
  }
  const Result<std::string> identity = MotionIdentity(model, {a.request, a.out, false, !a.no_play});
  if (!identity) return Report(identity.failure(), a.common);
  Result<JobJournal> journal = JobJournal::Open(RepairSettings::SoFar(a.out), *identity, a.resume);
  if (!journal) return Report(journal.failure(), a.common);
  const Result<PlayedRepair> done = RepairWithBar(model, a, *journal);
  if (!done) {
    if (done.failure().code != FailureCode::kSoFar) journal->Remove();
    return ReportRefusal(a, model, done.failure());
  }
  const Result<std::string> saved = SavePlan(done->repaired.plan, a.out);
  if (!saved) return Report(saved.failure(), a.common);
  journal->Remove();
  const RepairResult result = done->ResultOf(model);
  const auto written = WritePage(a, result, "");
  if (!written) return Report(written.failure(), a.common);
  return PrintRepair(result, WithReport(a, {{"plan", a.out}}), a.common);
}

void PrintClips(const RepairSettings& a, const RobotModel& model, const std::vector<ClipOutcome>& clips) {
  const auto passed =
      std::count_if(clips.begin(), clips.end(), [](const auto& c) { return c.verdict == ClipVerdict::kPass; });
  if (a.common.json) {
    fmt::print("{}\n", ClipsJson(model, clips, a.Table()));
  } else if (a.common.quiet) {
    fmt::print("{} of {} pass\n", passed, clips.size());
  } else {
    fmt::print("{}table   {}\n", ClipsText(clips), a.Table());
  }
}

/// What all ranks of a run repair.
struct FolderInputs {
  FolderRequest request;
  std::vector<std::string> clips;
  std::string identity;
};

Result<FolderInputs> ReadFolderInputs(const RepairSettings& a, const RobotModel& model) {
  FolderInputs folder{{a.request, a.out, a.check, !a.no_play}, ClipsOf(a.request.source.file), {}};
  const Result<std::string> identity = FolderIdentity(model, folder.request, folder.clips);
  if (!identity) return identity.failure();
  folder.identity = *identity;
  return folder;
}

/// Repairs the clips on this rank's threads and on the other ranks.
Result<std::vector<ClipOutcome>> RepairOnAllRanks(const RepairSettings& a, const RobotModel& model,
                                                  const FolderInputs& folder, JobJournal& journal, SharedWork& work) {
  const Result<std::vector<PieceRunner>> runners = work.Runners({.work = folder.identity, .problem = ""});
  if (!runners) return runners.failure();
  std::vector<std::function<std::string(std::size_t)>> elsewhere;
  for (const PieceRunner& run : *runners)
    elsewhere.emplace_back([&run](std::size_t clip) { return run(static_cast<int>(clip)); });
  ProgressBar bar(!a.common.quiet, "clips");
  const int before = static_cast<int>(journal.found());
  const auto show = [&](std::size_t done, std::size_t of) {
    bar.Show({before + static_cast<int>(done), before + static_cast<int>(of), before},
             Interruptible::asked() ? "ending" : "");
  };
  const int threads = a.threads == 0 && !elsewhere.empty() ? 1 : a.threads;
  return RepairClips(model, folder.request, folder.clips, journal, {threads, show, Interruptible::asked}, elsewhere);
}

int RunFolder(const RepairSettings& a, const RobotModel& model, SharedWork& work) {
  const Result<FolderInputs> folder = ReadFolderInputs(a, model);
  if (!folder) return Report(folder.failure(), a.common);
  std::filesystem::create_directories(a.out);
  Result<JobJournal> journal = JobJournal::Open(RepairSettings::SoFar(a.Table()), folder->identity, a.resume);
  if (!journal) return Report(journal.failure(), a.common);
  const Interruptible interruptible;
  const auto outcomes = RepairOnAllRanks(a, model, *folder, *journal, work);
  if (!outcomes) {
    const int status = Report(outcomes.failure(), a.common);
    return outcomes.failure().code == FailureCode::kInterrupted ? kInterrupted : status;
  }
  const auto written = WriteResults({{a.Table(), ClipsCsv(*outcomes)}}, RepairSettings::SoFar(a.Table()));
  if (!written) return Report(written.failure(), a.common);
  journal->Remove();
  PrintClips(a, model, *outcomes);
  const bool all =
      std::all_of(outcomes->begin(), outcomes->end(), [](const auto& c) { return c.verdict == ClipVerdict::kPass; });
  return all ? kPass : kVerdictFail;
}

/// Completes the settings. @return whether the motion is a folder of motions.
bool Settle(RepairSettings& a, const Ranks& ranks) {
  ApplySets("--set", a.common.sets, a.request.Fields());
  std::error_code ignored;
  const bool is_folder =
      std::filesystem::is_directory(a.request.source.file, ignored) && !IsBagFolder(a.request.source.file);
  if (a.out.empty()) a.out = is_folder ? "repaired" : "repaired.json";
  if (!a.report.empty() && is_folder) throw InvalidArgument("--report is for a single motion, not for a folder");
  if (!is_folder && ranks.count() > 1) {
    throw InvalidArgument(fmt::format(
        "a single motion is repaired in one process, and MPI has started {}; only folders are shared", ranks.count()));
  }
  return is_folder;
}

/// See HelpRank0.
std::optional<Failure> HelpWithRepair(RepairSettings& a, SharedWork& work) {
  Settle(a, work.ranks());
  const Result<RobotModel> model = ReadRobot(a.robot);
  if (!model) return model.failure();
  const Result<FolderInputs> folder = ReadFolderInputs(a, *model);
  if (!folder) return folder.failure();
  work.Serve({.work = folder->identity, .problem = ""}, [&](int piece) {
    return RepairOneClip(*model, folder->request, folder->clips.at(static_cast<std::size_t>(piece)));
  });
  return std::nullopt;
}

int RunRepair(RepairSettings& a) {
  SharedWork work(Ranks::Join());
  if (!work.ranks().leads()) return HelpRank0(work, [&] { return HelpWithRepair(a, work); });
  const bool is_folder = Settle(a, work.ranks());
  Paths paths;
  AddSourcePaths(a.request.source, a.robot, paths);
  paths.Read("--weights", a.request.weights_file);
  if (is_folder) {
    paths.Write("the table", a.Table(), {".csv"});
    paths.Write("the run so far", RepairSettings::SoFar(a.Table()));
  } else if (!a.check) {
    paths.Write("the plan", a.out, {".json"});
    paths.Write("the run so far", RepairSettings::SoFar(a.out));
  }
  paths.Write("--report", a.report, {".html"});
  CheckPaths(paths);
  const Result<RobotModel> model = ReadRobot(a.robot);
  if (!model) return Report(model.failure(), a.common);
  return is_folder ? RunFolder(a, *model, work) : RunOne(a, *model);
}

}  // namespace

void AddRepair(Verb program, int& status) {
  auto a = std::make_shared<RepairSettings>();
  const Verb verb = program.AddVerb("repair", "Change a motion as little as possible so that the robot can do it");
  AddMotionSource(
      verb, "MOTION",
      "The motion: a CSV with named columns, or frames without names as retargeted data sets have them (.csv, .tsv, "
      ".txt); a ROS joint trajectory (.yaml, .yml, .json); frames of motion_imitation (.txt, .json); arrays "
      "of NumPy (.npz); a recording of ROS 2 (.mcap, .db3, or the folder of a bag); a skeleton with the robot's joints "
      "(.bvh); frames of DeepMimic (.json, .txt); or a folder of such files.",
      a->request.source, a->robot);
  verb.SetGroup("Repair");
  AddField(verb, "--stretch", a->request.Fields(), "repair.stretch");
  AddField(verb, "--leave-out", a->request.Fields(), "repair.leave_out");
  AddText(verb, "--weights", "FILE", a->request.weights_file,
          "YAML file of weights by part of the body and by time, see docs/repair.md; default: repair.joint, "
          "repair.base_position and repair.base_rotation everywhere.");
  verb.SetGroup("Output");
  AddText(
      verb, "--out", "FILE", a->out,
      "Plan file to write, its folder is created if missing; default repaired.json. For a folder of motions: folder of "
      "the plans and of the table clips.csv; default repaired.");
  AddText(verb, "--report", "FILE", a->report,
          "Write a page about a single motion to this HTML file: failing checks before and after, distance, changes, "
          "and the motion in 3D with the original as a ghost; also if the motion fails or is refused; default: none.");
  verb.AddSwitch("--check", a->check, "Only report what is wrong with the motion, without a repair; default: no.");
  verb.AddSwitch("--no-play", a->no_play, "Do not play the plan in physics; default: no.");
  verb.AddSwitch("--resume", a->resume, "Continue an interrupted run over a folder or a long motion; default: no.");
  verb.SetGroup("Folders");
  AddWholeNumber(verb, "--threads", 0, a->threads,
                 "Number of motions that are repaired at the same time; default 0: one per core.");
  AddCommon(
      verb, a->common,
      {"repair dance.csv --urdf g1.urdf --out dance.json --report dance.html",
       "repair pace.txt --robot laikago --check --json", "repair clips --urdf g1.urdf --out repaired --threads 4"});
  AddOptionFlags(verb, a->request.Fields(), a->common.sets, a->common.json);
  SetWorkInRanks(verb, a->common, status, [a] { return RunRepair(*a); });
}

}  // namespace gaitwright::cli
