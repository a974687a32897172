// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <cmath>
#include <cstring>

#include "kinematics/base/hash.h"
#include "playback/play/play.h"

namespace gaitwright {
namespace {

/// The bytes to hash. Numbers enter exactly; zero enters without its sign. Rotations enter to 1e-6, because a plan file
/// stores them as quaternions, which read back with rounding.
class Bytes {
 public:
  void Add(double value) {
    value += 0.0;
    char bytes[sizeof value];
    std::memcpy(bytes, &value, sizeof value);
    bytes_.append(bytes, sizeof value);
  }
  void Count(std::size_t count) { Add(static_cast<double>(count)); }
  void Text(const std::string& text) {
    Count(text.size());
    bytes_ += text;
  }
  template <class Derived>
  void Add(const Eigen::MatrixBase<Derived>& values) {
    Count(static_cast<std::size_t>(values.size()));
    for (Eigen::Index i = 0; i < values.size(); ++i) Add(values[i]);
  }
  void Add(const Pose& X) {
    constexpr double kFine = 1e6;
    Add(X.translation());
    for (Eigen::Index i = 0; i < 9; ++i) Add(std::round(kFine * X.linear()(i / 3, i % 3)));
  }
  template <class Value>
  void Add(const std::vector<Value>& values) {
    Count(values.size());
    for (const Value& value : values) Add(value);
  }
  void Add(const TerrainPatch& patch) {
    Add(patch.X_WT);
    Add(patch.outline_T);
    Add(patch.friction);
  }
  void Add(const HeightField& field) {
    Add(field.origin_W);
    Add(field.resolution_m);
    Add(Vector2(field.columns, field.rows));
    Add(field.height_m);
    Add(field.friction);
  }
  void Add(const Obstacle& obstacle) {
    Add(static_cast<double>(obstacle.type));
    Add(obstacle.X_WO);
    obstacle.type == ShapeType::kMesh ? Add(obstacle.vertices_O) : Add(obstacle.size_m);
  }
  void Add(const PlanGate& gate) {
    Add(gate.at_s);
    Add(gate.joints_within);
    Add(static_cast<double>(gate.contact));
    Add(gate.longest_s);
  }
  void Add(const ContactPhase& phase) {
    Add(Vector2(phase.start_s, phase.end_s));
    Count(phase.stance);
  }
  void Add(const Foothold& foothold) {
    Add(Vector2(foothold.foot, foothold.patch));
    Add(foothold.X_WF);
    Add(foothold.roll_W);
    Add(Vector2(foothold.touchdown_s, foothold.liftoff_s));
    if (foothold.heel_off_s) Add(*foothold.heel_off_s);
  }
  void Add(const ContactWrench& wrench) {
    Add(wrench.force_W);
    Add(wrench.moment_W);
  }

  std::string Hash() const { return HexHash(bytes_); }

 private:
  std::string bytes_;
};

}  // namespace

std::string MotionHash(const MotionPlan& plan) {
  const WholeBodyTrajectory& w = plan.whole_body;
  Bytes bytes;
  bytes.Text(plan.robot_hash);
  bytes.Add(plan.terrain.patches);
  bytes.Add(plan.terrain.height_fields);
  bytes.Add(plan.terrain.obstacles);
  bytes.Add(plan.schedule.phases);
  bytes.Add(plan.footsteps.footholds);
  if (!plan.gates.empty()) bytes.Add(plan.gates);
  bytes.Add(Vector2(w.start_s, w.step_s));
  for (const std::vector<VectorX>* rows : {&w.q, &w.v, &w.a, &w.tau}) bytes.Add(*rows);
  bytes.Add(w.wrenches);
  return bytes.Hash();
}

}  // namespace gaitwright
