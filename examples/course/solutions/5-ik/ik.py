# SPDX-License-Identifier: BSD-3-Clause
"""A solution of assignment 5. SI units; x is forward, y to the left, z up."""

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
    """Hip and knee move the leg in a plane, and abduction rotates this plane about x."""
    hip, side = A1_HIPS[foot]
    abduction, thigh, knee = joints
    along = -A1_THIGH * np.sin(thigh) - A1_SHANK * np.sin(thigh + knee)
    down = -A1_THIGH * np.cos(thigh) - A1_SHANK * np.cos(thigh + knee)
    return hip + turned(np.array([1.0, 0.0, 0.0]), abduction) @ np.array([along, side * A1_SIDE, down])


def into_limits(joints, lower, upper):
    """The same posture, with each angle moved by whole turns as close as possible to the middle of its range."""
    middle = 0.5 * (lower + upper)
    return joints - 2.0 * np.pi * np.round((joints - middle) / (2.0 * np.pi))


def beyond(joints, lower, upper):
    return max((lower - joints).max(), (joints - upper).max())


def a1_leg_ik(foot, place):
    """The knee has one bending direction, and the leg can point down from the hip or up: the solution within the limits."""
    hip, side = A1_HIPS[foot]
    x, y, z = place - hip
    depth = np.sqrt(max(y * y + z * z - A1_SIDE**2, 0.0))
    cosine = (x * x + depth**2 - A1_THIGH**2 - A1_SHANK**2) / (2.0 * A1_THIGH * A1_SHANK)
    knee = -np.arccos(np.clip(cosine, -1.0, 1.0))
    found = []
    for down in (-depth, depth):
        abduction = np.arctan2(z, y) - np.arctan2(down, side * A1_SIDE)
        thigh = np.arctan2(-x, -down) - np.arctan2(A1_SHANK * np.sin(knee), A1_THIGH + A1_SHANK * np.cos(knee))
        found.append(into_limits(np.array([abduction, thigh, knee]), A1_LOWER, A1_UPPER))
    return min(found, key=lambda joints: beyond(joints, A1_LOWER, A1_UPPER))


def rotation_vector(rotation):
    """Axis times angle, for angles below half a turn."""
    twice_axis = np.array([rotation[2, 1] - rotation[1, 2], rotation[0, 2] - rotation[2, 0], rotation[1, 0] - rotation[0, 1]])
    sine, cosine = 0.5 * np.linalg.norm(twice_axis), 0.5 * (np.trace(rotation) - 1.0)
    return twice_axis * (0.5 if sine < 1e-9 else 0.5 * np.arctan2(sine, cosine) / sine)


def nao_jacobian(foot, joints):
    """Jacobian of position and rotation of the sole in the base; each column is (axis x arm, axis)."""
    place, rotation = np.zeros(3), np.eye(3)
    sole = nao_foot(foot, joints)[0]
    columns = []
    for i in range(6):
        place = place + rotation @ mirrored(NAO_PLACES[i], foot)
        axis = rotation @ nao_axis(i, foot)
        columns.append(np.concatenate([np.cross(axis, sole - place), axis]))
        rotation = rotation @ turned(nao_axis(i, foot), joints[i])
    return np.array(columns).T


def nao_search(foot, place, rotation, joints):
    """Damped least squares, clipped to the limits; the damping decreases with the error."""
    lower, upper = NAO_LOWER[foot], NAO_UPPER[foot]
    for _ in range(100):
        at, turn = nao_foot(foot, joints)
        left = np.concatenate([place - at, rotation_vector(rotation @ turn.T)])
        if np.linalg.norm(left) < 1e-11:
            break
        J = nao_jacobian(foot, joints)
        damping = 1e-3 * min(left @ left, 1.0) + 1e-14
        joints = np.clip(joints + np.linalg.solve(J.T @ J + damping * np.eye(6), J.T @ left), lower, upper)
    return joints, np.linalg.norm(left)


def nao_leg_ik(foot, place, rotation):
    """Searches from the middle of the limits; if this fails, from random postures between them."""
    lower, upper = NAO_LOWER[foot], NAO_UPPER[foot]
    random = np.random.default_rng(1)
    best, least = None, np.inf
    for attempt in range(60):
        share = 0.5 if attempt == 0 else random.uniform(0.1, 0.9, 6)
        joints, left = nao_search(foot, place, rotation, lower + share * (upper - lower))
        if left < least:
            best, least = joints, left
        if least < 1e-9:
            break
    return best
