// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "planning/audit/audit_report.h"
#include "planning/audit/broken_time_internal.h"

namespace gaitwright {

/// Keeps the worst value of each check at each place, and its margin.
class Findings {
 public:
  /// Sets the samples of the plan, over which failures are counted by Broken.
  void SetSamples(double start_s, double rate_hz, int samples) {
    start_s_ = start_s;
    rate_hz_ = rate_hz;
    samples_ = samples;
  }

  /// Adds a place of a check. @return its index for Hold and Near, which do not allocate.
  int Place(Law law, const std::string& where, const std::string& unit);

  /// Value of a place at a time. `room` is the margin to the limit, negative beyond; the check fails if it is less than
  /// -slack or NaN. An infinite limit is ignored.
  void Hold(int place, double at_s, double value, double limit, double room, double slack = 0.0) {
    Near(place, at_s, value, limit, room);
    if (!(room >= -slack)) Break(place, at_s, value, limit);
  }

  /// Like Hold, but never fails the check.
  void Near(int place, double at_s, double value, double limit, double room) {
    Closest& closest = places_[static_cast<std::size_t>(place)];
    if (!(room < closest.room)) return;
    closest = {room, at_s, value, limit};
  }

  /// The smallest margin of a place so far.
  double RoomOf(int place) const { return places_[static_cast<std::size_t>(place)].room; }
  /// Renames a place, for example to the pair of links that is nearest now.
  void Rename(int place, const std::string& where) { names_[static_cast<std::size_t>(place)].where = where; }

  /// Records a value beyond its limit; the worst one is kept for each check and place.
  void Note(Law law, const std::string& where, double at_s, double value, double limit, const char* unit);

  /// Violations by check in the order of AllLaws, then worst first.
  std::vector<Violation> Sorted() const;
  /// For how long each check fails, in the same order.
  std::vector<BrokenTime> Broken() const;
  /// Margins of all places with a finite limit, by check, then smallest first.
  std::vector<AuditMargin> Margins() const;

 private:
  struct Closest {
    double room = 1e300, at_s = 0.0, value = 0.0, limit = 0.0;
  };
  struct Named {
    Law law;
    std::string where, unit;
  };
  void Count(Law law, double at_s);
  void Break(int place, double at_s, double value, double limit);

  std::vector<Closest> places_;
  std::vector<Named> names_;  // by place
  std::map<std::pair<Law, std::string>, std::pair<double, Violation>> worst_;
  double start_s_ = 0.0, rate_hz_ = 1.0;
  int samples_ = 0;
  std::map<Law, std::vector<bool>> fails_;  // by sample
};

}  // namespace gaitwright
