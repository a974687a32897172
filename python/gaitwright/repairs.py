# SPDX-License-Identifier: BSD-3-Clause
"""Motions made feasible."""

from __future__ import annotations

import os
from collections.abc import Mapping
from typing import Any, Optional, Union

from gaitwright import _core
from gaitwright._core import Repair, Robot, Terrain


def repair(
    robot: Robot,
    motion: Union[str, os.PathLike[str], Mapping[str, Any]],
    *,
    terrain: Union[Terrain, str, os.PathLike[str]] = "flat",
    stretch: float = 1.0,
    leave_out: float = 0.5,
    weights: Union[None, str, os.PathLike[str], Mapping[str, Any]] = None,
    play: bool = True,
    options: Optional[Mapping[str, Any]] = None,
) -> Repair:
    """Changes a motion as little as possible so that the robot can do it (docs/repair.md).

    Args:
        motion: a file, or a dictionary of arrays with a row for each frame: ``dof_pos``, ``root_pos``, ``root_rot``
            (x y z w), or ``joint_pos``, ``body_pos_w``, ``body_quat_w`` (w x y z; the first body is the base); with
            ``fps`` and ``joint_names``. Without names, joints are in the order of the robot's description.
        stretch: most that a part may be slowed by if it cannot be done at its speed.
        leave_out: largest share of the motion, 0 to 1, that may be left out if the robot cannot do it; the robot stands
            there. The changes of the result list each part.
        weights: what matters more, by part of the body and by time: a YAML file, or a dictionary with the same keys,
            such as ``{"always": {"arms": 3.0}}``.
        play: play the plan in both engines.
        options: as for ``gaitwright repair --set``, such as ``{"repair.joint": 4.0}``.

    Raises:
        BadInputError: the motion or the weights are wrong.
        InfeasibleError: no motion near it was found; the message names the constraint and the time.
    """
    of_repair = dict(options or {})
    if stretch != 1.0:
        of_repair["repair.stretch"] = stretch
    if leave_out != 0.5:
        of_repair["repair.leave_out"] = leave_out
    if isinstance(motion, Mapping):
        motion = dict(motion)
    if isinstance(weights, Mapping):
        weights = dict(weights)
    return _core.repair(robot, motion, terrain=terrain, weights=weights, play=play, options=of_repair)
