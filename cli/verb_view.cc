// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <memory>
#include <nlohmann/json.hpp>

#include "cli/flags.h"
#include "cli/json_text_internal.h"
#include "cli/paths.h"
#include "cli/program.h"
#include "cli/shown_motion.h"
#include "kinematics/base/file.h"
#include "playback/viewer/viewer_page.h"

namespace gaitwright::cli {
namespace {

struct ViewSettings {
  Common common;
  std::string motion, beside, plan, meshes, out = "view.html";
  bool ghost = false;
};

void PrintViewed(const ViewSettings& a, const std::string& title, std::size_t bytes) {
  if (a.common.json) {
    const nlohmann::ordered_json json = {{"shows", title}, {"page_bytes", bytes}, {"files", {{"page", a.out}}}};
    PrintJson(json);
  } else if (a.common.quiet) {
    fmt::print("{}\n", a.out);
  } else {
    fmt::print("{}\npage    {} ({:.1f} MB): open it in a browser\n", title, a.out, 1e-6 * static_cast<double>(bytes));
  }
}

/// @throws InvalidArgument unless there are two motions of one robot.
void CheckGhost(const std::vector<MotionToShow>& motions, const ViewSettings& a) {
  if (motions.size() < 2) throw InvalidArgument("--ghost shows a second motion as a ghost; give a second FILE");
  if (motions[0].model.hash == motions[1].model.hash) return;
  throw InvalidArgument(fmt::format("--ghost needs two motions of the same robot: '{}' has '{}', but '{}' has '{}'",
                                    a.motion, motions[0].model.name, a.beside, motions[1].model.name));
}

int RunView(const ViewSettings& a) {
  Paths paths;
  paths.Read("the motion", a.motion);
  paths.Read("the second motion", a.beside);
  paths.Read("--plan", a.plan);
  paths.Write("--out", a.out, {".html"});
  CheckPaths(paths);
  if (!HasViewer()) throw InvalidArgument("this program was built without the viewer (GAITWRIGHT_VIEWER=OFF)");
  std::vector<MotionToShow> motions;
  for (const std::string& path : {a.motion, a.beside}) {
    if (path.empty()) continue;
    Result<MotionToShow> motion = ReadMotionToShow(path, a.plan);
    if (!motion) return Report(motion.failure(), a.common);
    motions.push_back(std::move(*motion));
  }
  CheckShown(motions, a.plan, a.meshes);
  if (a.ghost) CheckGhost(motions, a);
  if (motions.size() == 2 && motions[0].title == motions[1].title) {
    motions[0].title += ", " + a.motion;
    motions[1].title += ", " + a.beside;
  }
  const std::optional<std::string> meshes = a.meshes.empty() ? std::nullopt : std::optional(a.meshes);
  std::vector<ShownMotion> shown;
  std::string title;
  for (const MotionToShow& motion : motions) {
    shown.push_back(motion.Shown(meshes));
    title += (title.empty() ? "" : a.ghost ? " with the ghost of " : " beside ") + motion.title;
  }
  if (a.ghost) {
    shown.pop_back();
    shown[0].ghost = motions[1].AsGhost();
  }
  const std::string page = ViewerPage(title, shown);
  const auto written = WriteFileAtomically(a.out, page);
  if (!written) return Report(written.failure(), a.common);
  PrintViewed(a, title, page.size());
  return kPass;
}

}  // namespace

void AddView(Verb program, int& status) {
  auto a = std::make_shared<ViewSettings>();
  const Verb verb = program.AddVerb("view", "Make an HTML page that shows a plan or a log in 3D, or two side by side");
  AddText(verb, "MOTION", "FILE", a->motion, "A plan or a log, as written by 'plan', 'walk' and 'play'.").Require();
  AddText(verb, "BESIDE", "FILE", a->beside,
          "A second plan or log, shown beside the first on the same clock; default none.");
  verb.AddSwitch("--ghost", a->ghost,
                 "Show the second motion as a translucent robot in the picture of the first, instead of beside it; "
                 "default: no.");
  AddText(verb, "--plan", "FILE", a->plan, "The plan that a log was played from; default: plan.json beside the log.");
  AddText(verb, "--meshes", "FOLDER", a->meshes,
          "Folder of the URDF, to find its visual meshes; default: none, and collision shapes are drawn.");
  AddText(verb, "--out", "FILE", a->out, "Write the page to this file; default view.html.");
  AddCommon(verb, a->common,
            {"view plan.json", "view out/log.json --out trot.html", "view out/log.json plan.json --out two.html",
             "view out/log.json plan.json --ghost"});
  SetWork(verb, a->common, status, [a] { return RunView(*a); });
}

}  // namespace gaitwright::cli
