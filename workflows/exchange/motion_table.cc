// SPDX-License-Identifier: BSD-3-Clause
#include "workflows/exchange/motion_table.h"

#include <fmt/format.h>

#include <utility>

#include "kinematics/base/result.h"

namespace gaitwright {

namespace {

constexpr double kFinestGrid = 0.0005, kCoarsestGrid = 0.01;  // [s]

}  // namespace

double ImportOptions::time_unit_s() const {
  if (time_unit == "ms") return 1e-3;
  if (time_unit == "us") return 1e-6;
  return time_unit == "ns" ? 1e-9 : 1.0;
}

OptionFields ImportOptions::UnitFields() {
  return {{"quaternion_order",
           &quaternion_order,
           "",
           0.0,
           0.0,
           "Order of the base's quaternion in the four columns that are named for it: as their names say, unless the "
           "motion speaks against it, or as said here without a look at the motion.",
           {"detect", "xyzw", "wxyz"}},
          {"angle_unit",
           &angle_unit,
           "",
           0.0,
           0.0,
           "Of angles and their rates whose names end in rad or have no unit: rad, unless the motion speaks against "
           "it, or as said here.",
           {"detect", "rad", "deg"}},
          {"length_unit",
           &length_unit,
           "",
           0.0,
           0.0,
           "Of lengths and their rates: m, unless the motion speaks against it, or as said here.",
           {"detect", "m", "mm"}},
          {"time_unit",
           &time_unit,
           "",
           0.0,
           0.0,
           "Of times: s, unless the motion speaks against it, or as said here; rates are per second all the same.",
           {"detect", "s", "ms", "us", "ns"}}};
}

OptionFields ImportOptions::Fields() {
  OptionFields fields = {
      {"velocities",
       &velocities,
       "",
       0.0,
       0.0,
       "Joint velocities as the file has them, or from the positions.",
       {"given", "derived"}},
      {"missing_joints",
       &missing_joints,
       "",
       0.0,
       0.0,
       "A joint that the file does not have is refused, or stays where it is in the standing posture.",
       {"refuse", "standing"}},
      {"grid_step_s",
       &grid_step_s,
       "s",
       0.0,
       kCoarsestGrid,
       "Step of the plan's uniform grid, 0.0005 or more; 0 takes the file's own where it is even and of 1 to 10 ms, "
       "else 5 ms.",
       {}},
      {"smoothing_hz",
       &smoothing_hz,
       "Hz",
       0.0,
       1000.0,
       "Positions are smoothed above this frequency before they are differentiated; 0 leaves them as they are.",
       {}},
      {"lift_m", &lift_m, "m", -10.0, 10.0, "Added to the height of the base.", {}},
      {"contact_height",
       &contact_height,
       "1",
       0.0,
       0.5,
       "A foot stands, where no column says so, when it is no higher over the ground than this share of the leg, and",
       {}},
      {"contact_speed", &contact_speed, "1", 0.0, 10.0, "no faster than this share of sqrt(g leg).", {}},
      {"contact_least_s",
       &contact_least_s,
       "s",
       0.0,
       1.0,
       "Contacts and gaps between them that are shorter are none.",
       {}},
      {"load_ramp_s",
       &load_ramp_s,
       "s",
       0.0,
       1.0,
       "Longest time in which a foot takes up its load after touch-down and gives it up before lift-off.",
       {}},
      {"friction_use",
       &friction_use,
       "1",
       0.05,
       1.0,
       "Share of the ground's friction that contact forces may use where they are worked out.",
       {}}};
  return Joined({UnitFields(), std::move(fields)});
}

void CheckImportOptions(ImportOptions options) {
  CheckOptions(options.Fields());
  if (options.grid_step_s == 0.0 || options.grid_step_s >= kFinestGrid) return;
  throw InvalidArgument(fmt::format("option 'grid_step_s' is {} s; accepted: 0, and {} to {}", options.grid_step_s,
                                    kFinestGrid, kCoarsestGrid));
}

}  // namespace gaitwright
