// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <cstdlib>
#include <filesystem>
#include <memory>

#include "cli/flags.h"
#include "cli/interruptible.h"
#include "cli/options_file.h"
#include "cli/paths.h"
#include "cli/program.h"
#include "cli/robot_input.h"
#include "cli/walk_arguments.h"
#include "playback/viewer/viewer_page.h"
#include "workflows/live/live_session.h"
#include "workflows/walk/idle_options.h"

namespace gaitwright::cli {
namespace {

/// Without the choice of both engines: a page shows one world.
OptionFields InOneEngine(OptionFields fields) {
  for (OptionField& field : fields) {
    if (field.key != "play.engine") continue;
    std::erase(field.choices, "both");
    field.meaning = "Physics engine of the world.";
  }
  return fields;
}

/// Options that can be set: those of plans, the world and the controller. Sensors, delays and timed pushes are for
/// 'play'. Bumps are for 'play' too, since they cover a limited area and this walk has no end.
OptionFields FieldsOf(WalkRequest& walk, PlayRequest& play) {
  OptionFields world = play.play.world.Fields();
  std::erase_if(world, [](const OptionField& field) { return field.key.find("bump") != std::string::npos; });
  OptionFields all = Joined({walk.Fields(), Prefixed("play", world), Prefixed("stabilised", play.stabilised.Fields()),
                             Prefixed("recovering", play.recovering.Fields()), Prefixed("gains", play.gains.Fields())});
  std::erase_if(all, [&](const OptionField& field) {
    return FirstIdle(play, {field.key}, {"play.ground_slope_deg"}).has_value();
  });
  return InOneEngine(all);
}

struct LiveSettings {
  Common common;
  RobotFlags robot;
  WalkRequest walk;
  PlayRequest play, listed;  ///< `listed` has the options that --list-options prints: all that a robot may take here
  OptionsFile options;
  LiveAddress address{.port = 8017};
  double for_s = 0.0;
  bool debug = false, no_open = false;
};

/// Opens a page in the desktop's browser; does nothing without a desktop.
void OpenInBrowser(const std::string& url) {
  if (std::getenv("DISPLAY") == nullptr && std::getenv("WAYLAND_DISPLAY") == nullptr) return;
  const int ignored = std::system(("xdg-open '" + url + "' >/dev/null 2>&1 &").c_str());
  (void)ignored;
}

/// Exits without waiting for a plan in progress, which is no longer needed.
[[noreturn]] void EndAtOnce() {
  std::fflush(nullptr);
  std::_Exit(kPass);
}

int RunLive(LiveSettings& a) {
  a.play.play.world.seed = a.common.seed;
  const OptionFields fields = FieldsOf(a.walk, a.play);
  const Result<OptionTexts> options = a.options.Apply(fields, a.common);
  if (!options) return Report(options.failure(), a.common);
  ApplySets("--set", a.common.sets, fields);
  if (a.for_s < 0.0) throw InvalidArgument(fmt::format("--for is {} s; accepted: 0 (until Ctrl-C) or more", a.for_s));
  CheckController(a.play.controller);
  if (!HasViewer()) throw InvalidArgument("this program was built without the viewer (GAITWRIGHT_VIEWER=OFF)");
  Paths paths;
  a.robot.AddTo(paths);
  a.options.AddPathTo(paths);
  CheckPaths(paths);
  const Result<RobotModel> model = ReadRobot(a.robot);
  if (!model) return Report(model.failure(), a.common);
  Result<std::unique_ptr<LiveServer>> server = LiveServer::Start(a.address, LivePage(model->name + ", live"));
  if (!server) return Report(server.failure(), a.common);
  if (!a.common.quiet) fmt::print(stderr, "planning the first walk of {}\n", model->name);
  Result<std::unique_ptr<LiveWorld>> live = LiveWorld::Make(*model, a.walk, a.play);
  if (!live) return Report(live.failure(), a.common);
  const std::optional<std::string> meshes = a.robot.is_file() ? std::optional(a.robot.folder()) : std::nullopt;
  (*server)->Greet(LiveGreeting(**live, meshes));
  const std::string url = (*server)->url();
  fmt::print("{}\n", a.common.json ? fmt::format("{{\"url\": \"{}\"}}", url)
                                   : (a.common.quiet ? url : url + "  open it in a browser; press Ctrl-C to end"));
  std::fflush(stdout);
  if (!a.no_open) OpenInBrowser(url);
  LiveListener listener;
  if (!a.common.quiet && !a.common.json) listener.note = [](const std::string& note) { fmt::print("{}\n", note); };
  if (a.debug) listener.phase = [](const std::string& line) { fmt::print(stderr, "{}\n", line); };
  LiveSession session(**live, **server, listener);
  const Interruptible interruptible;
  const auto begun = std::chrono::steady_clock::now();
  session.Run([&] {
    const double passed = std::chrono::duration<double>(std::chrono::steady_clock::now() - begun).count();
    return Interruptible::asked() || (a.for_s > 0.0 && passed > a.for_s);
  });
  if ((*live)->plans()) EndAtOnce();
  return kPass;
}

}  // namespace

void AddLive(Verb program, int& status) {
  auto a = std::make_shared<LiveSettings>();
  const Verb verb = program.AddVerb("live", "Serve a web page where you steer, push and tune a simulated robot");
  verb.SetGroup("Robot");
  a->robot.AddTo(verb);
  AddText(verb, "--controller", "NAME", a->play.controller,
          "stabilised, joint-pd or recovering (as stabilised, but takes recovery steps if pushed while standing); "
          "default stabilised.");
  const OptionFields fields = InOneEngine(a->play.Fields());
  AddField(verb, "--engine", fields, "play.engine");
  verb.SetGroup("Web page");
  AddText(verb, "--host", "ADDRESS", a->address.host,
          "Network address to listen on; default 127.0.0.1, which only this machine can reach. Everyone who can reach "
          "another address can move the robot.");
  AddWholeNumber(verb, "--port", 0, a->address.port, "Port; 0 uses any free port; default 8017.");
  verb.AddSwitch("--no-open", a->no_open, "Do not open the page in this desktop's browser.");
  AddNumber(verb, "--for", "s", a->for_s, "End after this time; default 0: run until Ctrl-C.");
  verb.AddSwitch("--debug", a->debug, "Print each planned and measured contact change on standard error.");
  a->options.AddTo(verb);
  AddCommon(
      verb, a->common,
      {"live --robot a1", "live --urdf my_robot.urdf --port 0 --debug", "live --robot nao --set play.friction=0.6"});
  a->listed = a->play;
  a->listed.controller = "recovering";
  AddOptionFlags(verb, FieldsOf(a->walk, a->listed), a->common.sets, a->common.json);
  SetWork(verb, a->common, status, [a] { return RunLive(*a); });
}

}  // namespace gaitwright::cli
