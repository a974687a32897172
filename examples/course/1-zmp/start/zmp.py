# SPDX-License-Identifier: BSD-3-Clause
"""Assignment 1: the zero-moment point and the support polygon. See ../README.md. SI units; z is up."""

import numpy as np

GRAVITY = 9.81  # [m/s^2]


def pendulum_zmp(com, acceleration, com_height):
    """ZMP (x, y) of a linear inverted pendulum with constant height.

    com: centre of mass (3) [m].  acceleration: of the centre of mass (3) [m/s^2].  com_height: height above the ground [m].
    """
    return com[:2]  # correct only for a body at rest


def wrench_zmp(point, force, moment, ground_height):
    """Point (x, y) of level ground about which a wrench has no horizontal moment.

    point: where the force acts (3) [m].  force (3) [N].  moment: about `point` (3) [N m].  ground_height [m].
    """
    return point[:2]  # correct only for a vertical force without moment


def contacts_zmp(points, forces, ground_height):
    """ZMP (x, y) of several forces (n x 3) [N], each of which acts at one of the points (n x 3) [m]."""
    return points[:, :2].mean(axis=0)  # correct only for equal forces


def support_polygon(points):
    """Corners of the convex hull of points (n x 2) [m], counter-clockwise, none of them on an edge."""
    return points  # correct only if the points are the ordered corners


def support_margin(corners, point):
    """Distance of a point (2) to the edge of a convex polygon (n x 2, counter-clockwise) [m], negative outside."""
    return np.linalg.norm(corners - point, axis=1).min()  # the nearest corner is farther than the nearest edge


def show(what, got, wanted):
    print(f"{what}: {np.round(got, 4).tolist()}, expected {wanted}")


if __name__ == "__main__":
    show("forward acceleration", pendulum_zmp(np.array([0.0, 0.0, 0.5]), np.array([1.0, 0.0, 0.0]), 0.5), [-0.051, 0.0])
    show("inclined force", wrench_zmp(np.array([0.0, 0.0, 0.5]), np.array([10.0, 0.0, 100.0]), np.zeros(3), 0.0), [-0.05, 0.0])
    two = np.array([[0.0, 0.1, 0.0], [0.0, -0.1, 0.0]])
    show("two feet", contacts_zmp(two, np.array([[0.0, 0.0, 75.0], [0.0, 0.0, 25.0]]), 0.0), [0.0, 0.05])
    square = np.array([[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]])
    show("corners", len(support_polygon(np.vstack([square, [[0.5, 0.5], [0.5, 0.0]]]))), 4)
    show("inside", support_margin(square, np.array([0.5, 0.4])), 0.4)
    show("outside", support_margin(square, np.array([1.3, 1.4])), -0.5)
