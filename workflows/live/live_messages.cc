// SPDX-License-Identifier: BSD-3-Clause
#include "workflows/live/live_messages.h"

#include <fmt/format.h>

#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <nlohmann/json.hpp>
#include <numbers>

#include "kinematics/spatial/rotation.h"
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

/// Plan and measurement at this moment, as the viewer has them; the forces are means since the last picture.
MotionSeries Now(LiveWorld& live) {
  PlaybackLog log;
  log.log_rate_hz = 1.0 / live.step_s();
  log.start_s = live.time_s() - live.step_s();
  log.samples.push_back(live.TakeSample());
  return MakeMotionSeries(live.model(), live.plan(), log, {});
}

/// Where a point of plan view lies on what carries the robot, in flight on the ground.
Vector3 OnGround(const Vector2& p_W, const MotionSample& sample, const Terrain& terrain) {
  const bool flies = sample.support.empty();
  return {p_W.x(), p_W.y(), flies ? GroundAt(terrain, p_W).height_m : PlaneHeight(sample.support, p_W)};
}

Json BalanceJson(const MotionSample& sample, const Terrain& terrain) {
  Json support = Json::array();
  for (const Vector2& corner : sample.support.polygon) support.push_back(List(OnGround(corner, sample, terrain)));
  return {{"com", List(sample.p_WC)},
          {"dcm", List(OnGround(sample.dcm_W, sample, terrain))},
          {"zmp", sample.has_zmp ? List(OnGround(sample.p_WZ, sample, terrain)) : Json()},
          {"margin_m", sample.has_zmp ? Json(Short(sample.zmp_margin_m())) : Json()},
          {"support", support}};
}

Json GroundJson(const LiveWorld& live) {
  const WorldOptions& world = live.play().play.world;
  const Pose X = live.ground_tilt();
  const Eigen::Quaterniond turn(X.linear());
  Json pose = List(Vector3(X.translation()));
  for (const double number : {turn.x(), turn.y(), turn.z(), turn.w()}) pose.push_back(Short(number));
  return {{"friction", Short(FrictionOf(live.plan().terrain, world, live.world().q().head<2>()))},
          {"slope_deg", world.ground_slope_deg},
          {"slope_direction_deg", world.ground_slope_direction_deg},
          {"pose", pose}};
}

/// Those that pages may change: numbers of the controller and its gains.
OptionFields ChangeableFields(StabilisedOptions& stabilised, GainOptions& gains) {
  OptionFields fields = ChangeableFields(stabilised, gains);
  std::erase_if(fields, [](const OptionField& field) { return !std::holds_alternative<double*>(field.target); });
  return fields;
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
  OptionFields fields = ChangeableFields(stabilised, gains);
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

void SetHeading(const JsonPart& m, LiveWorld& live, LiveClock&) {
  constexpr double kMostTurns = 36000.0;
  m.Object({"do", "heading_deg"});
  live.AskHeading(m.At("heading_deg").NumberIn(-kMostTurns, kMostTurns) * std::numbers::pi / 180.0);
}

void Nudge(const JsonPart& m, LiveWorld& live, LiveClock&) {
  m.Object({"do", "dof", "by", "for_s"});
  live.Nudge(m.At("dof").Whole(0, live.model().num_dofs() - 1), m.At("by").Number(), m.At("for_s").Number());
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
                                                      {"heading", SetHeading},
                                                      {"nudge", Nudge},
                                                      {"clock", SetClock}};
  return doings;
}

}  // namespace

std::string LiveGreeting(const LiveWorld& live, const std::optional<std::string>& mesh_folder) {
  PlayRequest play = live.play();
  Json options = Json::object();
  for (const OptionField& field : ChangeableFields(play.stabilised, play.gains)) {
    options[field.key] = {{"value", *std::get<double*>(field.target)},
                          {"lowest", std::isfinite(field.lowest) ? Json(field.lowest) : Json()},
                          {"highest", std::isfinite(field.highest) ? Json(field.highest) : Json()},
                          {"unit", field.unit},
                          {"meaning", field.meaning}};
  }
  const Json json = {{"format", "gaitwright-live"},
                     {"schema", 1},
                     {"scene", Json::parse(RobotAndGroundJson(live.model(), live.plan().terrain, mesh_folder))},
                     {"gaits", GaitsFor(static_cast<int>(live.model().feet.size()))},
                     {"usual_pace", PaceJson(live.usual_pace())},
                     {"step_s", live.step_s()},
                     {"options", options}};
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

std::string LiveFrame(LiveWorld& live, const LiveStatus& status) {
  const MotionSeries now = Now(live);
  const Terrain& terrain = live.plan().terrain;
  Json feet = Json::array();
  for (const FootContact& foot : live.world().feet()) {
    feet.push_back({{"p", List(foot.p_W)},
                    {"f", foot.touching ? List(foot.wrench.force_W) : Json()},
                    {"touching", foot.touching}});
  }
  Json notes = Json::array(), options = Json::array();
  for (const auto& [number, note] : status.notes) notes.push_back({number, note});
  PlayRequest play = live.play();
  for (const OptionField& field : ChangeableFields(play.stabilised, play.gains))
    options.push_back(*std::get<double*>(field.target));
  const Json json = {{"t", live.time_s()},
                     {"mode", NameOf(live.mode())},
                     {"paused", status.clock.paused},
                     {"behind_s", Short(status.behind_s)},
                     {"pace", PaceJson(live.pace())},
                     {"wanted", live.wanted() ? PaceJson(*live.wanted()) : Json()},
                     {"heading_deg", Short(YawOf(BaseRotation(live.world().q())) * 180.0 / std::numbers::pi)},
                     {"q", List(live.world().q())},
                     {"tau", List(live.world().tau())},
                     {"target", List(live.command().q)},
                     {"ghost", List(now.plan.front().q)},
                     {"measured", BalanceJson(now.measured.front(), terrain)},
                     {"planned", BalanceJson(now.planned.front(), terrain)},
                     {"feet", feet},
                     {"pull_n", live.pull_W() ? List(*live.pull_W()) : Json()},
                     {"ground", GroundJson(live)},
                     {"options", options},
                     {"notes", notes}};
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

std::string LiveRefusal(const std::string& why) {
  return Json({{"refused", why}}).dump(-1, ' ', false, Json::error_handler_t::replace);
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
