// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "playback/engine/world.h"
#include "playback/log/playback_log.h"

namespace gaitwright::playing {

/// Builds stances from contacts, one step at a time.
class StanceRecorder {
 public:
  StanceRecorder(int num_feet, double weight_n, double step_s, double smoothing_s);

  /// @param time_s  at the step's start.
  void Add(double time_s, const std::vector<FootContact>& feet);

  /// All stances, sorted by touch-down, then foot. Stances of feet that still stand end at `end_s`.
  std::vector<StanceRecord> Finish(double end_s);

 private:
  struct Foot {
    bool standing = false;
    double last_touch_s = 0.0;  ///< end of the last step with force
    double smooth_normal_n = 0.0;
    double last_speed_m_s = 0.0;
    StanceRecord stance;
  };
  void TouchDown(int index, double time_s, const FootContact& contact);
  void AddContact(Foot& foot, double time_s, const FootContact& contact);

  double weight_n_, step_s_, smoothing_s_;
  std::vector<Foot> feet_;
  std::vector<StanceRecord> done_;
};

}  // namespace gaitwright::playing
