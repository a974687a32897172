// SPDX-License-Identifier: BSD-3-Clause
#include "cli/shown_motion.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <iterator>

#include "kinematics/base/file.h"
#include "planning/plan/plan_json.h"
#include "planning/plan/sample_plan.h"
#include "playback/log/log_json.h"
#include "playback/play/play.h"
#include "playback/report/report_page.h"
#include "workflows/exchange/motion_file.h"
#include "workflows/walk/walk.h"

namespace gaitwright::cli {
namespace {

constexpr char kShowStage[] = "ReadMotionToShow";
constexpr double kSameTime = 1e-6;  // [s]

/// Posture of a plan at a time since its start; empty after its end.
VectorX PostureAt(const WholeBodyTrajectory& rows, double time_s) {
  if (rows.q.empty() || time_s > rows.end_s() - rows.start_s + kSameTime) return {};
  WholeBodySample sample;
  SampleWholeBody(rows, rows.start_s + time_s, sample);
  return sample.q;
}

Result<MotionToShow> ShownPlan(MotionPlan plan) {
  Result<RobotModel> model = RobotOf(plan);
  if (!model) return model.failure();
  const std::string title = TitleOf(*model, plan);
  return MotionToShow{std::move(*model), std::move(plan), {}, {}, title};
}

/// Reads the plan that a log was played from: `plan_path`, or the plan beside the log.
Result<MotionPlan> PlayedPlan(const PlaybackLog& log, const std::string& path, const std::string& plan_path) {
  const std::string beside = (std::filesystem::path(path).parent_path() / "plan.json").string();
  if (plan_path.empty() && !std::filesystem::exists(beside)) {
    return Failure{FailureKind::kBadInput,
                   FailureCode::kNoPlan,
                   kShowStage,
                   fmt::format("'{}' is a log, which does not contain the ground and the plan, and '{}' does not exist",
                               path, beside),
                   {"--plan FILE, the plan that was played"}};
  }
  const std::string& from = plan_path.empty() ? beside : plan_path;
  Result<MotionPlan> plan = LoadPlan(from);
  if (plan && MotionHash(*plan) != log.plan_hash) {
    return Failure{
        FailureKind::kBadInput,
        FailureCode::kOtherPlan,
        kShowStage,
        fmt::format("'{}' is not the plan that '{}' was played from: its motion has hash {}, but the log has {}", from,
                    path, MotionHash(*plan), log.plan_hash),
        {"--plan FILE, the plan that was played"}};
  }
  return plan;
}

}  // namespace

ShownMotion MotionToShow::Shown(const std::optional<std::string>& mesh_folder) const {
  return {title, model, plan, log ? &*log : nullptr, report ? &*report : nullptr, "", mesh_folder};
}

ShownGhost MotionToShow::AsGhost() const {
  if (!log) return {title, [this](double time_s) { return PostureAt(plan.whole_body, time_s); }};
  return {title, [this](double time_s) {
            const std::vector<LogSample>& rows = log->samples;
            const double at_s = rows.empty() ? 0.0 : rows.front().time_s + time_s;
            const auto next = std::upper_bound(rows.begin(), rows.end(), at_s + kSameTime,
                                               [](double t, const LogSample& row) { return t < row.time_s; });
            if (next == rows.begin() || (next == rows.end() && at_s > rows.back().time_s + kSameTime)) return VectorX();
            return std::prev(next)->q;
          }};
}

Result<MotionToShow> ReadMotionToShow(const std::string& path, const std::string& plan_path) {
  const Result<std::string> text = ReadFile(path);
  if (!text) return text.failure();
  const MotionFileKind kind = KindOfText(*text);
  if (kind == MotionFileKind::kPlan) {
    Result<MotionPlan> plan = PlanFromJson(*text, path);
    return plan ? ShownPlan(std::move(*plan)) : plan.failure();
  }
  if (kind != MotionFileKind::kLog) {
    return Failure{FailureKind::kBadInput,
                   FailureCode::kNoMotion,
                   kShowStage,
                   fmt::format("'{}' is {}, neither a plan nor a log", path, NameOf(kind)),
                   {"give a plan.json or log.json, as written by 'walk'",
                    "for a motion from other software: gaitwright import FILE"}};
  }
  Result<PlaybackLog> log = LogFromJson(*text, path);
  if (!log) return log.failure();
  Result<MotionPlan> plan = PlayedPlan(*log, path, plan_path);
  if (!plan) return plan.failure();
  Result<MotionToShow> shown = ShownPlan(std::move(*plan));
  if (!shown) return shown;
  shown->log = std::move(*log);
  shown->report = Score(shown->model, shown->plan, *shown->log);
  return shown;
}

void CheckShown(const std::vector<MotionToShow>& motions, const std::string& plan_path,
                const std::string& mesh_folder) {
  const bool any_log = std::any_of(motions.begin(), motions.end(), [](const auto& m) { return m.log.has_value(); });
  if (!plan_path.empty() && !any_log)
    throw InvalidArgument(fmt::format("--plan '{}' is for logs, but a plan is shown", plan_path));
  if (!mesh_folder.empty() && !std::filesystem::is_directory(mesh_folder))
    throw InvalidArgument(fmt::format("--meshes '{}' is not a folder", mesh_folder));
}

}  // namespace gaitwright::cli
