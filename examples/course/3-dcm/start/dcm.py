# SPDX-License-Identifier: BSD-3-Clause
"""Assignment 3: planning with the divergent component of motion. See ../README.md. SI units."""

import numpy as np

GRAVITY = 9.81  # [m/s^2]


def dcm(com, velocity, com_height):
    """The divergent component of motion (x, y), from the centre of mass (3) [m] and its velocity (3) [m/s]."""
    return com[:2]  # correct only for a body at rest


def dcm_of_steps(zmp, step_time, com_height):
    """The DCM at the start of each step (n x 2), for which the DCM is at rest on the last ZMP when the last step ends.

    zmp: the ZMP of each step, constant during the step (n x 2) [m].  step_time: duration of each step [s].
    """
    return zmp  # correct only for a body that stays over its foot


def dcm_at(zmp, step_time, com_height, times):
    """The DCM of the plan of dcm_of_steps at times [s] since the start of the first step (m x 2)."""
    return np.zeros((len(times), 2))


def com_along_dcm(com, dcm_now, zmp, com_height, time):
    """The centre of mass (2) after a time [s] with constant ZMP (2), from a centre of mass (2) and a DCM (2)."""
    return com


if __name__ == "__main__":
    steps = np.array([[0.0, 0.1], [0.2, -0.1], [0.4, 0.1]])
    print("DCM of a body that moves forward:", dcm(np.zeros(3), np.array([0.5, 0.0, 0.0]), 0.8), "expected [0.1428 0]")
    print("DCM at the starts:", np.round(dcm_of_steps(steps, 0.8, 0.8), 4).tolist(), "expected [[0.0129, 0.0886], ...]")
    print("DCM at the end:", dcm_at(steps, 0.8, 0.8, np.array([2.4]))[0], "expected [0.4 0.1]")
    moved = com_along_dcm(np.zeros(2), np.array([0.1, 0.0]), np.zeros(2), 0.8, 0.3)
    print("a body that was pushed:", np.round(moved, 4).tolist(), "expected [0.1255, 0.0]")
