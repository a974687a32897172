# SPDX-License-Identifier: BSD-3-Clause
"""Learned policies in one call."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any, Callable, Optional, Union

from gaitwright._core import Playback, Policy, Robot


def play_policy(
    robot: Robot,
    policy: Union[str, Any, Callable[[Any], Any]],
    contract: Any,
    *,
    options: Optional[Mapping[str, Any]] = None,
    engine: Optional[str] = None,
    **commands: Any,
) -> Playback:
    """Plays a learned policy in physics and scores it, as ``gaitwright play --policy`` does.

    Args:
        policy, contract, commands: as for `Policy`, such as ``speed=0.5``.
        options, engine: as for `play`.
    """
    return Policy(robot, policy, contract, **commands).play(options=dict(options or {}), engine=engine)
