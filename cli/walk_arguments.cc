// SPDX-License-Identifier: BSD-3-Clause
#include "cli/walk_arguments.h"

#include <fmt/format.h>

#include <algorithm>

#include "cli/numbers.h"
#include "workflows/walk/idle_options.h"

namespace gaitwright::cli {
namespace {

/// Why the name is not that of a built-in set of sensors, or "" if it is.
std::string NotASensorKind(const std::string& kind) {
  try {
    SensorsOfKind(kind);
    return "";
  } catch (const InvalidArgument& error) {
    return error.what();
  }
}

/// The keys of --set whose value differs from the default.
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
          "Ground by name, with optional parameters, such as stairs:rise_m=0.05,count=2, see 'gaitwright terrains'; or "
          "a file (YAML, CSV, PNG, OBJ, STL); default flat.");
  AddCommandTo(verb);
  verb.SetGroup("Planning");
  const Flag method = AddText(verb, "--com-method", "NAME", request.motion.centre_of_mass.method,
                              "Planner of the centre of mass: optimised, closed-form, preview or rigid-body; default "
                              "optimised, and rigid-body for gaits with flight.");
  keyed.push_back({method, "centre_of_mass.method"});
  const Flag whole =
      AddText(verb, "--method", "NAME", request.motion.trajectory.method,
              "whole-body: optimise the motion of the whole body and its contact forces together; "
              "default as-needed: for gaits with flight, and where the plan of the passes is not feasible.");
  keyed.push_back({whole, "trajectory.method"});
  verb.SetGroup("Options");
}

void WalkArguments::AddCommandTo(Verb verb) {
  verb.SetGroup("Speed (flags can be combined)");
  WalkCommand& c = request.command;
  const Flag gait =
      AddText(verb, "--gait", "NAME", request.gait,
              "Gait by name, see 'gaitwright gaits', or from a file: FILE.yaml for its first gait, FILE.yaml:NAME for "
              "another; 'walk' is the slow gait for the robot's number of legs; default: the robot's best.");
  const Flag forward =
      AddNumber(verb, "--speed", "m/s", c.speed_m_s,
                "Forward speed; negative is backward; default 0: if no other speed is given, the robot's "
                "default speed, see 'gaitwright robots show'.");
  const Flag lateral = AddNumber(verb, "--lateral-speed", "m/s", c.lateral_speed_m_s,
                                 "Lateral speed; positive is to the left; default 0.");
  const Flag turning = AddNumber(verb, "--yaw-rate", "rad/s", c.yaw_rate_rad_s,
                                 "Yaw rate; positive is to the left; default 0. Given alone, the robot turns on the "
                                 "spot; with --distance, it walks a curve at its default speed.");
  verb.SetGroup("Distance (one of --distance, --duration, --goal, --steps)");
  const Flag distance = AddNumber(verb, "--distance", "m", extent.distance_m,
                                  "Length of the path in the commanded direction, along the curve with --yaw-rate; "
                                  "more than 0; default 1, or a quarter turn if --yaw-rate is given alone.");
  const Flag duration =
      AddNumber(verb, "--duration", "s", extent.duration_s,
                "Time to walk at the commanded speeds, in whole gait cycles; more than 0; default: as --distance.");
  const Flag pose = AddText(verb, "--goal", "x,y,yaw", goal,
                            "Goal pose in m, m and rad from the start: x forward, y to the left, yaw between -pi and "
                            "pi. The robot walks backward to a goal behind it. Given speeds are upper limits.");
  const Flag count =
      AddWholeNumber(verb, "--steps", 1, extent.steps,
                     "Number of footfalls at the commanded speeds; the last ones bring the feet together; 1 or more.");
  const Flag length = AddNumber(verb, "--step-length", "m", extent.step_length_m,
                                "Forward advance in each footfall, with --steps and instead of --speed; 0 steps on the "
                                "spot, negative steps backward; default: speed times the time of a footfall.")
                          .Need(count)
                          .Exclude(forward);
  keyed = {{forward, "speed"}, {lateral, "lateral_speed"}, {turning, "yaw_rate"}, {length, "step_length"}};
  verb.SetGroup("Several gaits in sequence, instead of the flags above");
  const Flag parts = AddText(verb, "--sequence", "PARTS", request.sequence,
                             "Parts of one plan in sequence, such as 'trot: speed=0.5, distance=1; stand: duration=1; "
                             "walk', or a YAML file, see docs/gaits.md. Keys are speed, lateral-speed, yaw-rate; "
                             "distance, duration or steps; step-length; default: none.");
  for (const Flag& other : {gait, forward, lateral, turning, distance, duration, pose, count}) parts.Exclude(other);
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
  verb.SetGroup("Playback and disturbances");
  AddText(verb, "--controller", "NAME", request.controller,
          "stabilised (default), joint-pd, or recovering (for standing plans).");
  add("--engine", "play.engine");
  add("--state", "state");
  only_with_sensors =
      verb.AddReader(
              "--sensors", [this](const std::string& kind) { request.sensing.sensors = SensorsOfKind(kind); },
              "Sensor quality for --state measured and estimated: ideal, good or hobby, see docs/sensing.md; --set "
              "sensors.* changes single values; default ideal.")
          .SetType("KIND")
          .Check(NotASensorKind);
  add("--command-delay", "command_delay_s");
  AddText(verb, "--push", "fx,fy,fz", push,
          "Pushing force on the base in N, in world axes: x forward, y to the left, z up; default none.");
  only_with_push = {add("--push-at", "play.push_at_s"), add("--push-for", "play.push_for_s")};
  add("--ground-slope-deg", "play.ground_slope_deg");
  add("--ground-bumps", "play.ground_bumps_m");
  add("--friction", "play.friction");
  add("--mass-scale", "play.mass_scale");
  add("--log-rate-hz", "play.log_rate_hz");
  verb.SetGroup("Options");
}

OptionFields PlayArguments::Fields() { return request.Fields(); }

void PlayArguments::SetDefaults(const Common& common) {
  request.play.world.seed = request.sensing.sensors.seed = common.seed;
}

void PlayArguments::Finish(const std::vector<std::string>& varied) {
  const auto varies = [&](const char* begins) {
    return std::any_of(varied.begin(), varied.end(), [&](const std::string& key) { return key.starts_with(begins); });
  };
  if (only_with_sensors->given() && !varies("state") && request.sensing.state == StateSourceNames().front())
    throw InvalidArgument("--sensors is for --state measured or estimated; the true state uses no sensors");
  if (!push.empty()) {
    const std::vector<double> force = ParseNumbers("--push", push, 3);
    request.play.push_force_W = Vector3(force[0], force[1], force[2]);
  }
  const bool pushes = !request.play.push_force_W.isZero(0.0);
  for (const Flag& flag : only_with_push) {
    if (flag.given() && push.empty() && !pushes && !varies("play.push_force"))
      throw InvalidArgument(flag.name() + " is given without --push, which sets the force");
  }
  if (pushes && request.play.push_for_s == 0.0)
    throw InvalidArgument("a push of 0 s has no effect: --push-for must be above 0");
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
