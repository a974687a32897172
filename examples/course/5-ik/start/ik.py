# SPDX-License-Identifier: BSD-3-Clause
"""Assignment 5: inverse kinematics of a leg. See ../README.md. SI units; x is forward, y to the left, z up."""

import numpy as np

# For each foot of the A1: the position of the hip in the base [m], and the side of the thigh (1 left, -1 right).
A1_HIPS = {
    "FL_foot": (np.array([0.1805, 0.047, 0.0]), 1.0),
    "FR_foot": (np.array([0.1805, -0.047, 0.0]), -1.0),
    "RL_foot": (np.array([-0.1805, 0.047, 0.0]), 1.0),
    "RR_foot": (np.array([-0.1805, -0.047, 0.0]), -1.0),
}
A1_SIDE, A1_THIGH, A1_SHANK = 0.0838, 0.2, 0.2  # [m]
A1_LOWER, A1_UPPER = np.array([-0.80285, -1.04719, -2.69653]), np.array([0.80285, 4.18879, -0.9163])  # [rad]

# The left leg of NAO from the hip on: position [m] and axis of each joint in the frame of the previous joint.
NAO_PLACES = np.array([[0.0, 0.05, -0.085], [0, 0, 0], [0, 0, 0], [0, 0, -0.1], [0, 0, -0.1029], [0, 0, 0]])
NAO_AXES = np.array([[0.0, 0.5**0.5, -(0.5**0.5)], [1, 0, 0], [0, 1, 0], [0, 1, 0], [0, 1, 0], [1, 0, 0]])
NAO_SOLE = np.array([0.0315, 0.006, -0.04511])  # [m], centre of the sole in the frame of the last joint
NAO_LOWER = {
    "l_ankle": np.array([-1.14529, -0.37943, -1.53589, -0.09232, -1.18944, -0.39776]),
    "r_ankle": np.array([-1.14529, -0.79046, -1.53589, -0.09232, -1.1863, -0.76899]),
}
NAO_UPPER = {
    "l_ankle": np.array([0.74071, 0.79046, 0.48398, 2.11255, 0.92258, 0.76899]),
    "r_ankle": np.array([0.74071, 0.37943, 0.48398, 2.11255, 0.932, 0.39776]),
}


def mirrored(vector, foot):
    """A vector of the left leg, mirrored (y negated) for the right leg."""
    return vector * np.array([1.0, 1.0 if foot == "l_ankle" else -1.0, 1.0])


def turned(axis, angle):
    """Rotation matrix for an angle about a unit axis (Rodrigues)."""
    x, y, z = axis
    K = np.array([[0.0, -z, y], [z, 0.0, -x], [-y, x, 0.0]])
    return np.eye(3) + np.sin(angle) * K + (1.0 - np.cos(angle)) * K @ K


def nao_axis(joint, foot):
    """Axis of a joint. Hip yaw and pitch are one joint: it rotates both legs by the same angle, about mirrored axes."""
    axis = NAO_AXES[joint]
    return axis * np.array([1.0, 1.0, -1.0]) if foot == "r_ankle" and joint == 0 else axis


def nao_foot(foot, joints):
    """Position (3) and rotation (3 x 3) of the centre of NAO's sole in the base."""
    place, rotation = np.zeros(3), np.eye(3)
    for i in range(6):
        place = place + rotation @ mirrored(NAO_PLACES[i], foot)
        rotation = rotation @ turned(nao_axis(i, foot), joints[i])
    return place + rotation @ mirrored(NAO_SOLE, foot), rotation


def a1_leg_fk(foot, joints):
    """Centre of the foot in the base (3) [m] for joint positions (3) [rad]: abduction, hip, knee."""
    return A1_HIPS[foot][0]


def a1_leg_ik(foot, place):
    """Joint positions (3) [rad] within their limits, for which the foot is at a position in the base (3) [m]."""
    return np.array([0.0, 0.9, -1.8])  # always the same posture


def nao_leg_ik(foot, place, rotation):
    """Joint positions (6) [rad] within their limits, for which the sole has a position (3) and rotation (3 x 3) in the base."""
    return np.array([0.0, 0.0, -0.4, 0.9, -0.5, 0.0])  # always the same posture


if __name__ == "__main__":
    print("A1, straight leg:", a1_leg_fk("FL_foot", np.zeros(3)), "expected [0.1805 0.1308 -0.4]")
    place = np.array([0.2, 0.12, -0.27])
    print("A1, forward of inverse:", a1_leg_fk("FL_foot", a1_leg_ik("FL_foot", place)), "expected", place)
    place, rotation = nao_foot("l_ankle", np.array([-0.2, 0.1, -0.6, 1.1, -0.5, -0.1]))
    reached = nao_foot("l_ankle", nao_leg_ik("l_ankle", place, rotation))[0]
    print("NAO, forward of inverse:", reached.round(4), "expected", place.round(4))
