// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>

#include "cli/flags.h"
#include "cli/json_text_internal.h"
#include "cli/paths.h"
#include "cli/program.h"
#include "cli/progress_bar.h"
#include "cli/shown_motion.h"
#include "cli/word_list.h"
#include "kinematics/base/file.h"
#include "playback/report/gait_figure.h"
#include "playback/viewer/viewer_page.h"
#include "workflows/render/render_pictures.h"
#include "workflows/render/svg_to_pdf.h"

namespace gaitwright::cli {
namespace {

constexpr double kRounding = 1e-6;  // rounding of cycle counts

struct RenderSettings {
  Common common;
  std::string motion, plan, meshes;
  std::string png, gif, mp4, figure;
  std::optional<double> at_s;
  PictureOptions picture;
  GaitFigureOptions cycles;

  bool wants_page() const { return !png.empty() || !gif.empty() || !mp4.empty(); }
};

void CheckRenderPaths(const RenderSettings& a) {
  Paths paths;
  paths.Read("the motion", a.motion);
  paths.Read("--plan", a.plan);
  paths.Write("--png", a.png, {".png"});
  paths.Write("--gif", a.gif, {".gif"});
  paths.Write("--mp4", a.mp4, {".mp4"});
  paths.WriteByEnding("--figure", a.figure, {".svg", ".pdf"});
  CheckPaths(paths);
  if (!a.wants_page() && a.figure.empty())
    throw InvalidArgument("nothing to render: give --png, --gif, --mp4 or --figure with a file");
  if (a.wants_page() && !HasViewer())
    throw InvalidArgument("this program was built without the viewer (GAITWRIGHT_VIEWER=OFF), which makes pictures");
}

/// Refuses flags of pictures or figures that are not made, so that no flag is ignored.
void CheckRenderFlags(const RenderSettings& a, Verb verb) {
  const bool film = !a.gif.empty() || !a.mp4.empty(), page = a.wants_page(), figure = !a.figure.empty();
  struct Use {
    std::vector<std::string> flags;
    bool used;
    const char* with;
  };
  const Use uses[] = {
      {{"--at"}, !a.png.empty(), "--png"},
      {{"--to-s", "--speed", "--fps"}, film, "--gif or --mp4"},
      {{"--from-s"}, film || figure, "--gif, --mp4 or --figure"},
      {{"--width", "--height", "--view", "--hide", "--dark", "--meshes"}, page, "--png, --gif or --mp4"},
      {{"--cycles"}, figure, "--figure"}};
  for (const Use& use : uses) {
    for (const std::string& flag : use.flags)
      if (!use.used && verb.Given(flag)) throw InvalidArgument(fmt::format("{} is for {} only", flag, use.with));
  }
}

/// Makes all requested outputs before any of them is written.
Result<std::vector<OutputFile>> RenderAll(RenderSettings& a, const MotionToShow& motion) {
  std::vector<OutputFile> files;
  const auto add = [&](const std::string& path, Result<std::string> made) -> std::optional<Failure> {
    if (!made) return made.failure();
    files.push_back({path, std::move(*made)});
    return std::nullopt;
  };
  if (!a.figure.empty()) {
    const std::string svg = GaitFigure(motion.model, motion.plan, motion.log ? &*motion.log : nullptr, a.cycles);
    if (auto failure = add(a.figure, EndingOf(a.figure) == ".pdf" ? SvgToPdf(svg) : Result<std::string>(svg)))
      return *failure;
  }
  if (!a.wants_page()) return files;
  const std::optional<std::string> meshes = a.meshes.empty() ? std::nullopt : std::optional(a.meshes);
  const std::string page = ViewerPage(motion.title, {motion.Shown(meshes)});
  ProgressBar bar(!a.common.json && !a.common.quiet, "pictures");
  a.picture.progress = [&](int done, int all) { bar.Show({done, all, 0}); };
  if (!a.png.empty()) {
    if (auto failure = add(a.png, RenderPng(page, a.at_s.value_or(motion.plan.whole_body.start_s), a.picture)))
      return *failure;
  }
  for (const auto& [path, format] : {std::pair(a.gif, FilmFormat::kGif), std::pair(a.mp4, FilmFormat::kMp4)}) {
    if (path.empty()) continue;
    if (auto failure = add(path, RenderFilm(page, format, a.picture))) return *failure;
  }
  return files;
}

/// @param cycles  number of gait cycles in the figure.
void PrintRendered(const RenderSettings& a, std::optional<double> cycles) {
  const std::pair<const char*, const std::string*> files[] = {
      {"png", &a.png}, {"gif", &a.gif}, {"mp4", &a.mp4}, {"figure", &a.figure}};
  if (a.common.json) {
    nlohmann::ordered_json json = {{"files", nlohmann::ordered_json::object()}};
    for (const auto& [kind, path] : files)
      if (!path->empty()) json["files"][kind] = *path;
    if (cycles) json["cycles"] = *cycles;
    PrintJson(json);
    return;
  }
  for (const auto& [kind, path] : files) {
    if (path->empty()) continue;
    fmt::print("{}", a.common.quiet ? *path + "\n" : fmt::format("{:<7} {}\n", kind, *path));
  }
  if (cycles && *cycles < a.cycles.cycles - kRounding && !a.common.quiet)
    fmt::print("the figure has {:.1f} of {} cycles: the motion ends there\n", *cycles, a.cycles.cycles);
}

int RunRender(RenderSettings& a) {
  CheckRenderPaths(a);
  Result<MotionToShow> motion = ReadMotionToShow(a.motion, a.plan);
  if (!motion) return Report(motion.failure(), a.common);
  const std::vector<MotionToShow> shown = {std::move(*motion)};
  CheckShown(shown, a.plan, a.meshes);
  const Result<std::vector<OutputFile>> files = RenderAll(a, shown.front());
  if (!files) return Report(files.failure(), a.common);
  const auto written = WriteFilesTogether(*files);
  if (!written) return Report(written.failure(), a.common);
  const MotionToShow& drawn = shown.front();
  std::optional<double> cycles;
  if (!a.figure.empty()) cycles = CyclesShown(drawn.plan, drawn.log ? &*drawn.log : nullptr, a.cycles);
  PrintRendered(a, cycles);
  return kPass;
}

void AddPictureFlags(Verb verb, RenderSettings& a) {
  verb.SetGroup("Pictures");
  AddNumber(verb, "--at", "s", a.at_s, "Time of the still picture, on the plan's clock; default: the start.");
  AddNumber(verb, "--from-s", "s", a.picture.from_s,
            "Start time of films and of the figure; default: the start of the motion for films, the first step for the "
            "figure.");
  AddNumber(verb, "--to-s", "s", a.picture.to_s, "End time of films; default: the end of the motion.");
  AddNumber(verb, "--speed", "factor", a.picture.speed,
            "Playback speed of films, as a multiple of real time; default 1.");
  AddNumber(verb, "--fps", "1/s", a.picture.frames_per_s, "Frames per second of films; default 30.");
  AddWholeNumber(verb, "--width", 64, a.picture.width_px, "Width of pictures in pixels; default 1280.");
  AddWholeNumber(verb, "--height", 64, a.picture.height_px, "Height of pictures in pixels; default 720.");
  AddText(verb, "--view", "NAME", a.picture.view,
          fmt::format("Camera view: one of {}; default corner.", JoinWords(ViewNames(), ", ")));
  verb.AddValue("--hide", a.picture.hidden,
                fmt::format("Parts to hide: {}; default: none.", JoinWords(OverlayNames(), ", ")))
      .SetType("NAME,...")
      .SplitAt(',');
  verb.AddSwitch("--dark", a.picture.dark,
                 "Light lines on a dark background; default: dark lines on a light background.");
  AddWholeNumber(verb, "--cycles", 1, a.cycles.cycles,
                 "Number of gait cycles in the figure, at most 1000; default 10.");
}

}  // namespace

void AddRender(Verb program, int& status) {
  auto a = std::make_shared<RenderSettings>();
  const Verb verb = program.AddVerb("render", "Make pictures, films and the figure of a gait from a plan or a log");
  AddText(verb, "MOTION", "FILE", a->motion, "A plan or a log, as written by 'plan', 'walk' and 'play'.").Require();
  AddText(verb, "--plan", "FILE", a->plan, "The plan that a log was played from; default: plan.json beside the log.");
  AddText(verb, "--meshes", "FOLDER", a->meshes,
          "Folder of the URDF, to find its visual meshes; default: none, and collision shapes are drawn.");
  verb.SetGroup("Output that needs a headless Chromium");
  AddText(verb, "--png", "FILE", a->png, "A still picture.");
  AddText(verb, "--gif", "FILE", a->gif, "Animated GIF; needs ffmpeg.");
  AddText(verb, "--mp4", "FILE", a->mp4, "MP4 film; needs ffmpeg.");
  verb.SetGroup("Output that needs no browser");
  AddText(verb, "--figure", "FILE", a->figure,
          "Figure of support polygons, ZMP and centre of mass over some cycles, for print: .svg, or .pdf (needs "
          "rsvg-convert).");
  AddPictureFlags(verb, *a);
  AddCommon(verb, a->common,
            {"render out/log.json --png trot.png --at 1.5 --view side",
             "render out/log.json --mp4 steps.mp4 --from-s 1 --to-s 1.5 --width 640 --height 360",
             "render out/log.json --figure gait.pdf --cycles 10"});
  SetWork(verb, a->common, status, [a, verb] {
    CheckRenderFlags(*a, verb);
    a->cycles.from_s = a->picture.from_s;
    return RunRender(*a);
  });
}

}  // namespace gaitwright::cli
