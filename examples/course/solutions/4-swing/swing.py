# SPDX-License-Identifier: BSD-3-Clause
"""A solution of assignment 4: the minimum-jerk step of Flash and Hogan, J. Neuroscience 5(7), 1985, and a bump."""

import numpy as np


def minimum_jerk(u):
    return np.array([
        10 * u**3 - 15 * u**4 + 6 * u**5,
        30 * u**2 - 60 * u**3 + 30 * u**4,
        60 * u - 180 * u**2 + 120 * u**3,
    ])


def bump(u):
    """64 u^3 (1 - u)^3 and its derivatives by u: up to 1 at 1/2 and back, at rest at both ends."""
    w = u * (1 - u)
    return np.array([64 * w**3, 192 * w**2 * (1 - 2 * u), 384 * w * (1 - 2 * u) ** 2 - 384 * w**2])


def swing(start, end, lift, duration, time):
    """By the chain rule each derivative by time is one by u, divided by the duration."""
    u = time / duration
    along, up = minimum_jerk(u), bump(u)
    rows = np.outer(along, end - start)
    rows[0] += start
    rows[:, 2] += lift * up
    return rows / np.array([[1.0], [duration], [duration**2]])


def swing_over_step(start, end, edge_x, clearance, duration, times):
    """Up at once, ahead in the middle, down at last: each a minimum-jerk step of its own, and they overlap.

    The foot is at its top from 0.4 to 0.6 of the time. Until then it has gone ahead by little, so that it is over the
    edge where the edge is; ahead it goes from 0.15 to 0.85.
    """
    u = times / duration
    rise = minimum_jerk(np.clip(u / 0.4, 0.0, 1.0))[0]
    fall = minimum_jerk(np.clip((u - 0.6) / 0.4, 0.0, 1.0))[0]
    ahead = minimum_jerk(np.clip((u - 0.15) / 0.7, 0.0, 1.0))[0]
    top = max(start[2], end[2]) + clearance + 0.05
    places = start + np.outer(ahead, end - start)
    places[:, 2] = start[2] + (top - start[2]) * rise + (end[2] - top) * fall
    return places
