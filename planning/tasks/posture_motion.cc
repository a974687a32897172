// SPDX-License-Identifier: BSD-3-Clause
#include "planning/tasks/posture_motion.h"

#include <fmt/format.h>

#include <cmath>

#include "kinematics/base/result.h"

namespace gaitwright {
namespace {

Motion1 Between(double from, double to, const Motion1& step, double duration_s) {
  const double change = to - from;
  return {from + change * step.value, change * step.rate / duration_s,
          change * step.acceleration / (duration_s * duration_s)};
}

}  // namespace

double PostureMotion::TimeOf(std::size_t key) const {
  double time_s = 0.0;
  for (std::size_t k = 1; k <= key && k < keys.size(); ++k) time_s += keys[k].after_s;
  return time_s;
}

double PostureMotion::duration_s() const { return TimeOf(keys.size() - 1); }

void SampleAt(const PostureMotion& motion, double time_s, PostureSample& sample) {
  std::size_t next = 1;
  double since_s = time_s;
  while (next + 1 < motion.keys.size() && since_s >= motion.keys[next].after_s) since_s -= motion.keys[next++].after_s;
  const PostureKey &a = motion.keys[next - 1], &b = motion.keys[next];
  const double duration_s = b.after_s > 0.0 ? b.after_s : 1.0;
  const Motion1 step = SmoothStep(b.after_s > 0.0 ? since_s / b.after_s : 1.0, b.cruise);
  for (std::size_t i = 0; i < 3; ++i) {
    const auto axis = static_cast<Eigen::Index>(i);
    sample.shift[i] = Between(a.shift[axis], b.shift[axis], step, duration_s);
    sample.turn[i] = Between(a.turn_rad[axis], b.turn_rad[axis], step, duration_s);
  }
  sample.q = a.joints + step.value * (b.joints - a.joints);
  sample.v = step.rate / duration_s * (b.joints - a.joints);
  sample.a = step.acceleration / (duration_s * duration_s) * (b.joints - a.joints);
}

PostureMotion Stretched(PostureMotion motion, double factor, double grid_step_s) {
  constexpr double kRounding = 1e-6;
  for (PostureKey& key : motion.keys)
    key.after_s = std::ceil(factor * key.after_s / grid_step_s - kRounding) * grid_step_s;
  return motion;
}

PostureMotion Chained(const std::vector<PostureMotion>& motions) {
  if (motions.empty()) throw InvalidArgument("no posture motions to join; give at least one");
  PostureMotion chain{motions.front().name, {motions.front().keys.front()}};
  for (const PostureMotion& motion : motions) {
    const std::size_t before = chain.keys.size() - 1;
    chain.keys.insert(chain.keys.end(), motion.keys.begin() + 1, motion.keys.end());
    for (FootLift lift : motion.lifts) {
      lift.from_key += before;
      lift.to_key += before;
      chain.lifts.push_back(lift);
    }
    for (RestStay stay : motion.rests) {
      stay.from_key += before;
      stay.to_key += before;
      const bool goes_on =
          !chain.rests.empty() && chain.rests.back().rest == stay.rest && chain.rests.back().to_key == stay.from_key;
      if (goes_on) {
        chain.rests.back().to_key = stay.to_key;
      } else {
        chain.rests.push_back(stay);
      }
    }
    for (PostureSection section : motion.sections) {
      section.last_key += before;
      chain.sections.push_back(section);
    }
    if (motion.sections.empty()) chain.sections.push_back({motion.name, chain.keys.size() - 1});
    for (const auto& [key, text] : motion.options)
      chain.options.emplace_back(fmt::format("{}.{}.{}", chain.sections.size(), motion.name, key), text);
  }
  return chain;
}

void CheckPostureMotion(const RobotModel& model, const PostureMotion& motion) {
  const auto refuse = [&](const std::string& what) {
    throw InvalidArgument(fmt::format("posture motion '{}' {}", motion.name, what));
  };
  if (motion.keys.size() < 2) refuse(fmt::format("has {} keys; two or more are needed", motion.keys.size()));
  for (std::size_t k = 0; k < motion.keys.size(); ++k) {
    const PostureKey& key = motion.keys[k];
    if (key.joints.size() != model.num_dofs()) {
      refuse(fmt::format("has {} joints at key {}; robot '{}' has {}", key.joints.size(), k, model.name,
                         model.num_dofs()));
    }
    if (!(key.after_s >= 0.0 && std::isfinite(key.after_s)) || !key.shift.allFinite() || !key.turn_rad.allFinite() ||
        !key.joints.allFinite())
      refuse(fmt::format("has key {} with a value that is not finite, or a time below 0", k));
  }
  const auto legs = static_cast<int>(model.legs.size()), feet = static_cast<int>(model.feet.size());
  for (const FootLift& lift : motion.lifts) {
    if (lift.foot < 0 || lift.foot >= legs || lift.from_key >= lift.to_key || lift.to_key >= motion.keys.size() ||
        !(lift.height_m > 0.0 && std::isfinite(lift.height_m)))
      refuse("lifts a foot that is unknown, outside of its keys, or to a height of 0 or less");
  }
  for (const RestStay& stay : motion.rests) {
    if (stay.rest < legs || stay.rest >= feet || stay.from_key >= stay.to_key || stay.to_key >= motion.keys.size())
      refuse("lies on an unknown support link, or outside of its keys");
  }
}

}  // namespace gaitwright
