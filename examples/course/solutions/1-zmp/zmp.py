# SPDX-License-Identifier: BSD-3-Clause
"""A solution of assignment 1."""

import numpy as np

GRAVITY = 9.81  # [m/s^2]


def pendulum_zmp(com, acceleration, com_height):
    """c - (h / g) c'': Kajita et al., ICRA 2003."""
    return com[:2] - com_height / GRAVITY * acceleration[:2]


def wrench_zmp(point, force, moment, ground_height):
    """The point Z where the horizontal moment vanishes: M + (P - Z) x F = 0 in x and y."""
    height = point[2] - ground_height
    x = point[0] - (moment[1] + height * force[0]) / force[2]
    y = point[1] + (moment[0] - height * force[1]) / force[2]
    return np.array([x, y])


def contacts_zmp(points, forces, ground_height):
    """All forces as one wrench about the origin."""
    return wrench_zmp(np.zeros(3), forces.sum(axis=0), np.cross(points, forces).sum(axis=0), ground_height)


def turn(a, b, c):
    """Twice the signed area of a triangle: positive if a, b, c turn left."""
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])


def lower_chain(points):
    """Lower chain of the convex hull of points sorted by x (Andrew 1979)."""
    chain = []
    for p in points:
        while len(chain) > 1 and turn(chain[-2], chain[-1], p) <= 1e-12:
            chain.pop()
        chain.append(p)
    return chain


def support_polygon(points):
    ordered = sorted(map(tuple, points))
    return np.array(lower_chain(ordered)[:-1] + lower_chain(ordered[::-1])[:-1])


def support_margin(corners, point):
    """Distance to the nearest point of all edges. The point is inside if it is to the left of every edge."""
    inside, nearest = True, np.inf
    for a, b in zip(corners, np.roll(corners, -1, axis=0)):
        share = np.clip((point - a) @ (b - a) / ((b - a) @ (b - a)), 0.0, 1.0)
        nearest = min(nearest, np.linalg.norm(a + share * (b - a) - point))
        inside = inside and turn(a, b, point) >= 0.0
    return nearest if inside else -nearest
