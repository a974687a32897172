#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Writes a1_trot.onnx and a1_trot.yaml: a policy for A1 that was not trained but follows from the geometry of the legs.

Two hidden units lift the diagonal pairs of legs in turn, by gait_phase. Products of commands and phase swing the feet
fore and aft. The network has no feedback; its inputs are projected_gravity, velocity_commands and gait_phase.
"""

import sys
from pathlib import Path

import numpy as np
from onnx_file import model, node

LINK = 0.2  # length of thigh and calf [m]
PERIOD, LIFT, THIGH = 0.4, 0.06, 0.76  # [s], [m], [rad]
REACH = 1.1  # of the commanded stride, since the drives lag behind
FORWARD = 0.03  # speed that keeps the trot on the spot in place [m/s]
TURNING = 0.39  # speed of a side per yaw rate [m]: more than half the width, since the feet do not swing sideways
LEGS = {"FR": (0, -1), "FL": (1, 1), "RR": (1, -1), "RL": (0, 1)}  # the pair that swings together, and the side
GRAVITY, SPEED, YAW_RATE, SINE, COSINE, INPUTS = 0, 3, 5, 6, 7, 8


def network():
    calf = -LIFT / (LINK * np.sin(THIGH))  # shortens a leg by LIFT
    sweep = -REACH * 0.25 * PERIOD / (2 * LINK * np.cos(THIGH))
    swing, lift, step = np.zeros((2, INPUTS), "f"), np.zeros((12, 2), "f"), np.zeros((12, 2), "f")
    swing[:, COSINE] = 1, -1
    for leg, (pair, side) in enumerate(LEGS.values()):
        sign = 1 - 2 * pair
        lift[3 * leg + 1, pair], lift[3 * leg + 2, pair] = -0.5 * calf, calf
        step[3 * leg + 1] = sign * sweep, -sign * sweep * side * TURNING
    constants = {"swing": swing, "lift": lift, "step": step, "forward": np.array([FORWARD], "f")}
    part = lambda at, to: node("Slice", ["obs"], [to], starts=[at], ends=[at + 1], axes=[1])
    nodes = [
        node("Gemm", ["obs", "swing"], ["phases"], transB=1),
        node("Relu", ["phases"], ["swings"]),
        node("Gemm", ["swings", "lift"], ["lifted"], transB=1),
        part(SPEED, "speed"),
        part(YAW_RATE, "yaw_rate"),
        part(SINE, "sine"),
        node("Add", ["speed", "forward"], ["forward_speed"]),
        node("Concat", ["forward_speed", "yaw_rate"], ["command"], axis=1),
        node("Mul", ["command", "sine"], ["sweeps"]),
        node("Gemm", ["sweeps", "step", "lifted"], ["action"], transB=1),
    ]
    return model(nodes, constants, INPUTS, 12)


def contract():
    names = [f"{leg}_{joint}_joint" for leg in LEGS for joint in ("hip", "thigh", "calf")]
    return f"""\
joint_names: [{", ".join(names)}]
step_dt: 0.02
stiffness: {[200.0] * 12}
damping: {[8.0] * 12}
default_joint_pos: {[0.0, THIGH, -2 * THIGH] * 4}
commands:
  base_velocity:
    ranges: {{lin_vel_x: [-0.3, 0.5], lin_vel_y: [0.0, 0.0], ang_vel_z: [-0.5, 0.5]}}
actions:
  JointPositionAction: {{scale: 1.0}}
observations:
  projected_gravity: {{}}
  velocity_commands: {{}}
  gait_phase: {{params: {{period: {PERIOD}}}}}
"""


def write(folder):
    (folder / "a1_trot.onnx").write_bytes(network())
    (folder / "a1_trot.yaml").write_text(contract())


if __name__ == "__main__":
    write(Path(sys.argv[1] if len(sys.argv) > 1 else Path(__file__).parent))
