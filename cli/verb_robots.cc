// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <optional>

#include "cli/flags.h"
#include "cli/json_text_internal.h"
#include "cli/paths.h"
#include "cli/program.h"
#include "cli/robot_input.h"
#include "cli/word_list.h"
#include "kinematics/base/file.h"
#include "kinematics/check/check_robot.h"
#include "kinematics/check/compare_robots.h"
#include "kinematics/collision/collision_checker.h"
#include "kinematics/ik/whole_body_ik.h"
#include "kinematics/model/describe.h"
#include "kinematics/model/load_robot.h"
#include "kinematics/model/names_description.h"
#include "kinematics/model/repaired_urdf.h"
#include "optimisation/pipeline/plan_posture.h"
#include "planning/tasks/repertoire.h"
#include "playback/control/gains.h"
#include "playback/viewer/viewer_page.h"
#include "workflows/render/render_pictures.h"
#include "workflows/render/robot_drawing.h"
#include "workflows/walk/walk.h"

namespace gaitwright::cli {
namespace {

struct RobotsSettings {
  Common common;
  std::string robot, file, png, page, against, repaired;
  RobotFlags loading;  ///< how to read its file
  PictureOptions picture;
};

/// The name or path of the robot, from the flags.
const std::string& RobotText(const RobotsSettings& a) {
  if (a.robot.empty() && a.file.empty())
    throw InvalidArgument(
        "ROBOT is required: a name from 'gaitwright robots', or the path of a URDF, xacro or MJCF file");
  return a.file.empty() ? a.robot : a.file;
}

/// Adds the robot: a name or a path as positional argument, or a file by flag.
void AddRobotTo(const Verb& verb, RobotsSettings& a) {
  const Flag named = AddText(verb, "ROBOT", "NAME", a.robot,
                             "A name from 'gaitwright robots', or the path of a URDF, xacro or MJCF file.");
  const Flag urdf = AddText(verb, "--urdf", "FILE", a.file, "A URDF or xacro file, as for other verbs; default none.");
  const Flag mjcf = AddText(verb, "--mjcf", "FILE", a.file, "An MJCF file, as for other verbs; default none.");
  named.Exclude(urdf).Exclude(mjcf);
  urdf.Exclude(mjcf);
  a.loading.AddLoadingTo(verb);
}

/// The robot flags for a name or a description file.
RobotFlags FlagsOf(const RobotsSettings& a) {
  if (!a.file.empty()) return {"", a.file, a.loading.loading};
  const bool is_file = NamesDescription(RobotText(a));
  return {is_file ? "" : a.robot, is_file ? a.robot : "", a.loading.loading};
}

/// The robot flags for another description.
RobotFlags FlagsOf(const std::string& text, const RobotLoading& loading) {
  const bool is_file = NamesDescription(text);
  return {is_file ? "" : text, is_file ? text : "", loading};
}

int ListRobots(const Common& common) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const std::string& name : RobotNames()) {
    const Result<RobotModel> model = LoadNamedRobot(name);
    if (!model) return Report(model.failure(), common);
    if (common.quiet && !common.json) fmt::print("{}\n", name);
    if (!common.json && !common.quiet) {
      fmt::print("{:<14} {} legs, {} motors, {:.1f} kg\n", name, model->legs.size(), model->num_dofs(),
                 model->total_mass_kg);
    }
    list.push_back({{"name", name},
                    {"legs", model->legs.size()},
                    {"motors", model->num_dofs()},
                    {"mass_kg", model->total_mass_kg}});
  }
  if (common.json) PrintJson(nlohmann::ordered_json{{"robots", list}});
  return kPass;
}

nlohmann::ordered_json SelfCollisionJson(const CollisionChecker& collision) {
  nlohmann::ordered_json left_out = nlohmann::ordered_json::array();
  for (const LeftOutPair& pair : collision.left_out())
    left_out.push_back({{"links", {pair.link_a, pair.link_b}}, {"reason", pair.reason}});
  return {{"pairs", collision.num_pairs()}, {"left_out", left_out}};
}

std::string SelfCollisionText(const CollisionChecker& collision) {
  std::string text =
      fmt::format("self-collision: {} pairs of shapes are checked; these are not:\n", collision.num_pairs());
  for (const LeftOutPair& pair : collision.left_out())
    text += fmt::format("  {} and {}: {}\n", pair.link_a, pair.link_b, pair.reason);
  return text;
}

constexpr char kDrawing[] = "drawing";  // the view that is not a 3D picture

bool NeedsViewer(const RobotsSettings& a) { return !a.page.empty() || a.picture.view != kDrawing; }

/// Shows the standing robot in 3D: as a page, and as a picture if a 3D view is requested.
Result<std::vector<OutputFile>> ShownRobot(const RobotModel& model, const RobotsSettings& a,
                                           const std::string& folder) {
  constexpr double kStand = 0.5;  // [s]
  const Result<MotionPlan> plan = PlanPosture(model, Hold(StandingKey(model), kStand), {});
  if (!plan) return plan.failure();
  ShownMotion shown{model.name, model, *plan};
  if (!folder.empty()) shown.mesh_folder = folder;
  const std::string page = ViewerPage(model.name, {shown});
  std::vector<OutputFile> files;
  if (!a.page.empty()) files.push_back({a.page, page});
  if (a.png.empty() || a.picture.view == kDrawing) return files;
  Result<std::string> png = RenderPng(page, 0.0, a.picture);
  if (!png) return png.failure();
  files.push_back({a.png, std::move(*png)});
  return files;
}

/// Draws the robot if requested. @return the failure, or nothing.
std::optional<Failure> DrawRobot(const RobotModel& model, const RobotsSettings& a, const std::string& folder) {
  if (a.png.empty() && a.page.empty()) return std::nullopt;
  if (NeedsViewer(a) && !HasViewer())
    throw InvalidArgument("this program was built without the viewer (GAITWRIGHT_VIEWER=OFF), which draws robots");
  Paths paths;
  paths.Write("--png", a.png, {".png"});
  paths.Write("--page", a.page, {".html"});
  CheckPaths(paths);
  Result<std::vector<OutputFile>> files = std::vector<OutputFile>();
  if (NeedsViewer(a)) files = ShownRobot(model, a, folder);
  if (!files) return files.failure();
  if (!a.png.empty() && a.picture.view == kDrawing) {
    Result<std::string> png = SvgToPng(RobotDrawing(model, folder));
    if (!png) return png.failure();
    files->push_back({a.png, std::move(*png)});
  }
  const auto written = WriteFilesTogether(*files);
  if (!written) return written.failure();
  return std::nullopt;
}

/// Why there is no plan of a 1 m walk at the robot's default speed that passes the audit, or nothing.
std::optional<std::string> ReasonNoWalk(const RobotModel& model) {
  WalkRequest request;
  request.own_pace = true;
  request.command.distance_m = 1.0;
  const Result<PlannedWalk> planned = PlanWalk(model, request);
  if (!planned) return planned.failure().message;
  if (planned->audit.pass()) return std::nullopt;
  const Violation& first = planned->audit.violations.front();
  return fmt::format("the plan of a 1 m walk fails the check '{}' at {:.2f} s: {}, {} (limit {})", LawName(first.law),
                     first.at_s, first.where, AuditFigure(first.value, first.unit),
                     AuditFigure(first.limit, first.unit));
}

std::string VerdictOn(const RobotModel& model, std::size_t errors, std::size_t warnings) {
  if (const auto reason = ReasonNoWalk(model)) return "cannot walk: " + *reason;
  if (errors > 0) return fmt::format("walks with errors ({}) and warnings ({})", errors, warnings);
  return warnings == 0 ? "walks" : fmt::format("walks with warnings ({})", warnings);
}

std::size_t CountOf(const std::vector<Finding>& findings, FindingLevel level) {
  return static_cast<std::size_t>(
      std::count_if(findings.begin(), findings.end(), [&](const Finding& f) { return f.level == level; }));
}

const char* NameOf(FindingLevel level) {
  return level == FindingLevel::kError ? "error" : level == FindingLevel::kWarning ? "warning" : "info";
}

nlohmann::ordered_json FindingsJson(const std::vector<Finding>& findings) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const Finding& finding : findings) {
    nlohmann::ordered_json json = {
        {"level", NameOf(finding.level)}, {"code", FailureCodeName(finding.code)}, {"part", PartText(finding.part)}};
    json["line"] = nullptr;
    if (finding.line > 0) json["line"] = finding.line;
    json["message"] = finding.message;
    list.push_back(std::move(json));
  }
  return list;
}

int ShowRobot(const RobotsSettings& a) {
  const RobotFlags robot = FlagsOf(a);
  Result<RobotModel> model = ReadRobot(robot);
  if (!model) return Report(model.failure(), a.common);
  if (const auto failure = DrawRobot(*model, a, robot.folder())) return Report(*failure, a.common);
  const WholeBodyIk ik(*model);
  const CollisionChecker collision(*model);
  model->notes.insert(model->notes.end(), ik.notes().begin(), ik.notes().end());
  model->notes.insert(model->notes.end(), collision.notes().begin(), collision.notes().end());
  const Gains gains = DeriveGains(*model);  // those of robot.yaml, if it has any
  model->stiffness = gains.stiffness;
  model->damping = gains.damping;
  const std::vector<Finding> findings = CheckRobot(*model);
  const std::string verdict =
      VerdictOn(*model, CountOf(findings, FindingLevel::kError), CountOf(findings, FindingLevel::kWarning));
  if (a.common.json) {
    nlohmann::ordered_json json = ParsedJson(RobotJson(*model));
    json["verdict"] = verdict;
    json["findings"] = FindingsJson(findings);
    json["self_collision"] = SelfCollisionJson(collision);
    json["files"] = nlohmann::ordered_json::object();
    if (!a.page.empty()) json["files"]["page"] = a.page;
    if (!a.png.empty()) json["files"]["png"] = a.png;
    PrintJson(json);
  } else {
    fmt::print("{}: {}\n", model->name, verdict);
    fmt::print("{}\n{}", DescribeRobot(*model), SelfCollisionText(collision));
    for (const std::string& path : {a.page, a.png}) {
      if (!path.empty()) fmt::print("drawn   {}\n", path);
    }
  }
  return kPass;
}

/// Findings about a robot description, and differences from another one if it is given.
std::vector<Finding> FindingsOf(const RobotsSettings& a, const Result<RobotModel>& model) {
  const auto not_loaded = [](const Failure& failure, const std::string& message) {
    return Finding{FindingLevel::kError, failure.code, RobotPart(), 0, message};
  };
  if (!model) return {not_loaded(model.failure(), model.failure().message)};
  std::vector<Finding> findings = CheckRobot(*model);
  if (a.against.empty()) return findings;
  const Result<RobotModel> other = ReadRobot(FlagsOf(a.against, a.loading.loading));
  if (!other) {
    findings.push_back(not_loaded(other.failure(), fmt::format("'{}': {}", a.against, other.failure().message)));
    return findings;
  }
  const std::vector<Finding> differences = CompareRobots(*model, *other);
  findings.insert(findings.end(), differences.begin(), differences.end());
  return findings;
}

/// Prints one line per finding; findings of the same kind and text share a line.
void PrintFindings(const RobotsSettings& a, const std::vector<Finding>& findings) {
  constexpr std::size_t kNamed = 4;  // parts of one line
  std::vector<bool> printed(findings.size(), false);
  for (std::size_t i = 0; i < findings.size(); ++i) {
    const Finding& first = findings[i];
    if (printed[i] || (a.common.quiet && first.level == FindingLevel::kInfo)) continue;
    std::vector<std::string> parts;
    for (std::size_t k = i; k < findings.size(); ++k) {
      if (findings[k].level != first.level || findings[k].code != first.code || findings[k].message != first.message)
        continue;
      printed[k] = true;
      parts.push_back(PartText(findings[k].part));
    }
    const std::size_t more = parts.size() > kNamed ? parts.size() - kNamed : 0;
    parts.resize(parts.size() - more);
    const std::string named = JoinWords(parts, ", ") + (more > 0 ? fmt::format(" and {} more", more) : "");
    fmt::print("{}{}: {}: {}: {} [{}]\n", RobotText(a), first.line > 0 ? fmt::format(":{}", first.line) : "",
               NameOf(first.level), named, first.message, FailureCodeName(first.code));
  }
}

int CheckOneRobot(const RobotsSettings& a) {
  Paths paths;
  paths.Write("--repaired", a.repaired, {".urdf"});
  CheckPaths(paths);
  const Result<RobotModel> model = ReadRobot(FlagsOf(a));
  const std::vector<Finding> findings = FindingsOf(a, model);
  const std::size_t errors = CountOf(findings, FindingLevel::kError);
  const std::size_t warnings = CountOf(findings, FindingLevel::kWarning);
  const std::string verdict = model ? VerdictOn(*model, errors, warnings) : "is not loaded";
  nlohmann::ordered_json files = nlohmann::ordered_json::object();
  if (model && !a.repaired.empty()) {
    const auto written = WriteFileAtomically(a.repaired, RepairedUrdf(*model));
    if (!written) return Report(written.failure(), a.common);
    files["repaired"] = a.repaired;
  }
  if (a.common.json) {
    PrintJson(nlohmann::ordered_json{{"robot", model ? model->name : RobotText(a)},
                                     {"verdict", verdict},
                                     {"errors", errors},
                                     {"warnings", warnings},
                                     {"findings", FindingsJson(findings)},
                                     {"files", files}});
  } else {
    PrintFindings(a, findings);
    fmt::print("{}: {} errors, {} warnings; {}\n", model ? model->name : RobotText(a), errors, warnings, verdict);
  }
  return errors == 0 ? kPass : kWrongInput;
}

}  // namespace

void AddRobots(Verb program, int& status) {
  auto a = std::make_shared<RobotsSettings>();
  const Verb verb =
      program.AddVerb("robots", "List the robots; 'robots show X' prints what was derived from a description");
  const Verb show = verb.AddVerb("show", "Show one robot: legs, feet, posture, limits");
  AddRobotTo(show, *a);
  show.SetGroup("Draw it standing");
  AddText(show, "--png", "FILE", a->png,
          "Write a picture of the robot to this file (needs a headless Chromium); default: none.");
  std::vector<std::string> views = ViewNames();
  views.insert(views.begin(), kDrawing);
  a->picture.view = kDrawing;
  AddText(show, "--page", "FILE", a->page, "Write an HTML page that shows the robot in 3D; default: none.");
  AddText(show, "--view", "NAME", a->picture.view,
          fmt::format("View of the picture: drawing (views to scale with soles, joint axes and centre of mass), or in "
                      "3D one of {}; default drawing.",
                      JoinWords(ViewNames(), ", ")))
      .AcceptOnly(views);
  AddCommon(verb, a->common, {"robots", "robots show a1"});
  AddCommon(show, a->common, {"robots show a1", "robots show nao --json", "robots show nao --png nao.png"});
  const Verb check = verb.AddVerb("check", "Check a robot description: one line per finding, exit status 1 on errors");
  AddRobotTo(check, *a);
  AddText(check, "--against", "FILE", a->against,
          "Another description of the same robot to compare with; default none.");
  AddText(check, "--repaired", "FILE", a->repaired, "Write the repaired URDF to this file; default none.");
  AddCommon(check, a->common, {"robots check a1", "robots check nao --json", "robots check go1 --repaired go1.urdf"});
  verb.RequireVerbs(0, 1);
  SetWork(verb, a->common, status, [a, verb, show, check] {
    if (verb.chosen() == check) return CheckOneRobot(*a);
    return verb.chosen() == show ? ShowRobot(*a) : ListRobots(a->common);
  });
}

}  // namespace gaitwright::cli
