// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>

#include "kinematics/spatial/rotation.h"
#include "planning/audit/auditor.h"

namespace gaitwright {
namespace {

constexpr double kPosition = 1e-3;  // [m]
constexpr double kRotation = 1e-3;  // [rad]
constexpr double kTime = 1e-6;      // [s]

Matrix3 BaseRotation(const VectorX& q) { return Quaternion(q[6], q[3], q[4], q[5]).normalized().toRotationMatrix(); }

}  // namespace

void Auditor::CheckColumns() {
  const WholeBodyTrajectory& w = plan_.whole_body;
  const double h = w.step_s;
  for (std::size_t k = 0; k < w.q.size(); ++k) {
    const double time_s = w.start_s + static_cast<double>(k) * h;
    const double norm = w.q[k].segment<4>(3).norm();
    if (!(std::abs(norm - 1.0) <= 1e-6)) findings_.Note("consistency", "quaternion norm", time_s, norm, 1.0, "1");
    if (k + 1 == w.q.size()) break;
    // The corrected trapezium, exact to the fifth order: what v and a say that q does in one step.
    const VectorX step = 0.5 * h * (w.v[k] + w.v[k + 1]) + h * h / 12.0 * (w.a[k] - w.a[k + 1]);
    const double position = (w.q[k + 1].head<3>() - w.q[k].head<3>() - step.head<3>()).norm();
    const double rotation =
        (RotationLog(BaseRotation(w.q[k + 1]) * BaseRotation(w.q[k]).transpose()) - step.segment<3>(3)).norm();
    if (!(position <= kPosition))
      findings_.Note("consistency", "base position against velocity", time_s, position, kPosition, "m");
    if (!(rotation <= kRotation))
      findings_.Note("consistency", "base rotation against velocity", time_s, rotation, kRotation, "rad");
    for (int d = 0; d < model_.num_dofs(); ++d) {
      const double joint = std::abs(w.q[k + 1][7 + d] - w.q[k][7 + d] - step[6 + d]);
      if (!(joint <= kRotation)) {
        findings_.Note("consistency", model_.dof_names[static_cast<std::size_t>(d)] + " position against velocity",
                       time_s, joint, kRotation, "rad");
      }
    }
  }
}

void Auditor::CheckCentroidal() {
  const CentroidalTrajectory& c = plan_.centroidal;
  if (c.p_WC.size() != plan_.whole_body.q.size()) {
    findings_.Note("consistency", "centroidal rows", 0.0, static_cast<double>(c.p_WC.size()),
                   static_cast<double>(plan_.whole_body.q.size()), "1");
    return;
  }
  for (std::size_t k = 0; k < c.p_WC.size(); ++k) {
    ForwardKinematics(model_, plan_.whole_body.q[k], scratch_);
    const double off = (CentreOfMass(model_, scratch_) - c.p_WC[k]).norm();
    if (!(off <= kPosition))
      findings_.Note("consistency", "centre of mass against joints", c.start_s + static_cast<double>(k) * c.step_s, off,
                     kPosition, "m");
  }
}

void Auditor::CheckFootholds() {
  for (int f = 0; f < static_cast<int>(model_.feet.size()); ++f) {
    const auto intervals = IntervalsOf(plan_.schedule, f);
    std::size_t i = 0;
    for (const Foothold& foothold : plan_.footsteps.footholds) {
      if (foothold.foot != f) continue;
      const bool fits = i < intervals.size() && std::abs(intervals[i].start_s - foothold.touchdown_s) <= kTime &&
                        std::abs(intervals[i].end_s - foothold.liftoff_s) <= kTime;
      if (!fits)
        findings_.Note("consistency", FootName(f) + " foothold against schedule", foothold.touchdown_s,
                       foothold.liftoff_s, kTime, "s");
      ++i;
    }
    if (i != intervals.size()) {
      findings_.Note("consistency", FootName(f) + " number of footholds", 0.0, static_cast<double>(i),
                     static_cast<double>(intervals.size()), "1");
    }
  }
}

void Auditor::CheckSwings() {
  for (const SwingTrajectory& swing : plan_.swings) {
    const int from = FootholdAt(plan_.footsteps, swing.foot, swing.start_s - kTime);
    const int to = FootholdAt(plan_.footsteps, swing.foot, swing.end_s);
    if (from < 0 || to < 0) continue;
    const Foothold& start = plan_.footsteps.footholds[static_cast<std::size_t>(from)];
    const Foothold& end = plan_.footsteps.footholds[static_cast<std::size_t>(to)];
    const double off = std::max((start.X_WF.translation() + start.roll_W - swing.X_WF_start.translation()).norm(),
                                (end.X_WF.translation() - swing.X_WF_end.translation()).norm());
    if (!(off <= kPosition))
      findings_.Note("consistency", FootName(swing.foot) + " swing off its footholds", swing.start_s, off, kPosition,
                     "m");
  }
}

}  // namespace gaitwright
