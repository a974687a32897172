// SPDX-License-Identifier: BSD-3-Clause
#include "playback/control/situation.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include "kinematics/dynamics/foot_contact.h"

namespace gaitwright {

void Situation::Reset() { touched_s_.clear(); }

void Situation::Observe(const RobotModel& model, const VectorX& q, const VectorX& v, BodyState& body) const {
  body.q = q;
  body.v = v;
  ForwardVelocities(model, q, v, body.scratch);
  body.p_WC = CentreOfMass(model, body.scratch);
  body.v_WC = CentroidalMomentum(model, body.scratch).head<3>() / model.total_mass_kg;
  body.X_WF.clear();
  for (int f = 0; f < static_cast<int>(model.feet.size()); ++f)
    body.X_WF.push_back(ContactFrame(model, body.scratch, f));
}

void Situation::Update(const RobotModel& model, const ControlInput& input) {
  constexpr double kBridge = 0.01;  // a contact lost for less is a bounce [s]
  constexpr double kLanding = 0.5;  // share of a swing after which a contact is an early landing
  constexpr double kLowest = 0.1;   // of the leg's length, of the height that the pendulum is reckoned with
  time_s = input.time_s;
  step_s = input.step_s;
  wrenches = input.wrenches;
  SampleWholeBody(plan_.whole_body, time_s, sample);
  Observe(model, input.q, input.v, measured);
  Observe(model, sample.q, sample.v, planned);
  scheduled = plan_.schedule.phases[static_cast<std::size_t>(PhaseAt(plan_.schedule, time_s))].stance;
  double height = 0.0;
  for (int f = 0; f < static_cast<int>(model.feet.size()); ++f) {
    if (Contains(scheduled, f)) height += planned.X_WF[static_cast<std::size_t>(f)].translation().z();
  }
  if (scheduled != 0) ground_m = height / std::popcount(scheduled);
  const double lowest = kLowest * std::max(model.leg_length_m(), 1e-3);
  omega_rad_s = std::sqrt(kGravity / std::max(planned.p_WC.z() - ground_m, lowest));
  if (touched_s_.empty()) touched_s_.assign(model.feet.size(), time_s);
  bearing = 0;
  for (int f = 0; f < static_cast<int>(model.feet.size()); ++f) {
    double& touched = touched_s_[static_cast<std::size_t>(f)];
    if (Contains(input.contact, f)) touched = time_s;
    const bool due = Contains(scheduled, f) || SwingAt(plan_.footsteps, f, time_s).Progress(time_s) > kLanding;
    if (due && time_s - touched < kBridge) bearing |= FootBit(f);
  }
}

double SwingNow::Progress(double time_s) const {
  return swings ? std::clamp((time_s - liftoff_s) / (touchdown_s - liftoff_s), 0.0, 1.0) : 0.0;
}

SwingNow SwingAt(const FootstepPlan& footsteps, int foot, double time_s) {
  constexpr double kTiny = 1e-9;  // [s]
  SwingNow swing;
  const auto& footholds = footsteps.footholds;
  const int index = FootholdAt(footsteps, foot, time_s);
  if (index < 0) return swing;
  const Foothold& last = footholds[static_cast<std::size_t>(index)];
  const auto next = std::find_if(footholds.begin() + index + 1, footholds.end(),
                                 [&](const Foothold& foothold) { return foothold.foot == foot; });
  swing.liftoff_s = last.liftoff_s;
  if (next == footholds.end() || next->touchdown_s <= last.liftoff_s) return swing;
  swing.touchdown_s = next->touchdown_s;
  swing.next_liftoff_s = next->liftoff_s;
  swing.swings = time_s > last.liftoff_s - kTiny && time_s < next->touchdown_s - kTiny;
  return swing;
}

}  // namespace gaitwright
