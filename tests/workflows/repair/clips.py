#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Kinematic clips for the tests of `gaitwright repair`.

The clips know nothing of dynamics: a base path, foot paths and arm swings, joined by a small inverse kinematics of
their own on the URDF. Most have the flaws of retargeted motion: feet that float, sink or skate, a base that drifts,
noise, and a centre of mass that nobody balanced.

    clips.py URDF SHOWN.json FOLDER                 the short clips
    clips.py URDF SHOWN.json FOLDER --long SECONDS  one long clip

Clips of humanoids are tables of frames, those of quadrupeds JSON of motion_imitation. SHOWN.json is the output of
`gaitwright robots show ROBOT --json`.
"""
import json
import math
import sys
import xml.etree.ElementTree as ElementTree
from pathlib import Path

import numpy as np


def rotation(axis, angle):
    axis = np.asarray(axis, float)
    x, y, z = axis / np.linalg.norm(axis)
    k = np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
    return np.eye(3) + math.sin(angle) * k + (1 - math.cos(angle)) * k @ k


def from_rpy(rpy):
    return rotation([0, 0, 1], rpy[2]) @ rotation([0, 1, 0], rpy[1]) @ rotation([1, 0, 0], rpy[0])


def log(R):
    c = max(-1.0, min(1.0, (np.trace(R) - 1) / 2))
    angle = math.acos(c)
    v = np.array([R[2, 1] - R[1, 2], R[0, 2] - R[2, 0], R[1, 0] - R[0, 1]])
    return v / 2 if angle < 1e-9 else v * angle / (2 * math.sin(angle))


def quaternion(R):
    """x y z w"""
    w = math.sqrt(max(0.0, 1 + np.trace(R))) / 2
    if w > 1e-3:
        return np.array([R[2, 1] - R[1, 2], R[0, 2] - R[2, 0], R[1, 0] - R[0, 1], 4 * w * w]) / (4 * w)
    v = log(R)
    a = np.linalg.norm(v)
    return np.append(math.sin(a / 2) * v / a, math.cos(a / 2))


def smooth(u):
    u = min(1.0, max(0.0, u))
    return u * u * u * (10 + u * (6 * u - 15))


class Chain:
    """Joints of a URDF by name, with the poses of links."""

    def __init__(self, urdf):
        root = ElementTree.parse(urdf).getroot()
        self.joints = {}
        self.order = []
        for joint in root.findall('joint'):
            origin = joint.find('origin')
            read = lambda key: [float(x) for x in (origin.get(key, '0 0 0') if origin is not None else '0 0 0').split()]
            axis = joint.find('axis')
            kind = joint.get('type')
            self.joints[joint.find('child').get('link')] = (
                joint.get('name'), joint.find('parent').get('link'), np.array(read('xyz')), from_rpy(read('rpy')),
                np.array([float(x) for x in axis.get('xyz').split()]) if axis is not None else np.array([1., 0, 0]),
                kind)
            if kind in ('revolute', 'continuous'):
                self.order.append(joint.get('name'))

    def path(self, link):
        path = []
        while link in self.joints:
            path.append(self.joints[link])
            link = path[-1][1]
        return path[::-1]

    def pose(self, link, q, p=np.zeros(3), R=np.eye(3)):
        """Pose of a link, and origin and axis of each joint before it by name."""
        screws = {}
        for name, _, xyz, R0, axis, kind in self.path(link):
            p, R = p + R @ xyz, R @ R0
            if kind in ('revolute', 'continuous'):
                screws[name] = (p, R @ axis)
                R = R @ rotation(axis, q.get(name, 0.0))
        return p, R, screws


class Robot:
    def __init__(self, urdf, shown):
        self.chain = Chain(urdf)
        self.order = [name for name in self.chain.order if name in shown['standing']]
        self.standing = dict(shown['standing'])
        self.height = shown['standing_base_height_m']
        self.length = shown['leg_length_m']
        self.legs = [(leg['foot']['link'], leg['joints']) for leg in shown['legs'].values()]
        self.has_soles = all(leg['foot']['type'] == 'sole' for leg in shown['legs'].values())
        self.limits = {n: (l.get('lower_rad', -9.), l.get('upper_rad', 9.)) for n, l in shown['limits'].items()}
        base = np.array([0, 0, self.height])
        self.feet = [self.chain.pose(link, self.standing, base)[:2] for link, _ in self.legs]

    def arm(self, side, *words):
        for name in self.order:
            low = name.lower()
            left = low.startswith('l') if side == 'left' else low.startswith('r')
            if left and all(word in low for word in words):
                return name
        return None

    def frame(self, q, p, R, feet):
        """The legs follow by damped least squares from the last frame."""
        for (link, joints), (p_foot, R_foot) in zip(self.legs, feet):
            for _ in range(30):
                at, R_at, screws = self.chain.pose(link, q, p, R)
                error = np.concatenate([p_foot - at, log(R_foot @ R_at.T)])[:6 if self.has_soles else 3]
                if np.linalg.norm(error) < 1e-7:
                    break
                J = np.array([np.concatenate([np.cross(screws[j][1], at - screws[j][0]), screws[j][1]])
                              for j in joints]).T[:error.size]
                step = J.T @ np.linalg.solve(J @ J.T + 1e-6 * np.eye(error.size), error)
                for j, d in zip(joints, step):
                    low, high = self.limits[j]
                    q[j] = min(high, max(low, q[j] + max(-0.3, min(0.3, d))))
        return np.concatenate([p, quaternion(R), [q[j] for j in self.order]])


class Clip:
    """A motion over time: base offset, base turn (roll, pitch, yaw), joints and feet."""

    def __init__(self, robot, duration):
        self.robot, self.duration, self.rate = robot, duration, 30.0
        self.base = lambda t: np.zeros(3)
        self.turn = lambda t: np.zeros(3)
        self.joints = lambda t: {}
        self.steps = []    # (foot, start, end, dx, dy, dyaw, lift), in units of the leg's length
        self.spins = []    # (foot, start, end, angle, lift): steps around the origin
        self.offset = lambda t: np.zeros(3)           # of the whole robot: floats, sinks, drifts
        self.skate = lambda foot, t: np.zeros(3)      # of a foot
        self.noise = 0.0

    def foot(self, index, t):
        p, R = self.robot.feet[index]
        p, yaw = p.copy(), 0.0
        for foot, start, end, dx, dy, dyaw, lift in self.steps:
            if foot != index or t <= start:
                continue
            u = (t - start) / (end - start)
            p += smooth(u) * self.robot.length * np.array([dx, dy, 0])
            yaw += smooth(u) * dyaw
            if u < 1:
                p[2] += lift * self.robot.length * math.sin(math.pi * smooth(u)) ** 2
        around = 0.0
        for foot, start, end, angle, lift in self.spins:
            if foot != index or t <= start:
                continue
            u = (t - start) / (end - start)
            around += smooth(u) * angle
            if u < 1:
                p[2] += lift * self.robot.length * math.sin(math.pi * smooth(u)) ** 2
        return rotation([0, 0, 1], around) @ p + self.skate(index, t), rotation([0, 0, 1], around + yaw) @ R

    def frames(self, seed=1):
        random = np.random.default_rng(seed)
        q = dict(self.robot.standing)
        rows = []
        for k in range(int(round(self.duration * self.rate)) + 1):
            t = k / self.rate
            for name, value in self.joints(t).items():
                if name is not None:
                    low, high = self.robot.limits[name]
                    q[name] = min(high, max(low, self.robot.standing[name] + value))
            p = np.array([0, 0, self.robot.height]) + self.robot.length * self.base(t)
            row = self.robot.frame(q, p, from_rpy(self.turn(t)), [self.foot(i, t) for i in range(len(self.robot.legs))])
            row[:3] += self.offset(t)
            if self.noise > 0:
                row[:3] += self.noise * random.normal(size=3)
                row[7:] += 2 * self.noise * random.normal(size=row.size - 7)
            rows.append(row)
        return np.array(rows)


def pulse(t, start, end, edge=0.8):
    """0, then 1 between start and end, then 0, smoothly."""
    return smooth((t - start) / edge) - smooth((t - end + edge) / edge)


def wave(t, period):
    return 0.5 - 0.5 * math.cos(2 * math.pi * t / period)


def stepping(clip, steps, dx, dy, dyaw, first=0.6, period=0.7, swing=0.45, lift=0.08):
    """Steps of both feet in turn; the first and the last are half steps. The base moves at a constant speed."""
    for i in range(steps):
        share = 0.5 if i in (0, steps - 1) else 1.0
        start = first + i * period
        clip.steps.append((i % 2, start, start + swing, share * dx, share * dy, share * dyaw, lift))
    end = first + steps * period
    clip.duration = end + 0.6
    distance = 0.5 * (steps - 1)
    clip.base = lambda t: np.array([dx, dy, 0]) * distance * smooth((t - first) / (end - first)) + np.array(
        [0, 0.03 * math.sin(2 * math.pi * (t - first) / (2 * period)) * pulse(t, 0.2, end), -0.03 * pulse(t, 0.0, end + 0.6)])
    clip.turn = lambda t: np.array([0, 0, dyaw * distance * smooth((t - first) / (end - first))])
    return clip


def humanoid_clips(robot):
    left = lambda *words: robot.arm('left', *words)
    right = lambda *words: robot.arm('right', *words)
    clips = {}

    def add(name, duration=4.0):
        clips[name] = Clip(robot, duration)
        return clips[name]

    c = add('squat', 5.0)
    c.base = lambda t: np.array([0, 0, -0.2 * wave(t, 2.5)])
    c = add('deep_squat', 4.0)
    c.base = lambda t: np.array([0, 0, -0.35 * wave(t, 4.0)])
    c = add('reach')
    c.base = lambda t: np.array([0.06, 0, -0.05]) * pulse(t, 0.3, 3.7)
    c.joints = lambda t: {left('shoulder', 'pitch'): -1.3 * pulse(t, 0.3, 3.7), right('shoulder', 'pitch'): -1.3 * pulse(t, 0.3, 3.7)}
    c = add('wave')
    c.joints = lambda t: {right('shoulder', 'pitch'): -1.8 * pulse(t, 0.2, 3.8), right('elbow'): 0.4 * math.sin(9 * t) * pulse(t, 0.8, 3.2)}
    c = add('bow')
    c.turn = lambda t: np.array([0, 0.45 * pulse(t, 0.3, 3.7, 1.2), 0])
    c = add('sway')
    c.base = lambda t: np.array([0, 0.07 * math.sin(2 * math.pi * t / 2.0) * pulse(t, 0, 4), -0.05 * pulse(t, 0, 4)])
    c = add('twist')
    c.turn = lambda t: np.array([0, 0, 0.3 * math.sin(2 * math.pi * t / 2.0) * pulse(t, 0, 4)])
    c.base = lambda t: np.array([0, 0, -0.06 * pulse(t, 0, 4)])
    c = add('arms', 6.0)
    c.joints = lambda t: {
        left('shoulder', 'pitch'): 0.8 * math.sin(5 * t) * pulse(t, 0, 6), right('shoulder', 'pitch'): -0.8 * math.sin(5 * t) * pulse(t, 0, 6),
        left('shoulder', 'roll'): 0.5 * wave(t, 1.5) * pulse(t, 0, 6), right('shoulder', 'roll'): -0.5 * wave(t, 1.5) * pulse(t, 0, 6)}
    c.base = lambda t: np.array([0, 0.03 * math.sin(4 * t), -0.03 + 0.02 * math.cos(8 * t)]) * pulse(t, 0, 6)
    c = add('arms_in_hips', 5.0)
    c.joints = lambda t: {
        left('shoulder', 'pitch'): 0.6 * math.sin(4 * t) * pulse(t, 0, 5), right('shoulder', 'pitch'): -0.6 * math.sin(4 * t) * pulse(t, 0, 5),
        left('shoulder', 'roll'): -0.45 * pulse(t, 0, 5), right('shoulder', 'roll'): 0.45 * pulse(t, 0, 5),
        left('elbow'): 0.2 * pulse(t, 0, 5), right('elbow'): 0.2 * pulse(t, 0, 5)}
    c = stepping(add('walk_floats'), 6, 0.3, 0, 0)
    c.offset = lambda t: np.array([0, 0, 0.02])
    c = stepping(add('walk_sinks'), 6, 0.3, 0, 0)
    c.offset = lambda t: np.array([0, 0, -0.02])
    c = stepping(add('walk_noise'), 6, 0.3, 0, 0)
    c.noise = 0.003
    c = stepping(add('walk_drifts'), 6, 0.25, 0, 0)
    c.offset = lambda t: np.array([0, 0.02 * t, 0])
    c = stepping(add('walk_back_120hz'), 6, -0.2, 0, 0)
    c.rate = 120.0
    c = stepping(add('turn'), 6, 0, 0, 0.4)
    c = add('side_skates', 6.0)
    for i in range(4):
        start = 0.6 + 1.2 * i
        c.steps += [(0, start, start + 0.45, 0, 0.1, 0, 0.06), (1, start + 0.6, start + 1.05, 0, 0.1, 0, 0.06)]
    c.base = lambda t: np.array([0, 0.4 * smooth((t - 0.6) / 4.8), -0.03 * pulse(t, 0, 6)])
    c.skate = lambda foot, t: np.array([0.02 * math.sin(3 * t + foot), 0.01 * math.sin(2 * t), 0])
    c = add('kick', 5.0)
    c.steps = [(0, 1.4, 2.2, 0.35, 0, 0, 0.15), (0, 2.4, 3.4, -0.35, 0, 0, 0.1)]
    c.base = lambda t: np.array([0, -0.08 * pulse(t, 0.3, 4.6), -0.03 * pulse(t, 0, 5)])
    c = add('march', 5.0)
    c.steps = [(i % 2, 0.6 + 0.7 * i, 1.1 + 0.7 * i, 0, 0, 0, 0.15) for i in range(6)]
    c.base = lambda t: np.array([0, 0.04 * math.sin(2 * math.pi * (t - 0.6) / 1.4) * pulse(t, 0.2, 4.9), -0.03 * pulse(t, 0, 5)])
    c = add('squat_noise_120hz', 4.0)
    c.base = lambda t: np.array([0, 0, -0.18 * wave(t, 2.0)])
    c.rate, c.noise = 120.0, 0.002
    c = add('lunge', 6.0)
    c.steps = [(0, 0.8, 1.5, 0.4, 0, 0, 0.08), (0, 4.3, 5.0, -0.4, 0, 0, 0.08)]
    c.base = lambda t: np.array([0.2, 0, -0.12]) * pulse(t, 0.8, 5.0) + np.array([0, 0, -0.03 * pulse(t, 0, 6)])
    c = add('jump', 3.0)
    flight = lambda t: max(0.0, (t - 1.2) * (1.5 - t) * 4.905) / robot.length
    c.base = lambda t: np.array([0, 0, flight(t) - 0.14 * pulse(t, 0.3, 1.2, 0.5) - 0.1 * pulse(t, 1.5, 2.6, 0.4)])
    c.skate = lambda foot, t: np.array([0, 0, robot.length * flight(t)])
    return clips


def paired_steps(clip, pairs, count, first, period, swing, dx, angle, lift):
    """Steps of two pairs of feet in turn, forward or around; the first and the last are half steps. @return the end."""
    for i in range(count):
        share, start = 0.5 if i in (0, count - 1) else 1.0, first + 0.5 * i * period
        for foot in pairs[i % 2]:
            if dx:
                clip.steps.append((foot, start, start + swing, share * dx, 0, 0, lift))
            if angle:
                clip.spins.append((foot, start, start + swing, share * angle, lift))
    return first + 0.5 * count * period


def quadruped_clips(robot):
    """At 60 Hz, as the clips of motion_imitation. Legs are front left, front right, rear left, rear right."""
    clips = {}

    def add(name, duration):
        clips[name] = Clip(robot, duration)
        clips[name].rate = 60.0
        return clips[name]

    diagonal, lateral = [(0, 3), (1, 2)], [(0, 2), (1, 3)]
    steps, first = 12, 0.5
    share = 0.5 * (steps - 1)
    c = add('trot', 0.0)
    end = paired_steps(c, diagonal, steps, first, 0.5, 0.22, 0.3, 0.0, 0.12)
    c.base = lambda t, end=end: np.array([0.3 * share * smooth((t - first) / (end - first)), 0, 0])
    c.duration = end + 0.5
    c.offset = lambda t: np.array([0, 0, 0.015])
    c = add('pace', 0.0)
    end = paired_steps(c, lateral, steps, first, 0.4, 0.18, 0.15, 0.0, 0.1)
    c.base = lambda t, end=end: np.array([0.15 * share * smooth((t - first) / (end - first)),
                                          0.03 * math.sin(math.pi * (t - first) / 0.2) * pulse(t, 0.3, end, 0.3), 0])
    c.duration = end + 0.5
    c.noise = 0.001
    c = add('spin', 0.0)
    end = paired_steps(c, diagonal, steps, first, 0.5, 0.22, 0.0, 0.25, 0.12)
    c.turn = lambda t, end=end: np.array([0, 0, 0.25 * share * smooth((t - first) / (end - first))])
    c.duration = end + 0.5
    c.skate = lambda foot, t: np.array([0.01 * math.sin(3 * t + foot), 0.01 * math.cos(2 * t), 0])
    c = add('hop_turn', 2.6)
    lift_off, flight_s, angle = 1.0, 0.24, 0.35
    height = lambda t: max(0.0, (t - lift_off) * (lift_off + flight_s - t) * 4.905) / robot.length
    c.base = lambda t: np.array([0, 0, height(t) - 0.15 * pulse(t, 0.3, lift_off, 0.35)
                                 - 0.12 * pulse(t, lift_off + flight_s, 2.3, 0.3)])
    c.turn = lambda t: np.array([0, 0, angle * smooth((t - lift_off + 0.1) / (flight_s + 0.2))])
    for foot in range(4):
        c.spins.append((foot, lift_off, lift_off + flight_s, angle, 0.0))
    c.skate = lambda foot, t: np.array([0, 0, robot.length * height(t)])
    return clips


def long_clip(robot, duration):
    """Rounds of 20 s: two squats, six steps forward, six steps back, arms. It floats by 1 cm."""
    c = Clip(robot, duration)
    rounds, steps, dx, period, swing = int(duration // 20), 6, 0.3, 0.7, 0.45
    left, right = robot.arm('left', 'shoulder', 'pitch'), robot.arm('right', 'shoulder', 'pitch')
    walks = [(20 * i + start, side * dx) for i in range(rounds) for start, side in ((6, 1), (12, -1))]
    for start, length in walks:
        for k in range(steps):
            share, at = 0.5 if k in (0, steps - 1) else 1.0, start + k * period
            c.steps.append((k % 2, at, at + swing, share * length, 0, 0, 0.08))

    def base(t):
        u, x, y = t % 20, 0.0, 0.0
        for start, length in walks:
            if t > start:
                x += 0.5 * (steps - 1) * length * smooth((t - start) / (steps * period))
        for start in (6, 12):
            y += 0.03 * math.sin(math.pi * (u - start) / period) * pulse(u, start - 0.4, start + steps * period)
        return np.array([x, y, -0.03 * pulse(t, 0, duration) - (0.2 * wave(u, 2.5) if u < 5 else 0.0)])

    c.base = base
    c.joints = lambda t: {left: 0.6 * math.sin(3 * t) * pulse(t, 0, duration), right: -0.6 * math.sin(3 * t) * pulse(t, 0, duration)}
    c.offset = lambda t: np.array([0, 0, 0.01])
    return c


def main():
    urdf, shown, folder = sys.argv[1:4]
    robot = Robot(urdf, json.loads(Path(shown).read_text()))
    Path(folder).mkdir(parents=True, exist_ok=True)
    rates = {}
    clips = humanoid_clips(robot) if len(robot.legs) == 2 else quadruped_clips(robot)
    if len(sys.argv) > 5 and sys.argv[4] == '--long':
        clips = {f'long_{sys.argv[5]}': long_clip(robot, float(sys.argv[5]))}
    for name, clip in clips.items():
        rates[name] = clip.rate
        if len(robot.legs) == 2:
            np.savetxt(Path(folder) / f'{name}.csv', clip.frames(), fmt='%.6f', delimiter=',')
            continue
        frames = ',\n'.join('[' + ', '.join(f'{x:.5f}' for x in row) + ']' for row in clip.frames())
        (Path(folder) / f'{name}.txt').write_text(
            f'{{\n"LoopMode": "Wrap",\n"FrameDuration": {1 / clip.rate:.6f},\n"Frames":\n[\n{frames}\n]\n}}\n')
    (Path(folder) / 'rates.json').write_text(json.dumps(rates, indent=1))


if __name__ == '__main__':
    main()
