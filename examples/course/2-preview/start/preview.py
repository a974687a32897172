# SPDX-License-Identifier: BSD-3-Clause
"""Assignment 2: preview control of the zero-moment point. See ../README.md. SI units."""

import numpy as np

GRAVITY = 9.81  # [m/s^2]


def cart_table(com_height, step):
    """Cart-table model in discrete time: x' = A x + b jerk, zmp = c x, with x = (position, rate, acceleration)."""
    A = np.array([[1.0, step, step**2 / 2], [0.0, 1.0, step], [0.0, 0.0, 1.0]])
    b = np.array([step**3 / 6, step**2 / 2, step])
    c = np.array([1.0, 0.0, -com_height / GRAVITY])
    return A, b, c


def preview_gains(com_height, step, preview, error_weight, jerk_weight):
    """The gains of the preview controller: K_i, the three elements of K_x, then f_1 to f_N, N = preview / step.

    com_height [m], step and preview [s], error_weight Q [1/m^2], jerk_weight R [s^6/m^2].
    """
    count = round(preview / step)
    return np.zeros(4 + count)  # zero gains: the cart does not move


def follow_zmp(reference, com, com_height, step, preview, error_weight, jerk_weight):
    """The centre of mass at each sample, for which the ZMP follows the reference (one value per step) [m].

    It starts at rest at `com`. Beyond the end of the reference, its last value holds.
    """
    return np.full(len(reference), com)  # the body does not move


if __name__ == "__main__":
    gains = preview_gains(0.8, 0.005, 1.6, 1.0, 1e-6)
    print("K_i", round(gains[0], 2), "expected 621.16;  K_x", np.round(gains[1:4], 2).tolist())
    print("f_1", round(gains[4], 2), "expected 621.16")
    print(f"should be nearly equal: K_x,1 = {gains[1]:.0f}, and the sum of all f = {gains[4:].sum():.0f}")
    steps = np.repeat([0.0, 0.0, 0.2, 0.4, 0.4, 0.4], 160)
    com = follow_zmp(steps, 0.0, 0.8, 0.005, 1.6, 1.0, 1e-6)
    zmp = com - 0.8 / GRAVITY * np.gradient(np.gradient(com, 0.005), 0.005)
    print(f"final position {com[-1]:.3f} m, expected 0.400; mean error of the ZMP {np.abs(zmp - steps).mean():.4f} m")
