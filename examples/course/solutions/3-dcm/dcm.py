# SPDX-License-Identifier: BSD-3-Clause
"""A solution of assignment 3: Englsberger, Ott and Albu-Schaeffer, T-RO 31(2), 2015."""

import numpy as np

GRAVITY = 9.81  # [m/s^2]


def omega_of(com_height):
    return np.sqrt(GRAVITY / com_height)


def dcm(com, velocity, com_height):
    return com[:2] + velocity[:2] / omega_of(com_height)


def dcm_of_steps(zmp, step_time, com_height):
    """Backward recursion: each step ends where the next one starts, and the last step ends on its own ZMP."""
    shrink = np.exp(-omega_of(com_height) * step_time)
    starts, end = np.zeros_like(zmp), zmp[-1]
    for i in range(len(zmp) - 1, -1, -1):
        starts[i] = zmp[i] + shrink * (end - zmp[i])
        end = starts[i]
    return starts


def dcm_at(zmp, step_time, com_height, times):
    starts = dcm_of_steps(zmp, step_time, com_height)
    step = np.clip(np.floor(times / step_time).astype(int), 0, len(zmp) - 1)
    growth = np.exp(omega_of(com_height) * (times - step * step_time))
    return zmp[step] + growth[:, None] * (starts[step] - zmp[step])


def com_along_dcm(com, dcm_now, zmp, com_height, time):
    """Solution of c' = omega (xi - c) with xi = p + e^{omega t} (xi_0 - p)."""
    away, back = np.exp(omega_of(com_height) * time), np.exp(-omega_of(com_height) * time)
    return zmp + 0.5 * away * (dcm_now - zmp) + 0.5 * back * (2.0 * com - dcm_now - zmp)
