// SPDX-License-Identifier: BSD-3-Clause
#include "workflows/live/live_session.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <thread>

#include "kinematics/base/result.h"
#include "planning/plan/sample_plan.h"

namespace gaitwright {
namespace {

constexpr std::size_t kNotesShown = 12;
constexpr double kSayEvery = 5.0;  // [s]
constexpr double kOnePicture = 1.0 / LiveSession::kPictures_hz;

std::string NamesOf(const RobotModel& model, FootSet feet) {
  std::string names;
  for (std::size_t i = 0; i < model.feet.size(); ++i) {
    if (Contains(feet, static_cast<int>(i))) names += (names.empty() ? "" : "+") + model.feet[i].name;
  }
  return names.empty() ? "none" : names;
}

FootSet TouchingOf(const World& world) {
  FootSet feet = 0;
  for (std::size_t i = 0; i < world.feet().size(); ++i) {
    if (world.feet()[i].touching) feet |= FootBit(static_cast<int>(i));
  }
  return feet;
}

double MachineSeconds() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

}  // namespace

LiveSession::LiveSession(LiveWorld& live, LiveServer& server, LiveListener listener, std::function<double()> spent_s)
    : live_(live), server_(server), listener_(std::move(listener)), spent_s_(std::move(spent_s)) {
  if (!spent_s_) spent_s_ = MachineSeconds;
}

void LiveSession::Turn(double wall_s) {
  constexpr double kToHear = 0.5;  // share of the time between two frames
  const double begun_s = spent_s_(), until_s = begun_s + kOnePicture;
  Hear(begun_s + kToHear * kOnePicture);
  const double step_s = live_.step_s();
  if (status_.clock.paused) {
    due_s_ = 0.0;
    for (; status_.clock.steps > 0 && spent_s_() < until_s; --status_.clock.steps) StepOnce();
  } else {
    status_.clock.steps = 0;
    due_s_ += wall_s;
    while (due_s_ >= step_s && spent_s_() < until_s) {
      StepOnce();
      due_s_ -= step_s;
    }
  }
  const double beyond = std::max(0.0, due_s_ - kMostBehind);
  due_s_ -= beyond;
  let_go_s_ += beyond;
  unsaid_for_s_ += wall_s;
  if (let_go_s_ > 0.0 && unsaid_for_s_ > kSayEvery) {
    Note(fmt::format("slower than real time: {:.1f} s lost in {:.1f} s", let_go_s_, unsaid_for_s_));
    let_go_s_ = unsaid_for_s_ = 0.0;
  }
  for (const std::string& note : live_.TakeNotes()) Note(note);
  status_.behind_s = due_s_ >= kOnePicture ? due_s_ : 0.0;
  if (server_.pages() > 0) server_.Publish(LiveFrame(live_, status_));
}

void LiveSession::Run(const std::function<bool()>& stop) {
  using Clock = std::chrono::steady_clock;
  const auto picture = std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(kOnePicture));
  Clock::time_point last = Clock::now(), next = last;
  while (!stop()) {
    const Clock::time_point now = Clock::now();
    Turn(std::chrono::duration<double>(now - last).count());
    last = now;
    next = std::max(next + picture, Clock::now());
    std::this_thread::sleep_until(next);
  }
}

void LiveSession::Hear(double until_s) {
  while (const std::optional<LiveSaying> saying = server_.Next()) {
    if (saying->left) {
      live_.hands().LetGo(saying->page);
      continue;
    }
    try {
      ReadLiveRequest(live_.model(), saying->text)(live_, status_.clock, saying->page);
    } catch (const InvalidArgument& refused) {
      server_.Tell(saying->page, LiveRefusal(refused.what()));
    }
    if (spent_s_() > until_s) return;
  }
}

/// Makes one step. If a controller or a plan refuses it, the simulation restarts, so that the session continues.
void LiveSession::StepOnce() {
  try {
    live_.Step();
  } catch (const InvalidArgument& refused) {
    Note(fmt::format("the simulation restarts: {}", refused.what()));
    live_.Reset();
  }
  ReportPhase();
}

void LiveSession::ReportPhase() {
  const ContactSchedule& schedule = live_.plan().schedule;
  const FootSet planned = schedule.phases[static_cast<std::size_t>(PhaseAt(schedule, live_.time_s()))].stance;
  const FootSet touching = TouchingOf(live_.world());
  if (planned == planned_stance_ && touching == touching_) return;
  planned_stance_ = planned;
  touching_ = touching;
  listener_.phase(fmt::format("{:9.3f} s  {:7}  planned {:12} touching {:12} base {:+.3f} {:+.3f} m/s", live_.time_s(),
                              NameOf(live_.mode()), NamesOf(live_.model(), planned), NamesOf(live_.model(), touching),
                              live_.world().v()[0], live_.world().v()[1]));
}

void LiveSession::Note(const std::string& text) {
  status_.notes.emplace_back(++noted_, text);
  if (status_.notes.size() > kNotesShown) status_.notes.erase(status_.notes.begin());
  listener_.note(text);
}

}  // namespace gaitwright
