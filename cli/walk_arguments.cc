// SPDX-License-Identifier: BSD-3-Clause
#include "cli/walk_arguments.h"

namespace gaitwright::cli {

void WalkArguments::AddTo(CLI::App& verb) {
  CLI::Option* named =
      AddText(verb, "--robot", "NAME", robot, "Robot by name (see 'gaitwright robots')")->capture_default_str();
  AddText(verb, "--urdf", "FILE", urdf, "A URDF file of your own, instead of --robot")->excludes(named);
  AddText(verb, "--gait", "NAME", request.gait, "Gait by name, or a .yaml file; default: the robot's best");
  AddText(verb, "--terrain", "NAME", request.terrain, "Ground")->capture_default_str();
  WalkCommand& c = request.command;
  AddNumber(verb, "--speed", "m/s", c.speed_m_s, "Speed ahead; default: the robot's own");
  AddNumber(verb, "--lateral-speed", "m/s", c.lateral_speed_m_s, "Speed to the left");
  AddNumber(verb, "--yaw-rate", "rad/s", c.yaw_rate_rad_s, "Turning to the left");
  AddNumber(verb, "--distance", "m", distance_m, "How far, along the commanded direction; default 1");
  AddText(verb, "--goal", "x,y,yaw", goal, "Where to: x,y,yaw in the start frame [m, m, rad]");
  CLI::Option* count = AddWholeNumber(verb, "--steps", 1, steps, "How many footfalls, the last one closing the feet");
  AddNumber(verb, "--step-length", "m", step_length_m, "Advance of a footfall, with --steps")->needs(count);
}

void WalkArguments::Finish(const RobotModel& model) {
  WalkCommand& c = request.command;
  if (static_cast<int>(distance_m.has_value()) + static_cast<int>(!goal.empty()) + static_cast<int>(steps.has_value()) >
      1) {
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
  if (steps) {
    c.extent = WalkCommand::Extent::kSteps;
    c.steps = *steps;
    c.step_length_m = step_length_m.value_or(0.16 * model.leg_length_m());
  }
}

void PlayArguments::AddTo(CLI::App& verb) {
  const OptionFields fields = request.Fields();
  AddText(verb, "--controller", "NAME", request.controller, "stabilised or joint-pd")->capture_default_str();
  AddText(verb, "--push", "fx,fy,fz", push, "Push on the base, in world axes: fx,fy,fz [N]");
  only_with_push = {AddField(verb, "--push-at", fields, "play.push_at_s"),
                    AddField(verb, "--push-for", fields, "play.push_for_s")};
  AddField(verb, "--ground-slope-deg", fields, "play.ground_slope_deg");
  AddField(verb, "--ground-bumps", fields, "play.ground_bumps_m");
  AddField(verb, "--friction", fields, "play.friction");
  AddField(verb, "--mass-scale", fields, "play.mass_scale");
  AddField(verb, "--log-rate-hz", fields, "play.log_rate_hz");
}

void PlayArguments::Finish() {
  if (!push.empty()) {
    const std::vector<double> force = ParseNumbers("--push", push, 3);
    request.play.push_force_W = Vector3(force[0], force[1], force[2]);
  }
  for (const CLI::Option* flag : only_with_push) {
    if (flag->count() > 0 && push.empty() && request.play.push_force_W.isZero(0.0))
      throw InvalidArgument(flag->get_name() + " is given without --push: how hard is missing");
  }
}

}  // namespace gaitwright::cli
