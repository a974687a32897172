# SPDX-License-Identifier: BSD-3-Clause
"""Assignment 8: a controller that survives pushes. See ../README.md. SI units."""

import math
import random

import gaitwright as gw
import numpy as np


class OpenLoop(gw.Controller):
    """Applies the plan's torques without feedback: the robot falls before its first step."""

    def __init__(self, plan):
        super().__init__()
        self.plan = plan

    def update(self, now):
        """Called every 1 ms. now.q: base (3), quaternion xyzw, joints.  now.v: linear and angular velocity, joint rates."""
        wanted = self.plan.at(now.time_s + now.step_s)
        return gw.JointCommand(now.q[7:], tau_ff=wanted["tau"])


def make_controller(plan):
    return OpenLoop(plan)


def survived(plan, n=10, seed=1):
    """Number of survived playbacks of n, each with a lateral push."""
    draw = random.Random(seed)
    count = 0
    for _ in range(n):
        angle = math.radians(draw.choice((60, 90, 120)) * draw.choice((-1, 1)))
        push = (185 * math.cos(angle), 185 * math.sin(angle), 0.0, draw.uniform(0.3, 0.7) * plan.duration_s, 0.1)
        count += gw.play(plan, make_controller(plan), push=push).metrics["fell"].value == 0
    return count


if __name__ == "__main__":
    trot = gw.plan_walk(gw.load_robot("a1"), gait="trot", speed=0.3, distance=0.6)
    playback = gw.play(trot, make_controller(trot))
    print(f"undisturbed: {playback.reason}")
    if playback.passed:
        print(f"survived {survived(trot)} of 10 pushes")
