# SPDX-License-Identifier: BSD-3-Clause
"""A solution of assignment 2: Kajita et al., ICRA 2003, with the summed error of Katayama et al., 1985."""

import numpy as np

GRAVITY = 9.81  # [m/s^2]


def cart_table(com_height, step):
    A = np.array([[1.0, step, step**2 / 2], [0.0, 1.0, step], [0.0, 0.0, 1.0]])
    b = np.array([step**3 / 6, step**2 / 2, step])
    c = np.array([1.0, 0.0, -com_height / GRAVITY])
    return A, b, c


def with_error(A, b, c):
    """The system whose first state is the ZMP error; the others are the increments of x."""
    big = np.zeros((4, 4))
    big[0, 0] = 1.0
    big[0, 1:] = c @ A
    big[1:, 1:] = A
    return big, np.concatenate([[c @ b], b])


def riccati(A, b, Q, R):
    """P of the discrete algebraic Riccati equation, by backward iteration until P does not change."""
    P = Q.copy()
    for _ in range(100000):
        Pb, PA = P @ b, P @ A
        following = A.T @ PA - np.outer(A.T @ Pb, b @ PA) / (R + b @ Pb) + Q
        change = np.abs(following - P).max()
        P = following
        if change <= 1e-13 * np.abs(P).max():
            break
    return P


def preview_gains(com_height, step, preview, error_weight, jerk_weight):
    A, b = with_error(*cart_table(com_height, step))
    Q = np.zeros((4, 4))
    Q[0, 0] = error_weight
    P = riccati(A, b, Q, jerk_weight)
    scale = 1.0 / (jerk_weight + b @ P @ b)
    K = scale * (b @ P @ A)
    closed = A - np.outer(b, K)
    pulled, ahead = P[:, 0], []
    for _ in range(round(preview / step)):
        ahead.append(scale * (b @ pulled))
        pulled = closed.T @ pulled
    return np.concatenate([K, ahead])


def follow_zmp(reference, com, com_height, step, preview, error_weight, jerk_weight):
    A, b, c = cart_table(com_height, step)
    gains = preview_gains(com_height, step, preview, error_weight, jerk_weight)
    K_i, K_x, f = gains[0], gains[1:4], gains[4:]
    beyond = K_x[0] - f.sum()  # beyond the preview the reference is constant
    padded = np.concatenate([reference, np.full(len(f) + 1, reference[-1])])
    x, summed, path = np.array([com, 0.0, 0.0]), 0.0, []
    for k in range(len(reference)):
        path.append(x[0])
        summed += c @ x - reference[k]
        ahead = padded[k + 1 : k + 1 + len(f)]
        x = A @ x + b * (-K_i * summed - K_x @ x + f @ ahead + beyond * ahead[-1])
    return np.array(path)
