// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "planning/audit/audit_report.h"

namespace gaitwright {

/// Keeps the worst of each law at each place, and how near to its limit each place comes.
class Findings {
 public:
  /// Names a place that a law is looked at. @return its number for Hold and Near, which allocate nothing.
  int Place(Law law, const std::string& where, const std::string& unit);

  /// What a place has at a time. `room` is how far it is inside of its limit, negative beyond; it breaks its law where
  /// that is less than -slack or no number. A limit that is infinite is none.
  void Hold(int place, double at_s, double value, double limit, double room, double slack = 0.0) {
    Near(place, at_s, value, limit, room);
    if (!(room >= -slack)) Break(place, at_s, value, limit);
  }

  /// The same without a verdict.
  void Near(int place, double at_s, double value, double limit, double room) {
    Closest& closest = places_[static_cast<std::size_t>(place)];
    if (!(room < closest.room)) return;
    closest = {room, at_s, value, limit};
  }

  /// The least room of a place so far.
  double RoomOf(int place) const { return places_[static_cast<std::size_t>(place)].room; }
  /// Gives a place another name, such as that of the pair that is nearest now.
  void Rename(int place, const std::string& where) { names_[static_cast<std::size_t>(place)].where = where; }

  /// Notes a value that is past its limit; the one farthest past it is kept for each law and place.
  void Note(Law law, const std::string& where, double at_s, double value, double limit, const char* unit);

  /// Violations by law in the order of AllLaws, then worst first.
  std::vector<Violation> Sorted() const;
  /// The places that came near a limit at all, by law, then the one with the least to spare first.
  std::vector<AuditMargin> Margins() const;

 private:
  struct Closest {
    double room = 1e300, at_s = 0.0, value = 0.0, limit = 0.0;
  };
  struct Named {
    Law law;
    std::string where, unit;
  };
  void Break(int place, double at_s, double value, double limit);

  std::vector<Closest> places_;
  std::vector<Named> names_;  // by place
  std::map<std::pair<Law, std::string>, std::pair<double, Violation>> worst_;
};

}  // namespace gaitwright
