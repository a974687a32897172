// SPDX-License-Identifier: BSD-3-Clause
#include "playback/score/fall.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace gaitwright {
namespace {

double AngleBetween(const Vector3& a, const Vector3& b) { return std::atan2(a.cross(b).norm(), a.dot(b)); }

Vector3 UpInBase(const MotionSample& sample) { return sample.X_WB.linear().transpose() * Vector3::UnitZ(); }

double Tilt(const MotionSample& sample) { return AngleBetween(UpInBase(sample), Vector3::UnitZ()); }

/// Height of the ground under the feet that are scheduled to stand, at their actual places; includes unplanned ground.
double GroundUnder(const MotionSample& sample) {
  return sample.p_WC.z() - kGravity / (sample.omega_rad_s * sample.omega_rad_s);
}

/// Checks base tilt and height against their bounds.
class Bounds {
 public:
  explicit Bounds(const ScoreOptions& options) : options_(options) {}

  /// The fall that this sample shows, if any; call for all samples in order.
  std::optional<Fall> Passed(const MotionSample& planned, const MotionSample& measured) {
    if (AngleBetween(UpInBase(planned), UpInBase(measured)) > options_.fall_tilt_rad) {
      return Fall{true, measured.time_s, FallKind::kTilted,
                  fmt::format("the base tilted to {:.2f} rad, planned {:.2f} rad", Tilt(measured), Tilt(planned))};
    }
    const double planned_ground = GroundUnder(planned);
    if (!measured.support.empty()) higher_ground_m_ = GroundUnder(measured) - planned_ground;
    const double height = measured.base_height_m - planned_ground - higher_ground_m_;
    const double planned_height = planned.base_height_m - planned_ground;
    if (height < options_.fall_height_lowest * planned_height ||
        height > options_.fall_height_highest * planned_height) {
      return Fall{true, measured.time_s, FallKind::kLeftHeight,
                  fmt::format("the base was at a height of {:.3f} m, planned {:.3f} m", height, planned_height)};
    }
    return std::nullopt;
  }

 private:
  const ScoreOptions& options_;
  /// Height of the measured ground above the planned one at the last stance. In flight both bases are compared above
  /// the same ground: near an edge, two close positions can have very different ground heights.
  double higher_ground_m_ = 0.0;
};

void Earlier(const std::optional<Fall>& other, Fall& fall) {
  if (other && !(fall.fell && fall.time_s <= other->time_s)) fall = *other;
}

FallKind KindOfEnd(StoppedBy by) {
  return by == StoppedBy::kController ? FallKind::kControllerStopped : FallKind::kPhysicsStopped;
}

}  // namespace

Fall FindFall(const MotionPlan& plan, const PlaybackLog& log, const MotionSeries& series, const ScoreOptions& options) {
  Fall fall{false, log.samples.empty() ? log.start_s : log.samples.back().time_s};
  const double log_end = fall.time_s;
  Bounds bounds(options);
  for (std::size_t k = 0; k < series.measured.size() && !fall.fell; ++k) {
    Earlier(bounds.Passed(series.planned[k], series.measured[k]), fall);
  }
  for (const BodyContact& contact : log.body_contacts) {
    Earlier(Fall{true, contact.time_s, FallKind::kBodyContact,
                 fmt::format("'{}', which is not a foot, touched the ground", contact.link)},
            fall);
  }
  if (!log.broke_off.empty() && (!fall.fell || fall.time_s >= log_end))
    fall = {true, log_end, KindOfEnd(log.broke_off_by), log.broke_off};
  if (series.measured.size() < log.samples.size()) {
    Earlier(Fall{true, log.samples[series.measured.size()].time_s, FallKind::kNotFinite,
                 "the physics gave a state that is not finite"},
            fall);
  }
  const double plan_end = plan.whole_body.end_s();
  if (log_end < plan_end - std::max(0.02, 2.0 / log.log_rate_hz)) {
    Earlier(Fall{true, log_end, FallKind::kEndedEarly,
                 fmt::format("the log ends here, before the plan's end at {:.2f} s", plan_end)},
            fall);
  }
  return fall;
}

}  // namespace gaitwright
