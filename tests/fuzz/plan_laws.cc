// SPDX-License-Identifier: BSD-3-Clause
#include "tests/fuzz/plan_laws.h"

#include <cmath>

#include "kinematics/spatial/convex_hull.h"
#include "planning/plan/plan_json.h"
#include "tests/fuzz/inputs.h"
#include "tests/fuzz/reader.h"

namespace gaitwright::fuzz {
namespace {

constexpr double kMost = 1e12;
constexpr std::size_t kMostNodes = 4000000;

bool IsSensible(double value) { return std::abs(value) <= kMost; }

template <class Vector>
bool AreSensible(const Vector& values) {
  return values.size() == 0 || (values.allFinite() && values.cwiseAbs().maxCoeff() <= kMost);
}

bool IsPose(const Pose& X) {
  return X.matrix().allFinite() && IsSensible(X.translation().norm()) &&
         (X.linear() * X.linear().transpose() - Matrix3::Identity()).norm() < 1e-6;
}

bool IsFriction(double friction) { return friction >= 0.0 && friction <= 100.0; }

void CheckField(const HeightField& field) {
  Require(field.columns >= 2 && field.rows >= 2, "a height field has two columns and rows");
  const std::size_t nodes = static_cast<std::size_t>(field.columns) * static_cast<std::size_t>(field.rows);
  Require(nodes <= kMostNodes && field.height_m.size() == nodes, "a height field is complete, and not too large");
  Require(field.resolution_m > 0.0 && IsSensible(field.resolution_m) && AreSensible(field.origin_W),
          "it has a finite origin and resolution");
  for (const double height : field.height_m) Require(IsSensible(height), "heights are finite");
}

void CheckObstacle(const Obstacle& obstacle) {
  Require(IsPose(obstacle.X_WO), "an obstacle has a place");
  if (obstacle.type == ShapeType::kMesh) {
    Require(obstacle.vertices_O.size() >= 4, "a mesh has four points");
    for (const Vector3& v : obstacle.vertices_O) Require(AreSensible(v), "points are finite");
  } else {
    const bool box = obstacle.type == ShapeType::kBox;
    Require(obstacle.size_m.head(box ? 3 : 2).minCoeff() > 0.0 && AreSensible(obstacle.size_m), "sizes are positive");
  }
}

void CheckTrajectory(const WholeBodyTrajectory& w) {
  Require(w.step_s > 0.0 && w.step_s <= 10.0 && IsSensible(w.start_s), "rows have times");
  Require(!w.q.empty() && w.v.size() == w.q.size() && w.a.size() == w.q.size() && w.tau.size() == w.q.size() &&
              w.wrenches.size() == w.q.size(),
          "columns have the same number of rows");
  for (std::size_t k = 0; k < w.q.size(); ++k) {
    Require(AreSensible(w.q[k]) && AreSensible(w.v[k]) && AreSensible(w.a[k]) && AreSensible(w.tau[k]),
            "states are finite");
    Require(std::abs(w.q[k].segment<4>(3).norm() - 1.0) < 1e-5, "quaternions are of unit length");
    Require(w.v[k].size() == w.q[k].size() - 1 && w.tau[k].size() == w.q[k].size() - 7, "sizes belong together");
    Require(w.wrenches[k].size() == w.wrenches[0].size() && w.wrenches[k].size() <= 64,
            "the number of feet is constant");
  }
}

bool IsIn(int index, std::size_t count) { return index >= 0 && static_cast<std::size_t>(index) < count; }

void CheckSteps(const MotionPlan& plan) {
  const std::size_t feet = plan.whole_body.wrenches.front().size();
  for (std::size_t i = 0; i < plan.footsteps.footholds.size(); ++i) {
    const Foothold& foothold = plan.footsteps.footholds[i];
    Require(IsIn(foothold.foot, feet) && IsIn(foothold.patch, static_cast<std::size_t>(plan.terrain.num_surfaces())),
            "feet and surfaces of footholds exist");
    Require(IsPose(foothold.X_WF) && foothold.touchdown_s <= foothold.liftoff_s, "footholds have a place and a time");
    Require(i == 0 || plan.footsteps.footholds[i - 1].touchdown_s <= foothold.touchdown_s, "footholds are sorted");
  }
  for (const SwingTrajectory& swing : plan.swings)
    Require(IsIn(swing.foot, feet) && swing.start_s < swing.end_s && IsPose(swing.X_WF_start), "swings take time");
  Require(!plan.parts.empty(), "a plan has parts");
  for (const MotionPart& part : plan.parts) {
    Require(part.start_s < part.end_s && part.gait.phase.size() == feet, "parts have a positive duration and all feet");
    CheckGaitLaws(part.gait);
  }
  CheckSchedule(plan.schedule, static_cast<int>(feet));
}

}  // namespace

void CheckTerrainLaws(const Terrain& terrain) {
  Require(terrain.num_surfaces() > 0, "there is ground");
  for (const TerrainPatch& patch : terrain.patches) {
    Require(IsPose(patch.X_WT) && patch.X_WT.linear()(2, 2) > 0.0, "a patch faces up");
    Require(IsFriction(patch.friction), "friction is sensible");
    for (const Vector2& corner : patch.outline_T) Require(AreSensible(corner), "corners are finite");
    Require(patch.outline_T.empty() || (patch.outline_T.size() > 2 && Area(patch.outline_T) > 0.0), "it has an area");
  }
  for (const HeightField& field : terrain.height_fields) CheckField(field);
  for (const Obstacle& obstacle : terrain.obstacles) CheckObstacle(obstacle);
  for (const double x : {-1.0, 0.0, 0.7, 3.0}) {
    const GroundPoint ground = GroundAt(terrain, {x, 0.1 * x});
    Require(ground.patch < terrain.num_surfaces() && (ground.patch < 0 || std::isfinite(ground.height_m)),
            "ground has a height");
  }
}

void CheckGaitLaws(const Gait& gait) {
  Require(gait.cycle_s >= 0.0 && IsSensible(gait.cycle_s), "a cycle takes time");
  Require(gait.phase.size() == gait.duty_factor.size() && !gait.phase.empty() && gait.phase.size() <= 64,
          "phases and duty factors are by foot, for at most 64 feet");
  for (const double phase : gait.phase) Require(phase >= 0.0 && phase < 1.0, "phases are from 0 to less than 1");
  for (const double share : gait.duty_factor)
    Require(share > 0.0 && share <= 1.0, "duty factors are above 0, at most 1");
}

void CheckPlanLaws(const MotionPlan& plan) {
  CheckTerrainLaws(plan.terrain);
  CheckTrajectory(plan.whole_body);
  CheckSteps(plan);
  for (std::size_t k = 0; k < plan.centroidal.p_WC.size(); ++k)
    Require(AreSensible(plan.centroidal.p_WC[k]) && AreSensible(plan.centroidal.p_WZ[k]), "the centre is finite");
  const Result<MotionPlan> back = PlanFromJson(PlanToJson(plan), "again");
  Require(back.ok(), "a plan is read back: " + (back.ok() ? "" : back.failure().message));
  Require(back->whole_body.q == plan.whole_body.q && back->whole_body.wrenches == plan.whole_body.wrenches &&
              back->schedule == plan.schedule && back->provenance == plan.provenance &&
              back->footsteps.footholds.size() == plan.footsteps.footholds.size() && back->urdf_text == plan.urdf_text,
          "a plan is read back as it was");
}

MotionPlan SmallPlan() {
  constexpr int kJoints = 8;
  constexpr std::size_t kFeet = 4;
  MotionPlan plan;
  plan.robot = "four";
  plan.robot_hash = "0123456789abcdef";
  plan.urdf_text = SourceFile("tests/fuzz/corpus/urdf/four_legs.urdf");
  plan.meshes = {{"a.stl", {Vector3(0.0, 0.0, 0.0), Vector3(0.1, 0.0, 0.2)}}};
  plan.provenance = {"0.1.0", "fuzz", {{"step_s", "0.005"}}, 7};
  const Gait stand = StandingGait(static_cast<int>(kFeet));
  plan.parts = {{stand, {}, {}, 0.0, 0.01},
                {{"trot", "", 0.5, {0, 0.5, 0.5, 0}, {0.6, 0.6, 0.6, 0.6}}, {}, {}, 0.01, 0.02}};
  plan.terrain = FlatTerrain();
  plan.terrain.patches.push_back(PatchThrough("step", {{0, 0, 0.1}, {1, 0, 0.1}, {1, 1, 0.1}, {0, 1, 0.1}}, 0.6));
  plan.terrain.height_fields = {{"field", {2.0, 0.0}, 0.5, 2, 2, {0.0, 0.1, 0.0, 0.2}, 0.7}};
  Obstacle post;
  post.name = "post";
  post.type = ShapeType::kCylinder;
  post.size_m = {0.1, 1.0, 0.0};
  plan.terrain.obstacles = {post};
  plan.schedule.phases = {{0.0, 0.01, 15}, {0.01, 0.02, 9}};
  for (int foot = 0; foot < static_cast<int>(kFeet); ++foot)
    plan.footsteps.footholds.push_back({foot, Pose::Identity(), Vector3::Zero(), 0, 0.0, 0.02});
  plan.swings = {{1, 0.01, 0.02, Pose::Identity(), Pose::Identity(), 0.05, 0.03, {Vector3(0.0, 0.0, 0.1)}, 0.1}};
  plan.whole_body.step_s = plan.centroidal.step_s = 0.01;
  for (int k = 0; k < 3; ++k) {
    VectorX q = VectorX::Constant(7 + kJoints, 0.1 * k);
    q.segment<4>(3) << 0.0, 0.0, 0.0, 1.0;
    plan.whole_body.q.push_back(q);
    plan.whole_body.v.push_back(VectorX::Constant(6 + kJoints, 0.5));
    plan.whole_body.a.push_back(VectorX::Zero(6 + kJoints));
    plan.whole_body.tau.push_back(VectorX::Constant(kJoints, -1.5));
    plan.whole_body.wrenches.emplace_back(kFeet, ContactWrench{Vector3(0.0, 0.0, 30.0), Vector3::Zero()});
    plan.centroidal.p_WC.emplace_back(0.0, 0.0, 0.3);
    plan.centroidal.v_WC.emplace_back(Vector3::Zero());
    plan.centroidal.a_WC.emplace_back(Vector3::Zero());
    plan.centroidal.p_WZ.emplace_back(Vector2::Zero());
  }
  return plan;
}

}  // namespace gaitwright::fuzz
