# SPDX-License-Identifier: BSD-3-Clause
"""Misuse is refused without a crash: threads, sizes, lifetimes, arguments that contradict each other."""

import threading

import gaitwright as gw
import numpy as np
import pytest


def in_threads(count, act):
    """The exceptions that the threads raised."""
    raised = []

    def run():
        try:
            act()
        except gw.BadInputError as error:
            raised.append(str(error))

    threads = [threading.Thread(target=run) for _ in range(count)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    return raised


def test_a_controller_is_played_by_one_thread_at_a_time(trot):
    controller = gw.make_controller(trot)
    raised = in_threads(4, lambda: gw.play(trot, controller))
    assert raised, "four playbacks at a time with one controller"
    assert all("in use by another thread" in words for words in raised)
    assert gw.play(trot, controller).passed, "it is free again"


def test_a_world_is_stepped_by_one_thread_at_a_time(a1):
    world = gw.World(a1)
    command = gw.JointCommand(a1.standing[7:])
    raised = in_threads(4, lambda: world.step(command, 3000))
    assert raised
    assert all("this World is in use" in words for words in raised)
    world.step(command)
    assert np.isfinite(world.q).all()


def test_arrays_stay_what_they_are(a1):
    measured = gw.World(a1).measured()
    q = measured.q
    with pytest.raises(ValueError, match="3 numbers are given; 19 are needed"):
        measured.q = [0.0] * 3
    measured.q = np.arange(19.0)
    assert q[18] == 18.0, "the same array"
    command = gw.JointCommand(np.zeros(12))
    with pytest.raises(ValueError, match="12 are needed"):
        command.stiffness = [1.0]
    state = gw.RobotState(a1)
    before, kept = state.q, state.q.copy()
    state.set(np.r_[1.0, 2.0, 3.0, kept[3:]])
    assert np.array_equal(before, kept), "a state's arrays are copies"


def test_what_a_controller_was_told_can_be_kept(trot):
    class Keeping(gw.Controller):
        def __init__(self):
            super().__init__()
            self.told = []

        def update(self, now):
            self.told.append(now)
            wanted = trot.at(now.time_s)
            return gw.JointCommand(wanted["q"][7:], wanted["v"][6:], wanted["tau"], *gains)

    gains = gw.derive_gains(trot.robot)
    controller = Keeping()
    playback = gw.play(trot, controller)
    last = controller.told[-1]
    assert last.time_s == pytest.approx(playback.time_s[-1], abs=0.01)
    last.q = np.ones(19)
    assert controller.told[-2].q[3:7] @ controller.told[-2].q[3:7] == pytest.approx(1.0)


def test_truths_are_shared_and_cannot_be_written_to(trot, playback):
    for owner in (trot, playback):
        assert np.shares_memory(owner.contact, owner.contact)
        with pytest.raises(ValueError, match="read-only"):
            owner.contact[0, 0] = False


def test_a_sequence_goes_with_no_other_way(a1):
    for extra in ({"gait": "crawl"}, {"speed": 0.9}, {"distance": 5.0}, {"steps": 3}, {"goal": (1.0, 0.0, 0.0)}):
        with pytest.raises(gw.BadInputError, match="leave out the other arguments"):
            gw.plan_walk(a1, sequence="trot: distance=0.3", **extra)


def test_a_log_goes_with_its_own_plan(trot, playback, a1, tmp_path):
    other = gw.plan_walk(a1, gait="trot", speed=0.3, distance=0.3)
    path = playback.save(tmp_path / "log.json")
    with pytest.raises(gw.BadInputError, match="another plan") as told:
        gw.load_log(path, other)
    assert told.value.code == "other_plan"
    assert gw.load_log(tmp_path / "log.json", trot).score == playback.score


def test_steps_that_are_wrong_are_counted(a1):
    steps = [("FR_foot", 0.2, -0.13, 0.0), ("RL_foot", -0.1, 0.13, 0.0), ("FL_foot", float("nan"), 0.13, 0.0)]
    with pytest.raises(gw.BadInputError, match="line 3"):
        gw.plan_footsteps(a1, steps)
