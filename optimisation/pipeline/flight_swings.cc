// SPDX-License-Identifier: BSD-3-Clause
#include "optimisation/pipeline/flight_swings.h"

#include <algorithm>
#include <cmath>

#include "kinematics/trajectory/swing_curve.h"
#include "optimisation/swing/swing_lift.h"

namespace gaitwright {
namespace {

/// The flights within a swing.
struct Flights {
  double longest_s = 0.0, whole_s = 0.0;

  /// Largest rise of a body in the longest flight: g T^2 / 8.
  double Rise() const { return kGravity * longest_s * longest_s / 8.0; }
};

Flights FlightsIn(const ContactSchedule& schedule, double start_s, double end_s) {
  Flights flights;
  for (const ContactPhase& phase : schedule.phases) {
    if (phase.stance != 0 || phase.start_s < start_s - 1e-9 || phase.end_s > end_s + 1e-9) continue;
    flights.longest_s = std::max(flights.longest_s, phase.end_s - phase.start_s);
    flights.whole_s += phase.end_s - phase.start_s;
  }
  return flights;
}

/// Peak acceleration of a swing that starts and ends at one place and is lifted by 1 m in 1 s [m/s^2].
double PeakAcceleration(double cruise) {
  constexpr int kSamples = 200;
  SwingCurve curve;
  curve.lift_m = 1.0;
  curve.cruise = cruise;
  // The bump depends on the progress along the path only, so its acceleration does not depend on the path's length.
  double peak = 0.0;
  for (int k = 0; k <= kSamples; ++k)
    peak = std::max(peak, std::abs(Evaluate(curve, static_cast<double>(k) / kSamples).a_WF.z()));
  return peak;
}

}  // namespace

FlightSwings::FlightSwings(const RobotModel& model, const ContactSchedule& schedule, const SwingOptions& options)
    : model_(model), schedule_(schedule), lift_m_(SwingLift(model, options)), own_lift_(options.height_m > 0.0) {}

double FlightSwings::AccelerationOf(FootSet feet) const {
  const auto known = acceleration_m_s2_.find(feet);
  if (known != acceleration_m_s2_.end()) return known->second;
  std::vector<int> list;
  for (int f = 0; f < static_cast<int>(model_.feet.size()); ++f) {
    if (Contains(feet, f)) list.push_back(f);
  }
  return acceleration_m_s2_[feet] = FootAccelerationInFlight(model_, list);
}

FlightSwing FlightSwings::At(double start_s, double end_s) const {
  constexpr double kMostCruise = 0.6, kUse = 0.4, kLeastLift = 0.1;
  const Flights flights = FlightsIn(schedule_, start_s, end_s);
  const double time_s = end_s - start_s, rise_m = flights.Rise();
  // While the body flies at constant speed, its feet should move along with it.
  FlightSwing swing{lift_m_ + rise_m, kMostCruise * flights.whole_s / time_s};
  if (flights.whole_s == 0.0 || own_lift_) return swing;
  const FootSet stance = schedule_.phases[static_cast<std::size_t>(PhaseAt(schedule_, 0.5 * (start_s + end_s)))].stance;
  const FootSet in_air = AllFeet(static_cast<int>(model_.feet.size())) & ~stance;
  const double acceleration = kUse * AccelerationOf(in_air) - kGravity;
  const auto most = [&](double cruise) {
    return std::max(0.0, acceleration) * time_s * time_s / PeakAcceleration(cruise);
  };
  if (swing.lift_m <= most(swing.cruise)) return swing;
  if (rise_m + kLeastLift * lift_m_ <= most(swing.cruise)) return {most(swing.cruise), swing.cruise};
  return {std::max(std::min(swing.lift_m, most(0.0)), kLeastLift * lift_m_), 0.0};
}

}  // namespace gaitwright
