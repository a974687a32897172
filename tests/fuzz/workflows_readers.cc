// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <cmath>
#include <filesystem>

#include "kinematics/base/file.h"
#include "kinematics/base/options_file.h"
#include "kinematics/model/load_robot.h"
#include "playback/trials/trial_outcome.h"
#include "tests/fuzz/exchange_readers.h"
#include "tests/fuzz/grade_readers.h"
#include "tests/fuzz/inputs.h"
#include "tests/fuzz/plan_laws.h"
#include "tests/fuzz/recording_readers.h"
#include "tests/fuzz/words_readers.h"
#include "tests/playback/trials/made_outcomes.h"
#include "workflows/live/live_requests.h"
#include "workflows/study/candidate_worth.h"
#include "workflows/study/centroidal_problems.h"
#include "workflows/study/job_journal.h"
#include "workflows/study/point_outcome.h"
#include "workflows/study/study_axes.h"
#include "workflows/study/trials_result.h"
#include "workflows/walk/walk.h"

namespace gaitwright::fuzz {
namespace {

bool IsShare(double value) { return value >= 0.0 && value <= 1.0; }

Verdict ReadResultOfTrials(const std::string& input) {
  const Result<TrialsResult> read = TrialsResultFromJson(input, "input");
  if (!read) return Verdict::kRefused;
  Require(read->n > 0 && read->survived >= 0 && read->survived <= read->n, "at most all trials survive");
  Require(IsShare(read->survival) && IsShare(read->survival_low) && IsShare(read->survival_high),
          "shares are from 0 to 1");
  Require(read->survival_low <= read->survival && read->survival <= read->survival_high,
          "an interval contains its share");
  for (const TrialsResult::Cause& cause : read->causes)
    Require(cause.count > 0 && cause.count <= read->n - read->survived, "causes are counted among the falls");
  Require(0 < read->different && read->different <= read->n, "at most all trials are different");
  Require(0 <= read->different_passed && read->different_passed <= read->different_survived &&
              read->different_survived <= read->different,
          "of the different trials, at most the survivors pass");
  return Verdict::kAccepted;
}

std::vector<std::string> MadeResultsOfTrials() {
  PlayRequest request;
  TrialSubject subject = made::Subject();
  subject.whole_plan_hash = "w";
  subject.options = TextsOf(request.Fields());
  return {RobustnessJson(ReduceTrials(subject, made::Outcomes(8, 25.0)))};
}

Verdict ReadAxis(const std::string& input, StudyLayout layout) {
  StudyAxis axis;
  try {
    axis = ParseAxis(input, layout);
  } catch (const InvalidArgument&) {
    return Verdict::kRefused;
  }
  WalkRequest walk;
  PlayRequest play;
  if (axis.is_range()) {
    Require(std::isfinite(axis.low) && std::isfinite(axis.high) && axis.low < axis.high, "a range is increasing");
    for (const double share : {0.0, 0.37, 1.0})
      ApplyPoint({axis}, {ValueAt(axis, share)}, walk, play);  // throws for a value that the option does not accept
  }
  Require(axis.values.size() <= kMostStudyPoints, "there are at most as many values as points");
  for (std::size_t k = 0; k < axis.values.size() && k < 100; ++k) ApplyPoint({axis}, {axis.values[k]}, walk, play);
  return Verdict::kAccepted;
}

/// The first byte selects the option of the axis.
Verdict ReadAnyAxis(const std::string& input) {
  if (input.empty()) return Verdict::kRefused;
  const StudyLayout layouts[] = {StudyLayout::kGrid, StudyLayout::kSamples, StudyLayout::kTuning};
  return ReadAxis(input.substr(1), layouts[static_cast<unsigned char>(input[0]) % 3]);
}

Verdict ReadPoint(const std::string& input) {
  const Result<PointOutcome> read = PointFromLine(input);
  if (!read) return Verdict::kRefused;
  Require(std::isfinite(read->score.value_or(0.0)) && std::isfinite(read->fell_at_s.value_or(0.0)),
          "numbers of a point are finite");
  if (read->survival) {
    const PointSurvival& s = *read->survival;
    Require(s.trials > 0 && s.survived >= 0 && s.survived <= s.trials, "at most all trials survive");
    Require(IsShare(s.share) && IsShare(s.low) && IsShare(s.high), "shares are from 0 to 1");
  }
  const std::string line = PointToLine(*read);
  Require(line.find('\n') == std::string::npos, "an outcome is one line");
  Require(PointToLine(PointFromLine(line).value()) == line, "a point is read back as it was");
  return Verdict::kAccepted;
}

Verdict ReadCandidate(const std::string& input) {
  const Result<CandidateWorth> read = WorthFromLine(input);
  if (!read) return Verdict::kRefused;
  Require(std::isfinite(MeanValue(*read, 100.0).value_or(0.0)), "a candidate's value is finite");
  Require(read->refusal.empty() || read->trials.empty(), "a refused candidate has no trials");
  Require(WorthFromLine(WorthToLine(*read)).value() == *read, "a candidate is read back as it was");
  return Verdict::kAccepted;
}

std::vector<std::string> MadeCandidates() {
  return {WorthToLine({"", {{91.5, true}, {12.25, false}}}), WorthToLine({"too fast for its \"legs\"", {}})};
}

std::vector<std::string> MadePoints() {
  PointOutcome good;
  good.point = 7;
  good.status = PointStatus::kGateMissed;
  good.code = "slip_m";
  good.score = 71.25;
  good.metrics = {0.1, std::nullopt};
  good.survival = SurvivalOf(20, 19, 80.0);
  PointOutcome refused;
  refused.code = "too_fast";
  refused.reason = "a line\nand \"another\"";
  return {PointToLine(good), PointToLine(refused)};
}

/// Only reads the request, so that no robot has to walk here.
Verdict ReadLive(const std::string& input) {
  static const RobotModel model = LoadNamedRobot("a1").value();
  try {
    Require(static_cast<bool>(ReadLiveRequest(model, input)), "an accepted request can be executed");
  } catch (const InvalidArgument&) {
    return Verdict::kRefused;
  }
  return Verdict::kAccepted;
}

std::vector<std::string> MadeRequests() {
  return {R"({"do":"pace","gait":"trot","speed_m_s":0.4,"yaw_rate_rad_s":-0.2})",
          R"({"do":"heading","heading_deg":90})",
          R"({"do":"pull","body":3,"at_m":[0,0,0.1],"by_m":[0.1,0,0.3],"along":true})",
          R"({"do":"ground","friction":0.6,"slope_deg":3,"slope_direction_deg":90})",
          R"({"do":"options","options":{"gains.stiffness_scale":1.2}})",
          R"({"do":"pose","q":[0,0,0.3,0,0,0,1,0,0.7,-1.4,0,0.7,-1.4,0,0.7,-1.4,0,0.7,-1.4]})",
          R"({"do":"nudge","dof":3,"by":0.1,"for_s":0.5})",
          R"({"do":"clock","paused":true,"steps":3})",
          R"({"do":"stand_up"})"};
}

/// Results that were stored are found again, together with new ones.
Verdict ReadJournal(const std::string& input) {
  const std::string path = InFile(input, ".so-far");
  std::size_t found = 0;
  {
    Result<JobJournal> journal = JobJournal::Open(path, "work", true);
    if (!journal) return Verdict::kRefused;
    found = journal->found();
    if (journal->Find(123456)) return Verdict::kAccepted;
    journal->Add(123456, "{}");
  }
  Result<JobJournal> again = JobJournal::Open(path, "work", true);
  Require(again.ok(), "a journal is opened again");
  Require(again->found() == found + 1 && again->Find(123456) == "{}", "a journal keeps its entries");
  return Verdict::kAccepted;
}

/// A journal as it is written, and the rest of it after a cut.
std::vector<std::string> MadeJournals() {
  const std::string path = InFile("", ".so-far");
  std::filesystem::remove(path);
  {
    Result<JobJournal> journal = JobJournal::Open(path, "work", false);
    journal->Add(3, "{\"a\":1}");
    journal->Add(0, "text");
  }
  const std::string whole = ReadFile(path).value();
  return {whole, whole.substr(0, whole.size() - 3)};
}

Verdict ReadProblems(const std::string& input) {
  const Result<CentroidalProblemSet> set = LoadCentroidalProblems(InFile(input, ".json"));
  if (!set) return Verdict::kRefused;
  Require(set->distance_m > 0.0 && set->duration_s > 0.0 && set->friction > 0.0, "requested values are positive");
  for (const Terrain& ground : set->grounds) CheckTerrainLaws(ground);
  for (const auto& [name, robot] : set->robots) {
    Require(robot.mass_kg > 0.0 && std::isfinite(robot.mass_kg) && robot.inertia_B.allFinite(), "masses are physical");
    Require(!robot.feet.empty() && robot.feet.size() <= 64, "a robot has feet");
    for (const CentroidalSchedule& schedule : robot.schedules) {
      Require(schedule.phase_durations_s.size() == robot.feet.size(), "a schedule has all feet");
      for (const auto& durations : schedule.phase_durations_s) {
        for (const double duration : durations) Require(duration > 0.0 && std::isfinite(duration), "phases take time");
      }
    }
  }
  return Verdict::kAccepted;
}

Verdict ReadOptionsOfFile(const std::string& input) {
  WalkRequest walk;
  PlayRequest play;
  const Result<OptionTexts> read = LoadOptionsFile(InFile(input, ".yaml"), StudyFields(walk, play));
  if (!read) return Verdict::kRefused;
  WalkRequest other_walk;
  PlayRequest other_play;
  OptionFields fields = StudyFields(other_walk, other_play);
  for (const auto& [key, text] : *read) SetOption(fields, key, text);
  CheckOptions(fields);
  return Verdict::kAccepted;
}

const std::vector<std::string> kJson = {"null", "true", "{}", "[]", "\"\"", "-1", "1e400", "0.5", "\\u0000"};

std::vector<std::string> WithJson(std::vector<std::string> words) {
  words.insert(words.end(), kJson.begin(), kJson.end());
  return words;
}

std::vector<Reader> StudyReaders() {
  const std::vector<std::string> keys = {"gait.cycle_s",   "speed",          "stabilised.dcm_gain", "play.friction",
                                         "swing.height_m", "play.actuation", "step_length",         "gait.duty_factor"};
  std::vector<std::string> axis = keys, options = keys;
  axis.insert(axis.end(), {"=", ":", ",", "0.1:1.5:20", "1,1.3,2", "1e400", "nan", "-1", "1e-300", "1000001", "true"});
  options.insert(options.end(), {": ", "\n", "&a", "*a", "---", "{", "}", "[", "]", "~", ".nan", "1e400", "-1", "'"});
  return {
      {"trials_result",
       ReadResultOfTrials,
       WithJson({"\"n\"", "\"survived\"", "\"survival\"", "\"survival_low\"", "\"survival_high\"", "\"causes\"",
                 "\"worst\"", "\"seed\"", "\"reason\"", "\"disturbances\"", "\"passed\"", "\"options\"", "\"rows\""}),
       {},
       MadeResultsOfTrials},
      {"axis", ReadAnyAxis, axis, {}, nullptr, 500},
      {"point", ReadPoint, WithJson({"\"point\"", "\"status\"", "\"survival\"", "\"metrics\""}), {}, MadePoints},
      {"candidate", ReadCandidate, WithJson({"\"refusal\"", "\"trials\"", "[0.5,true]"}), {}, MadeCandidates},
      {"journal", ReadJournal, {"\n", " ", "0", "-1", "18446744073709551616", "work", "{}"}, {}, MadeJournals},
      {"centroidal_problems",
       ReadProblems,
       WithJson({"\"robots\"", "\"mass_kg\"", "\"inertia\"", "\"feet\"", "\"schedules\"", "\"phase_durations_s\"",
                 "\"distance_m\"", "1e-300"}),
       {"tests/benchmarks/centroidal_problems.json"},
       nullptr,
       300},
      {"options_file", ReadOptionsOfFile, options, {}, nullptr, 500},
      {"live_request",
       ReadLive,
       WithJson({"\"do\"", "\"pace\"", "\"gait\"", "\"pull\"", "\"at_m\"", "\"pose\"", "\"q\"", "\"clock\"",
                 "\"steps\"", "\"options\"", "\"gains.stance_damping\"", "\"ground\"", "\"nudge\"", "\"reset\""}),
       {},
       MadeRequests}};
}

}  // namespace

const std::vector<Reader>& Readers() {
  static const std::vector<Reader> readers = [] {
    std::vector<Reader> all = ExchangeReaders();
    for (Reader& reader : RecordingReaders()) all.push_back(std::move(reader));
    for (Reader& reader : StudyReaders()) all.push_back(std::move(reader));
    for (Reader& reader : WordsReaders()) all.push_back(std::move(reader));
    for (Reader& reader : GradeReaders()) all.push_back(std::move(reader));
    return all;
  }();
  return readers;
}

}  // namespace gaitwright::fuzz
