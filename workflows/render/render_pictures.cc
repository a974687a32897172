// SPDX-License-Identifier: BSD-3-Clause
#include "workflows/render/render_pictures.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "kinematics/base/file.h"
#include "workflows/render/chromium.h"
#include "workflows/render/run_program.h"
#include "workflows/render/temporary_folder_internal.h"

namespace gaitwright {
namespace {

constexpr char kStage[] = "Render";
constexpr int kMostFrames = 20000;

Failure Failed(FailureCode code, const std::string& what, const std::vector<Suggestion>& suggestions = {}) {
  return {FailureKind::kBadInput, code, kStage, what, suggestions};
}

/// Refuses options out of range.
void CheckOptions(const PictureOptions& options) {
  const auto within = [](const char* what, double value, double least, double most) {
    if (value >= least && value <= most) return;
    throw InvalidArgument(fmt::format("{} is {}; it must be from {} to {}", what, value, least, most));
  };
  within("the width in pixels", options.width_px, 64, 7680);
  within("the height in pixels", options.height_px, 64, 4320);
  within("the number of frames per second", options.frames_per_s, 1, 120);
  within("the speed", options.speed, 0.01, 100);
  const auto known = [](const char* what, const std::string& name, const std::vector<std::string>& names) {
    if (std::find(names.begin(), names.end(), name) != names.end()) return;
    throw InvalidArgument(fmt::format("there is no {} '{}'; accepted: {}", what, name, QuotedList(names)));
  };
  known("view", options.view, ViewNames());
  for (const std::string& name : options.hidden) known("overlay", name, OverlayNames());
  if (!(options.from_s < options.to_s))
    throw InvalidArgument(fmt::format("the time range from {} to {} s is empty", options.from_s, options.to_s));
}

/// A page in a browser, in the layout for pictures.
class Studio {
 public:
  static Result<Studio> Open(const std::string& page, const PictureOptions& options) {
    Studio studio;
    if (!studio.folder_->there()) return Failed(FailureCode::kNoFolder, "no temporary folder can be created");
    const std::string file = studio.folder_->In("page.html");
    const auto written = WriteFileAtomically(file, page);
    if (!written) return written.failure();
    auto browser =
        Chromium::Start({.width_px = options.width_px, .height_px = options.height_px, .dark = options.dark});
    if (!browser) return browser.failure();
    studio.browser_ = std::move(*browser);
    const auto opened = studio.browser_->Open(FileUrl(file));
    if (!opened) return opened.failure();
    const auto laid = studio.LayOut(options);
    if (!laid) return laid.failure();
    return studio;
  }

  Result<std::string> PictureAt(double time_s) {
    auto shown = browser_->Evaluate(fmt::format("window.gaitwright.viewers[0].showNow({})", time_s));
    if (!shown) return shown;
    return browser_->Png();
  }

  double start_s() const { return start_s_; }
  double end_s() const { return end_s_; }
  const TemporaryFolder& folder() const { return *folder_; }

 private:
  Studio() : folder_(std::make_unique<TemporaryFolder>()) {}

  Result<std::string> LayOut(const PictureOptions& options) {
    std::string script =
        "(() => { const v = window.gaitwright.viewers[0]; "
        "document.querySelector('.gw-viewer').classList.add('gw-picture'); ";
    for (const std::string& name : options.hidden) script += fmt::format("v.setOverlay('{}', false); ", name);
    script += fmt::format("v.showNow(v.clock.start); v.look('{}'); ", options.view);
    script += "return {stages: v.stages.length, start: v.clock.start, end: v.clock.end}; })()";
    Result<std::string> answer = browser_->Evaluate(script);
    if (!answer) return answer;
    const auto json = nlohmann::ordered_json::parse(*answer);
    if (json.value("stages", 0) == 0)
      return Failed(FailureCode::kNo3d, "3D pictures need WebGL, which this Chromium does not have");
    start_s_ = std::max(json.value("start", 0.0), options.from_s);
    end_s_ = std::min(json.value("end", 0.0), options.to_s);
    return answer;
  }

  std::unique_ptr<TemporaryFolder> folder_;
  std::unique_ptr<Chromium> browser_;
  double start_s_ = 0.0, end_s_ = 0.0;
};

std::vector<std::string> FfmpegArguments(FilmFormat format, const TemporaryFolder& folder, const std::string& out,
                                         const PictureOptions& options) {
  std::vector<std::string> arguments = {
      "-loglevel", "error", "-y", "-framerate", fmt::format("{}", options.frames_per_s), "-i", folder.In("%06d.png")};
  if (format == FilmFormat::kGif) {
    arguments.insert(arguments.end(), {"-vf", "split[a][b];[a]palettegen[p];[b][p]paletteuse"});
  } else {
    // Most players accept only this pixel format, which needs an even width and height.
    arguments.insert(arguments.end(), {"-c:v", "libx264", "-pix_fmt", "yuv420p", "-vf", "pad=ceil(iw/2)*2:ceil(ih/2)*2",
                                       "-movflags", "+faststart"});
  }
  arguments.push_back(out);
  return arguments;
}

}  // namespace

const std::vector<std::string>& OverlayNames() {
  static const std::vector<std::string> names = {"ghost", "support", "zmp",       "com",
                                                 "dcm",   "forces",  "footsteps", "swings"};
  return names;
}

const std::vector<std::string>& ViewNames() {
  static const std::vector<std::string> names = {"corner", "side", "front", "top"};
  return names;
}

Result<std::string> RenderPng(const std::string& page, double at_s, const PictureOptions& options) {
  CheckOptions(options);
  Result<Studio> studio = Studio::Open(page, options);
  if (!studio) return studio.failure();
  return studio->PictureAt(at_s);
}

Result<std::string> RenderFilm(const std::string& page, FilmFormat format, const PictureOptions& options) {
  CheckOptions(options);
  const std::string ffmpeg = FindProgram({"ffmpeg"});
  if (ffmpeg.empty()) {
    return Failed(FailureCode::kNoFfmpeg, "films need ffmpeg, which is not installed",
                  {"on Debian: apt-get install ffmpeg", "use --png FILE for a still picture without ffmpeg"});
  }
  Result<Studio> studio = Studio::Open(page, options);
  if (!studio) return studio.failure();
  const double span_s = studio->end_s() - studio->start_s(), step_s = options.speed / options.frames_per_s;
  if (!(span_s > 0.0))
    return Failed(FailureCode::kNoTime,
                  fmt::format("the motion has no frames between {} and {} s", options.from_s, options.to_s));
  const int frames = static_cast<int>(std::min(std::floor(span_s / step_s + 1e-9), 1e6)) + 1;
  if (frames > kMostFrames)
    return Failed(FailureCode::kTooLong,
                  fmt::format("{} pictures are too many; at most {} are accepted", frames, kMostFrames),
                  {"--from-s, --to-s, --speed, --fps"});
  for (int k = 0; k < frames; ++k) {
    const Result<std::string> png = studio->PictureAt(studio->start_s() + k * step_s);
    if (!png) return png.failure();
    const auto written = WriteFileAtomically(studio->folder().In(fmt::format("{:06d}.png", k)), *png);
    if (!written) return written.failure();
    if (options.progress) options.progress(k + 1, frames);
  }
  const std::string out = studio->folder().In(format == FilmFormat::kGif ? "film.gif" : "film.mp4");
  const Result<std::string> made = RunProgram(ffmpeg, FfmpegArguments(format, studio->folder(), out, options));
  if (!made) return made.failure();
  return ReadBytes(out);
}

}  // namespace gaitwright
