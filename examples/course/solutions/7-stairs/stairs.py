# SPDX-License-Identifier: BSD-3-Clause
"""A solution of assignment 7: where a foot would stand near an edge, it stands on the nearest place that is level. SI units."""

import math

import gaitwright as gw

STRIDE = 0.1  # [m], the farthest that the body goes while each foot makes one step
ORDER = ("RR_foot", "FR_foot", "RL_foot", "FL_foot")  # a crawl: of one side the rear foot, then the front foot


MARGIN = 0.04  # [m] from a foot to the nearest edge, before it and behind it
SHIN = 0.08  # [m] behind a foot where no ground is higher: on the way down the shin leans back over it
GRAIN = 0.005  # [m] between places that are looked at


def is_good(terrain, x, y):
    """Whether the ground about a place is as high as the place itself, and none behind it higher."""
    here = terrain.ground_at(x, y)["height_m"]
    about = (-MARGIN, -0.5 * MARGIN, 0.5 * MARGIN, MARGIN)
    is_level = all(abs(terrain.ground_at(x + d, y)["height_m"] - here) < 1e-3 for d in about)
    return is_level and terrain.ground_at(x - SHIN, y)["height_m"] < here + 1e-3


def nearest_good(terrain, x, y):
    """The nearest place before or behind where a foot may stand."""
    for i in range(60):
        for there in (x + i * GRAIN, x - i * GRAIN):
            if is_good(terrain, there, y):
                return there
    raise ValueError(f"no good ground about x = {x:.2f} m")


def plan_steps(robot, terrain, goal):
    """As the body goes on by a stride, each foot in turn goes to where it stands under the body, or near it."""
    standing = {foot: gw.RobotState(robot).contact_frame(foot)[:2, 3] for foot in robot.feet}
    rounds = math.ceil(goal[0] / STRIDE)
    for i in range(1, rounds + 1):
        for foot in ORDER:
            x, y = standing[foot]
            yield foot, nearest_good(terrain, x + goal[0] * i / rounds, y), y, 0.0


if __name__ == "__main__":
    a1, stairs = gw.load_robot("a1"), "stairs:start_m=0.41,rise_m=0.05,tread_m=0.31,count=3,landing_m=2"
    try:
        plan = gw.walk_with(plan_steps, a1, (1.2, 0.0, 0.0), stairs, swing_s=0.4, pause_s=0.15)
        print(gw.audit(plan))
        print(gw.play(plan))
    except gw.GaitwrightError as error:
        print("no walk:", error)
