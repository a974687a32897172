// SPDX-License-Identifier: BSD-3-Clause
#include "workflows/live/live_requests.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <numbers>
#include <utility>
#include <vector>

#include "kinematics/base/options.h"
#include "planning/gait/find_gait.h"
#include "planning/plan/json_part_internal.h"
#include "playback/play/make_world.h"
#include "workflows/walk/idle_options.h"

namespace gaitwright {
namespace {

constexpr double kLongest_s = 10.0;  // duration of a push or a nudge
constexpr int kMostSteps = 10000;    // per request, while the clock is paused

/// A gait by name. Pages must not name files.
std::string GaitOf(const JsonPart& part, const RobotModel& model) {
  std::string name = part.Text();
  if (name == kStanding) return name;
  if (!GaitFileOf(name).empty()) part.Refuse("is a file; give a gait by its name");
  const Result<Gait> gait = FindGait(model, name, 0.0, {});
  if (!gait) throw InvalidArgument(gait.failure().message);
  return gait->name;
}

LiveRequest ReadPace(const JsonPart& m, const RobotModel& model) {
  constexpr double kFastest = 20.0, kFastestTurn = 20.0;
  m.Object({"do", "gait"}, {"speed_m_s", "lateral_speed_m_s", "yaw_rate_rad_s"});
  const auto number = [&](const char* key, double most) { return m.Has(key) ? m.At(key).NumberIn(-most, most) : 0.0; };
  const WalkPace pace = {.gait = GaitOf(m.At("gait"), model),
                         .speed_m_s = number("speed_m_s", kFastest),
                         .lateral_speed_m_s = number("lateral_speed_m_s", kFastest),
                         .yaw_rate_rad_s = number("yaw_rate_rad_s", kFastestTurn)};
  return [pace](LiveWorld& live, LiveClock&, HandId) { live.Ask(pace); };
}

LiveRequest ReadHeading(const JsonPart& m, const RobotModel&) {
  constexpr double kMost_deg = 36000.0;
  m.Object({"do", "heading_deg"});
  const double heading_rad = m.At("heading_deg").NumberIn(-kMost_deg, kMost_deg) * std::numbers::pi / 180.0;
  return [heading_rad](LiveWorld& live, LiveClock&, HandId) { live.AskHeading(heading_rad); };
}

LiveRequest ReadPull(const JsonPart& m, const RobotModel& model) {
  constexpr double kFarthest = 1e3;
  m.Object({"do", "body", "at_m", "by_m"}, {"along"});
  const int body = m.At("body").Whole(0, static_cast<int>(model.bodies.size()) - 1);
  const Vector3 at = m.At("at_m").Vector(3), by = m.At("by_m").Vector(3);
  if (at.norm() > kFarthest)
    m.Refuse(fmt::format("has a hold point too far from the body's origin, {:.4g} m; at most {} m is accepted",
                         at.norm(), kFarthest));
  if (by.norm() > kFarthest)
    m.Refuse(fmt::format("has a pull distance of {:.4g} m; at most {} m is accepted", by.norm(), kFarthest));
  const bool along = m.Has("along") && m.At("along").Truth();
  return [=](LiveWorld& live, LiveClock&, HandId hand) { live.hands().Pull(hand, body, at, by, along); };
}

LiveRequest ReadLetGo(const JsonPart& m, const RobotModel&) {
  m.Object({"do"});
  return [](LiveWorld& live, LiveClock&, HandId hand) { live.hands().LetGo(hand); };
}

LiveRequest ReadPush(const JsonPart& m, const RobotModel&) {
  m.Object({"do", "force_n", "for_s"});
  const Vector3 force_W = m.At("force_n").Vector(3);
  const double for_s = m.At("for_s").NumberIn(0.0, kLongest_s);
  return [force_W, for_s](LiveWorld& live, LiveClock&, HandId) { live.hands().Push(force_W, live.time_s() + for_s); };
}

LiveRequest ReadGround(const JsonPart& m, const RobotModel&) {
  m.Object({"do", "friction", "slope_deg", "slope_direction_deg"});
  const double friction = m.At("friction").Number(), slope = m.At("slope_deg").Number();
  const double direction = m.At("slope_direction_deg").Number();
  return [=](LiveWorld& live, LiveClock&, HandId) { live.SetGround(friction, slope, direction); };
}

LiveRequest ReadOptions(const JsonPart& m, const RobotModel&) {
  m.Object({"do", "options"});
  const JsonPart options = m.At("options");
  if (!options.json().is_object()) options.Refuse("is not an object of options");
  OptionTexts texts;
  PlayRequest tried;
  tried.controller = "recovering";  // it has the options of all controllers
  OptionFields fields = LiveOptions(tried);
  for (const auto& [key, value] : options.json().items()) {
    texts.emplace_back(key, fmt::format("{}", options.At(key).Number()));
    SetOption(fields, key, texts.back().second);
  }
  return [texts](LiveWorld& live, LiveClock&, HandId) {
    PlayRequest changed = live.play();
    OptionFields changing = LiveOptions(changed);
    for (const auto& [key, text] : texts) SetOption(changing, key, text);
    live.SetControl(changed);
  };
}

LiveRequest ReadPose(const JsonPart& m, const RobotModel& model) {
  constexpr double kShortest = 0.1, kLongest = 10.0;  // length of a quaternion
  constexpr double kRounding = 1e-4;                  // rounding of numbers from pages
  m.Object({"do", "q"});
  VectorX q = m.At("q").Vector(static_cast<std::size_t>(model.nq()));
  const double length = q.segment<4>(3).norm();
  if (!(length > kShortest && length < kLongest)) m.Refuse("has an invalid quaternion of the base");
  q.segment<4>(3) /= length;
  for (int d = 0; d < model.num_dofs(); ++d) {
    const double lower = model.dof_lower(d), upper = model.dof_upper(d);
    if (q[7 + d] < lower - kRounding || q[7 + d] > upper + kRounding)
      m.Refuse(fmt::format("has {} for {}; accepted: {} to {}", q[7 + d], model.dof_names[static_cast<std::size_t>(d)],
                           lower, upper));
    q[7 + d] = std::clamp(q[7 + d], lower, upper);
  }
  return [q](LiveWorld& live, LiveClock&, HandId) { live.PutInPose(q); };
}

LiveRequest ReadNudge(const JsonPart& m, const RobotModel& model) {
  m.Object({"do", "dof", "by", "for_s"});
  const int dof = m.At("dof").Whole(0, model.num_dofs() - 1);
  const double by = m.At("by").Number(), for_s = m.At("for_s").NumberIn(0.0, kLongest_s);
  return [=](LiveWorld& live, LiveClock&, HandId) { live.hands().Nudge(dof, by, live.time_s() + for_s); };
}

LiveRequest ReadClock(const JsonPart& m, const RobotModel&) {
  m.Object({"do"}, {"paused", "steps"});
  std::optional<bool> paused;
  if (m.Has("paused")) paused = m.At("paused").Truth();
  const int steps = m.Has("steps") ? m.At("steps").Whole(0, kMostSteps) : 0;
  return [paused, steps](LiveWorld&, LiveClock& clock, HandId) {
    clock.paused = paused.value_or(clock.paused);
    clock.steps = std::min(clock.steps + steps, kMostSteps);
  };
}

LiveRequest ReadReset(const JsonPart& m, const RobotModel&) {
  m.Object({"do"}, {"engine"});
  if (!m.Has("engine")) return [](LiveWorld& live, LiveClock&, HandId) { live.Reset(); };
  const std::string engine = m.At("engine").Text();
  const std::vector<std::string>& engines = EngineNames();
  if (std::find(engines.begin(), engines.end(), engine) == engines.end())
    m.Refuse(fmt::format("has engine '{}'; accepted: {}", engine, QuotedList(engines)));
  return [engine](LiveWorld& live, LiveClock&, HandId) { live.Reset(engine); };
}

/// Requests without further data that act on the robot.
template <void (LiveWorld::*Act)()>
LiveRequest ReadPlain(const JsonPart& m, const RobotModel&) {
  m.Object({"do"});
  return [](LiveWorld& live, LiveClock&, HandId) { (live.*Act)(); };
}

using Reader = LiveRequest (*)(const JsonPart& message, const RobotModel& model);

const std::map<std::string, Reader>& Readers() {
  static const std::map<std::string, Reader> readers = {{"pace", ReadPace},
                                                        {"heading", ReadHeading},
                                                        {"pull", ReadPull},
                                                        {"push", ReadPush},
                                                        {"let_go", ReadLetGo},
                                                        {"reset", ReadReset},
                                                        {"stand_up", ReadPlain<&LiveWorld::StandUp>},
                                                        {"ground", ReadGround},
                                                        {"options", ReadOptions},
                                                        {"pose", ReadPose},
                                                        {"nudge", ReadNudge},
                                                        {"clock", ReadClock}};
  return readers;
}

std::vector<std::string> NamesOfRequests() {
  std::vector<std::string> names;
  for (const auto& [name, reader] : Readers()) names.push_back(name);
  return names;
}

}  // namespace

OptionFields LiveOptions(PlayRequest& play) {
  OptionFields fields =
      Joined({Prefixed("stabilised", play.stabilised.Fields()), Prefixed("recovering", play.recovering.Fields()),
              Prefixed("gains", play.gains.Fields())});
  std::erase_if(fields, [&](const OptionField& field) {
    return !std::holds_alternative<double*>(field.target) || FirstIdle(play, {field.key}).has_value();
  });
  return fields;
}

LiveRequest ReadLiveRequest(const RobotModel& model, const std::string& message) {
  using Json = JsonPart::Json;
  if (message.size() > kLongestLiveMessage)
    throw InvalidArgument(
        fmt::format("the message has {} bytes; at most {} are read", message.size(), kLongestLiveMessage));
  try {
    const Json json = ParseJsonOnce(message);
    const JsonPart part(json);
    if (!json.is_object() || !part.Has("do")) throw InvalidArgument("the message lacks the key 'do'");
    const std::string what = part.At("do").Text();
    const auto reader = Readers().find(what);
    if (reader == Readers().end())
      throw InvalidArgument(fmt::format("'do' is '{}'; accepted: {}", what, QuotedList(NamesOfRequests())));
    return reader->second(part, model);
  } catch (const Json::exception&) {
    throw InvalidArgument(fmt::format("the message is not JSON: {}", ReasonNoJson(message)));
  }
}

}  // namespace gaitwright
