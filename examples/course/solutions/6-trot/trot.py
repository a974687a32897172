# SPDX-License-Identifier: BSD-3-Clause
"""A solution of assignment 6: first the candidates that the geometry allows, then the cheapest of them in physics."""

import gaitwright as gw

SPEEDS = (0.3, 0.6, 0.9)  # [m/s]
LEAST_CLEARANCE, MOST_SPEED_USE = 0.035, 0.85
LONGEST_STANCE = 0.33  # [m], length of a stance at the top speed: 0.8 leg lengths
QUICKEST_SWING = 0.2  # [s]


def candidates():
    """Cycle times and duty factors with stances short enough for the leg and swings slow enough for the joints."""
    for cycle in (0.4, 0.45, 0.5, 0.55):
        for duty in (0.55, 0.6):
            if duty * cycle * SPEEDS[-1] <= LONGEST_STANCE and (1.0 - duty) * cycle >= QUICKEST_SWING:
                yield {"gait.cycle_s": cycle, "gait.duty_factor": duty, "swing.height_m": 0.08}


def cost(robot, options):
    """Cost of transport at the top speed; None if a limit is violated."""
    try:
        plan = gw.plan_walk(robot, gait="trot", speed=SPEEDS[-1], distance=1.5, options=options)
    except gw.InfeasibleError:
        return None
    playback = gw.play(plan)
    value = {key: metric.value for key, metric in playback.metrics.items()}
    kept = value["clearance_min_m"] >= LEAST_CLEARANCE and value["joint_speed_use_max"] <= MOST_SPEED_USE
    return value["cost_of_transport"] if playback.passed and kept else None


if __name__ == "__main__":
    a1 = gw.load_robot("a1")
    best, least = None, float("inf")
    for options in candidates():
        found = cost(a1, options)
        print(options, found)
        if found is not None and found < least:
            best, least = options, found
    with open("trot.yaml", "w", encoding="utf-8") as file:
        file.writelines(f"{key}: {value}\n" for key, value in best.items())
