// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <optional>
#include <set>
#include <tuple>
#include <utility>

#include "kinematics/base/file.h"
#include "kinematics/base/hash.h"
#include "kinematics/base/text.h"
#include "kinematics/base/version.h"
#include "planning/plan/plan_json.h"
#include "workflows/exchange/read_motion_internal.h"
#include "workflows/exchange/recorded_motion_internal.h"
#include "workflows/repair/clip_table_internal.h"
#include "workflows/repair/played_repair_internal.h"
#include "workflows/repair/repair_folder_internal.h"

namespace gaitwright {
namespace {

namespace fs = std::filesystem;

void SetBefore(const MotionFindings& findings, ClipOutcome& outcome) {
  outcome.duration_s = findings.duration_s;
  outcome.broken_share = 1.0;
  if (!findings.before) return;
  outcome.broken_share = 0.0;
  outcome.violations = static_cast<int>(findings.before->violations.size());
  for (const BrokenTime& broken : findings.broken) {
    if (broken.share <= outcome.broken_share) continue;
    outcome.broken_share = broken.share;
    outcome.broken = LawName(broken.law);
  }
}

ClipOutcome RefusedClip(const std::string& clip, const Failure& failure) {
  ClipOutcome outcome;
  outcome.clip = clip;
  outcome.verdict = ClipVerdict::kRefused;
  outcome.broken_share = 1.0;
  outcome.reason = failure.message;
  return outcome;
}

std::string ReasonOf(const PlayedRepair& done) {
  const AuditReport& after = done.repaired.after;
  if (!after.pass()) {
    const Violation& worst = after.violations.front();
    return fmt::format("{} at {:.3f} s, {}", LawName(worst.law), worst.at_s, worst.where);
  }
  return done.played ? done.played->decisive().report.reason : "";
}

void SetAfter(const RobotModel& model, const PlayedRepair& done, ClipOutcome& outcome) {
  outcome.verdict = done.ResultOf(model).pass() ? ClipVerdict::kPass : ClipVerdict::kFail;
  outcome.joint_rms_rad = done.repaired.distance.joint_rms_rad;
  outcome.joint_largest_rad = done.repaired.distance.joint_largest_rad;
  outcome.base_rms_m = done.repaired.distance.base_rms_m;
  if (!done.repaired.findings.kept) {
    for (const RepairChange& change : ChangesOf(model, done.repaired.findings)) {
      if (change.kind == RepairChangeKind::kSlowed) outcome.slowed_s += change.by;
      if (change.kind == RepairChangeKind::kLeftOut) outcome.left_out_s += change.by;
    }
  }
  if (outcome.verdict != ClipVerdict::kFail) return;
  outcome.reason = ReasonOf(done);
  const MotionFindings& findings = done.repaired.findings;
  if (!findings.lost.empty()) outcome.reason += "; " + LostText(findings.lost, findings.duration_s);
}

/// @throws CannotKeep if the plan cannot be written.
ClipOutcome RepairClip(const RobotModel& model, const FolderRequest& request, const std::string& clip) {
  RepairRequest one = request.repair;
  one.source.file = (fs::path(request.repair.source.file) / clip).string();
  one.progress = {};
  ClipOutcome outcome;
  outcome.clip = clip;
  if (request.check) {
    const Result<MotionFindings> findings = ExamineMotion(model, one);
    if (!findings) return RefusedClip(clip, findings.failure());
    SetBefore(*findings, outcome);
    outcome.verdict = findings->before && findings->before->pass() ? ClipVerdict::kPass : ClipVerdict::kFail;
    outcome.reason = findings->not_audited;
    return outcome;
  }
  const Result<PlayedRepair> done = RepairAndPlay(model, one, request.plays);
  if (!done) return RefusedClip(clip, done.failure());
  SetBefore(done->repaired.findings, outcome);
  SetAfter(model, *done, outcome);
  outcome.plan = (fs::path(request.out) / (clip + ".plan.json")).string();
  if (const auto saved = SavePlan(done->repaired.plan, outcome.plan); !saved) throw CannotKeep(saved.failure().message);
  return outcome;
}

void SortClips(std::vector<ClipOutcome>& outcomes) {
  std::sort(outcomes.begin(), outcomes.end(), [](const ClipOutcome& a, const ClipOutcome& b) {
    return std::tuple(a.verdict, -a.broken_share, -a.joint_rms_rad, a.clip) <
           std::tuple(b.verdict, -b.broken_share, -b.joint_rms_rad, b.clip);
  });
}

/// Hash of a file, or of all files of a folder.
Result<std::string> HashOfClip(const std::string& path) {
  if (!fs::is_directory(path)) {
    const Result<std::string> bytes = ReadBytes(path);
    return bytes ? Result<std::string>(HexHash(*bytes)) : Result<std::string>(bytes.failure());
  }
  std::string hashes;
  std::set<fs::path> files;
  for (const fs::directory_entry& entry : fs::directory_iterator(path)) {
    if (entry.is_regular_file()) files.insert(entry.path());
  }
  for (const fs::path& file : files) {
    Result<std::string> hash = HashOfClip(file.string());
    if (!hash) return hash;
    hashes += file.filename().string() + ' ' + *hash + '\n';
  }
  return HexHash(hashes);
}

/// A line on a repair. @param contents  of what is repaired. @param kind  of it.
Result<std::string> IdentityOf(const RobotModel& model, const FolderRequest& request, std::string contents,
                               const std::string& kind) {
  RepairRequest repair = request.repair;
  for (const auto& [key, value] : TextsOf(repair.Fields())) contents += key + '=' + value + '\n';
  contents += repair.source.terrain + '\n' + request.out + '\n';
  for (const std::string& file : {repair.source.columns_file, repair.weights_file}) {
    if (file.empty()) continue;
    const Result<std::string> text = ReadFile(file);
    if (!text) return text.failure();
    contents += *text;
  }
  return fmt::format("repair {} {} {} {}{}{}", Version(), model.hash, kind, HexHash(contents),
                     request.check ? " check" : "", request.plays ? " plays" : "");
}

}  // namespace

std::vector<std::string> ClipsOf(const std::string& folder) {
  const std::vector<std::string>& endings = MotionEndings();
  std::vector<std::string> clips;
  for (auto entry = fs::recursive_directory_iterator(folder); entry != fs::recursive_directory_iterator(); ++entry) {
    const bool is_bag = entry->is_directory() && IsBagFolder(entry->path().string());
    if (is_bag) entry.disable_recursion_pending();
    const std::string ending = LowerCase(entry->path().extension().string());
    const bool is_motion =
        entry->is_regular_file() && std::find(endings.begin(), endings.end(), ending) != endings.end();
    if (is_bag || is_motion) clips.push_back(fs::relative(entry->path(), folder).generic_string());
  }
  if (clips.empty())
    throw InvalidArgument(fmt::format("folder '{}' has no motion: {}", folder, fmt::join(endings, ", ")));
  std::sort(clips.begin(), clips.end());
  return clips;
}

Result<std::string> FolderIdentity(const RobotModel& model, const FolderRequest& request,
                                   const std::vector<std::string>& clips) {
  std::string contents;
  for (const std::string& clip : clips) {
    const Result<std::string> hash = HashOfClip((fs::path(request.repair.source.file) / clip).string());
    if (!hash) return hash.failure();
    contents += clip + ' ' + *hash + '\n';
  }
  return IdentityOf(model, request, contents, fmt::format("{} clips", clips.size()));
}

Result<std::string> MotionIdentity(const RobotModel& model, const FolderRequest& request) {
  const Result<std::string> hash = HashOfClip(request.repair.source.file);
  if (!hash) return hash.failure();
  return IdentityOf(model, request, *hash + '\n', "motion");
}

std::string RepairOneClip(const RobotModel& model, const FolderRequest& request, const std::string& clip) {
  return LineOf(RepairClip(model, request, clip));
}

Result<std::vector<ClipOutcome>> RepairClips(const RobotModel& model, const FolderRequest& request,
                                             const std::vector<std::string>& clips, JobJournal& journal,
                                             const JobOptions& options,
                                             const std::vector<std::function<std::string(std::size_t)>>& elsewhere) {
  std::vector<std::optional<ClipOutcome>> outcomes(clips.size());
  std::vector<std::size_t> order;
  for (std::size_t i = 0; i < clips.size(); ++i) {
    if (const std::optional<std::string> line = journal.Find(i)) {
      outcomes[i] = ClipOfLine(*line);
    } else {
      order.push_back(i);
    }
  }
  const auto keep = [&](std::size_t i, const std::string& line) {
    outcomes[i] = ClipOfLine(line);
    journal.Add(i, line);
  };
  std::vector<JobRunner> others;
  for (const auto& run : elsewhere) others.emplace_back([&run, &keep](std::size_t i) { keep(i, run(i)); });
  const auto job = [&](std::size_t i) { keep(i, RepairOneClip(model, request, clips[i])); };
  try {
    if (!RunJobs(order, job, options, others)) return Interrupted("RepairMotion");
  } catch (const CannotKeep& error) {
    return Failure{FailureKind::kBadInput, FailureCode::kSoFar, "RepairMotion", error.what(), {}};
  }
  std::vector<ClipOutcome> sorted;
  for (std::optional<ClipOutcome>& outcome : outcomes) sorted.push_back(std::move(*outcome));
  SortClips(sorted);
  return sorted;
}

}  // namespace gaitwright
