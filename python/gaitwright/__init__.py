# SPDX-License-Identifier: BSD-3-Clause
"""Plans gaits for legged robots offline and proves them in physics.

    import gaitwright as gw

    robot = gw.load_robot("a1")
    plan = gw.plan_walk(robot, gait="trot", speed=0.3, distance=1.0)
    playback = gw.play(plan)
    print(playback)
    gw.plot(playback)
"""

from gaitwright._core import (
    AUDIT_LAWS,
    FAILURE_CODES,
    CONTROLLERS,
    AuditMargin,
    AuditReport,
    Comparison,
    ControlInput,
    Controller,
    JointCommand,
    Metric,
    Network,
    Plan,
    Playback,
    Policy,
    Repair,
    Robot,
    RobotState,
    Terrain,
    TrialsReport,
    Violation,
    World,
    __version__,
    audit,
    compare,
    derive_gains,
    flat_terrain,
    import_motion,
    leg_joints,
    load_log,
    load_plan,
    load_robot,
    load_terrain,
    make_controller,
    plan_footsteps,
    plan_tasks,
    plan_walk,
    play,
    play_trial,
    robot_names,
    solve_leg,
    terrain_kinds,
    trials,
    understand,
)
from gaitwright.errors import BadInputError, GaitwrightError, InfeasibleError
from gaitwright.footstep_planner import FootstepPlanner, walk_with
from gaitwright.notebook import Page, show
from gaitwright.plots import plot
from gaitwright.policies import play_policy
from gaitwright.repairs import repair

__all__ = [
    "AUDIT_LAWS",
    "FAILURE_CODES",
    "CONTROLLERS",
    "AuditMargin",
    "AuditReport",
    "BadInputError",
    "Comparison",
    "ControlInput",
    "Controller",
    "FootstepPlanner",
    "GaitwrightError",
    "InfeasibleError",
    "JointCommand",
    "Metric",
    "Network",
    "Page",
    "Plan",
    "Playback",
    "Policy",
    "Repair",
    "Robot",
    "RobotState",
    "Terrain",
    "TrialsReport",
    "Violation",
    "World",
    "__version__",
    "audit",
    "compare",
    "derive_gains",
    "flat_terrain",
    "import_motion",
    "leg_joints",
    "load_log",
    "load_plan",
    "load_robot",
    "load_terrain",
    "make_controller",
    "plan_footsteps",
    "plan_tasks",
    "plan_walk",
    "play",
    "play_policy",
    "play_trial",
    "plot",
    "repair",
    "robot_names",
    "show",
    "solve_leg",
    "terrain_kinds",
    "trials",
    "understand",
    "walk_with",
]
