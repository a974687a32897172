# SPDX-License-Identifier: BSD-3-Clause
"""Kinematics directly from the text of a URDF, by matrix products: an independent check of the package."""

import xml.etree.ElementTree as xml

import numpy as np


def numbers(text, usual):
    return np.array([float(word) for word in (text or usual).split()])


def cross_matrix(w):
    return np.array([[0.0, -w[2], w[1]], [w[2], 0.0, -w[0]], [-w[1], w[0], 0.0]])


def turn(axis, angle):
    """Rodrigues' formula."""
    K = cross_matrix(axis / np.linalg.norm(axis))
    return np.eye(3) + np.sin(angle) * K + (1.0 - np.cos(angle)) * K @ K


def pose(R=None, p=None):
    X = np.eye(4)
    X[:3, :3] = np.eye(3) if R is None else R
    X[:3, 3] = 0.0 if p is None else p
    return X


def origin_of(element):
    origin = element.find("origin")
    if origin is None:
        return np.eye(4)
    roll, pitch, yaw = numbers(origin.get("rpy"), "0 0 0")
    R = turn(np.array([0, 0, 1.0]), yaw) @ turn(np.array([0, 1.0, 0]), pitch) @ turn(np.array([1.0, 0, 0]), roll)
    return pose(R, numbers(origin.get("xyz"), "0 0 0"))


def rotation_of(quaternion):
    """Rotation matrix of a unit quaternion x y z w."""
    x, y, z, w = quaternion / np.linalg.norm(quaternion)
    K = cross_matrix([x, y, z])
    return np.eye(3) + 2.0 * w * K + 2.0 * K @ K


class Urdf:
    def __init__(self, path):
        root = xml.parse(path).getroot()
        self.joints = root.findall("joint")
        self.links = {link.get("name"): link for link in root.findall("link")}
        self.joint_above = {joint.find("child").get("link"): joint for joint in self.joints}
        self.root = next(name for name in self.links if name not in self.joint_above)

    def position(self, joint, by_name):
        """Position of a joint; for a mimic joint, from that of its leader."""
        mimic = joint.find("mimic")
        if mimic is None:
            return by_name[joint.get("name")]
        return float(mimic.get("multiplier", "1")) * by_name[mimic.get("joint")] + float(mimic.get("offset", "0"))

    def chain(self, link):
        """The joints from the root to a link."""
        joints = []
        while link in self.joint_above:
            joints.insert(0, self.joint_above[link])
            link = joints[0].find("parent").get("link")
        return joints

    def forward(self, robot, q, link):
        """Pose of a link, and its 6 x nv Jacobian from the screws of the joints."""
        by_name = dict(zip(robot.joints, q[7:]))
        X = pose(rotation_of(q[3:7]), q[:3])
        screws = []
        for joint in self.chain(link):
            X = X @ origin_of(joint)
            if joint.get("type") == "fixed":
                continue
            axis = numbers(joint.find("axis").get("xyz"), "1 0 0")
            axis /= np.linalg.norm(axis)
            mimic = joint.find("mimic")
            leader = joint.get("name") if mimic is None else mimic.get("joint")
            factor = 1.0 if mimic is None else float(mimic.get("multiplier", "1"))
            column = 6 + robot.joints.index(leader)
            angle = self.position(joint, by_name)
            if joint.get("type") == "prismatic":
                screws.append((column, factor * X[:3, :3] @ axis, None, None))
                X = X @ pose(p=axis * angle)
            else:
                screws.append((column, None, factor * X[:3, :3] @ axis, X[:3, 3].copy()))
                X = X @ pose(turn(axis, angle))
        J = np.zeros((6, robot.nv))
        J[:3, :3] = J[3:, 3:6] = np.eye(3)
        J[:3, 3:6] = -cross_matrix(X[:3, 3] - q[:3])
        for column, slide, axis, at in screws:
            if slide is not None:
                J[:3, column] += slide
            else:
                J[:3, column] += np.cross(axis, X[:3, 3] - at)
                J[3:, column] += axis
        return X, J

    def centre_of_mass(self, robot, q):
        moment, mass = np.zeros(3), 0.0
        for name, link in self.links.items():
            inertial = link.find("inertial")
            if inertial is None:
                continue
            m = float(inertial.find("mass").get("value"))
            X, _ = self.forward(robot, q, name)
            moment += m * (X @ origin_of(inertial))[:3, 3]
            mass += m
        return moment / mass, mass
