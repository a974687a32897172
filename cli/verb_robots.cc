// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>

#include "cli/flags.h"
#include "cli/json_text_internal.h"
#include "cli/paths.h"
#include "cli/program.h"
#include "cli/robot_input.h"
#include "cli/word_list.h"
#include "kinematics/base/file.h"
#include "kinematics/collision/collision_checker.h"
#include "kinematics/ik/whole_body_ik.h"
#include "kinematics/model/describe.h"
#include "kinematics/model/load_robot.h"
#include "optimisation/pipeline/plan_posture.h"
#include "planning/tasks/repertoire.h"
#include "playback/control/gains.h"
#include "playback/viewer/viewer_page.h"
#include "workflows/render/render_pictures.h"
#include "workflows/walk/walk.h"

namespace gaitwright::cli {
namespace {

struct RobotsSettings {
  Common common;
  std::string robot, png, page;
  PictureOptions picture;
};

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
      fmt::format("self-collision: {} pairs of shapes are checked; not checked are\n", collision.num_pairs());
  for (const LeftOutPair& pair : collision.left_out())
    text += fmt::format("  {} and {}: {}\n", pair.link_a, pair.link_b, pair.reason);
  return text;
}

/// The robot as it stands, as a page and as a picture.
Result<std::vector<OutputFile>> DrawnRobot(const RobotModel& model, const RobotsSettings& a,
                                           const std::string& folder) {
  constexpr double kStand = 0.5;  // [s]
  const Result<MotionPlan> plan = PlanPosture(model, Hold(StandingKey(model), kStand), {});
  if (!plan) return plan.failure();
  ShownMotion shown{model.name, model, *plan};
  if (!folder.empty()) shown.mesh_folder = folder;
  const std::string page = ViewerPage(model.name, {shown});
  std::vector<OutputFile> files;
  if (!a.page.empty()) files.push_back({a.page, page});
  if (a.png.empty()) return files;
  Result<std::string> png = RenderPng(page, 0.0, a.picture);
  if (!png) return png.failure();
  files.push_back({a.png, std::move(*png)});
  return files;
}

/// Draws the robot where that is asked for. @return what is wrong, or nothing.
std::optional<Failure> DrawRobot(const RobotModel& model, const RobotsSettings& a, const std::string& folder) {
  if (a.png.empty() && a.page.empty()) return std::nullopt;
  if (!HasViewer())
    throw InvalidArgument("this program was built without the viewer (GAITWRIGHT_VIEWER=OFF), which draws robots");
  Paths paths;
  paths.Write("--png", a.png, {".png"});
  paths.Write("--page", a.page, {".html"});
  CheckPaths(paths);
  const Result<std::vector<OutputFile>> files = DrawnRobot(model, a, folder);
  if (!files) return files.failure();
  const auto written = WriteFilesTogether(*files);
  if (!written) return written.failure();
  return std::nullopt;
}

int ShowRobot(const RobotsSettings& a) {
  const bool is_file =
      a.robot.ends_with(".urdf") || a.robot.ends_with(".xml") || a.robot.find('/') != std::string::npos;
  Result<RobotModel> model = ReadRobot(a.robot, is_file ? a.robot : "");
  if (!model) return Report(model.failure(), a.common);
  const std::string folder = is_file ? std::filesystem::path(a.robot).parent_path().string() : "";
  if (const auto failure = DrawRobot(*model, a, folder)) return Report(*failure, a.common);
  const WholeBodyIk ik(*model);
  const CollisionChecker collision(*model);
  model->notes.insert(model->notes.end(), ik.notes().begin(), ik.notes().end());
  model->notes.insert(model->notes.end(), collision.notes().begin(), collision.notes().end());
  const Gains gains = DeriveGains(*model);  // those of robot.yaml where it has some
  model->stiffness = gains.stiffness;
  model->damping = gains.damping;
  if (a.common.json) {
    nlohmann::ordered_json json = ParsedJson(RobotJson(*model));
    json["self_collision"] = SelfCollisionJson(collision);
    json["files"] = nlohmann::ordered_json::object();
    if (!a.page.empty()) json["files"]["page"] = a.page;
    if (!a.png.empty()) json["files"]["png"] = a.png;
    PrintJson(json);
  } else {
    fmt::print("{}\n{}", DescribeRobot(*model), SelfCollisionText(collision));
    for (const std::string& path : {a.page, a.png}) {
      if (!path.empty()) fmt::print("drawn   {}\n", path);
    }
  }
  return kPass;
}

}  // namespace

void AddRobots(Verb program, int& status) {
  auto a = std::make_shared<RobotsSettings>();
  const Verb verb = program.AddVerb("robots", "List the robots; 'robots show X' tells what was derived from a URDF");
  const Verb show = verb.AddVerb("show", "Explain one robot: legs, feet, posture, limits");
  AddText(show, "ROBOT", "NAME", a->robot, "A name of the list, or the path of a URDF file.").Require();
  show.SetGroup("Draw it standing");
  AddText(show, "--png", "FILE", a->png, "A picture of it, by a headless Chromium; default: none.");
  AddText(show, "--page", "FILE", a->page, "A page on which it can be turned and looked at in 3D; default: none.");
  AddText(show, "--view", "NAME", a->picture.view,
          fmt::format("Of the picture: one of {}; default corner.", JoinWords(ViewNames(), ", ")));
  AddCommon(verb, a->common, {"robots", "robots show a1"});
  AddCommon(show, a->common,
            {"robots show a1", "robots show nao --json", "robots show nao --png nao.png --view front"});
  verb.RequireVerbs(0, 1);
  SetWork(verb, a->common, status, [a] {
    ApplySets("--set", a->common.sets, {});
    return a->robot.empty() ? ListRobots(a->common) : ShowRobot(*a);
  });
}

}  // namespace gaitwright::cli
