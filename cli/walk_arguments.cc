// SPDX-License-Identifier: BSD-3-Clause
#include "cli/walk_arguments.h"

#include <fmt/format.h>

#include <algorithm>

#include "cli/numbers.h"
#include "workflows/walk/idle_options.h"

namespace gaitwright::cli {
namespace {

/// Why there is no ready-made set of sensors of that name, or "".
std::string NotASensorKind(const std::string& kind) {
  try {
    SensorsOfKind(kind);
    return "";
  } catch (const InvalidArgument& error) {
    return error.what();
  }
}

/// The keys of --set that give more than the usual value.
std::vector<std::string> ChangedBy(const std::vector<std::string>& sets, PlayRequest& request) {
  PlayRequest usual;
  std::vector<std::string> keys;
  for (const OptionChange& change : ChangesFrom(usual.Fields(), TextsOf(request.Fields()))) {
    const auto gives = [&](const std::string& set) { return set.starts_with(change.key + "="); };
    if (std::any_of(sets.begin(), sets.end(), gives)) keys.push_back(change.key);
  }
  return keys;
}

}  // namespace

void WalkArguments::AddTo(Verb verb) {
  verb.SetGroup("Robot and ground");
  robot.AddTo(verb);
  AddText(verb, "--terrain", "NAME", request.terrain,
          "Ground by name, with parameters or without, as stairs:rise_m=0.05,count=2, see 'gaitwright terrains'; or a "
          "file of one (YAML, CSV, PNG, OBJ, STL); default flat.");
  AddCommandTo(verb);
  verb.SetGroup("How it is planned");
  const Flag method = AddText(verb, "--com-method", "NAME", request.motion.centre_of_mass.method,
                              "How the centre of mass is planned: optimised, closed-form, preview or rigid-body; "
                              "default optimised, and rigid-body for gaits that fly.");
  keyed.push_back({method, "centre_of_mass.method"});
  verb.SetGroup("Options");
}

void WalkArguments::AddCommandTo(Verb verb) {
  verb.SetGroup("How fast (any mix of these)");
  WalkCommand& c = request.command;
  const Flag gait =
      AddText(verb, "--gait", "NAME", request.gait,
              "Gait by name, see 'gaitwright gaits', or a file of gaits: FILE.yaml for its first, FILE.yaml:NAME for "
              "another one; 'walk' is the slow one for the robot's number of legs; default: the robot's best.");
  const Flag ahead = AddNumber(verb, "--speed", "m/s", c.speed_m_s,
                               "Speed ahead, 0 or more; default 0: where no other speed says where to go the robot's "
                               "own, see 'gaitwright robots show'.");
  const Flag aside = AddNumber(verb, "--lateral-speed", "m/s", c.lateral_speed_m_s,
                               "Speed to the left, negative to the right; default 0.");
  const Flag turning = AddNumber(
      verb, "--yaw-rate", "rad/s", c.yaw_rate_rad_s,
      "Turning to the left, negative to the right; default 0. Alone it turns on the spot, with --distance it bends "
      "the way at the robot's own speed.");
  verb.SetGroup("How far (one of --distance, --duration, --goal, --steps)");
  const Flag distance =
      AddNumber(verb, "--distance", "m", extent.distance_m,
                "Length of the way in the commanded direction, along the curve where --yaw-rate bends it, more than 0; "
                "default 1, or a quarter turn where --yaw-rate stands alone.");
  const Flag duration = AddNumber(
      verb, "--duration", "s", extent.duration_s,
      "Time of walking at the commanded speeds, in whole cycles of the gait, more than 0; default: as --distance "
      "says.");
  const Flag pose = AddText(
      verb, "--goal", "x,y,yaw", goal,
      "Where to, in m, m and rad from the start: x ahead, y to the left, yaw between -pi and pi. A goal behind is "
      "walked to backward. Speeds given are the largest on the way.");
  const Flag count = AddWholeNumber(verb, "--steps", 1, extent.steps,
                                    "So many footfalls at the commanded speeds, the last ones closing the stance; 1 "
                                    "or more.");
  const Flag length =
      AddNumber(verb, "--step-length", "m", extent.step_length_m,
                "Advance of the robot in a footfall, with --steps and instead of --speed; 0 steps on the spot, "
                "negative goes back; default: speed times the time of a footfall.")
          .Need(count)
          .Exclude(ahead);
  keyed = {{ahead, "speed"}, {aside, "lateral_speed"}, {turning, "yaw_rate"}, {length, "step_length"}};
  verb.SetGroup("Several gaits one after the other, instead of all these");
  const Flag parts =
      AddText(verb, "--sequence", "PARTS", request.sequence,
              "Parts one after the other in one plan, as 'trot: speed=0.5, distance=1; stand: duration=1; walk', or a "
              "YAML file of them, see docs/gaits.md. Keys are speed, lateral-speed, yaw-rate; distance, duration or "
              "steps; step-length; default: none.");
  for (const Flag& other : {gait, ahead, aside, turning, distance, duration, pose, count}) parts.Exclude(other);
}

OptionFields WalkArguments::Fields() { return request.Fields(); }

void WalkArguments::Finish(const RobotModel& model) {
  if (!goal.empty()) {
    const std::vector<double> pose = ParseNumbers("--goal", goal, 3);
    extent.goal = PlanarPose{pose[0], pose[1], pose[2]};
  }
  SetExtent(model, extent, request.command, "--");
}

void PlayArguments::AddTo(Verb verb) {
  const OptionFields fields = request.Fields();
  const auto add = [&](const std::string& flag, const std::string& key) {
    const Flag option = AddField(verb, flag, fields, key);
    keyed.push_back({option, key});
    return option;
  };
  verb.SetGroup("Playback, and what the plan does not know");
  AddText(verb, "--controller", "NAME", request.controller,
          "stabilised (default), joint-pd, or for plans that stand recovering.");
  add("--state", "state");
  only_with_sensors =
      verb.AddReader(
              "--sensors", [this](const std::string& kind) { request.sensing.sensors = SensorsOfKind(kind); },
              "Figures of the sensors that --state measured and estimated have: ideal, good or hobby, see "
              "docs/sensing.md; --set sensors.* changes single ones; default ideal.")
          .SetType("KIND")
          .Check(NotASensorKind);
  add("--command-delay", "command_delay_s");
  AddText(verb, "--push", "fx,fy,fz", push,
          "Push on the base in N, world axes: x ahead, y to the left, z up; default none.");
  only_with_push = {add("--push-at", "play.push_at_s"), add("--push-for", "play.push_for_s")};
  add("--ground-slope-deg", "play.ground_slope_deg");
  add("--ground-bumps", "play.ground_bumps_m");
  add("--friction", "play.friction");
  add("--mass-scale", "play.mass_scale");
  add("--log-rate-hz", "play.log_rate_hz");
  verb.SetGroup("Options");
}

OptionFields PlayArguments::Fields() { return request.Fields(); }

void PlayArguments::Finish(const std::vector<std::string>& varied) {
  const auto varies = [&](const char* begins) {
    return std::any_of(varied.begin(), varied.end(), [&](const std::string& key) { return key.starts_with(begins); });
  };
  if (only_with_sensors->given() && !varies("state") && request.sensing.state == StateSourceNames().front())
    throw InvalidArgument("--sensors is for --state measured or estimated: the true state reads no sensor");
  if (!push.empty()) {
    const std::vector<double> force = ParseNumbers("--push", push, 3);
    request.play.push_force_W = Vector3(force[0], force[1], force[2]);
  }
  const bool pushes = !request.play.push_force_W.isZero(0.0);
  for (const Flag& flag : only_with_push) {
    if (flag.given() && push.empty() && !pushes && !varies("play.push_force"))
      throw InvalidArgument(flag.name() + " is given without --push: how hard is missing");
  }
  if (pushes && request.play.push_for_s == 0.0)
    throw InvalidArgument("a push that lasts for 0 s does nothing: --push-for is to be above 0");
}

void PlayArguments::CheckActs(const std::vector<std::string>& sets, const std::vector<std::string>& varied,
                              const std::vector<std::string>& drawn) {
  std::vector<std::string> open = drawn;
  open.insert(open.end(), varied.begin(), varied.end());
  if (!push.empty()) open.emplace_back("play.push_force");
  for (const auto& [flag, keys] : {std::pair("--set", ChangedBy(sets, request)), std::pair("--over", varied)}) {
    if (const std::optional<IdleOption> idle = FirstIdle(request, keys, open))
      throw InvalidArgument(fmt::format("{} {} has no effect {}; {}", flag, idle->key, idle->why, idle->hint));
  }
}

}  // namespace gaitwright::cli
