# SPDX-License-Identifier: BSD-3-Clause
"""Assignment 5: inverse kinematics of a leg. See ../README.md. SI units; x is ahead, y to the left, z up."""

import numpy as np

# The legs of the A1 by the names of their feet: the hip in the base [m], and on which side the thigh is of it.
A1_HIPS = {
    "FL_foot": (np.array([0.1805, 0.047, 0.0]), 1.0),
    "FR_foot": (np.array([0.1805, -0.047, 0.0]), -1.0),
    "RL_foot": (np.array([-0.1805, 0.047, 0.0]), 1.0),
    "RR_foot": (np.array([-0.1805, -0.047, 0.0]), -1.0),
}
A1_SIDE, A1_THIGH, A1_SHANK = 0.0838, 0.2, 0.2  # [m]
A1_LOWER, A1_UPPER = np.array([-0.80285, -1.04719, -2.69653]), np.array([0.80285, 4.18879, -0.9163])  # [rad]

# The leg of NAO from the hip on: of each joint its place in the frame of the joint before [m] and its axis, for the left leg.
NAO_PLACES = np.array([[0.0, 0.05, -0.085], [0, 0, 0], [0, 0, 0], [0, 0, -0.1], [0, 0, -0.1029], [0, 0, 0]])
NAO_AXES = np.array([[0.0, 0.5**0.5, -(0.5**0.5)], [1, 0, 0], [0, 1, 0], [0, 1, 0], [0, 1, 0], [1, 0, 0]])
NAO_SOLE = np.array([0.0315, 0.006, -0.04511])  # [m], the middle of the sole in the frame of the last joint
NAO_LOWER = {
    "l_ankle": np.array([-1.14529, -0.37943, -1.53589, -0.09232, -1.18944, -0.39776]),
    "r_ankle": np.array([-1.14529, -0.79046, -1.53589, -0.09232, -1.1863, -0.76899]),
}
NAO_UPPER = {
    "l_ankle": np.array([0.74071, 0.79046, 0.48398, 2.11255, 0.92258, 0.76899]),
    "r_ankle": np.array([0.74071, 0.37943, 0.48398, 2.11255, 0.932, 0.39776]),
}


def mirrored(vector, foot):
    """Of the left leg that of the right one, its y turned round."""
    return vector * np.array([1.0, 1.0 if foot == "l_ankle" else -1.0, 1.0])


def turned(axis, angle):
    """The rotation by an angle about an axis of length 1 (Rodrigues)."""
    x, y, z = axis
    K = np.array([[0.0, -z, y], [z, 0.0, -x], [-y, x, 0.0]])
    return np.eye(3) + np.sin(angle) * K + (1.0 - np.cos(angle)) * K @ K


def nao_axis(joint, foot):
    """Of the right leg: hip yaw and pitch are one joint, which turns both legs alike about axes that mirror each other."""
    axis = NAO_AXES[joint]
    return axis * np.array([1.0, 1.0, -1.0]) if foot == "r_ankle" and joint == 0 else axis


def nao_foot(foot, joints):
    """Place (3) and rotation (3 x 3) of the middle of NAO's sole in its base."""
    place, rotation = np.zeros(3), np.eye(3)
    for i in range(6):
        place = place + rotation @ mirrored(NAO_PLACES[i], foot)
        rotation = rotation @ turned(nao_axis(i, foot), joints[i])
    return place + rotation @ mirrored(NAO_SOLE, foot), rotation


def a1_leg_fk(foot, joints):
    """The middle of the foot in the base (3) [m] at joints (3) [rad]: abduction, hip, knee."""
    return A1_HIPS[foot][0]


def a1_leg_ik(foot, place):
    """Joints (3) [rad] within their limits that bring the foot to a place in the base (3) [m]."""
    return np.array([0.0, 0.9, -1.8])  # always the same posture


def nao_leg_ik(foot, place, rotation):
    """Joints (6) [rad] within their limits that bring the sole to a place (3) and rotation (3 x 3) in the base."""
    return np.array([0.0, 0.0, -0.4, 0.9, -0.5, 0.0])  # always the same posture


if __name__ == "__main__":
    print("A1, straight leg:", a1_leg_fk("FL_foot", np.zeros(3)), "to be [0.1805 0.1308 -0.4]")
    place = np.array([0.2, 0.12, -0.27])
    print("A1, there and back:", a1_leg_fk("FL_foot", a1_leg_ik("FL_foot", place)), "to be", place)
    place, rotation = nao_foot("l_ankle", np.array([-0.2, 0.1, -0.6, 1.1, -0.5, -0.1]))
    reached = nao_foot("l_ankle", nao_leg_ik("l_ankle", place, rotation))[0]
    print("NAO, there and back:", reached.round(4), "to be", place.round(4))
