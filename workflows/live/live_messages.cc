// SPDX-License-Identifier: BSD-3-Clause
#include "workflows/live/live_messages.h"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>
#include <random>

#include "kinematics/dynamics/foot_contact.h"
#include "kinematics/spatial/rotation.h"
#include "planning/gait/load_gaits.h"
#include "playback/play/make_world.h"
#include "playback/score/motion_series.h"
#include "playback/viewer/scene.h"

namespace gaitwright {
namespace {

using Json = nlohmann::ordered_json;

/// Rounds to single precision, which is enough for display and needs half the space.
double Short(double value) { return static_cast<double>(static_cast<float>(value)); }

template <class Numbers>
Json List(const Numbers& numbers) {
  Json list = Json::array();
  for (const double number : numbers) list.push_back(std::isfinite(number) ? Json(Short(number)) : Json());
  return list;
}

Json PaceJson(const WalkPace& pace) {
  return {{"gait", pace.gait},
          {"speed_m_s", pace.speed_m_s},
          {"lateral_speed_m_s", pace.lateral_speed_m_s},
          {"yaw_rate_rad_s", pace.yaw_rate_rad_s}};
}

/// Plan and measurement at this time, in the viewer's form.
MotionSeries Now(const LiveWorld& live, const LogSample& sample) {
  PlaybackLog log;
  log.log_rate_hz = 1.0 / live.step_s();
  log.start_s = live.time_s() - live.step_s();
  log.samples.push_back(sample);
  return MakeMotionSeries(live.model(), live.plan(), log, {});
}

/// Positions of the feet; for feet in contact, their contact points and forces.
Json FeetJson(const LiveWorld& live, const LogSample& sample) {
  const RobotModel& model = live.model();
  DynamicsScratch scratch(model);
  ForwardKinematics(model, sample.q, scratch);
  Json feet = Json::array();
  for (std::size_t i = 0; i < model.feet.size(); ++i) {
    const bool touching = Contains(sample.contact, static_cast<int>(i));
    const Vector3 p_W = touching ? live.world().feet()[i].p_W
                                 : Vector3(ContactFrame(model, scratch, static_cast<int>(i)).translation());
    feet.push_back(
        {{"p", List(p_W)}, {"f", touching ? List(sample.wrenches[i].force_W) : Json()}, {"touching", touching}});
  }
  return feet;
}

/// Projects a point in plan view onto the support of the robot, or onto the ground in flight.
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
  return {{"engine", world.engine},
          {"friction", Short(FrictionOf(live.plan().terrain, world, live.world().q().head<2>()))},
          {"slope_deg", world.ground_slope_deg},
          {"slope_direction_deg", world.ground_slope_direction_deg},
          {"pose", pose}};
}

Json Degrees(double angle_rad) { return Short(angle_rad * 180.0 / std::numbers::pi); }

Json PullsJson(const HandsOn& hands) {
  Json pulls = Json::array();
  for (const Grip& grip : hands.grips())
    pulls.push_back({{"page", grip.hand},
                     {"body", grip.body},
                     {"at_m", List(grip.p_Body)},
                     {"from_m", List(grip.from_W.value_or(Vector3::Zero()))},
                     {"force_n", List(grip.force_W)}});
  return pulls;
}

/// A name that identifies one start of the program.
std::string RunName() {
  std::random_device device;
  return fmt::format("{:08x}{:08x}", device(), device());
}

std::vector<std::string> GaitsFor(int feet) {
  std::vector<std::string> names = {kStanding};
  if (const Result<std::vector<GaitEntry>> gaits = BuiltInGaits()) {
    for (const GaitEntry& entry : *gaits) {
      if (entry.gait.num_feet() == feet) names.push_back(entry.gait.name);
    }
  }
  for (const GaitEntry& entry : GeneratedGaits(feet)) names.push_back(entry.gait.name);
  return names;
}

}  // namespace

std::string LiveGreeting(const LiveWorld& live, const std::optional<std::string>& mesh_folder) {
  PlayRequest play = live.play();
  Json options = Json::object();
  for (const OptionField& field : LiveOptions(play)) {
    options[field.key] = {{"value", *std::get<double*>(field.target)},
                          {"lowest", std::isfinite(field.lowest) ? Json(field.lowest) : Json()},
                          {"highest", std::isfinite(field.highest) ? Json(field.highest) : Json()},
                          {"unit", field.unit},
                          {"meaning", field.meaning}};
  }
  const PullSpring spring = PullSpringFor(live.model());
  const Json json = {{"format", "gaitwright-live"},
                     {"schema", 1},
                     {"run", RunName()},
                     {"scene", Json::parse(RobotAndGroundJson(live.model(), live.plan().terrain, mesh_folder))},
                     {"engines", EngineNames()},
                     {"gaits", GaitsFor(static_cast<int>(live.model().feet.size()))},
                     {"usual_pace", PaceJson(live.usual_pace())},
                     {"step_s", live.step_s()},
                     {"spring", {{"n_per_m", Short(spring.n_per_m)}, {"most_n", Short(spring.most_n)}}},
                     {"options", options}};
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

std::string LiveFrame(LiveWorld& live, const LiveStatus& status) {
  const LogSample sample = live.TakeSample();
  const MotionSeries now = Now(live, sample);
  const Terrain& terrain = live.plan().terrain;
  const std::optional<double> wanted_heading = live.wanted_heading_rad();
  const std::optional<Vector3> push_W = live.hands().push_W();
  Json notes = Json::array(), options = Json::array();
  for (const auto& [number, note] : status.notes) notes.push_back({number, note});
  PlayRequest play = live.play();
  for (const OptionField& field : LiveOptions(play)) options.push_back(*std::get<double*>(field.target));
  const Json json = {{"t", live.time_s()},
                     {"mode", NameOf(live.mode())},
                     {"paused", status.clock.paused},
                     {"behind_s", Short(status.behind_s)},
                     {"pace", PaceJson(live.pace())},
                     {"wanted", live.wanted() ? PaceJson(live.wanted()->pace) : Json()},
                     {"heading_deg", Degrees(YawOf(BaseRotation(live.world().q())))},
                     {"wanted_heading_deg", wanted_heading ? Degrees(*wanted_heading) : Json()},
                     {"q", List(live.world().q())},
                     {"tau", List(live.world().tau())},
                     {"target", List(live.command().q)},
                     {"stiffness", List(live.gains().stiffness)},
                     {"damping", List(live.gains().damping)},
                     {"ghost", List(now.plan.front().q)},
                     {"measured", BalanceJson(now.measured.front(), terrain)},
                     {"planned", BalanceJson(now.planned.front(), terrain)},
                     {"feet", FeetJson(live, sample)},
                     {"pulls", PullsJson(live.hands())},
                     {"push_n", push_W ? List(*push_W) : Json()},
                     {"ground", GroundJson(live)},
                     {"options", options},
                     {"notes", notes}};
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

std::string LivePageNumber(std::uint64_t page) { return Json({{"page", page}}).dump(); }

std::string LiveRefusal(const std::string& why) {
  return Json({{"refused", why}}).dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace gaitwright
