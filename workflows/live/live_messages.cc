// SPDX-License-Identifier: BSD-3-Clause
#include "workflows/live/live_messages.h"

#include <fmt/format.h>

#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <nlohmann/json.hpp>

#include "planning/gait/load_gaits.h"
#include "planning/plan/json_part_internal.h"
#include "playback/score/motion_series.h"
#include "playback/viewer/scene.h"

namespace gaitwright {
namespace {

using Json = nlohmann::ordered_json;

/// Seven digits tell more than can be seen, and take half the room.
double Short(double value) { return static_cast<double>(static_cast<float>(value)); }

template <class Numbers>
Json List(const Numbers& numbers) {
  Json list = Json::array();
  for (const double number : numbers) list.push_back(std::isfinite(number) ? Json(Short(number)) : Json());
  return list;
}

Json PaceJson(const Pace& pace) {
  return {{"gait", pace.gait},
          {"speed_m_s", pace.speed_m_s},
          {"lateral_speed_m_s", pace.lateral_speed_m_s},
          {"yaw_rate_rad_s", pace.yaw_rate_rad_s}};
}

/// Plan and measurement at this moment, as the viewer has them.
MotionSeries Now(const LiveWorld& live) {
  PlaybackLog log;
  log.log_rate_hz = 1.0 / live.step_s();
  log.start_s = live.time_s() - live.step_s();
  LogSample sample;
  sample.time_s = live.time_s();
  sample.q = live.world().q();
  sample.v = live.world().v();
  sample.tau = sample.tau_peak = live.world().tau();
  for (std::size_t i = 0; i < live.world().feet().size(); ++i) {
    sample.wrenches.push_back(live.world().feet()[i].wrench);
    if (live.world().feet()[i].touching) sample.contact |= FootBit(static_cast<int>(i));
  }
  log.samples.push_back(std::move(sample));
  return MakeMotionSeries(live.model(), live.plan(), log, {});
}

Json BalanceJson(const MotionSample& sample) {
  Json support = Json::array();
  for (const Vector2& corner : sample.support.polygon) support.push_back(List(corner));
  return {{"com", List(sample.p_WC)},
          {"dcm", List(sample.dcm_W)},
          {"zmp", sample.has_zmp ? List(sample.p_WZ) : Json()},
          {"margin_m", sample.has_zmp ? Json(Short(sample.zmp_margin_m())) : Json()},
          {"support", support}};
}

std::vector<std::string> GaitsFor(int feet) {
  std::vector<std::string> names = {"stand"};
  if (const Result<std::vector<GaitEntry>> gaits = BuiltInGaits()) {
    for (const GaitEntry& entry : *gaits) {
      if (entry.gait.num_feet() == feet) names.push_back(entry.gait.name);
    }
  }
  for (const GaitEntry& entry : GeneratedGaits(feet)) names.push_back(entry.gait.name);
  return names;
}

void SetPace(const JsonPart& m, LiveWorld& live, LiveClock&) {
  constexpr double kFastest = 20.0, kQuickestTurn = 20.0;
  m.Object({"do", "gait"}, {"speed_m_s", "lateral_speed_m_s", "yaw_rate_rad_s"});
  Pace pace;
  pace.gait = m.At("gait").Text();
  const auto number = [&](const char* key, double most) { return m.Has(key) ? m.At(key).NumberIn(-most, most) : 0.0; };
  pace.speed_m_s = number("speed_m_s", kFastest);
  pace.lateral_speed_m_s = number("lateral_speed_m_s", kFastest);
  pace.yaw_rate_rad_s = number("yaw_rate_rad_s", kQuickestTurn);
  live.Ask(pace);
}

void Pull(const JsonPart& m, LiveWorld& live, LiveClock&) {
  constexpr double kFarthest = 1e3;
  m.Object({"do", "body", "at_m", "to_m"});
  const int body = m.At("body").Whole(0, static_cast<int>(live.model().bodies.size()) - 1);
  const Vector3 at = m.At("at_m").Vector(3), to = m.At("to_m").Vector(3);
  if (at.norm() > kFarthest || to.norm() > kFarthest) m.Refuse("pulls too far away");
  live.Pull(body, at, to);
}

void SetGround(const JsonPart& m, LiveWorld& live, LiveClock&) {
  m.Object({"do", "friction", "slope_deg", "slope_direction_deg"});
  live.SetGround(m.At("friction").Number(), m.At("slope_deg").Number(), m.At("slope_direction_deg").Number());
}

void SetOptions(const JsonPart& m, LiveWorld& live, LiveClock&) {
  m.Object({"do", "options"});
  StabilisedOptions stabilised = live.play().stabilised;
  GainOptions gains = live.play().gains;
  OptionFields fields = Joined({Prefixed("stabilised", stabilised.Fields()), Prefixed("gains", gains.Fields())});
  const JsonPart options = m.At("options");
  if (!options.json().is_object()) options.Refuse("is no object of options");
  for (const auto& [key, value] : options.json().items())
    SetOption(fields, key, fmt::format("{}", options.At(key).Number()));
  live.SetControl(stabilised, gains);
}

void SetPose(const JsonPart& m, LiveWorld& live, LiveClock&) {
  m.Object({"do", "q"});
  VectorX q = m.At("q").Vector(static_cast<std::size_t>(live.model().nq()));
  if (q.head<3>().norm() > 100.0 || q.segment<4>(3).norm() < 0.1) m.Refuse("puts the base where it cannot be");
  q.segment<4>(3).normalize();
  for (int d = 0; d < live.model().num_dofs(); ++d) {
    const double held = std::min(std::max(q[7 + d], live.model().dof_lower(d)), live.model().dof_upper(d));
    q[7 + d] = held;
  }
  live.PutInPose(q);
}

void SetClock(const JsonPart& m, LiveWorld&, LiveClock& clock) {
  constexpr int kMostSteps = 10000;
  m.Object({"do"}, {"paused", "steps"});
  if (m.Has("paused")) clock.paused = m.At("paused").json().get<bool>();
  if (m.Has("steps")) clock.steps = m.At("steps").Whole(0, kMostSteps);
}

/// What acts on the robot alone.
template <void (LiveWorld::*Act)()>
void Plainly(const JsonPart& m, LiveWorld& live, LiveClock&) {
  m.Object({"do"});
  (live.*Act)();
}

using Doing = void (*)(const JsonPart& message, LiveWorld& live, LiveClock& clock);

const std::map<std::string, Doing>& Doings() {
  static const std::map<std::string, Doing> doings = {{"pace", SetPace},
                                                      {"pull", Pull},
                                                      {"let_go", Plainly<&LiveWorld::LetGo>},
                                                      {"reset", Plainly<&LiveWorld::Reset>},
                                                      {"stand_up", Plainly<&LiveWorld::StandUp>},
                                                      {"ground", SetGround},
                                                      {"options", SetOptions},
                                                      {"pose", SetPose},
                                                      {"clock", SetClock}};
  return doings;
}

}  // namespace

std::string LiveGreeting(const LiveWorld& live) {
  const RobotModel& model = live.model();
  PlayRequest play = live.play();
  Json options = Json::object();
  for (const OptionField& field :
       Joined({Prefixed("stabilised", play.stabilised.Fields()), Prefixed("gains", play.gains.Fields())})) {
    const auto* number = std::get_if<double*>(&field.target);
    if (number == nullptr) continue;
    options[field.key] = {{"value", **number},
                          {"lowest", field.lowest},
                          {"highest", field.highest},
                          {"unit", field.unit},
                          {"meaning", field.meaning}};
  }
  const Json json = {{"format", "gaitwright-live"},
                     {"schema", 1},
                     {"scene", Json::parse(RobotAndGroundJson(model, live.plan().terrain))},
                     {"gaits", GaitsFor(static_cast<int>(model.feet.size()))},
                     {"nominal_speed_m_s", model.nominal_speed_m_s},
                     {"weight_n", model.weight_n()},
                     {"friction", FrictionOf(live.plan().terrain, live.play().play.world, Vector2::Zero())},
                     {"step_s", live.step_s()},
                     {"options", options}};
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

std::string LiveFrame(LiveWorld& live, const LiveClock& clock, double behind_s, const std::vector<std::string>& notes) {
  const MotionSeries now = Now(live);
  Json feet = Json::array();
  for (const FootContact& foot : live.world().feet()) {
    feet.push_back({{"p", List(foot.p_W)},
                    {"f", foot.touching ? List(foot.wrench.force_W) : Json()},
                    {"touching", foot.touching}});
  }
  Json said = Json::array();
  for (const std::string& note : live.TakeNotes()) said.push_back(note);
  for (const std::string& note : notes) said.push_back(note);
  const Json json = {{"t", live.time_s()},
                     {"mode", NameOf(live.mode())},
                     {"paused", clock.paused},
                     {"behind_s", Short(behind_s)},
                     {"pace", PaceJson(live.pace())},
                     {"wanted", live.wanted() ? PaceJson(*live.wanted()) : Json()},
                     {"q", List(live.world().q())},
                     {"tau", List(live.world().tau())},
                     {"target", List(live.command().q)},
                     {"ghost", now.plan.empty() ? Json() : List(now.plan.front().q)},
                     {"measured", now.measured.empty() ? Json() : BalanceJson(now.measured.front())},
                     {"planned", now.planned.empty() ? Json() : BalanceJson(now.planned.front())},
                     {"feet", feet},
                     {"pull_n", live.pull_W() ? List(*live.pull_W()) : Json()},
                     {"notes", said}};
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

void ApplyLiveMessage(const std::string& message, LiveWorld& live, LiveClock& clock) {
  if (message.size() > kLongestLiveMessage) throw InvalidArgument("the message is too long");
  try {
    const Json json = ParseJsonOnce(message);
    const JsonPart part(json);
    if (!json.is_object() || !part.Has("do")) throw InvalidArgument("the message does not say what to 'do'");
    const std::string what = part.At("do").Text();
    const auto doing = Doings().find(what);
    if (doing == Doings().end()) {
      std::vector<std::string> names;
      for (const auto& [name, act] : Doings()) names.push_back(name);
      throw InvalidArgument(fmt::format("there is no doing '{}'; there are {}", what, QuotedList(names)));
    }
    doing->second(part, live, clock);
  } catch (const Json::exception&) {
    throw InvalidArgument(fmt::format("the message is no JSON: {}", WhyNoJson(message)));
  }
}

}  // namespace gaitwright
