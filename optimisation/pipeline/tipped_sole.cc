// SPDX-License-Identifier: BSD-3-Clause
#include "optimisation/pipeline/tipped_sole.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "kinematics/dynamics/dynamics.h"
#include "kinematics/dynamics/foot_contact.h"
#include "optimisation/pipeline/sole_width.h"

namespace gaitwright {
namespace {

constexpr double kTouching = 1e-4;  // [m]

struct Tipped {
  int foot = -1;
  double depth_m = kTouching, tilt_rad = 0.0, at_s = 0.0;
};

Tipped Worst(const RobotModel& model, const Terrain& terrain, const WholeBodyTrajectory& motion) {
  DynamicsScratch scratch(model);
  Tipped worst;
  for (int k = 0; k < motion.size(); ++k) {
    ForwardKinematics(model, motion.q[static_cast<std::size_t>(k)], scratch);
    for (int f = 0; f < static_cast<int>(model.feet.size()); ++f) {
      if (model.feet[static_cast<std::size_t>(f)].type != FootType::kLine) continue;
      for (const Vector3& p : ContactPoints(model, scratch, f)) {
        const double depth = GroundAt(terrain, p.head<2>()).height_m - p.z();
        if (depth <= worst.depth_m) continue;
        const double side = ContactFrame(model, scratch, f).linear()(2, 1);
        worst = {f, depth, std::asin(std::clamp(std::abs(side), 0.0, 1.0)), motion.start_s + k * motion.step_s};
      }
    }
  }
  return worst;
}

}  // namespace

bool HasTiltingSole(const RobotModel& model) {
  return std::any_of(model.feet.begin(), model.feet.end(), [](const Foot& f) { return f.type == FootType::kLine; });
}

std::optional<Failure> TippedSole(const RobotModel& model, const Terrain& terrain, const WholeBodyTrajectory& motion) {
  if (!HasTiltingSole(model)) return std::nullopt;
  const Tipped worst = Worst(model, terrain, motion);
  if (worst.foot < 0) return std::nullopt;
  const Foot& foot = model.feet[static_cast<std::size_t>(worst.foot)];
  return Failure{
      FailureKind::kInfeasible,
      FailureCode::kTippedSole,
      "PlanMotion",
      fmt::format("at {:.2f} s the edge of the sole of '{}' would be {:.1f} mm below the ground: its leg ({} joints) "
                  "has no ankle roll joint, so the sole tilts by {:.3f} rad as the body sways, and it is {:.3f} m wide",
                  worst.at_s, foot.name, 1e3 * worst.depth_m,
                  model.legs[static_cast<std::size_t>(worst.foot)].joints.size(), worst.tilt_rad, SoleWidth(foot)),
      {"give the leg an ankle roll joint",
       "if an arm was mistaken for a leg, name the feet in robot.yaml (feet: [...])"}};
}

}  // namespace gaitwright
