# SPDX-License-Identifier: BSD-3-Clause
"""A solution of assignment 8: joint PD about the plan, and swing feet that follow the push. SI units."""

import math

import gaitwright as gw
import numpy as np

REACH = 0.12  # [m], maximum offset of a foot from its plan
SWING_TIME, STANCE_TIME = 0.03, 0.3  # [s], time constants of the offset: growth in swing, decay in stance


def heading(q):
    return 2.0 * math.atan2(q[5], q[6])  # yaw of a nearly level body


def ahead_and_left(q, v):
    """The base's velocity in the directions forward and left."""
    c, s = math.cos(heading(q)), math.sin(heading(q))
    return np.array([c * v[0] + s * v[1], -s * v[0] + c * v[1]])


class CaptureSteps(gw.Controller):
    """PD about the plan with its torques; a swing foot is displaced by sqrt(h / g) times the velocity error.

    There, a pendulum of height h comes to rest (Pratt et al., Humanoids 2006). In stance the offset decays.
    """

    def __init__(self, plan):
        super().__init__()
        self.plan, robot = plan, plan.robot
        self.stiffness, self.damping = gw.derive_gains(robot)
        self.state = gw.RobotState(robot)
        self.feet = [(foot, [robot.joints.index(joint) for joint in gw.leg_joints(robot, foot)]) for foot in robot.feet]
        self.fall_time = math.sqrt(plan.q[0][2] / 9.81)
        self.grid = plan.time_s[1] - plan.time_s[0]
        self.reset()

    def reset(self):
        self.offset = np.zeros((len(self.feet), 2))

    def stands(self, time):
        row = round((time - self.plan.time_s[0]) / self.grid)
        return self.plan.contact[min(max(row, 0), len(self.plan.contact) - 1)]

    def move_offsets(self, now, wanted):
        error = ahead_and_left(now.q, now.v) - ahead_and_left(wanted["q"], wanted["v"])
        there = np.clip(self.fall_time * error, -REACH, REACH)
        stands = self.stands(now.time_s)
        for i in range(len(self.feet)):
            if stands[i]:
                self.offset[i] *= 1.0 - now.step_s / STANCE_TIME
            else:
                self.offset[i] += (there - self.offset[i]) * now.step_s / SWING_TIME

    def update(self, now):
        wanted = self.plan.at(now.time_s + now.step_s)
        self.move_offsets(now, wanted)
        self.state.set(wanted["q"], wanted["v"])
        joints = wanted["q"][7:].copy()
        for (foot, of_leg), offset in zip(self.feet, self.offset):
            if np.abs(offset).max() < 1e-4:
                continue
            jacobian = self.state.jacobian(foot)[:3, 6:][:, of_leg]
            joints[of_leg] += np.linalg.solve(jacobian, np.append(offset, 0.0))
        return gw.JointCommand(joints, wanted["v"][6:], wanted["tau"], self.stiffness, self.damping)


def make_controller(plan):
    return CaptureSteps(plan)
