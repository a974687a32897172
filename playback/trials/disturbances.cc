// SPDX-License-Identifier: BSD-3-Clause
#include "playback/trials/disturbances.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "kinematics/base/nearest_name.h"
#include "planning/plan/sample_plan.h"
#include "playback/sensing/sensor_options.h"

namespace gaitwright {
namespace {

constexpr double kRadian = std::numbers::pi / 180.0;

std::vector<DisturbanceRule> BodyAndGround() {
  return {
      {"mass_scale", "play.mass_scale", "1", 0.1, 10.0, "factor on all masses and inertias",
       DisturbanceEffect::kFactor},
      {"inertia_scale", "play.inertia_scale", "1", 0.1, 10.0, "additional factor on all moments of inertia",
       DisturbanceEffect::kFactor},
      {"com_shift_m", "", "m", 0.0, 1.0, "shift of the base link's centre of mass, in a random direction"},
      {"com_shift_x_m", "play.com_shift_x_m", "m", -1.0, 1.0, "forward shift of the base link's centre of mass",
       DisturbanceEffect::kOffset},
      {"com_shift_y_m", "play.com_shift_y_m", "m", -1.0, 1.0, "shift of the base link's centre of mass to the left",
       DisturbanceEffect::kOffset},
      {"com_shift_z_m", "play.com_shift_z_m", "m", -1.0, 1.0, "upward shift of the base link's centre of mass",
       DisturbanceEffect::kOffset},
      {"friction", "play.friction", "1", 0.01, 10.0, "friction coefficient of all ground"},
      {"contact_softness", "play.contact_softness", "1", 0.01, 1000.0, "factor on the compliance of all contacts",
       DisturbanceEffect::kFactor},
      {"ground_slope_deg", "play.ground_slope_deg", "deg", -45.0, 45.0, "slope of the ground"},
      {"ground_slope_direction_deg", "play.ground_slope_direction_deg", "deg", -360.0, 360.0,
       "uphill direction of the slope: 0 is x of the world frame, 90 is y"},
      {"ground_bumps_m", "play.ground_bumps_m", "m", 0.0, 0.5, "amplitude of ground bumps"},
      {"bump_wavelength_m", "play.bump_wavelength_m", "m", 0.02, 10.0,
       "wavelength of ground bumps: twice the distance between neighbours"},
      {"bump_seed", "play.seed", "1", 0.0, 2147483647.0,
       "random seed of the ground bumps; default: a different one for each trial", DisturbanceEffect::kValue, true},
  };
}

std::vector<DisturbanceRule> MotorsAndStart() {
  return {
      {"latency_s", "command_delay_s", "s", 0.0, 0.1, "delay of commands, rounded to whole time steps",
       DisturbanceEffect::kOffset},
      {"sensor_noise_scale", "", "1", 0.0, 100.0, "factor on noise, biases and bias random walk of all sensors"},
      {"motor_strength", "play.motor_strength", "1", 0.01, 10.0, "factor on the effort limits of all joints",
       DisturbanceEffect::kFactor},
      {"torque_scale", "play.torque_scale", "1", 0.01, 2.0, "share of each motor's torque that reaches its joint",
       DisturbanceEffect::kFactor},
      {"joint_friction_nm", "play.joint_friction_nm", "N m", 0.0, 1000.0, "dry friction added to every joint",
       DisturbanceEffect::kOffset},
      {"rotor_inertia_kg_m2", "play.rotor_inertia_kg_m2", "kg m^2", 0.0, 100.0,
       "reflected rotor inertia added to every joint with a motor", DisturbanceEffect::kOffset},
      {"stiffness_scale", "gains.stiffness_scale", "1", 0.0, 100.0, "factor on the stiffness of all joints",
       DisturbanceEffect::kFactor},
      {"damping_scale", "gains.damping_scale", "1", 0.0, 100.0, "factor on the damping of all joints",
       DisturbanceEffect::kFactor},
      {"start.x_m", "play.start_x_m", "m", -10.0, 10.0,
       "offset of the base's start from the plan, along x of the world frame", DisturbanceEffect::kOffset},
      {"start.y_m", "play.start_y_m", "m", -10.0, 10.0,
       "offset of the base's start from the plan, along y of the world frame", DisturbanceEffect::kOffset},
      {"start.z_m", "play.start_z_m", "m", -10.0, 10.0, "upward offset of the base's start from the plan",
       DisturbanceEffect::kOffset},
      {"start.roll_rad", "play.start_roll_rad", "rad", -3.2, 3.2,
       "rotation of the base's start from the plan, about x of the base", DisturbanceEffect::kOffset},
      {"start.pitch_rad", "play.start_pitch_rad", "rad", -3.2, 3.2,
       "rotation of the base's start from the plan, about y of the base", DisturbanceEffect::kOffset},
      {"start.yaw_rad", "play.start_yaw_rad", "rad", -3.2, 3.2,
       "rotation of the base's start from the plan, about z of the world frame", DisturbanceEffect::kOffset},
      {"start.joints_rad", "", "rad", -3.2, 3.2,
       "offset of each joint's start, drawn for each joint (in metres for prismatic joints)"},
  };
}

/// Distribution of a push's key, or `usual` if the push does not have the key.
Distribution OfPush(const DisturbedPush& push, const std::string& key, const Distribution& usual) {
  const auto at = std::find_if(push.begin(), push.end(), [&](const Disturbance& d) { return d.key == key; });
  return at == push.end() ? usual : at->distribution;
}

std::string UnitOfSensor(const std::string& key) {
  SensorOptions sensors;
  for (const OptionField& field : Prefixed("sensors", sensors.Fields())) {
    if (field.key == key) return field.unit;
  }
  return "";
}

/// Draws one trial, or sets all values to one end of their ranges.
class Sampler {
 public:
  Sampler(const RobotModel& model, const MotionPlan& plan, std::uint64_t seed, std::optional<RangeEnd> end)
      : model_(model), plan_(plan), end_(end) {
    trial_.seed = seed;
    trial_.noise_seed = NamedRandom(seed, "noise").Whole();
  }

  void Figure(const Disturbance& figure) {
    if (figure.key == "com_shift_m") return ShiftInAnyDirection(figure);
    if (figure.key == "start.joints_rad") return Joints(figure);
    double value = Drawn(figure.key, figure.distribution);
    const auto rule = std::find_if(DisturbanceRules().begin(), DisturbanceRules().end(),
                                   [&](const DisturbanceRule& r) { return r.key == figure.key; });
    const bool of_sensor = rule == DisturbanceRules().end();
    if (!of_sensor && rule->whole) value = std::round(value);
    Record(figure.key, of_sensor ? UnitOfSensor(figure.key) : rule->unit, value);
    if (figure.key == "sensor_noise_scale") {
      trial_.sensor_noise_scale = value;
    } else if (of_sensor) {
      trial_.options.push_back({figure.key, value});
    } else {
      trial_.options.push_back({rule->option, value, rule->effect});
    }
  }

  void Push(const DisturbedPush& push, const std::string& name) {
    const auto drawn = [&](const char* key, const Distribution& usual) {
      return Drawn(name + "." + key, OfPush(push, key, usual));
    };
    double size = 0.0;
    if (HasFigure(push, "size_n")) size = drawn("size_n", {});
    if (HasFigure(push, "size_of_weight")) size = model_.weight_n() * drawn("size_of_weight", {});
    const double direction = drawn("direction_deg", Distribution::Uniform(0.0, 360.0));
    const double elevation = drawn("elevation_deg", Distribution::Fixed(0.0));
    const double start_s = plan_.whole_body.start_s;
    const double at_s = HasFigure(push, "at_s")
                            ? drawn("at_s", {})
                            : start_s + drawn("at_share", Distribution::Uniform(0.1, 0.9)) * plan_.duration_s();
    const double for_s = drawn("duration_s", Distribution::Fixed(0.1));
    NamedRandom random(trial_.seed, name + ".place");
    const std::string place = DrawWord(OfPush(push, "place", Distribution::OneOf({std::string("base")})), random);
    const double level = size * std::cos(elevation * kRadian);
    const Vector3 force(level * std::cos(direction * kRadian), level * std::sin(direction * kRadian),
                        size * std::sin(elevation * kRadian));
    Record(name + ".size_n", "N", size);
    Record(name + ".direction_deg", "deg", direction);
    Record(name + ".ahead_n", "N", Part(force.x(), size));
    Record(name + ".left_n", "N", Part(force.y(), size));
    if (HasFigure(push, "elevation_deg")) Record(name + ".up_n", "N", Part(force.z(), size));
    Record(name + ".at_s", "s", at_s);
    Record(name + ".duration_s", "s", for_s);
    trial_.values.push_back({name + ".place", "", 0.0, place});
    trial_.pushes.push_back({Eigen::AngleAxisd(HeadingAt(at_s), Vector3::UnitZ()) * force, at_s, for_s, place});
  }

  /// Components of a slope's direction; call after all quantities are drawn.
  void SlopeParts() {
    const std::optional<double> direction = Value("ground_slope_direction_deg"), slope = Value("ground_slope_deg");
    if (!direction) return;
    const std::string name = slope ? "ground_slope_" : "ground_slope_direction_", ending = slope ? "_deg" : "";
    const std::string unit = slope ? "deg" : "1";
    const double whole = slope.value_or(1.0);
    Record(name + "x" + ending, unit, Part(whole * std::cos(*direction * kRadian), whole));
    Record(name + "y" + ending, unit, Part(whole * std::sin(*direction * kRadian), whole));
  }

  SampledTrial Take() { return std::move(trial_); }

 private:
  /// A component of a vector; zero if it is only the rounding error of a right angle, which would be ranked as a cause.
  static double Part(double part, double whole) { return std::abs(part) > 1e-9 * std::abs(whole) ? part : 0.0; }

  double Drawn(const std::string& name, const Distribution& distribution) const {
    if (end_) return *end_ == RangeEnd::kHighest ? distribution.highest : distribution.lowest;
    NamedRandom random(trial_.seed, name);
    return Draw(distribution, random);
  }

  std::optional<double> Value(const std::string& name) const {
    for (const SampledValue& one : trial_.values) {
      if (one.name == name) return one.value;
    }
    return std::nullopt;
  }

  void Record(const std::string& name, const std::string& unit, double value) {
    trial_.values.push_back({name, unit, value, ""});
  }

  /// A uniformly distributed direction on the sphere.
  void ShiftInAnyDirection(const Disturbance& figure) {
    const double radius = Drawn(figure.key, figure.distribution);
    NamedRandom random(trial_.seed, "com_shift_direction");
    const double z = 2.0 * random.Uniform() - 1.0, angle = 2.0 * std::numbers::pi * random.Uniform();
    const double level = std::sqrt(std::max(0.0, 1.0 - z * z));
    Vector3 shift = radius * Vector3(level * std::cos(angle), level * std::sin(angle), z);
    if (end_) shift.setConstant((*end_ == RangeEnd::kHighest ? 1.0 : -1.0) * figure.distribution.highest);
    Record(figure.key, "m", radius);
    const char* names[] = {"com_shift_x_m", "com_shift_y_m", "com_shift_z_m"};
    for (int axis = 0; axis < 3; ++axis) {
      Record(names[axis], "m", shift[axis]);
      trial_.options.push_back({std::string("play.") + names[axis], shift[axis], DisturbanceEffect::kOffset});
    }
  }

  void Joints(const Disturbance& figure) {
    trial_.start_joints = VectorX::Zero(model_.num_dofs());
    for (int dof = 0; dof < model_.num_dofs(); ++dof) {
      const bool slides = model_.LeaderOf(dof).is_prismatic();
      const std::string name =
          fmt::format("start.joint.{}_{}", model_.dof_names[static_cast<std::size_t>(dof)], slides ? "m" : "rad");
      trial_.start_joints[dof] = Drawn(name, figure.distribution);
      Record(name, slides ? "m" : "rad", trial_.start_joints[dof]);
    }
  }

  /// Yaw of the planned base [rad].
  double HeadingAt(double time_s) const {
    const WholeBodyTrajectory& w = plan_.whole_body;
    if (w.q.empty() || w.step_s <= 0.0) return 0.0;
    const double row = std::clamp((time_s - w.start_s) / w.step_s, 0.0, static_cast<double>(w.q.size() - 1));
    const Matrix3 R_WB = BaseRotation(w.q[static_cast<std::size_t>(row)]);
    return std::atan2(R_WB(1, 0), R_WB(0, 0));
  }

  const RobotModel& model_;
  const MotionPlan& plan_;
  const std::optional<RangeEnd> end_;
  SampledTrial trial_;
};

constexpr double kHardestPush = 1e5;    // [N]
constexpr double kShortestPush = 1e-4;  // [s]; a push without duration has no impulse, and every robot would survive it

/// @throws InvalidArgument for a push on an unknown link, or a push that is too strong.
void CheckPushes(const Disturbances& disturbances, const RobotModel& model) {
  std::vector<std::string> places = {"base", "robot"};
  for (const Frame& frame : model.frames) places.push_back(frame.name);
  for (std::size_t i = 0; i < disturbances.pushes.size(); ++i) {
    const DisturbedPush& push = disturbances.pushes[i];
    const double hardest =
        std::max(OfPush(push, "size_n", {}).highest, model.weight_n() * OfPush(push, "size_of_weight", {}).highest);
    if (hardest > kHardestPush) {
      throw InvalidArgument(
          fmt::format("push {} may reach {:.6g} N; at most {} N are accepted", i + 1, hardest, kHardestPush));
    }
    for (const std::string& word : OfPush(push, "place", {}).words) {
      if (std::find(places.begin(), places.end(), word) != places.end()) continue;
      throw InvalidArgument(fmt::format("push {} has the place '{}'; accepted: 'base', 'robot' or a link of '{}'{}",
                                        i + 1, word, model.name, NearestHint(word, places)));
    }
  }
}

SampledTrial Sampled(const Disturbances& disturbances, const RobotModel& model, Sampler sampler) {
  CheckPushes(disturbances, model);
  for (const Disturbance& figure : disturbances.figures) sampler.Figure(figure);
  sampler.SlopeParts();
  for (std::size_t i = 0; i < disturbances.pushes.size(); ++i)
    sampler.Push(disturbances.pushes[i], fmt::format("push{}", i + 1));
  return sampler.Take();
}

}  // namespace

bool HasFigure(const DisturbedPush& push, const std::string& key) {
  return std::any_of(push.begin(), push.end(), [&](const Disturbance& d) { return d.key == key; });
}

const std::vector<DisturbanceRule>& DisturbanceRules() {
  static const std::vector<DisturbanceRule> rules = [] {
    std::vector<DisturbanceRule> all = BodyAndGround();
    for (const DisturbanceRule& rule : MotorsAndStart()) all.push_back(rule);
    return all;
  }();
  return rules;
}

const std::vector<DisturbanceRule>& PushRules() {
  static const std::vector<DisturbanceRule> rules = {
      {"size_n", "", "N", 0.0, kHardestPush, "size of the push"},
      {"size_of_weight", "", "1", 0.0, 100.0, "size of the push, as a share of the robot's weight"},
      {"direction_deg", "", "deg", -360.0, 360.0,
       "direction of the push relative to the planned heading: 0 is forward, 90 to the left; default: any direction"},
      {"elevation_deg", "", "deg", -90.0, 90.0, "elevation of the push above horizontal; default 0"},
      {"place", "", "", 0.0, 0.0,
       "point of the push: base, robot (the whole robot's centre of mass) or the name of a link; default base"},
      {"at_s", "", "s", 0.0, 1e5, "start time of the push, on the plan's clock"},
      {"at_share", "", "1", 0.0, 1.0,
       "start time of the push, as a share of the plan's duration; default: uniform from 0.1 to 0.9"},
      {"duration_s", "", "s", kShortestPush, 100.0, "duration of the push; default 0.1 s"},
  };
  return rules;
}

namespace {

/// Null for a sensor option, whose key is that of the option.
const DisturbanceRule* RuleOfFigure(const Disturbance& figure) {
  const auto rule = std::find_if(DisturbanceRules().begin(), DisturbanceRules().end(),
                                 [&](const DisturbanceRule& r) { return r.key == figure.key; });
  return rule == DisturbanceRules().end() ? nullptr : &*rule;
}

}  // namespace

std::vector<std::string> DrawnOptions(const Disturbances& disturbances) {
  std::vector<std::string> options;
  for (const Disturbance& figure : disturbances.figures) {
    if (figure.distribution.lowest == 0.0 && figure.distribution.highest == 0.0) continue;
    const DisturbanceRule* rule = RuleOfFigure(figure);
    options.push_back(rule == nullptr ? figure.key : rule->option);
  }
  return options;
}

std::vector<std::string> DrawnInPlaceOf(const Disturbances& disturbances, const std::vector<std::string>& options) {
  std::vector<std::string> keys;
  for (const Disturbance& figure : disturbances.figures) {
    const DisturbanceRule* rule = RuleOfFigure(figure);
    if (rule != nullptr && rule->effect != DisturbanceEffect::kValue) continue;
    const std::string& option = rule == nullptr ? figure.key : rule->option;
    if (std::find(options.begin(), options.end(), option) != options.end()) keys.push_back(figure.key);
  }
  return keys;
}

SampledTrial SampleTrial(const Disturbances& disturbances, const RobotModel& model, const MotionPlan& plan,
                         std::uint64_t seed) {
  return Sampled(disturbances, model, Sampler(model, plan, seed, std::nullopt));
}

SampledTrial ExtremeTrial(const Disturbances& disturbances, const RobotModel& model, const MotionPlan& plan,
                          RangeEnd end) {
  return Sampled(disturbances, model, Sampler(model, plan, 0, end));
}

}  // namespace gaitwright
