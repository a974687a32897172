// SPDX-License-Identifier: BSD-3-Clause
#include "kinematics/model/describe.h"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

namespace gaitwright {
namespace {

using Json = nlohmann::ordered_json;

const std::string& FootTypeName(FootType type) { return FootTypeNames()[static_cast<std::size_t>(type)]; }

std::string FootText(const Foot& foot) {
  std::string text = fmt::format("{} '{}'", FootTypeName(foot.type), foot.link);
  if (foot.radius > 0.0) text += fmt::format(", radius {:.3f} m", foot.radius);
  if (!foot.sole_F.empty()) {
    Vector2 low = foot.sole_F[0], high = low;
    for (const Vector2& corner : foot.sole_F) {
      low = low.cwiseMin(corner);
      high = high.cwiseMax(corner);
    }
    text += fmt::format(", {} corners, {:.3f} m long, {:.3f} m wide", foot.sole_F.size(), high.x() - low.x(),
                        high.y() - low.y());
  }
  return text;
}

std::string JointNamesText(const RobotModel& model, const Leg& leg) {
  std::string names;
  for (const int joint : leg.joints) {
    const Joint& j = model.joints[static_cast<std::size_t>(joint)];
    names += (names.empty() ? "" : ", ") + j.name + (j.is_mimic ? " (mimic)" : "");
  }
  return names;
}

Json LegJson(const RobotModel& model, const Leg& leg) {
  const Foot& foot = model.feet[static_cast<std::size_t>(leg.foot)];
  Json joints = Json::array();
  for (const int joint : leg.joints) joints.push_back(model.joints[static_cast<std::size_t>(joint)].name);
  Json sole = Json::array();
  for (const Vector2& corner : foot.sole_F) sole.push_back({corner.x(), corner.y()});
  return {
      {"joints", joints},
      {"length_m", leg.length_m},
      {"mirror", leg.mirror < 0 ? Json(nullptr) : Json(model.legs[static_cast<std::size_t>(leg.mirror)].name)},
      {"knee", leg.knee_joint < 0 ? Json(nullptr) : Json(model.joints[static_cast<std::size_t>(leg.knee_joint)].name)},
      {"knee_side", leg.knee_joint < 0 ? Json(nullptr) : Json(leg.knee_sign > 0.0 ? "plus" : "minus")},
      {"foot",
       {{"link", foot.link},
        {"type", FootTypeName(foot.type)},
        {"radius_m", foot.radius},
        {"sole_m", sole},
        {"derived_from", foot.derived_from}}}};
}

/// A number, or null for a limit that does not exist.
Json Finite(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }

Json LimitsJson(const RobotModel& model, int dof) {
  const bool slides = model.LeaderOf(dof).is_prismatic();
  return {{slides ? "lower_m" : "lower_rad", Finite(model.dof_lower(dof))},
          {slides ? "upper_m" : "upper_rad", Finite(model.dof_upper(dof))},
          {slides ? "velocity_m_s" : "velocity_rad_s", Finite(model.dof_velocity_limit(dof))},
          {slides ? "effort_n" : "effort_nm", Finite(model.dof_effort_limit(dof))}};
}

Json GainsJson(const RobotModel& model, int dof) {
  const bool slides = model.LeaderOf(dof).is_prismatic();
  const auto given = [](double gain) { return gain > 0.0 ? Json(gain) : Json(nullptr); };
  return {{slides ? "stiffness_n_m" : "stiffness_nm_rad", given(model.stiffness[dof])},
          {slides ? "damping_n_s_m" : "damping_nm_s_rad", given(model.damping[dof])}};
}

Json MirrorsJson(const RobotModel& model) {
  Json pairs = Json::array();
  for (std::size_t i = 0; i < model.legs.size(); ++i) {
    const int mirror = model.legs[i].mirror;
    if (mirror > static_cast<int>(i)) {
      pairs.push_back({model.legs[i].name, model.legs[static_cast<std::size_t>(mirror)].name});
    }
  }
  return pairs;
}

/// Motor data; units are rad, rad/s, N m and kg m^2 for a revolute joint, and m, m/s, N and kg for a prismatic one.
Json MotorJson(const Motor& motor, const Joint& joint) {
  return {{"corner_speed", Finite(motor.corner_speed)},
          {"no_load_speed", Finite(motor.no_load_speed)},
          {"continuous_effort", Finite(motor.continuous_effort)},
          {"thermal_s", motor.thermal_s},
          {"rotor_inertia", motor.rotor_inertia},
          {"acceleration_limit", Finite(motor.acceleration_limit)},
          {"jerk_limit", Finite(motor.jerk_limit)},
          {"damping", joint.damping},
          {"friction", joint.friction}};
}

/// The known data of a motor as text; empty if no data are known.
std::string MotorText(const Motor& motor, const Joint& joint) {
  std::string text;
  const auto add = [&](bool known, const std::string& words) {
    if (known) text += (text.empty() ? "" : ", ") + words;
  };
  add(motor.has_curve(),
      fmt::format("full effort up to speed {:g}, none from {:g} on", motor.corner_speed, motor.no_load_speed));
  add(std::isfinite(motor.continuous_effort),
      fmt::format("continuous {:g} (root mean square over {:g} s)", motor.continuous_effort, motor.thermal_s));
  add(motor.rotor_inertia > 0.0, fmt::format("rotor inertia {:g}", motor.rotor_inertia));
  add(std::isfinite(motor.acceleration_limit), fmt::format("acceleration to {:g}", motor.acceleration_limit));
  add(std::isfinite(motor.jerk_limit), fmt::format("jerk to {:g}", motor.jerk_limit));
  add(joint.damping > 0.0, fmt::format("damping {:g}", joint.damping));
  add(joint.friction > 0.0, fmt::format("friction {:g}", joint.friction));
  return text;
}

std::string MotorTexts(const RobotModel& model) {
  std::string text;
  for (int d = 0; d < model.num_dofs(); ++d) {
    const std::string words = MotorText(model.MotorOf(d), model.LeaderOf(d));
    if (!words.empty()) text += fmt::format("  {:<20} {}\n", model.dof_names[static_cast<std::size_t>(d)], words);
  }
  return text.empty() ? text : "\nmotors and joints     (rad, rad/s, N m, kg m^2; prismatic: m, m/s, N, kg)\n" + text;
}

Json TransmissionJson(const RobotModel& model, const Transmission& transmission) {
  Json joints = Json::array(), motors = Json::array();
  for (const int dof : transmission.dofs) joints.push_back(model.dof_names[static_cast<std::size_t>(dof)]);
  for (std::size_t m = 0; m < transmission.motors.size(); ++m) {
    const TransmissionMotor& motor = transmission.motors[m];
    Json ratios = Json::array();
    for (const double ratio : transmission.ratios.row(static_cast<Eigen::Index>(m))) ratios.push_back(ratio);
    motors.push_back({{"name", motor.name},
                      {"ratios", ratios},
                      {"slides", motor.slides},
                      {"effort_limit", Finite(motor.effort_limit)},
                      {"velocity_limit", Finite(motor.velocity_limit)},
                      {"corner_speed", Finite(motor.motor.corner_speed)},
                      {"no_load_speed", Finite(motor.motor.no_load_speed)},
                      {"continuous_effort", Finite(motor.motor.continuous_effort)},
                      {"thermal_s", motor.motor.thermal_s},
                      {"rotor_inertia", motor.motor.rotor_inertia}});
  }
  return {{"name", transmission.name}, {"joints", joints}, {"motors", motors}};
}

std::string TransmissionTexts(const RobotModel& model) {
  std::string text;
  for (const Transmission& transmission : model.transmissions) {
    std::string joints;
    for (const int dof : transmission.dofs)
      joints += (joints.empty() ? "" : ", ") + model.dof_names[static_cast<std::size_t>(dof)];
    text += fmt::format("  {}: joints {}\n", transmission.name, joints);
    for (std::size_t m = 0; m < transmission.motors.size(); ++m) {
      const TransmissionMotor& motor = transmission.motors[m];
      std::string ratios;
      for (const double ratio : transmission.ratios.row(static_cast<Eigen::Index>(m)))
        ratios += fmt::format("{}{:g}", ratios.empty() ? "" : ", ", ratio);
      const std::string words = MotorText(motor.motor, {});
      text += fmt::format("    {:<18} ratios [{}], speed {:.2f}, effort {:.2f}{}{}\n", motor.name, ratios,
                          motor.velocity_limit, motor.effort_limit, words.empty() ? "" : ", ", words);
    }
  }
  return text.empty()
             ? text
             : "\ntransmissions         (joint limits above are the bounding box of the motors' limits)\n" + text;
}

}  // namespace

std::string DescribeRobot(const RobotModel& model) {
  std::string text = fmt::format("{}: {:.3f} kg, {} motors, {} legs of {:.3f} m, default speed {:.2f} m/s\n",
                                 model.name, model.total_mass_kg, model.num_dofs(), model.legs.size(),
                                 model.leg_length_m(), model.nominal_speed_m_s);
  if (!model.description.empty()) text += model.description + "\n";
  text += fmt::format("stands with its base '{}' {:.4f} m above the ground\n\nlegs\n", model.bodies[0].name,
                      model.standing_base_height_m);
  for (const Leg& leg : model.legs) {
    text += fmt::format("  {}: {}\n    joints {}\n", leg.name, FootText(model.feet[static_cast<std::size_t>(leg.foot)]),
                        JointNamesText(model, leg));
    if (leg.knee_joint >= 0) {
      text += fmt::format("    knee {} bends to {}\n", model.joints[static_cast<std::size_t>(leg.knee_joint)].name,
                          leg.knee_sign > 0.0 ? "plus" : "minus");
    }
  }
  text +=
      "\njoint                 standing    lower    upper    speed   effort  (rad, rad/s, N m; prismatic: m, m/s, N)\n";
  for (int d = 0; d < model.num_dofs(); ++d) {
    text += fmt::format("  {:<20} {:8.3f} {:8.3f} {:8.3f} {:8.2f} {:8.2f}\n",
                        model.dof_names[static_cast<std::size_t>(d)], model.standing_joints[d], model.dof_lower(d),
                        model.dof_upper(d), model.dof_velocity_limit(d), model.dof_effort_limit(d));
  }
  text += MotorTexts(model);
  text += TransmissionTexts(model);
  if (!model.notes.empty()) text += "\nnotes\n";
  for (const std::string& note : model.notes) text += "  " + note + "\n";
  return text;
}

std::string RobotJson(const RobotModel& model) {
  Json transmissions = Json::array();
  for (const Transmission& transmission : model.transmissions)
    transmissions.push_back(TransmissionJson(model, transmission));
  Json legs = Json::object(), standing = Json::object(), limits = Json::object(), gains = Json::object(),
       motors = Json::object();
  for (const Leg& leg : model.legs) legs[leg.name] = LegJson(model, leg);
  for (int d = 0; d < model.num_dofs(); ++d) {
    const std::string& joint = model.dof_names[static_cast<std::size_t>(d)];
    standing[joint] = model.standing_joints[d];
    limits[joint] = LimitsJson(model, d);
    gains[joint] = GainsJson(model, d);
    motors[joint] = MotorJson(model.MotorOf(d), model.LeaderOf(d));
  }
  const Json json = {{"name", model.name},
                     {"description", model.description},
                     {"mass_kg", model.total_mass_kg},
                     {"motors", model.num_dofs()},
                     {"leg_length_m", model.leg_length_m()},
                     {"nominal_speed_m_s", model.nominal_speed_m_s},
                     {"standing_base_height_m", model.standing_base_height_m},
                     {"legs", legs},
                     {"mirror_pairs", MirrorsJson(model)},
                     {"standing", standing},
                     {"limits", limits},
                     {"gains", gains},
                     {"motor_limits", motors},
                     {"transmissions", transmissions},
                     {"notes", model.notes},
                     {"hash", model.hash}};
  return json.dump(2);
}

}  // namespace gaitwright
