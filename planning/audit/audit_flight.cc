// SPDX-License-Identifier: BSD-3-Clause
// Check `flight`: without contact, gravity is the only external force.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "planning/audit/auditor.h"
#include "planning/audit/tolerances.h"

namespace gaitwright {

using namespace tolerance;

/// Whether no foot is in contact from one row before a time to one row after it, and the base is not held externally.
/// Forces are linear between rows, so the forces of a touch-down may begin one row early.
bool Auditor::Flies(double time_s) const {
  if (Hanging(time_s)) return false;
  for (int f = 0; f < static_cast<int>(model_.feet.size()); ++f) {
    if (!SwingsThroughout(f, time_s)) return false;
  }
  return true;
}

/// In flight, with the mass m, the centre of mass C and the angular momentum L about it:
///   m (a_WC - g) = 0,   dL/dt = 0,
/// at each sample by the accelerations, and over the whole flight by the velocities, which accelerations need not
/// match.
void Auditor::CheckFlight(double time_s) {
  if (!flies_) return EndFlight();
  const Vector3 force_W = needed_.head<3>();
  const Vector3 arm_W = scratch_.p_WB[0] - CentreOfMass(model_, scratch_);
  const double force = force_W.norm() / model_.weight_n();
  const double moment = (needed_.segment<3>(3) + arm_W.cross(force_W)).norm() / FlightMoment();
  const Vector6 momentum_W = CentroidalMomentum(model_, scratch_);
  if (!flight_.begun) flight_ = {true, time_s, time_s, momentum_W, momentum_W, {}};
  flight_.last_s = time_s;
  flight_.last_W = momentum_W;
  const double worst = std::max(force, moment);
  flight_.samples.push_back({time_s, worst});
  NoteFlight(places_.fall, time_s, force);
  NoteFlight(places_.spin, time_s, moment);
}

void Auditor::NoteFlight(int place, double time_s, double share) {
  findings_.Hold(place, time_s, share, kResidualShare, kResidualShare - share);
}

/// Checks the change of the momentum over a flight that has just ended, if there is one.
void Auditor::EndFlight() {
  constexpr double kBrief = 0.01;  // [s] shorter flights have no meaningful means
  if (!flight_.begun) return;
  const double lasted_s = flight_.last_s - flight_.start_s;
  if (lasted_s >= kBrief) {
    Vector6 mean_W = (flight_.last_W - flight_.first_W) / lasted_s;
    mean_W[2] += model_.weight_n();
    const double force = mean_W.head<3>().norm() / model_.weight_n();
    const double moment = mean_W.tail<3>().norm() / FlightMoment();
    NoteFlight(places_.fall, flight_.last_s, force);
    NoteFlight(places_.spin, flight_.last_s, moment);
    RemarkOnFlight(lasted_s, mean_W[2] / model_.weight_n());
  }
  flight_ = {};
}

/// Adds the likely cause, once, if the body does not fall in a flight at all, or does not near its ends only.
/// @param carried  mean vertical force over the weight.
void Auditor::RemarkOnFlight(double lasted_s, double carried) {
  constexpr double kCarried = 0.5, kMiddle = 0.25;  // share of the weight; of the flight, from its middle on
  if (remarked_on_flight_) return;
  double inside = 0.0, outside = 0.0;
  for (const auto& [time_s, worst] : flight_.samples) {
    const bool is_inside = std::abs(time_s - 0.5 * (flight_.start_s + flight_.last_s)) <= kMiddle * lasted_s;
    double& most = is_inside ? inside : outside;
    most = std::max(most, worst);
  }
  if (std::max(inside, outside) <= kResidualShare) return;
  if (carried > kCarried) {
    remarked_on_flight_ = true;
    remarks_.push_back(fmt::format(
        "from {:.3f} to {:.3f} s no foot is in contact, but the body does not fall: {:.0f} % of its weight is carried. "
        "Probably a contact is missing from the schedule",
        flight_.start_s, flight_.last_s, 100.0 * carried));
  } else if (inside <= kResidualShare) {
    remarked_on_flight_ = true;
    remarks_.push_back(fmt::format(
        "in the flight from {:.3f} to {:.3f} s the body falls freely, except near take-off or touch-down. Probably the "
        "contact times do not match the motion: in a recording they are known to one of its rows only, and "
        "accelerations to a few rows. Record at a higher rate, or give contacts and accelerations",
        flight_.start_s, flight_.last_s));
  }
}

}  // namespace gaitwright
