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
  return Object({{"file", Text(), "As the URDF names it."},
                 {"vertices_m", PointsShape(1), "Of its convex hull, before the URDF's scale."}});
}

DataShape PlanarPoseShape() { return Object({{"x_m", Number()}, {"y_m", Number()}, {"yaw_rad", Number()}}); }

DataShape CommandShape() {
  return Object({{"extent", Text(PlanExtents()), "What says how far."},
                 {"speed_m_s", Number(0.0, kLargestNumber)},
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
                 {"outline_m", List(Numbers(2)), "In the pose's plane; empty: without end."},
                 {"friction", Number(0.0, kMostFriction)}});
}

DataShape PlanHeightFieldShape() {
  return Object({{"name", Text()},
                 {"origin_m", Numbers(2), "The first node."},
                 {"resolution_m", Positive(kLargestNumber)},
                 {"columns", Whole(2, kMostNodesAlong), "Along x."},
                 {"rows", Whole(2, kMostNodesAlong), "Along y."},
                 {"heights_m", Numbers(), "Of node (column, row) at number row * columns + column."},
                 {"friction", Number(0.0, kMostFriction)}});
}

DataShape PlanObstacleShape() {
  return Object({{"name", Text()},
                 {"type", Text(ObstacleTypeNames())},
                 {"pose", PoseShape()},
                 Optional("size_m", List(Positive(kLargestNumber), 2, 3), "Edges of a box; radius and length."),
                 Optional("vertices_m", PointsShape(4), "Of a mesh.")},
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
                 {"phase", List(Number(0.0, 1.0)), "By foot, less than 1."},
                 {"duty_factor", List(Number(0.0, 1.0)), "By foot."}});
}

DataShape PlanPartShape() {
  return Object({{"start_s", Number()},
                 {"end_s", Number()},
                 {"command", CommandShape(), "What was asked."},
                 {"goal", PlanarPoseShape(), "Where the base was to end."},
                 {"gait", PlanGaitShape()}});
}

DataShape PlanGateShape() {
  return Object({{"at_s", Number()},
                 {"phase", Text()},
                 {"joints_within", Number(0.0, kWidestGate), "Of every joint to its place [rad], [m]."},
                 {"contact", Whole(), "Bits of the feet that carry force."},
                 {"longest_s", Number(0.0, kLongestWait)}});
}

DataShape FootholdShape() {
  return Object({{"foot", FootIndexShape()},
                 {"pose", PoseShape(), "At touch-down."},
                 {"roll_m", Numbers(3), "How far a sphere rolls until lift-off."},
                 {"patch", Whole(), "Number of the surface: patches first, then height fields."},
                 {"touchdown_s", Number()},
                 {"liftoff_s", Number()}});
}

DataShape SwingShape() {
  return Object({{"foot", FootIndexShape()},
                 {"start_s", Number()},
                 {"end_s", Number()},
                 {"start_pose", PoseShape()},
                 {"end_pose", PoseShape()},
                 {"lift_m", Number(), "Over the straight line between the ends, at half time."},
                 {"clearance_m", OrNull(Number()), "Of the whole sole in mid swing; null: no ground under it."},
                 Optional("detour_m", List(Numbers(3)), "Control points in place of the bump."),
                 Optional("cruise", Number(0.0, 1.0), "Share of the time at constant speed.")});
}

DataShape AdjustmentsShape() {
  return List(Object({{"what", Text(), "The flag or option that sets it, without dashes."},
                      {"asked", Number()},
                      {"given", Number()},
                      {"unit", Text()},
                      {"why", Text(FailureCodeNames()), "Code for which the plan with the requested value is refused."},
                      {"part", Text(), "Of a sequence: its number and gait; else empty."}}));
}

DataShape ProvenanceShape() {
  return Object({{"program_version", Text()},
                 {"made_by", Text()},
                 {"seed", Whole()},
                 {"options", MapOf(Text()), "Every option that shapes the motion."}});
}

DataShape PlanShape() {
  return Object({{"format", Text({kPlanFormat})},
                 {"schema", Whole(MotionPlan::kSchema, MotionPlan::kSchema)},
                 {"robot", Text()},
                 {"robot_hash", Text()},
                 {"provenance", ProvenanceShape()},
                 {"parts", List(PlanPartShape(), 1), "One for each gait or stand, in order."},
                 {"goal", PlanarPoseShape(), "That of the last part."},
                 {"warnings", List(Text()), "Limits that the plan knowingly does not keep, and the like."},
                 {"terrain", PlanTerrainShape()},
                 {"schedule", List(List(Number(), 3, 3)), "[start_s, end_s, stance], bit i of stance being foot i."},
                 {"footholds", List(FootholdShape())},
                 {"swings", List(SwingShape())},
                 {"urdf", Text(), "The text that the robot was made from."},
                 {"robot_yaml", Text(), "The text of its robot.yaml, or empty."},
                 {"start_s", Number(-kLongestTime, kLongestTime)},
                 {"step_s", Positive(kLongestStep), "Of the grid of all rows."},
                 {"omega_rad_s", Number(), "The pendulum's frequency."},
                 {"centroidal", List(Numbers(11), 1), "Centre of mass, its velocity and acceleration, ZMP (2)."},
                 {"q", RowsShape(), "[p_WB, quaternion xyzw, joints]."},
                 {"v", RowsShape(), "[v_WB, w_WB, joint rates]."},
                 {"a", RowsShape(), "Their rates."},
                 {"tau_nm", RowsShape(), "Feed-forward torques by joint."},
                 {"contact_wrenches", RowsShape(), "Force and moment of each foot."},
                 Optional("adjustments", AdjustmentsShape(), "Where the plan differs from the request."),
                 Optional("meshes", List(MeshShape())),
                 Optional("gates", List(PlanGateShape()), "Where the motion waits for what is measured.")});
}

}  // namespace gaitwright
