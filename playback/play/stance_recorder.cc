// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <tuple>

#include "playback/play/stance_recorder_internal.h"

namespace gaitwright::playing {
namespace {

constexpr double kFlicker = 0.015;      // gaps shorter than this do not end a stance [s]
constexpr double kSlipLoad = 0.02;      // slip counts above this share of the weight
constexpr double kFrictionLoad = 0.05;  // friction use counts above this share of the weight

}  // namespace

StanceRecorder::StanceRecorder(int num_feet, double weight_n, double step_s, double smoothing_s)
    : weight_n_(weight_n), step_s_(step_s), smoothing_s_(smoothing_s), feet_(static_cast<std::size_t>(num_feet)) {}

void StanceRecorder::TouchDown(int index, double time_s, const FootContact& contact) {
  Foot& foot = feet_[static_cast<std::size_t>(index)];
  foot.standing = true;
  foot.stance = StanceRecord{};
  foot.stance.foot = index;
  foot.stance.touchdown_s = time_s;
  foot.stance.p_touchdown_W = contact.p_W;
  foot.stance.touchdown_speed_m_s = foot.last_speed_m_s;
}

void StanceRecorder::AddContact(Foot& foot, double time_s, const FootContact& contact) {
  foot.last_touch_s = time_s + step_s_;
  StanceRecord& stance = foot.stance;
  stance.penetration_m = std::max(stance.penetration_m, contact.penetration_m);
  if (contact.normal_n > kSlipLoad * weight_n_) stance.slip_m += contact.slide_m;
  if (contact.normal_n > kFrictionLoad * weight_n_ && contact.friction > 0.0) {
    stance.friction_use_max =
        std::max(stance.friction_use_max, contact.tangential_n / (contact.friction * contact.normal_n));
  }
}

void StanceRecorder::Add(double time_s, const std::vector<FootContact>& feet) {
  const double forget = step_s_ / (smoothing_s_ + step_s_);
  for (std::size_t i = 0; i < feet_.size(); ++i) {
    Foot& foot = feet_[i];
    const FootContact& contact = feet[i];
    foot.smooth_normal_n += forget * (contact.normal_n - foot.smooth_normal_n);
    if (foot.standing && !contact.touching && time_s + step_s_ - foot.last_touch_s >= kFlicker) {
      foot.stance.liftoff_s = foot.last_touch_s;
      done_.push_back(foot.stance);
      foot.standing = false;
    }
    if (contact.touching) {
      if (!foot.standing) TouchDown(static_cast<int>(i), time_s, contact);
      AddContact(foot, time_s, contact);
    }
    if (foot.standing) foot.stance.peak_normal_n = std::max(foot.stance.peak_normal_n, foot.smooth_normal_n);
    foot.last_speed_m_s = contact.speed_m_s;
  }
}

std::vector<StanceRecord> StanceRecorder::Finish(double end_s) {
  std::vector<StanceRecord> stances = done_;
  for (const Foot& foot : feet_) {
    if (!foot.standing) continue;
    stances.push_back(foot.stance);
    const bool stands = end_s - foot.last_touch_s < kFlicker;
    stances.back().liftoff_s = stands ? end_s : foot.last_touch_s;
  }
  std::sort(stances.begin(), stances.end(), [](const StanceRecord& a, const StanceRecord& b) {
    return std::tie(a.touchdown_s, a.foot) < std::tie(b.touchdown_s, b.foot);
  });
  return stances;
}

}  // namespace gaitwright::playing
