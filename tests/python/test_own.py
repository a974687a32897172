# SPDX-License-Identifier: BSD-3-Clause
"""Controllers and footstep planners written in Python."""

import gaitwright as gw
import numpy as np
import pytest


class FollowThePlan(gw.Controller):
    """PD control around the plan, with the plan's torques as feed-forward."""

    def __init__(self, plan):
        super().__init__()
        self.plan = plan
        self.stiffness, self.damping = gw.derive_gains(plan.robot)
        self.calls = 0

    def name(self):
        return "follow-the-plan"

    def reset(self):
        self.calls = 0

    def update(self, now):
        self.calls += 1
        wanted = self.plan.at(now.time_s + now.step_s)
        return gw.JointCommand(wanted["q"][7:], wanted["v"][6:], wanted["tau"], self.stiffness, self.damping)


def test_a_controller_of_ones_own_walks(trot):
    controller = FollowThePlan(trot)
    playback = gw.play(trot, controller)
    assert playback.controller == "follow-the-plan"
    assert controller.calls == pytest.approx(1000 * (trot.duration_s + 0.5), rel=0.05)
    assert playback.passed, playback.reason


def test_what_a_controller_does_wrong_comes_back_as_it_was_raised(trot):
    class Broken(gw.Controller):
        def update(self, now):
            raise ZeroDivisionError("of its own")

    with pytest.raises(ZeroDivisionError, match="of its own"):
        gw.play(trot, Broken())

    class Lazy(Broken):
        def update(self, now):
            return None

    with pytest.raises(ValueError, match="update\\(\\) gave None; a JointCommand is needed"):
        gw.play(trot, Lazy())

    class Short(Broken):
        def update(self, now):
            return gw.JointCommand(np.zeros(3))

    with pytest.raises(ValueError, match="size|numbers|12"):
        gw.play(trot, Short())
    with pytest.raises(ValueError, match="no controller 'pid'"):
        gw.play(trot, "pid")
    with pytest.raises(TypeError, match="controller is 3"):
        gw.play(trot, 3)
    with pytest.raises(TypeError, match="terrain is 3"):
        gw.plan_walk(trot.robot, terrain=3)


def test_a_controller_without_a_name_is_called_as_its_class(trot):
    class Limp(gw.Controller):
        def update(self, now):
            return gw.JointCommand(now.q[7:])

    playback = gw.play(trot, Limp())
    assert playback.controller == "Limp"
    assert not playback.passed and "fell while settling" in playback.reason


def test_a_controller_needs_an_update(trot):
    class Nothing(gw.Controller):
        pass

    with pytest.raises(ValueError, match="needs a method update"):
        gw.play(trot, Nothing())


def test_a_controller_can_be_asked_step_by_step(trot):
    """The loop of a playback, written in Python: the robot walks as far."""
    robot = trot.robot
    world = gw.World(robot, trot.terrain, trot.q[0])
    controller = gw.make_controller(trot, "stabilised")
    controller.reset()
    settle_s = 0.2
    while world.time_s < settle_s + trot.duration_s:
        time_s = max(world.time_s - settle_s, 0.0) + trot.time_s[0]
        world.step(controller.update(world.measured(time_s)))
    assert world.q[0] == pytest.approx(trot.q[-1, 0], abs=0.03)
    assert not world.body_contacts


def test_a_biped_is_asked_before_its_first_step(nao):
    plan = gw.plan_walk(nao, steps=2, step_length=0.03)
    world = gw.World(nao, plan.terrain, plan.q[0])
    now = world.measured()
    assert now.forces_n.tolist() == [[0.0] * 3] * 2 and now.contact == [False, False]
    controller = gw.make_controller(plan)
    world.step(controller.update(now))
    assert sum(force[2] for force in world.forces_n) == pytest.approx(nao.weight_n, rel=0.3)


def test_an_input_of_another_robot_is_refused(nao, trot):
    controller = gw.make_controller(trot)
    with pytest.raises(gw.BadInputError, match="q has .* numbers; 'a1' needs 19"):
        controller.update(gw.World(nao, gw.flat_terrain()).measured())
    start = trot.at(0.0)
    with pytest.raises(gw.BadInputError, match="forces_n has 0 feet; 'a1' has 4"):
        controller.update(gw.ControlInput(0.0, 0.001, start["q"], start["v"], np.zeros((0, 3)), []))
    with pytest.raises(gw.BadInputError, match="finite"):
        controller.update(gw.ControlInput(0.0, 0.001, start["q"] * np.nan, start["v"], np.zeros((4, 3)), [True] * 4))


def steps_ahead(robot, terrain, goal):
    """Left and right steps in turn, 4 cm forward each, to the goal."""
    left, right = robot.feet[:2]
    beside = {foot: gw.RobotState(robot).contact_frame(foot)[:2, 3] for foot in (left, right)}
    x, count = 0.0, 0
    while x < goal[0] - 1e-9:
        x = min(x + 0.04, goal[0])
        foot = (left, right)[count % 2]
        yield foot, beside[foot][0] + x, beside[foot][1], 0.0
        count += 1
    foot = (left, right)[count % 2]
    yield foot, beside[foot][0] + x, beside[foot][1], 0.0


def test_a_controller_can_be_asked_about_an_input_that_is_made_up(trot):
    state = trot.at(0.0)
    now = gw.ControlInput(0.5, 0.001, state["q"], state["v"], np.arange(12.0).reshape(4, 3), [True, False, True, True])
    assert now.contact == [True, False, True, True]
    assert now.forces_n.tolist() == np.arange(12.0).reshape(4, 3).tolist()
    assert FollowThePlan(trot).update(now).q.tolist() == trot.at(0.501)["q"][7:].tolist()
    with pytest.raises(gw.BadInputError, match="forces_n is 1 x 3; 2 x 3 are needed"):
        gw.ControlInput(0.5, 0.001, state["q"], state["v"], [[0, 0, 1]], [True, False])


def test_a_footstep_planner_of_ones_own_walks_nao(nao):
    plan = gw.walk_with(steps_ahead, nao, goal=(0.2, 0.0, 0.0))
    assert gw.audit(plan), str(gw.audit(plan))
    playback = gw.play(plan)
    assert playback.passed, playback.reason
    assert playback.q[-1, 0] - playback.q[0, 0] == pytest.approx(0.2, abs=0.03)


def test_steps_that_cannot_be_are_refused(nao):
    with pytest.raises(gw.BadInputError, match="l_foot"):
        gw.plan_footsteps(nao, [("l_foot", 0.0, 0.05, 0.0)])
    with pytest.raises(gw.GaitwrightError):
        gw.plan_footsteps(nao, [])
    with pytest.raises(gw.GaitwrightError):
        gw.plan_footsteps(nao, [(nao.feet[0], 3.0, 0.05, 0.0)])


def test_nothing_is_no_robot_and_no_plan(trot):
    for call in (lambda: gw.RobotState(None), lambda: gw.play(None), lambda: gw.make_controller(None), lambda: gw.trials(None, 1),
                 lambda: gw.audit(None), lambda: gw.plan_walk(None), lambda: gw.World(None, gw.flat_terrain()), lambda: gw.load_terrain("flat", None)):
        with pytest.raises(TypeError):
            call()


def test_a_world_takes_states_and_pushes_that_can_be(a1):
    with pytest.raises(gw.BadInputError, match="quaternion"):
        gw.World(a1, gw.flat_terrain(), np.zeros(19))
    world = gw.World(a1, gw.flat_terrain())
    with pytest.raises(gw.BadInputError, match="q has 3 numbers; 'a1' needs 19"):
        world.set_state(np.zeros(3), np.zeros(18))
    with pytest.raises(gw.BadInputError, match="finite"):
        world.set_state(np.full(19, np.nan), np.zeros(18))
    for link in ("trunk", "FL_calf"):
        with pytest.raises(gw.BadInputError, match="a push is not finite"):
            world.push([0.0, 0.0, np.inf], link)
    with pytest.raises(gw.BadInputError, match="steps is -5"):
        world.step(gw.JointCommand(np.zeros(12)), -5)
