# SPDX-License-Identifier: BSD-3-Clause
"""Assignment 4: swing trajectories of a foot. See ../README.md. SI units; z is up."""

import numpy as np


def minimum_jerk(u):
    """Value, first and second derivative at u in [0, 1] of the minimum-jerk curve from 0 to 1, at rest at both ends."""
    return np.array([u, 1.0, 0.0])  # constant speed: the foot is not at rest at lift-off and touch-down


def swing(start, end, lift, duration, time):
    """Position [m], velocity [m/s] and acceleration [m/s^2] (3 x 3, one row each) of a swing at a time [s].

    Minimum jerk from start (3) to end (3), and a bump of `lift` [m] along z at half time.
    """
    share = time / duration
    return np.array([start + share * (end - start), (end - start) / duration, np.zeros(3)])


def swing_over_step(start, end, edge_x, clearance, duration, times):
    """Positions (m x 3) [m] at times [s] of a swing up or down a step.

    The ground has the height of the start before edge_x, and the height of the end from edge_x on.
    """
    return start + np.outer(times / duration, end - start)  # a straight line goes through the edge


if __name__ == "__main__":
    print("minimum jerk at 1/4:", minimum_jerk(0.25), "expected [0.1035 1.0547 5.625]")
    middle = swing(np.zeros(3), np.array([0.2, 0.0, 0.0]), 0.05, 0.4, 0.2)
    print("at half time:", middle.round(4).tolist(), "expected [[0.1, 0.0, 0.05], [0.9375, 0.0, 0.0], [0.0, 0.0, -7.5]]")
    times = np.linspace(0.0, 0.5, 101)
    start, end = np.zeros(3), np.array([0.2, 0.0, 0.08])
    path = swing_over_step(start, end, 0.12, 0.02, 0.5, times)
    ground = np.where(path[:, 0] < 0.12, 0.0, 0.08)
    inner = (path[:, 0] > 0.05) & (path[:, 0] < 0.15)
    print(f"height above the ground: {(path[:, 2] - ground).min():.4f} m, expected 0 or more; in the middle "
          f"{(path[:, 2] - ground)[inner].min():.4f} m, expected 0.02 or more")
