// SPDX-License-Identifier: BSD-3-Clause
#include "workflows/repair/repair_options_internal.h"

namespace gaitwright {

OptionFields RepairOptions::Fields() {
  return WithBasics(
      {"smoothing_hz", "stand_height", "stand_speed", "joint", "base_position", "stretch", "leave_out"},
      {{"smoothing_hz", &smoothing_hz, "Hz", 0.0, 1000.0,
        "Cut-off frequency of the smoothing of the file's positions; 0 chooses it: a fifth of the rate of frames that "
        "are more than 10 ms apart, 8 Hz for noisy positions, otherwise none."},
       {"stand_height", &stand_height, "1", 0.0, 0.5,
        "Largest height at which a foot begins to stand, over the height at which feet stand in the file, as a share "
        "of the leg length."},
       {"stand_speed", &stand_speed, "1", 0.0, 10.0,
        "Largest speed of a foot that begins to stand, as a share of sqrt(g x leg length)."},
       {"stand_tilt_rad", &stand_tilt_rad, "rad", 0.0, 1.5,
        "Largest tilt against the ground of a sole that begins to stand."},
       {"leave", &leave, "1", 1.0, 10.0,
        "Multiple of the height, speed and tilt above at which a foot that stands begins to swing."},
       {"least_stance_s", &least_stance_s, "s", 0.0, 1.0, "Shortest stance; shorter ones become part of a swing."},
       {"least_swing_s", &least_swing_s, "s", 0.0, 1.0, "Shortest swing; shorter ones become part of a stance."},
       {"clearance", &clearance, "1", 0.0, 0.5,
        "Least height of the whole sole in the middle of a swing, as a share of the leg length."},
       {"sole_margin", &sole_margin, "1", 0.0, 0.5,
        "Distance that the pressure under a sole keeps from its edges, as a share of the leg length; at most half "
        "the distance from the middle to the edge. It is given up if no motion keeps it."},
       {"effort_use", &effort_use, "1", 0.1, 1.0,
        "Share of the motors' limits that the motion may use, so that controllers have the rest; nearly all of them if "
        "no motion keeps it."},
       {"base_position", &base_position, "1/m", 0.0, 1e4, "Weight on the distance of the base from the motion."},
       {"base_rotation", &base_rotation, "1/rad", 0.0, 1e4, "Weight on the turn of the base from the motion."},
       {"joint", &joint, "1/rad", 0.0, 1e4, "Weight on the distance of each joint from the motion."},
       {"acceleration", &acceleration, "1", 0.0, 1e3,
        "Multiple of the usual weights on differences of accelerations from the motion."},
       {"effort", &effort, "1", 0.0, 1e3, "Weight on the efforts of motors, as shares of their limits."},
       {"rest_s", &rest_s, "s", 0.1, 5.0,
        "Time over which the motion is brought from rest to its own speed, and back to rest, where it does not begin "
        "or end at rest."},
       {"stretch", &stretch, "1", 1.0, 10.0,
        "Largest factor on the duration of a part that the robot cannot do at its speed: 1.3 lets it take 1.3 times "
        "as long."},
       {"leave_out", &leave_out, "1", 0.0, 1.0,
        "Largest share of the motion that may be left out if the robot cannot do it; the robot then stands. 0: "
        "nothing is left out."},
       {"stretch_over_rad", &stretch_over_rad, "rad", 0.0, 10.0,
        "With stretch: root mean square of the joints' distance from the motion with clean contacts over which a part "
        "is slowed."},
       {"window_s", &window_s, "s", 1.0, 3600.0,
        "Length of the windows in which a long motion is optimised; a motion of up to one and a half windows is "
        "optimised in one."},
       {"overlap_s", &overlap_s, "s", 0.2, 60.0,
        "Time by which a window is optimised beyond the place where the next one begins."}});
}

}  // namespace gaitwright
