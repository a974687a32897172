// SPDX-License-Identifier: BSD-3-Clause
#include "workflows/render/chromium.h"

#include <fmt/format.h>
#include <unistd.h>

#include <cctype>
#include <cstdlib>
#include <filesystem>
#include <string_view>
#include <utility>

#include "kinematics/base/base64_internal.h"
#include "workflows/render/devtools_pipe_internal.h"
#include "workflows/render/run_program.h"
#include "workflows/render/temporary_folder_internal.h"

namespace gaitwright {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;
constexpr char kChromiumStage[] = "Chromium";

/// The program to start; "" if there is none.
std::string ProgramOf(const ChromiumOptions& options) {
  if (!options.program.empty()) return options.program;
  if (const char* named = std::getenv("GAITWRIGHT_CHROMIUM"); named != nullptr && *named != '\0') return named;
  return FindProgram({"chromium", "chromium-browser", "google-chrome", "google-chrome-stable", "chrome"});
}

std::vector<std::string> ArgumentsOf(const std::string& profile) {
  std::vector<std::string> arguments = {"--headless",
                                        "--remote-debugging-pipe",
                                        "--user-data-dir=" + profile,
                                        "--no-first-run",
                                        "--no-default-browser-check",
                                        "--disable-background-networking",
                                        "--disable-component-update",
                                        "--disable-sync",
                                        "--disable-quic",
                                        "--disable-extensions",
                                        "--disable-dev-shm-usage",
                                        "--hide-scrollbars",
                                        "--mute-audio",
                                        "--enable-unsafe-swiftshader",
                                        "--ignore-gpu-blocklist"};
  if (geteuid() == 0) arguments.emplace_back("--no-sandbox");  // Chromium refuses root otherwise
  arguments.emplace_back("about:blank");
  return arguments;
}

Failure Refused(const std::string& what) {
  return {FailureKind::kBadInput, FailureCode::kBrowser, kChromiumStage, what, {}};
}

}  // namespace

/// The pipe to one page.
class Chromium::Pipe {
 public:
  Pipe(DevtoolsPipe pipe, std::unique_ptr<TemporaryFolder> profile, double timeout_s)
      : profile_(std::move(profile)), pipe_(std::move(pipe)), timeout_s_(timeout_s) {}
  /// Asks the browser to end, so that its processes stop writing to the profile; kills it if it does not answer.
  ~Pipe() {
    constexpr double kLongest = 5.0;  // [s]
    if (!pipe_.Send({{"id", ++last_id_}, {"method", "Browser.close"}})) return;
    while (pipe_.Receive(kLongest)) {
    }
  }
  Pipe(const Pipe&) = delete;
  Pipe& operator=(const Pipe&) = delete;

  /// Calls a method and waits for its answer; processes events that arrive before it.
  Result<Json> Call(const std::string& method, const Json& parameters = Json::object()) {
    const int id = ++last_id_;
    Json message = {{"id", id}, {"method", method}, {"params", parameters}};
    if (!session_.empty()) message["sessionId"] = session_;
    const Result<int> sent = pipe_.Send(message);
    if (!sent) return sent.failure();
    while (true) {
      Result<Json> answer = pipe_.Receive(timeout_s_);
      if (!answer) return answer.failure();
      if (answer->value("id", 0) != id) {
        Look(*answer);
        continue;
      }
      if (answer->contains("error")) return Refused(method + ": " + (*answer)["error"].value("message", "refused"));
      return answer->value("result", Json::object());
    }
  }

  Result<Json> WaitFor(const std::string& event) {
    while (true) {
      Result<Json> message = pipe_.Receive(timeout_s_);
      if (!message) return message.failure();
      Look(*message);
      if (message->value("method", "") == event) return message;
    }
  }

  /// Opens a page of the given size and subscribes to its events.
  Result<Json> Attach(const ChromiumOptions& options) {
    const Result<Json> target = Call("Target.createTarget", {{"url", "about:blank"}});
    if (!target) return target.failure();
    Result<Json> session =
        Call("Target.attachToTarget", {{"targetId", target->value("targetId", "")}, {"flatten", true}});
    if (!session) return session.failure();
    session_ = session->value("sessionId", "");
    const Json metrics = {{"width", options.width_px},
                          {"height", options.height_px},
                          {"deviceScaleFactor", options.pixel_ratio},
                          {"mobile", false}};
    const Json scheme = {{"name", "prefers-color-scheme"}, {"value", options.dark ? "dark" : "light"}};
    const std::vector<std::pair<std::string, Json>> calls = {
        {"Page.enable", Json::object()},
        {"Runtime.enable", Json::object()},
        {"Log.enable", Json::object()},
        {"Emulation.setDeviceMetricsOverride", metrics},
        {"Emulation.setEmulatedMedia", {{"features", Json::array({scheme})}}}};
    for (const auto& [method, parameters] : calls) {
      Result<Json> done = Call(method, parameters);
      if (!done) return done;
    }
    return session;
  }

  std::vector<std::string> complaints;

 private:
  void Look(const Json& message) {
    const std::string method = message.value("method", "");
    const Json parameters = message.value("params", Json::object());
    if (method == "Runtime.exceptionThrown") {
      complaints.push_back(parameters["exceptionDetails"].dump());
    } else if (method == "Runtime.consoleAPICalled" && parameters.value("type", "") == "error") {
      complaints.push_back(parameters["args"].dump());
    } else if (method == "Log.entryAdded" && parameters["entry"].value("level", "") == "error") {
      complaints.push_back(parameters["entry"].value("text", ""));
    }
  }

  std::unique_ptr<TemporaryFolder> profile_;  // outlives the browser, which writes to it until it ends
  DevtoolsPipe pipe_;
  double timeout_s_;
  int last_id_ = 0;
  std::string session_;
};

Chromium::Chromium(std::unique_ptr<Pipe> pipe) : pipe_(std::move(pipe)) {}
Chromium::~Chromium() = default;

Result<std::unique_ptr<Chromium>> Chromium::Start(const ChromiumOptions& options) {
  const std::string program = ProgramOf(options);
  if (program.empty()) {
    return Failure{FailureKind::kBadInput,
                   FailureCode::kNoBrowser,
                   kChromiumStage,
                   "pictures need Chromium, which is not installed",
                   {"on Debian: apt-get install chromium", "GAITWRIGHT_CHROMIUM=/path/to/chromium"}};
  }
  auto profile = std::make_unique<TemporaryFolder>();
  if (!profile->there()) return Refused("no temporary folder can be created");
  Result<DevtoolsPipe> started = DevtoolsPipe::Start(program, ArgumentsOf(profile->path()));
  if (!started) return started.failure();
  auto pipe = std::make_unique<Pipe>(std::move(*started), std::move(profile), options.timeout_s);
  const Result<Json> attached = pipe->Attach(options);
  if (!attached) return attached.failure();
  return std::unique_ptr<Chromium>(new Chromium(std::move(pipe)));
}

Result<std::string> Chromium::Open(const std::string& url) {
  pipe_->complaints.clear();
  const Result<Json> answer = pipe_->Call("Page.navigate", {{"url", url}});
  if (!answer) return answer.failure();
  if (answer->contains("errorText")) return Refused(url + ": " + answer->value("errorText", ""));
  const Result<Json> loaded = pipe_->WaitFor("Page.loadEventFired");
  if (!loaded) return loaded.failure();
  return url;
}

Result<std::string> Chromium::Evaluate(const std::string& expression) {
  const Result<Json> answer =
      pipe_->Call("Runtime.evaluate", {{"expression", expression}, {"awaitPromise", true}, {"returnByValue", true}});
  if (!answer) return answer.failure();
  if (answer->contains("exceptionDetails")) {
    const Json& details = (*answer)["exceptionDetails"];
    const Json thrown = details.value("exception", Json::object());
    return Refused(thrown.value("description", details.value("text", "an exception")));
  }
  const Json& result = answer->at("result");
  return result.contains("value") ? result["value"].dump() : std::string("null");
}

Result<std::string> Chromium::Png() {
  const Result<Json> answer = pipe_->Call("Page.captureScreenshot", {{"format", "png"}});
  if (!answer) return answer.failure();
  return FromBase64(answer->value("data", ""));
}

Result<std::string> Chromium::Press(const std::string& key) {
  for (const char* type : {"keyDown", "keyUp"}) {
    Json parameters = {{"type", type}, {"key", key}};
    if (key.size() == 1 && std::string(type) == "keyDown") parameters["text"] = key;
    const Result<Json> done = pipe_->Call("Input.dispatchKeyEvent", parameters);
    if (!done) return done.failure();
  }
  return key;
}

Result<std::string> Chromium::Point(Mouse does, double x_px, double y_px) {
  const bool moves = does == Mouse::kMove || does == Mouse::kDrag, down = does == Mouse::kDrag || does == Mouse::kPress;
  const char* const type = moves ? "mouseMoved" : (down ? "mousePressed" : "mouseReleased");
  const Json parameters = {{"type", type},
                           {"x", x_px},
                           {"y", y_px},
                           {"button", does == Mouse::kMove ? "none" : "left"},
                           {"buttons", down ? 1 : 0},
                           {"clickCount", moves ? 0 : 1}};
  const Result<Json> done = pipe_->Call("Input.dispatchMouseEvent", parameters);
  if (!done) return done.failure();
  return std::string(type);
}

const std::vector<std::string>& Chromium::complaints() const { return pipe_->complaints; }

std::string FileUrl(const std::string& path) {
  constexpr char kKept[] = "-_.~/";
  std::string url = "file://";
  for (const char c : fs::absolute(path).string()) {
    const unsigned char byte = static_cast<unsigned char>(c);
    const bool plain =
        byte < 0x80 && (std::isalnum(byte) != 0 || std::string_view(kKept).find(c) != std::string_view::npos);
    url += plain ? std::string(1, c) : fmt::format("%{:02X}", byte);
  }
  return url;
}

}  // namespace gaitwright
