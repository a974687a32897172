// SPDX-License-Identifier: BSD-3-Clause
// Check `start_posture`, and check `consistency` for a base that is held externally.
#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>

#include "planning/audit/auditor.h"
#include "planning/audit/tolerances.h"

namespace gaitwright {

using namespace tolerance;

namespace {

/// Angle between the vertical axes of a posture and of a measured base. The heading of an IMU is arbitrary, so only the
/// tilt is compared.
double TiltBetween(const VectorX& q, const Quaternion& R_WB) {
  const Vector3 up = BaseRotation(q).row(2), measured = R_WB.toRotationMatrix().row(2);
  return std::atan2(up.cross(measured).norm(), up.dot(measured));
}

}  // namespace

/// Compares the first command with the measured posture: the difference is a jump of each joint.
void Auditor::CheckStart() {
  if (!options_.start) return;
  const StartPosture& start = *options_.start;
  const double time_s = plan_.whole_body.start_s;
  const VectorX& q = plan_.whole_body.q.front();
  for (int d = 0; d < model_.num_dofs(); ++d) {
    const double jump = std::abs(q[7 + d] - start.joints[d]);
    const double limit = Slides(d) ? options_.start_tolerance_m : options_.start_tolerance_rad;
    const int place =
        findings_.Place(Law::kStartPosture, model_.dof_names[static_cast<std::size_t>(d)], Slides(d) ? "m" : "rad");
    findings_.Hold(place, time_s, jump, limit, limit - jump);
  }
  CheckStartSpeeds();
  if (start.R_WB) CheckStartTilt(*start.R_WB);
}

/// If the measured tilt is very large, the quaternion was probably written with w first.
void Auditor::CheckStartTilt(const Quaternion& R_WB) {
  constexpr double kFarFromUpright = 1.0;  // [rad]
  const VectorX& q = plan_.whole_body.q.front();
  const double tilt = TiltBetween(q, R_WB), limit = options_.start_tilt_rad;
  const int place = findings_.Place(Law::kStartPosture, kStartTilt, "rad");
  findings_.Hold(place, plan_.whole_body.start_s, tilt, limit, limit - tilt);
  const double w_first = TiltBetween(q, Quaternion(R_WB.x(), R_WB.y(), R_WB.z(), R_WB.w()));
  if (tilt <= kFarFromUpright || w_first > limit) return;
  remarks_.push_back(fmt::format(
      "the start posture's quaternion seems to have w first: read as w, x, y, z, its tilt is {:.3g} rad from the first "
      "command's, read as x, y, z, w {:.3g} rad; write it as base_quaternion_xyzw: [x, y, z, w]",
      w_first, tilt));
}

/// The measured robot is at rest, so a first command with a speed is a jump, too.
void Auditor::CheckStartSpeeds() {
  const double time_s = plan_.whole_body.start_s;
  const VectorX& v = plan_.whole_body.v.front();
  const auto hold = [&](const std::string& where, double speed, bool slides) {
    const double limit = slides ? options_.start_speed_m_s : options_.start_speed_rad_s;
    const int place = findings_.Place(Law::kStartPosture, where + kStartSpeed, slides ? "m/s" : "rad/s");
    findings_.Hold(place, time_s, speed, limit, limit - speed);
  };
  for (int d = 0; d < model_.num_dofs(); ++d)
    hold(model_.dof_names[static_cast<std::size_t>(d)], std::abs(v[6 + d]), Slides(d));
  hold("base", v.head<3>().norm(), true);
  hold("base rotation", v.segment<3>(3).norm(), false);
}

/// In a hanging part no foot is on the ground, and the base does not move.
void Auditor::CheckHanging(const MotionPart& part) {
  for (const ContactPhase& phase : plan_.schedule.phases) {
    const bool within = phase.end_s > part.start_s + kTime && phase.start_s < part.end_s - kTime;
    if (within && phase.stance != 0) {
      findings_.Note(Law::kConsistency, "feet on the ground while the robot hangs",
                     std::max(part.start_s, phase.start_s), std::popcount(phase.stance), 0.0, "1");
    }
  }
  const WholeBodyTrajectory& w = plan_.whole_body;
  for (std::size_t k = 0; k < w.v.size(); ++k) {
    const double time_s = w.start_s + static_cast<double>(k) * w.step_s;
    if (time_s < part.start_s - kTime || time_s > part.end_s + kTime) continue;
    Expect("velocity of the hanging base", time_s, w.v[k].head<3>().norm(), kSpeed, "m/s");
    Expect("angular velocity of the hanging base", time_s, w.v[k].segment<3>(3).norm(), kRate, "rad/s");
  }
}

}  // namespace gaitwright
