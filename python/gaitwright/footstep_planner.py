# SPDX-License-Identifier: BSD-3-Clause
"""Footstep planners written in Python."""

from __future__ import annotations

from collections.abc import Iterable
from os import PathLike
from typing import Any, Protocol

from gaitwright._core import Plan, Robot, Terrain, load_terrain, plan_footsteps

Step = tuple[str, float, float, float]
Pose = tuple[float, float, float]


class FootstepPlanner(Protocol):
    """Whatever can be called like this says where the feet go."""

    def __call__(self, robot: Robot, terrain: Terrain, goal: Pose, /) -> Iterable[Step]:
        """Steps one after the other: (foot, x, y, yaw), as `plan_footsteps` takes them.

        Args:
            robot: it stands at the origin and faces x.
            terrain: the ground, to be asked by `Terrain.ground_at`.
            goal: of the base: x, y [m] and yaw [rad].
        """


def walk_with(
    planner: FootstepPlanner,
    robot: Robot,
    goal: Pose,
    terrain: Terrain | str | PathLike[str] = "flat",
    swing_s: float = 0.5,
    pause_s: float = 0.1,
    options: dict[str, Any] | None = None,
) -> Plan:
    """A plan over the steps of a planner of your own.

    Raises:
        BadInputError: the planner gave no steps, or one that is none: a foot that there is not, a place without ground.
        InfeasibleError: no motion serves these steps. As of `plan_footsteps` the plan is not audited: ask `audit`.
    """
    ground = terrain if isinstance(terrain, Terrain) else load_terrain(terrain, robot)
    steps = [(str(foot), float(x), float(y), float(yaw)) for foot, x, y, yaw in planner(robot, ground, goal)]
    return plan_footsteps(robot, steps, terrain=ground, swing_s=swing_s, pause_s=pause_s, options=options or {})
