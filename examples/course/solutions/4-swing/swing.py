# SPDX-License-Identifier: BSD-3-Clause
"""A solution of assignment 4: the minimum-jerk curve of Flash and Hogan, J. Neuroscience 5(7), 1985, and a bump."""

import numpy as np


def minimum_jerk(u):
    return np.array([
        10 * u**3 - 15 * u**4 + 6 * u**5,
        30 * u**2 - 60 * u**3 + 30 * u**4,
        60 * u - 180 * u**2 + 120 * u**3,
    ])


def bump(u):
    """64 u^3 (1 - u)^3 and its derivatives with respect to u: 1 at u = 1/2, 0 and at rest at both ends."""
    w = u * (1 - u)
    return np.array([64 * w**3, 192 * w**2 * (1 - 2 * u), 384 * w * (1 - 2 * u) ** 2 - 384 * w**2])


def swing(start, end, lift, duration, time):
    """By the chain rule, a derivative with respect to time is the derivative with respect to u divided by the duration."""
    u = time / duration
    along, up = minimum_jerk(u), bump(u)
    rows = np.outer(along, end - start)
    rows[0] += start
    rows[:, 2] += lift * up
    return rows / np.array([[1.0], [duration], [duration**2]])


def swing_over_step(start, end, edge_x, clearance, duration, times):
    """The foot moves up first, forward in the middle and down at the end: three minimum-jerk curves that overlap in time.

    It moves forward from 0.15 to 0.85 of the duration, and is at its highest position from 0.4 to 0.6. Therefore it is
    high enough when it passes the edge.
    """
    u = times / duration
    rise = minimum_jerk(np.clip(u / 0.4, 0.0, 1.0))[0]
    fall = minimum_jerk(np.clip((u - 0.6) / 0.4, 0.0, 1.0))[0]
    ahead = minimum_jerk(np.clip((u - 0.15) / 0.7, 0.0, 1.0))[0]
    top = max(start[2], end[2]) + clearance + 0.05
    places = start + np.outer(ahead, end - start)
    places[:, 2] = start[2] + (top - start[2]) * rise + (end[2] - top) * fall
    return places
