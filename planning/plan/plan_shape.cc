// SPDX-License-Identifier: BSD-3-Clause
#include "planning/plan/plan_shape.h"

#include "planning/plan/plan_reading_internal.h"
#include "planning/plan/plan_shape_internal.h"

namespace gaitwright {

using namespace shapes;

namespace {

DataShape PoseShape() { return Numbers(7); }  // x, y, z, qx, qy, qz, qw

DataShape PointsShape(std::size_t least) { return List(Numbers(3), least, kMostHullPoints); }

DataShape FootIndexShape() { return Whole(0, kMostFeet - 1); }

DataShape RowsShape() { return List(Numbers(), 1); }

}  // namespace

DataShape MeshShape() {
  return Object({{"file", Text(), "Name in the URDF."},
                 {"vertices_m", PointsShape(1), "Points of its convex hull, before the URDF's scale is applied."}});
}

DataShape PlanarPoseShape() { return Object({{"x_m", Number()}, {"y_m", Number()}, {"yaw_rad", Number()}}); }

DataShape CommandShape() {
  return Object({{"extent", Text(PlanExtents()), "Name of the value that sets the distance."},
                 {"speed_m_s", Number(), "Negative: backward."},
                 {"lateral_speed_m_s", Number()},
                 {"yaw_rate_rad_s", Number()},
                 {"distance_m", Number(0.0, kLargestNumber)},
                 {"goal_x_m", Number()},
                 {"goal_y_m", Number()},
                 {"goal_yaw_rad", Number()},
                 {"steps", Whole(0, kMostSteps)},
                 {"step_length_m", Number()},
                 Optional("duration_s", Number(0.0, kLargestNumber))});
}

DataShape PlanPatchShape() {
  return Object({{"name", Text()},
                 {"pose", PoseShape()},
                 {"outline_m", List(Numbers(2)), "Corners in the pose's plane; empty for an infinite plane."},
                 {"friction", Number(0.0, kMostFriction)}});
}

DataShape PlanHeightFieldShape() {
  return Object({{"name", Text()},
                 {"origin_m", Numbers(2), "Position of the first node."},
                 {"resolution_m", Positive(kLargestNumber)},
                 {"columns", Whole(2, kMostNodesAlong), "Number of points along x."},
                 {"rows", Whole(2, kMostNodesAlong), "Number of points along y."},
                 {"heights_m", Numbers(), "Height of node (column, row) at index row * columns + column."},
                 {"friction", Number(0.0, kMostFriction)}});
}

DataShape PlanObstacleShape() {
  return Object({{"name", Text()},
                 {"type", Text(ObstacleTypeNames())},
                 {"pose", PoseShape()},
                 Optional("size_m", List(Positive(kLargestNumber), 2, 3),
                          "Edge lengths of a box; radius and length of other shapes."),
                 Optional("vertices_m", PointsShape(4), "Vertices of a mesh.")},
                {{"size_m", "vertices_m"}});
}

DataShape PlanMarkerShape() { return Object({{"name", Text()}, {"place_m", Numbers(2)}}); }

DataShape PlanTerrainShape() {
  return Object({{"name", Text()},
                 {"patches", List(PlanPatchShape())},
                 {"height_fields", List(PlanHeightFieldShape())},
                 {"obstacles", List(PlanObstacleShape())},
                 Optional("markers", List(PlanMarkerShape()))});
}

DataShape PlanGaitShape() {
  return Object({{"name", Text()},
                 {"description", Text()},
                 {"cycle_s", Positive(kLargestNumber)},
                 {"phase", List(Number(0.0, 1.0)), "One value for each foot, less than 1."},
                 {"duty_factor", List(Number(0.0, 1.0)), "One value for each foot."},
                 Optional("roll_turns", Number(-2.0, 2.0), "Turns of the body about its x axis in each cycle."),
                 Optional("pitch_turns", Number(-2.0, 2.0), "Turns of the body about its y axis in each cycle.")});
}

DataShape PlanPartShape() {
  return Object({{"start_s", Number()},
                 {"end_s", Number()},
                 {"command", CommandShape(), "Command of the part."},
                 {"goal", PlanarPoseShape(), "Commanded end pose of the base."},
                 {"gait", PlanGaitShape()}});
}

DataShape PlanGateShape() {
  return Object({{"at_s", Number()},
                 {"phase", Text()},
                 {"joints_within", Number(0.0, kWidestGate), "Tolerance of the position of every joint [rad], [m]."},
                 {"contact", Whole(), "Bit mask of the feet that carry force."},
                 {"longest_s", Number(0.0, kLongestWait)}});
}

DataShape FootholdShape() {
  return Object({{"foot", FootIndexShape()},
                 {"pose", PoseShape(), "Pose of the foot at touch-down."},
                 {"roll_m", Numbers(3), "Distance that a spherical foot rolls until lift-off."},
                 {"patch", Whole(), "Index of the surface: patches first, then height fields."},
                 {"touchdown_s", Number()},
                 {"liftoff_s", Number()},
                 Optional("heel_off_s", Number(), "Time from which the sole stands on its front edge only.")});
}

DataShape SwingShape() {
  return Object({{"foot", FootIndexShape()},
                 {"start_s", Number()},
                 {"end_s", Number()},
                 {"start_pose", PoseShape()},
                 {"end_pose", PoseShape()},
                 {"lift_m", Number(), "Height above the straight line between the ends, at half time."},
                 {"clearance_m", OrNull(Number()),
                  "Smallest height of the whole sole in mid swing; null without ground under it."},
                 Optional("detour_m", List(Numbers(3)), "Control points that replace the default curve."),
                 Optional("cruise", Number(0.0, 1.0), "Share of the swing's time at constant speed; below 1.")});
}

DataShape AdjustmentsShape() {
  return List(Object({{"what", Text(), "Flag or option that sets the value, without dashes."},
                      {"asked", Number()},
                      {"given", Number()},
                      {"unit", Text()},
                      {"why", Text(FailureCodeNames()), "Failure code of the plan with the requested value."},
                      {"part", Text(), "Number and gait of the part of a sequence; empty for a single part."}}));
}

DataShape ProvenanceShape() {
  return Object({{"program_version", Text()},
                 {"made_by", Text()},
                 {"seed", Whole()},
                 {"options", MapOf(Text()), "Every option that shapes the motion."}});
}

DataShape PlanShape() {
  return Object(
      {{"format", Text({kPlanFormat})},
       {"schema", Whole(MotionPlan::kSchema, MotionPlan::kSchema)},
       {"robot", Text()},
       {"robot_hash", Text()},
       {"provenance", ProvenanceShape()},
       {"parts", List(PlanPartShape(), 1), "Parts in order, one for each gait or stand."},
       {"goal", PlanarPoseShape(), "Goal of the last part."},
       {"warnings", List(Text()), "Warnings, such as limits that the plan knowingly exceeds."},
       {"terrain", PlanTerrainShape()},
       {"schedule", List(List(Number(), 3, 3)), "Phases as [start_s, end_s, stance]; bit i of stance is foot i."},
       {"footholds", List(FootholdShape())},
       {"swings", List(SwingShape())},
       {"urdf", Text(), "Text of the robot description."},
       {"robot_yaml", Text(), "Text of the robot's robot.yaml, or empty."},
       {"start_s", Number(-kLongestTime, kLongestTime)},
       {"step_s", Positive(kLongestStep), "Time step of all rows."},
       {"omega_rad_s", Number(), "Frequency of the pendulum model."},
       {"centroidal", List(Numbers(11), 1), "Centre of mass, its velocity and acceleration, ZMP (2)."},
       {"q", RowsShape(), "[p_WB, quaternion xyzw, joints]."},
       {"v", RowsShape(), "[v_WB, w_WB, joint rates]."},
       {"a", RowsShape(), "Time derivatives of v."},
       {"tau_nm", RowsShape(), "Feed-forward torques by joint."},
       {"contact_wrenches", RowsShape(), "Force and moment of each foot."},
       Optional("adjustments", AdjustmentsShape(), "Differences between the plan and the request."),
       Optional("meshes", List(MeshShape())),
       Optional("gates", List(PlanGateShape()), "Times at which the motion waits for a measured condition.")});
}

}  // namespace gaitwright
