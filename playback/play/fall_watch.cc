// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>

#include "kinematics/dynamics/foot_contact.h"
#include "kinematics/model/base_height.h"
#include "playback/play/fall_watch_internal.h"

namespace gaitwright::playing {
namespace {

constexpr double kFallenTilt = 1.0;     // [rad]
constexpr double kFallenContact = 0.2;  // a body on the ground for this long is a fall [s]
constexpr double kKeptAfterFall = 0.3;  // [s]

Matrix3 RotationOf(const VectorX& q) { return Quaternion(q[6], q[3], q[4], q[5]).toRotationMatrix(); }

/// Height in W of a point of the base [m].
double HeightOf(const VectorX& q, const Vector3& p_B) { return q[2] + (RotationOf(q) * p_B).z(); }

FootSet StanceAt(const MotionPlan& plan, int feet, double time_s) {
  if (plan.schedule.phases.empty()) return AllFeet(feet);
  return plan.schedule.phases[static_cast<std::size_t>(PhaseAt(plan.schedule, time_s))].stance;
}

std::vector<double> PlannedHeights(const MotionPlan& plan, const Vector3& p_B) {
  std::vector<double> heights_m;
  for (const VectorX& q : plan.whole_body.q) heights_m.push_back(HeightOf(q, p_B));
  return heights_m;
}

/// Mean height of the standing feet by row; if no foot stands, of the last standing feet.
std::vector<double> PlannedGrounds(const RobotModel& model, const MotionPlan& plan) {
  DynamicsScratch scratch(model);
  const int feet = static_cast<int>(model.feet.size());
  std::vector<double> grounds_m;
  double ground_m = GroundAt(plan.terrain, plan.whole_body.q.front().head<2>()).height_m;
  for (const VectorX& q : plan.whole_body.q) {
    const double time_s = plan.whole_body.start_s + static_cast<double>(grounds_m.size()) * plan.whole_body.step_s;
    const FootSet stance = StanceAt(plan, feet, time_s);
    ForwardKinematics(model, q, scratch);
    double sum = 0.0;
    int standing = 0;
    for (int foot = 0; foot < feet; ++foot) {
      if ((stance & FootBit(foot)) == 0) continue;
      sum += ContactFrame(model, scratch, foot).translation().z();
      ++standing;
    }
    if (standing > 0) ground_m = sum / standing;
    grounds_m.push_back(ground_m);
  }
  return grounds_m;
}

/// Up axis of W in the base, by row.
std::vector<Vector3> PlannedUps(const MotionPlan& plan) {
  std::vector<Vector3> ups;
  for (const VectorX& q : plan.whole_body.q) ups.emplace_back(RotationOf(q).transpose() * Vector3::UnitZ());
  return ups;
}

}  // namespace

FallWatch::FallWatch(const RobotModel& model, const MotionPlan& plan, double height_lowest)
    : up_B_(PlannedUps(plan)),
      start_s_(plan.whole_body.start_s),
      step_s_(plan.whole_body.step_s),
      height_lowest_(height_lowest),
      height_point_B_(HeightPoint(model)),
      planned_m_(PlannedHeights(plan, height_point_B_)),
      planned_ground_m_(PlannedGrounds(model, plan)),
      ground_m_(planned_ground_m_.front()) {}

std::size_t FallWatch::RowAt(double time_s) const {
  const double last = static_cast<double>(planned_m_.size() - 1);
  return static_cast<std::size_t>(std::clamp(std::round((time_s - start_s_) / step_s_), 0.0, last));
}

bool FallWatch::Sunk(double time_s, const World& world) {
  double sum = 0.0;
  int touching = 0;
  for (const FootContact& foot : world.feet()) {
    if (!foot.touching) continue;
    sum += foot.p_W.z();
    ++touching;
  }
  const std::size_t row = RowAt(time_s);
  if (touching > 0) {
    ground_m_ = sum / touching;
    touched_row_ = row;
  }
  const double planned_m = planned_m_[row] - planned_ground_m_[touched_row_];
  // Over lower ground a planned base can be below the feet that stood last.
  return height_lowest_ > 0.0 && planned_m > 0.0 &&
         HeightOf(world.q(), height_point_B_) - ground_m_ < height_lowest_ * planned_m;
}

void FallWatch::Add(double time_s, const World& world) {
  const Vector3 up_W = RotationOf(world.q()) * up_B_[RowAt(time_s)];
  const bool tilted = std::acos(std::clamp(up_W.z(), -1.0, 1.0)) > kFallenTilt;
  if (world.body_contacts().empty()) contact_since_s_ = time_s;
  const bool down = time_s - contact_since_s_ > kFallenContact;
  const bool sunk = Sunk(time_s, world);
  if (fallen_ || !(tilted || down || sunk)) return;
  fallen_ = true;
  fallen_s_ = time_s;
}

bool FallWatch::Over(double time_s) const { return fallen_ && time_s - fallen_s_ > kKeptAfterFall; }

}  // namespace gaitwright::playing
