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
    """Any callable with this signature is a footstep planner."""

    def __call__(self, robot: Robot, terrain: Terrain, goal: Pose, /) -> Iterable[Step]:
        """Returns the steps in order: (foot, x, y, yaw) each, as for `plan_footsteps`.

        Args:
            robot: the robot, which stands at the origin and faces x.
            terrain: the ground; `Terrain.ground_at` gives its height and surface.
            goal: goal pose of the base: x, y [m] and yaw [rad].
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
    """Plans a motion over the steps of your own planner. The plan is not audited: call `audit`.

    Raises:
        BadInputError: the planner gave no steps, or a step with an unknown foot or at a place without ground.
        InfeasibleError: no motion over these steps is feasible.
    """
    ground = terrain if isinstance(terrain, Terrain) else load_terrain(terrain, robot)
    steps = [(str(foot), float(x), float(y), float(yaw)) for foot, x, y, yaw in planner(robot, ground, goal)]
    return plan_footsteps(robot, steps, terrain=ground, swing_s=swing_s, pause_s=pause_s, options=options or {})
