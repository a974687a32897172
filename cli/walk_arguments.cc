// SPDX-License-Identifier: BSD-3-Clause
#include "cli/walk_arguments.h"

#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <sstream>

namespace gaitwright::cli {

std::vector<double> ParseNumbers(const std::string& flag, const std::string& text, std::size_t count) {
  std::vector<double> numbers;
  std::istringstream stream(text);
  for (std::string word; std::getline(stream, word, ',');) {
    std::size_t used = 0;
    double value = std::nan("");
    try {
      value = std::stod(word, &used);
    } catch (const std::exception&) {
      used = 0;
    }
    if (used != word.size() || !std::isfinite(value))
      throw InvalidArgument(fmt::format("{}: '{}' is not a finite number", flag, word));
    numbers.push_back(value);
  }
  if (numbers.size() != count)
    throw InvalidArgument(
        fmt::format("{}: {} numbers are needed, separated by commas; '{}' has {}", flag, count, text, numbers.size()));
  return numbers;
}

void ApplySets(const std::vector<std::string>& sets, OptionFields fields) {
  for (const std::string& set : sets) {
    const std::size_t equals = set.find('=');
    if (equals == std::string::npos) throw InvalidArgument(fmt::format("--set {}: key=value is needed", set));
    SetOption(fields, set.substr(0, equals), set.substr(equals + 1));
  }
}

void WalkArguments::AddTo(CLI::App& verb) {
  verb.add_option("--robot", robot, "Robot by name (see 'gaitwright robots')")->capture_default_str();
  verb.add_option("--urdf", urdf, "A URDF file of your own, instead of --robot");
  verb.add_option("--gait", request.gait, "Gait by name, or a .yaml file; default: the robot's best");
  verb.add_option("--terrain", request.terrain, "Ground")->capture_default_str();
  WalkCommand& c = request.command;
  verb.add_option("--speed", c.speed_m_s, "Speed ahead [m/s]; default: the robot's own");
  verb.add_option("--lateral-speed", c.lateral_speed_m_s, "Speed to the left [m/s]");
  verb.add_option("--yaw-rate", c.yaw_rate_rad_s, "Turning to the left [rad/s]");
  verb.add_option("--distance", distance_m, "How far, along the commanded direction [m]; default 1");
  verb.add_option("--goal", goal, "Where to: x,y,yaw in the start frame [m, m, rad]");
  verb.add_option("--steps", steps, "How many footfalls, the last one closing the feet");
  verb.add_option("--step-length", c.step_length_m, "Advance of a footfall [m], with --steps");
}

void WalkArguments::Finish(const RobotModel& model) {
  WalkCommand& c = request.command;
  if (static_cast<int>(distance_m.has_value()) + static_cast<int>(!goal.empty()) + static_cast<int>(steps != 0) > 1) {
    throw InvalidArgument("--distance, --goal and --steps each say how far: give one of them");
  }
  c.distance_m = distance_m.value_or(1.0);
  if (!goal.empty()) {
    const std::vector<double> pose = ParseNumbers("--goal", goal, 3);
    c.extent = WalkCommand::Extent::kGoal;
    c.goal_x_m = pose[0];
    c.goal_y_m = pose[1];
    c.goal_yaw_rad = pose[2];
  }
  if (steps != 0) {
    c.extent = WalkCommand::Extent::kSteps;
    c.steps = steps;
    if (c.step_length_m == 0.0) c.step_length_m = 0.16 * model.leg_length_m();
  }
}

void PlayArguments::AddTo(CLI::App& verb) {
  verb.add_option("--controller", request.controller, "stabilised or joint-pd")->capture_default_str();
  verb.add_option("--push", push, "Push on the base, in world axes: fx,fy,fz [N]");
  verb.add_option("--push-at", request.play.push_at_s, "When the push begins [s]");
  verb.add_option("--push-for", request.play.push_for_s, "How long it lasts [s]")->capture_default_str();
  verb.add_option("--ground-slope-deg", request.play.world.ground_slope_deg, "Unannounced slope [degrees]");
  verb.add_option("--ground-bumps", request.play.world.ground_bumps_m, "Unannounced bumps: amplitude [m]");
  verb.add_option("--friction", request.play.world.friction, "Friction of the ground; 0: the terrain's own");
  verb.add_option("--mass-scale", request.play.world.mass_scale, "Factor on all masses, unknown to the plan")
      ->capture_default_str();
}

void PlayArguments::Finish() {
  if (push.empty()) return;
  const std::vector<double> force = ParseNumbers("--push", push, 3);
  request.play.push_force_W = Vector3(force[0], force[1], force[2]);
}

}  // namespace gaitwright::cli
