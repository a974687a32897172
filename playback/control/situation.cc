// SPDX-License-Identifier: BSD-3-Clause
#include "playback/control/situation.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

#include "kinematics/dynamics/foot_contact.h"
#include "planning/plan/heel_off_internal.h"

namespace gaitwright {

void Situation::Reset() { touched_s_.clear(); }

void Situation::Observe(const RobotModel& model, const VectorX& q, const VectorX& v, BodyState& body) const {
  body.q = q;
  body.v = v;
  ForwardVelocities(model, q, v, body.scratch);
  body.p_WC = CentreOfMass(model, body.scratch);
  const Vector6 momentum = CentroidalMomentum(model, body.scratch);
  body.v_WC = momentum.head<3>() / model.total_mass_kg;
  body.l_W = momentum.tail<3>();
  body.X_WF.clear();
  for (int f = 0; f < static_cast<int>(model.feet.size()); ++f)
    body.X_WF.push_back(ContactFrame(model, body.scratch, f, swings.Under(f, time_s).normal_W));
}

void Situation::Update(const RobotModel& model, const ControlInput& input) {
  constexpr double kBridge = 0.01;  // a contact that is lost for a shorter time is a bounce [s]
  constexpr double kLanding = 0.5;  // share of a swing after which a contact is an early landing
  constexpr double kLowest = 0.1;   // lowest height of the pendulum as a share of the leg length
  time_s = input.time_s;
  step_s = input.step_s;
  lead_s = input.lead_steps * input.step_s;
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
  contacts_.resize(model.feet.size());
  for (std::size_t f = 0; f < contacts_.size(); ++f) PointsAt(static_cast<int>(f), planned, contacts_[f]);
  support = SupportPlaneAt(plan_.schedule, time_s, contacts_);
  const double lowest = kLowest * std::max(model.leg_length_m(), 1e-3);
  omega_rad_s = std::sqrt(kGravity / std::max(planned.p_WC.z() - ground_m, lowest));
  if (touched_s_.empty()) touched_s_.assign(model.feet.size(), time_s);
  bearing = 0;
  for (int f = 0; f < static_cast<int>(model.feet.size()); ++f) {
    double& touched = touched_s_[static_cast<std::size_t>(f)];
    const bool rests = f >= static_cast<int>(model.legs.size());
    // Where the plan lies on the trunk, the legs yield until it touches the ground.
    if (Contains(input.contact, f) || (rests && Contains(scheduled, f))) touched = time_s;
    const bool due = Contains(scheduled, f) || (!rests && swings.At(f, time_s).Progress(time_s) > kLanding);
    if (due && time_s - touched < kBridge) bearing |= FootBit(f);
  }
}

void Situation::PointsAt(int foot, const BodyState& body, std::vector<Vector3>& points_W) const {
  points_W.clear();
  for (const Vector2& p_F : swings.Under(foot, time_s).support_F)
    points_W.push_back(body.X_WF[static_cast<std::size_t>(foot)] * Vector3(p_F.x(), p_F.y(), 0.0));
}

double SwingNow::Progress(double time_s) const {
  return swings ? std::clamp((time_s - liftoff_s) / (touchdown_s - liftoff_s), 0.0, 1.0) : 0.0;
}

Swings::Swings(const RobotModel& model, const MotionPlan& plan)
    : stays_(model.feet.size()), grounds_(stays_.size()), edges_(stays_.size()) {
  const std::vector<Polygon> supports = SupportsOf(model, plan.terrain, plan.footsteps);
  for (std::size_t i = 0; i < plan.footsteps.footholds.size(); ++i) {
    const Foothold& foothold = plan.footsteps.footholds[i];
    const auto foot = static_cast<std::size_t>(foothold.foot);
    if (foot >= stays_.size()) continue;
    stays_[foot].push_back({foothold.touchdown_s, foothold.liftoff_s});
    const bool is_plane = foothold.patch < static_cast<int>(plan.terrain.patches.size());
    grounds_[foot].push_back(
        {foothold.X_WF.linear().col(2), FrictionOf(plan.terrain, foothold.patch), is_plane, supports[i]});
    edges_[foot].emplace_back(std::numeric_limits<double>::infinity(), grounds_[foot].back());
    if (!foothold.heel_off_s || !model.feet[foot].has_sole()) continue;
    edges_[foot].back().first = *foothold.heel_off_s;
    edges_[foot].back().second.support_F = FrontEdge(model.feet[foot].sole_F);
    edges_[foot].back().second.on_edge = true;
    edges_[foot].back().second.middle_F = EdgeMiddle(model.feet[foot]);
  }
  for (const ContactPhase& phase : plan.schedule.phases) {
    if (phase.stance == 0) flights_.push_back(phase);
  }
  for (std::size_t f = 0; f < grounds_.size(); ++f) {
    const Polygon whole = model.feet[f].has_sole() ? model.feet[f].sole_F : Polygon{Vector2::Zero()};
    if (grounds_[f].empty()) grounds_[f].push_back({Vector3::UnitZ(), FrictionOf(plan.terrain, 0), true, whole});
  }
}

/// Index of the current stay, else of the last one before, else of the first.
std::size_t Swings::StayAt(std::size_t foot, double time_s) const {
  constexpr double kTiny = 1e-9;  // [s]
  const std::vector<ContactInterval>& stays = stays_[foot];
  if (stays.empty()) return 0;
  const auto next = std::partition_point(stays.begin() + 1, stays.end(),
                                         [&](const ContactInterval& stay) { return stay.start_s <= time_s + kTiny; });
  return static_cast<std::size_t>(next - stays.begin()) - 1;
}

SwingNow Swings::At(int foot, double time_s) const {
  constexpr double kTiny = 1e-9;  // [s]
  SwingNow swing;
  const std::vector<ContactInterval>& stays = stays_.at(static_cast<std::size_t>(foot));
  if (stays.empty()) return swing;
  const std::size_t next = StayAt(static_cast<std::size_t>(foot), time_s) + 1;
  swing.liftoff_s = stays[next - 1].end_s;
  if (next == stays.size() || stays[next].start_s <= swing.liftoff_s) return swing;
  swing.touchdown_s = stays[next].start_s;
  swing.next_liftoff_s = swing.next_support_s = stays[next].end_s;
  const auto flight = std::partition_point(flights_.begin(), flights_.end(), [&](const ContactPhase& phase) {
    return phase.start_s < swing.next_liftoff_s - kTiny;
  });
  if (flight != flights_.end() && flight->start_s < swing.next_liftoff_s + kTiny) swing.next_support_s = flight->end_s;
  swing.swings = time_s > swing.liftoff_s - kTiny && time_s < swing.touchdown_s - kTiny;
  return swing;
}

const GroundUnder& Swings::Under(int foot, double time_s) const {
  constexpr double kTiny = 1e-9;  // [s]
  const auto f = static_cast<std::size_t>(foot);
  const std::size_t stay = StayAt(f, time_s);
  const bool on_edge =
      stay < edges_.at(f).size() && time_s > edges_[f][stay].first - kTiny && time_s < stays_[f][stay].end_s + kTiny;
  return on_edge ? edges_[f][stay].second : grounds_[f][stay];
}

}  // namespace gaitwright
