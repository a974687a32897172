// SPDX-License-Identifier: BSD-3-Clause
#include "playback/sensing/contact_sensors.h"

#include <algorithm>

namespace gaitwright {
namespace {

constexpr int kContactStream = 4;

}  // namespace

ContactSensors::ContactSensors(std::size_t feet, double weight_n, const SensorOptions& options, double step_s)
    : options_(options),
      weight_n_(weight_n),
      clock_(options.contact_rate_hz, step_s),
      noise_(options.seed, kContactStream),
      delay_(DelaySteps(options.contact_delay_s, step_s)) {
  now_.load_n.assign(feet, 0.0);
}

const ContactReading& ContactSensors::Read(FootSet contact, const std::vector<ContactWrench>& wrenches) {
  if (clock_.Tick()) Sample(contact, wrenches);
  return delay_.Push(now_);
}

void ContactSensors::Sample(FootSet contact, const std::vector<ContactWrench>& wrenches) {
  now_.contact = 0;
  for (std::size_t f = 0; f < now_.load_n.size(); ++f) {
    const double error_n = options_.contact_noise * weight_n_ * noise_.Normal(), luck = noise_.Uniform();
    now_.load_n[f] = std::max(wrenches[f].force_W.z() + error_n, 0.0);
    const bool touches =
        Contains(contact, static_cast<int>(f)) && now_.load_n[f] > options_.contact_threshold * weight_n_;
    const bool wrong = luck < (touches ? options_.contact_missed : options_.contact_false);
    if (touches != wrong) now_.contact |= FootBit(static_cast<int>(f));
  }
}

}  // namespace gaitwright
