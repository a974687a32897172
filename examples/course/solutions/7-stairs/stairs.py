# SPDX-License-Identifier: BSD-3-Clause
"""A solution of assignment 7: a foot that would be near an edge is placed on the nearest level position. SI units."""

import math

import gaitwright as gw

STRIDE = 0.1  # [m], maximum advance of the body while each foot makes one step
ORDER = ("RR_foot", "FR_foot", "RL_foot", "FL_foot")  # a crawl: rear foot, then front foot of each side


MARGIN = 0.04  # [m] from a foot to the nearest edge, forward and backward
SHIN = 0.08  # [m] behind a foot without higher ground, because the shin leans backward on the way down
GRAIN = 0.005  # [m] between tested positions


def is_good(terrain, x, y):
    """Whether the ground around a position has its height, and the ground behind it is not higher."""
    here = terrain.ground_at(x, y)["height_m"]
    about = (-MARGIN, -0.5 * MARGIN, 0.5 * MARGIN, MARGIN)
    is_level = all(abs(terrain.ground_at(x + d, y)["height_m"] - here) < 1e-3 for d in about)
    return is_level and terrain.ground_at(x - SHIN, y)["height_m"] < here + 1e-3


def nearest_good(terrain, x, y):
    """The nearest position along x, forward or backward, where a foot may stand."""
    for i in range(60):
        for there in (x + i * GRAIN, x - i * GRAIN):
            if is_good(terrain, there, y):
                return there
    raise ValueError(f"no suitable ground near x = {x:.2f} m")


def plan_steps(robot, terrain, goal):
    """In each stride of the body, each foot steps to its nominal position below the body, or near it."""
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
        print("no plan:", error)
