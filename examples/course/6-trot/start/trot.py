# SPDX-License-Identifier: BSD-3-Clause
"""Assignment 6: the parameters of a trot. See ../README.md. Plays options, prints the results and writes trot.yaml."""

import gaitwright as gw

OPTIONS = {
    "gait.cycle_s": 2.0,  # time from one touch-down of a foot to the next
    "gait.duty_factor": 0.75,  # fraction of the cycle that a foot is on the ground
    "swing.height_m": 0.01,  # height of the swing's bump
}
SPEEDS = (0.3, 0.6, 0.9)  # [m/s]


def tried(robot, options, speed):
    """The measured values of a trot in physics, or None; and the reason of the verdict or failure."""
    try:
        plan = gw.plan_walk(robot, gait="trot", speed=speed, distance=1.5, options=options)
    except gw.GaitwrightError as error:
        return None, str(error)
    playback = gw.play(plan)
    figures = {key: playback.metrics[key].value for key in ("clearance_min_m", "joint_speed_use_max", "cost_of_transport")}
    return figures, playback.reason


def write(options, path="trot.yaml"):
    with open(path, "w", encoding="utf-8") as file:
        file.writelines(f"{key}: {value}\n" for key, value in options.items())


if __name__ == "__main__":
    a1 = gw.load_robot("a1")
    for speed in SPEEDS:
        figures, reason = tried(a1, OPTIONS, speed)
        print(f"{speed} m/s: {figures}: {reason}")
    write(OPTIONS)
