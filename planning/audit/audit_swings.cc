// SPDX-License-Identifier: BSD-3-Clause
// Check `foot_clearance` of the swing curves, and check `consistency` of swings with the schedule, the footholds and
// the motion of the feet in q.
#include <algorithm>
#include <cmath>

#include "kinematics/spatial/rotation.h"
#include "planning/audit/auditor.h"
#include "planning/audit/swing_depth.h"
#include "planning/audit/tolerances.h"
#include "planning/plan/heel_off_internal.h"

namespace gaitwright {

using namespace tolerance;

/// The motion of a foot in q must follow its swing curve from start to end. A spherical foot also rolls in the air: its
/// contact point differs from the curve by the distance rolled since lift-off, and the curve ends short by the total of
/// it.
void Auditor::CheckSwingPath(const SwingTrajectory& swing) {
  const Foot& foot = model_.feet[static_cast<std::size_t>(swing.foot)];
  const Vector3 normal_W = swing.X_WF_start.linear().col(2);  // ground on which it rolls until touch-down
  const double duration = swing.end_s - swing.start_s;
  const int pieces = std::max(2, static_cast<int>(std::ceil(duration / plan_.whole_body.step_s)));
  const auto time = [&](int k) { return swing.start_s + k * duration / pieces; };
  std::vector<Pose> path;
  std::vector<Vector3> rolled_W;
  for (int k = 0; k <= pieces; ++k) {
    SampleWholeBody(plan_.whole_body, time(k), sample_);
    ForwardKinematics(model_, sample_.q, scratch_);
    // The foot's own frame: the curve's z changes from the normal of the first ground to that of the second.
    path.push_back(FramePose(scratch_, foot.body, foot.X_BF));
    Vector3 roll_W = Vector3::Zero();
    if (k > 0) {
      const Vector3 turn = RotationLog(path[path.size() - 1].linear() * path[path.size() - 2].linear().transpose());
      roll_W = rolled_W.back() + foot.radius * turn.cross(normal_W);
    }
    rolled_W.push_back(roll_W);
  }
  SwingCurve curve = CurveOf(swing);
  curve.X_WF_end.translation() -= rolled_W.back();
  for (int k = 0; k <= pieces; ++k) {
    const auto i = static_cast<std::size_t>(k);
    Pose X_WF = Evaluate(curve, time(k)).X_WF;
    const Vector3 p_WF = X_WF.translation() + foot.radius * X_WF.linear().col(2);
    Expect(FootName(swing.foot) + " off its swing", time(k), (path[i].translation() - rolled_W[i] - p_WF).norm(),
           kPosition, "m");
    if (foot.type == FootType::kSole) {
      Expect(FootName(swing.foot) + " rotated from its swing", time(k),
             RotationLog(path[i].linear() * X_WF.linear().transpose()).norm(), kRotation, "rad");
    }
    X_WF.translation() += rolled_W[i];
    CheckSwingClearance(swing.foot, X_WF, time(k), -SwingDepth(static_cast<double>(k) / pieces));
  }
}

void Auditor::CheckSwingClearance(int foot, const Pose& X_WF, double time_s, double limit) {
  const Foot& of_foot = model_.feet[static_cast<std::size_t>(foot)];
  const std::string where = FootName(foot) + " on its swing";
  for (const Vector3& p : ContactPoints(of_foot, X_WF)) CheckHeight(where, p, limit, time_s);
  Pose X_WS = X_WF;  // the centre of a sphere
  X_WS.translation() += of_foot.radius * X_WF.linear().col(2);
  constexpr double kNear = 1e-3;  // [m]
  const double distance = watch_.NearestToFoot(foot, X_WS, kNear).distance_m;
  if (!(distance >= limit)) findings_.Note(Law::kFootClearance, where, time_s, distance, limit, "m");
}

/// Each foot has its swings in order, one for each gap between two of its contact intervals.
void Auditor::CheckSwings() {
  const int feet = static_cast<int>(model_.feet.size());
  std::vector<std::vector<const SwingTrajectory*>> swings(model_.feet.size());
  for (const SwingTrajectory& swing : plan_.swings) {
    if (swing.foot >= 0 && swing.foot < feet) {
      swings[static_cast<std::size_t>(swing.foot)].push_back(&swing);
    } else {
      findings_.Note(Law::kConsistency, "swing of an unknown foot", swing.start_s, swing.foot, feet - 1.0, "1");
    }
  }
  for (int f = 0; f < static_cast<int>(model_.legs.size()); ++f) {  // support links have no swings
    const auto intervals = IntervalsOf(plan_.schedule, f);
    const auto& of_foot = swings[static_cast<std::size_t>(f)];
    const std::size_t gaps = intervals.empty() ? 0 : intervals.size() - 1;
    if (of_foot.size() != gaps) {
      findings_.Note(Law::kConsistency, FootName(f) + " number of swings", plan_.schedule.start_s(),
                     static_cast<double>(of_foot.size()), static_cast<double>(gaps), "1");
    }
    for (std::size_t i = 0; i < std::min(gaps, of_foot.size()); ++i)
      CheckSwing(*of_foot[i], {intervals[i].end_s, intervals[i + 1].start_s});
  }
}

void Auditor::CheckSwing(const SwingTrajectory& swing, const ContactInterval& gap) {
  const std::string& foot = FootName(swing.foot);
  const auto fits = [&](const char* what, double value, double limit) {
    if (std::abs(value - limit) <= kTime) return true;
    findings_.Note(Law::kConsistency, foot + " swing's " + what + " against schedule", limit, value, limit, "s");
    return false;
  };
  const bool starts = fits("start", swing.start_s, gap.start_s), ends = fits("end", swing.end_s, gap.end_s);
  const int from = FootholdAt(plan_.footsteps, swing.foot, gap.start_s - kTime);
  const int to = FootholdAt(plan_.footsteps, swing.foot, gap.end_s);
  if (!starts || !ends || from < 0 || to < 0) return;
  const Foothold& start = plan_.footsteps.footholds[static_cast<std::size_t>(from)];
  const Foothold& end = plan_.footsteps.footholds[static_cast<std::size_t>(to)];
  const Foot& of_foot = model_.feet[static_cast<std::size_t>(swing.foot)];
  const auto turned = [](const Pose& X_WF, const Pose& X_WG) {
    return RotationLog(X_WF.linear() * X_WG.linear().transpose()).norm();
  };
  double off = (start.X_WF.translation() + start.roll_W - swing.X_WF_start.translation()).norm();
  double rotated = turned(start.X_WF, swing.X_WF_start);
  if (start.heel_off_s && of_foot.has_sole()) {
    const EdgeTurn turn = EdgeTurnOf(of_foot, start.X_WF, swing.X_WF_start);
    off = turn.off_m;
    rotated = turn.turned_rad;
  }
  Expect(foot + " swing off its footholds", swing.start_s,
         std::max(off, (end.X_WF.translation() - swing.X_WF_end.translation()).norm()), kPosition, "m");
  Expect(foot + " swing rotated from its footholds", swing.start_s, std::max(rotated, turned(end.X_WF, swing.X_WF_end)),
         kRotation, "rad");
  CheckSwingPath(swing);
}

}  // namespace gaitwright
