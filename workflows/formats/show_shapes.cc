// SPDX-License-Identifier: BSD-3-Clause
// Output of the verbs that show or list something.
#include "kinematics/model/robot_model.h"
#include "workflows/formats/result_shapes_internal.h"

namespace gaitwright {

using namespace shapes;

namespace {

DataShape LegShape() {
  const DataShape foot =
      Object({{"link", Text()},
              {"type", Text(FootTypeNames())},
              {"radius_m", Number(), "Radius of a spherical foot; 0 for other feet."},
              {"sole_m", List(Numbers(2)), "Corners of the sole in the foot's frame; empty for a point foot."},
              {"derived_from", Text()}});
  return Object({{"joints", List(Text()), "Joints from the base to the foot."},
                 {"length_m", Number()},
                 {"mirror", OrNull(Text()), "Mirrored leg on the other side."},
                 {"knee", OrNull(Text())},
                 {"knee_side", OrNull(Text({"plus", "minus"})), "Sign of the knee angle when it bends."},
                 {"foot", foot}});
}

/// An object for a revolute or a prismatic joint; null for values without a limit or not given.
DataShape PerJoint(const std::vector<std::string>& turns, const std::vector<std::string>& slides) {
  const auto keys = [](const std::vector<std::string>& names) {
    DataShape object = Object({});
    for (const std::string& name : names) object.members.push_back({name, NumberOrNull()});
    return object;
  };
  return MapOf(Either(keys(turns), keys(slides)));
}

DataShape MotorShape() {
  return Object({{"corner_speed", NumberOrNull(), "Speed up to which the motor has its full effort."},
                 {"no_load_speed", NumberOrNull()},
                 {"continuous_effort", NumberOrNull()},
                 {"thermal_s", Number()},
                 {"rotor_inertia", Number(), "Rotor inertia reflected to the joint."},
                 {"acceleration_limit", NumberOrNull()},
                 {"jerk_limit", NumberOrNull()},
                 {"damping", Number()},
                 {"friction", Number()}});
}

DataShape TransmissionShape() {
  const DataShape motor = Object({{"name", Text()},
                                  {"ratios", Numbers(), "Motor speed for unit speed of each joint."},
                                  {"slides", Truth(), "True if its units are m, s, N, kg."},
                                  {"effort_limit", NumberOrNull()},
                                  {"velocity_limit", NumberOrNull()},
                                  {"corner_speed", NumberOrNull()},
                                  {"no_load_speed", NumberOrNull()},
                                  {"continuous_effort", NumberOrNull()},
                                  {"thermal_s", Number()},
                                  {"rotor_inertia", Number(), "Rotor inertia at the motor's shaft."}});
  return Object({{"name", Text()}, {"joints", List(Text())}, {"motors", List(motor)}});
}

DataShape SelfCollisionShape() {
  const DataShape left_out = Object({{"links", List(Text(), 2, 2)}, {"reason", Text()}});
  return Object({{"pairs", Whole(), "Number of link pairs that are checked."}, {"left_out", List(left_out)}});
}

/// A finding of the linter of robot descriptions.
DataShape FindingShape() {
  return Object({{"level", Text(), "error, warning or info."},
                 {"code", Text(), "Kind of the finding."},
                 {"part", Text(), "Link, joint or robot of the finding."},
                 {"line", OrNull(Whole()), "Line of the file."},
                 {"message", Text()}});
}

DataShape RobotShape() {
  return Object({{"name", Text()},
                 {"description", Text()},
                 {"mass_kg", Number()},
                 {"motors", Whole()},
                 {"leg_length_m", Number()},
                 {"nominal_speed_m_s", Number()},
                 {"standing_base_height_m", Number()},
                 {"legs", MapOf(LegShape()), "Legs by name."},
                 {"mirror_pairs", List(List(Text(), 2, 2))},
                 {"standing", MapOf(Number()), "Standing posture by joint, rad or m."},
                 {"limits", PerJoint({"lower_rad", "upper_rad", "velocity_rad_s", "effort_nm"},
                                     {"lower_m", "upper_m", "velocity_m_s", "effort_n"})},
                 {"gains", PerJoint({"stiffness_nm_rad", "damping_nm_s_rad"}, {"stiffness_n_m", "damping_n_s_m"})},
                 {"motor_limits", MapOf(MotorShape()),
                  "Data by joint; in rad, s, N m, kg m^2, for prismatic joints in m, s, N, kg."},
                 {"transmissions", List(TransmissionShape()), "Motors that drive several joints together."},
                 {"notes", TextsShape(), "Notes on what was derived from the URDF, and how."},
                 {"hash", Text()},
                 {"verdict", Text(), "Whether it walks."},
                 {"findings", List(FindingShape())},
                 {"self_collision", SelfCollisionShape()},
                 {"files", FilesShape({"page", "png"})}});
}

DataShape RobotCheckShape() {
  return Object({{"robot", Text()},
                 {"verdict", Text(), "Whether it walks."},
                 {"errors", Whole()},
                 {"warnings", Whole()},
                 {"findings", List(FindingShape())},
                 {"files", FilesShape({"repaired"})}});
}

DataShape ParameterShape() {
  return Object({{"key", Text()},
                 {"value", Text(), "Value, written as for --set."},
                 {"unit", Text()},
                 {"lowest", Number()},
                 {"highest", Number()},
                 {"meaning", Text()}});
}

DataShape ObstacleShape() {
  return Object({{"name", Text()},
                 {"type", Text()},
                 {"position_m", Numbers(3)},
                 Optional("size_m", Numbers(), "Edge lengths of a box; radius and length of another shape."),
                 Optional("vertices", Whole(), "Number of points of a mesh.")});
}

DataShape TerrainShape() {
  const DataShape patch = Object({{"name", Text()},
                                  {"origin_m", Numbers(3)},
                                  {"normal", Numbers(3)},
                                  {"outline_m", List(Numbers(3)), "Corners; empty for an infinite plane."},
                                  {"friction", Number()}});
  const DataShape field = Object({{"name", Text()},
                                  {"origin_m", Numbers(2)},
                                  {"resolution_m", Number()},
                                  {"columns", Whole()},
                                  {"rows", Whole()},
                                  {"lowest_m", Number()},
                                  {"highest_m", Number()},
                                  {"friction", Number()}});
  return Object({{"name", Text()},
                 {"description", Text()},
                 {"robot", Text(), "Robot whose size set the dimensions."},
                 {"parameters", List(ParameterShape())},
                 {"patches", List(patch)},
                 {"height_fields", List(field)},
                 {"obstacles", List(ObstacleShape())},
                 {"markers", List(Object({{"name", Text()}, {"position_m", Numbers(2)}}))},
                 {"files", FilesShape({"picture", "ground"})},
                 Optional("terrain", Text(), "Text for --terrain that reads the file of --out; for .obj and .png."),
                 Optional("notes", List(Text()), "How the file of --out differs from the terrain.")});
}

}  // namespace

DataShape RobotsResultShape() {
  const DataShape entry = Object({{"name", Text()}, {"legs", Whole()}, {"motors", Whole()}, {"mass_kg", Number()}});
  return Either(Either(Object({{"robots", List(entry), "Robots, without `show` and `check`."}}), RobotShape()),
                RobotCheckShape());
}

DataShape GaitsResultShape() {
  const DataShape gait = Object(
      {{"name", Text()},
       {"feet", Whole()},
       {"description", Text()},
       {"cycle_s", OrNull(Number()), "Cycle time; null if derived from the robot."},
       {"cycle_per_leg_time", Number(), "Cycle time divided by sqrt(leg length / g); 0 if cycle_s is given."},
       {"stride_per_leg", OrNull(Number()), "Stride divided by the leg length."},
       {"pitch_turns", Number(), "Turns of the body about its y axis in each cycle."},
       {"roll_turns", Number(), "Turns of the body about its x axis in each cycle."},
       {"travel_per_leg", OrNull(Numbers(2)), "Forward and lateral travel in each cycle divided by the leg length."},
       {"phase", Numbers(), "Share of the cycle at which each foot touches down."},
       {"duty_factor", Numbers(), "Share of the cycle during which each foot is on the ground."},
       {"flight", Truth()}});
  return Object({{"gaits", List(gait)}});
}

DataShape TerrainsResultShape() {
  const DataShape entry = Object({{"name", Text()}, {"description", Text()}, {"parameters", List(Text())}});
  return Either(Object({{"terrains", List(entry), "Without `show`."}}), TerrainShape());
}

DataShape ViewResultShape() {
  return Object({{"shows", Text(), "The page's title."}, {"page_bytes", Whole()}, {"files", FilesShape({"page"})}});
}

DataShape RenderResultShape() {
  return Object({{"files", FilesShape({"png", "gif", "mp4", "figure"})},
                 Optional("cycles", Number(), "Number of gait cycles in the figure.")});
}

DataShape LiveResultShape() { return Object({{"url", Text(), "Address of the page, printed once it can be opened."}}); }

DataShape OptionListShape() {
  const DataShape option = Object({{"key", Text()},
                                   {"default", Text()},
                                   {"unit", Text()},
                                   {"accepted", Text(), "A range, or the accepted words."},
                                   {"advanced", Truth(), "Listed by --list-options=all only."},
                                   {"meaning", Text()}});
  return Object({{"options", List(option)}});
}

DataShape ReferenceResultShape() {
  const DataShape entry = Object({{"name", Text()}, {"title", Text()}});
  return Either(Object({{"schemas", List(entry)}}),
                Object({{"files", List(Text()), "Written files, with --out-dir."}}));
}

}  // namespace gaitwright
