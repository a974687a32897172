# SPDX-License-Identifier: BSD-3-Clause
"""Assignment 7: a footstep planner for stairs. See ../README.md. SI units."""

import math

import gaitwright as gw

STRIDE = 0.1  # [m], maximum advance of the body while each foot makes one step
ORDER = ("RR_foot", "FR_foot", "RL_foot", "FL_foot")  # a crawl: rear foot, then front foot of each side


def plan_steps(robot, terrain, goal):
    """Yields the steps (foot, x, y, yaw) in order, until the body is at the goal (x, y, yaw) [m, m, rad].

    terrain.ground_at(x, y)["height_m"] is the height of the ground.
    """
    standing = {foot: gw.RobotState(robot).contact_frame(foot)[:2, 3] for foot in robot.feet}
    rounds = math.ceil(goal[0] / STRIDE)
    for i in range(1, rounds + 1):
        for foot in ORDER:
            x, y = standing[foot]
            yield foot, x + goal[0] * i / rounds, y, 0.0  # even on an edge


if __name__ == "__main__":
    a1, stairs = gw.load_robot("a1"), "stairs:start_m=0.41,rise_m=0.05,tread_m=0.31,count=3,landing_m=2"
    try:
        plan = gw.walk_with(plan_steps, a1, (1.2, 0.0, 0.0), stairs, swing_s=0.4, pause_s=0.15)
        print(gw.audit(plan))
        print(gw.play(plan))
    except gw.GaitwrightError as error:
        print("no plan:", error)
