# SPDX-License-Identifier: BSD-3-Clause
"""Motions from words, and comparisons of motions."""

import json

import gaitwright as gw
import numpy as np
import pytest


@pytest.fixture(scope="module")
def wave(nao):
    return gw.plan_tasks(nao, "wave with your left hand")


def test_words_become_a_motion_that_physics_takes(wave):
    plan, notes = wave
    assert gw.audit(plan) and isinstance(notes, list)
    playback = gw.play(plan)
    assert playback.passed, playback.reason
    shoulder = 7 + plan.robot.joints.index("LShoulderPitch")
    assert np.ptp(playback.q[:, shoulder]) > 0.5


def test_a_task_plan_does_what_its_words_do(nao, wave):
    tasks = gw.understand(nao, "wave with your left hand")
    assert [(task["action"], task["side"]) for task in tasks["tasks"]] == [("wave", "left")]
    assert gw.plan_tasks(nao, tasks)[0].hash == wave[0].hash


def test_places_of_a_ground_can_be_walked_to(a1):
    ground = gw.flat_terrain().with_marker("desk", 0.6, 0.0)
    tasks = gw.understand(a1, "walk to the desk", terrain=ground)
    assert tasks["tasks"][0]["to"]["name"] == "desk"
    with pytest.raises(gw.BadInputError, match="desk"):
        gw.understand(a1, "walk to the desk")


def test_what_is_not_understood_is_refused(a1, nao):
    with pytest.raises(gw.BadInputError, match="fly"):
        gw.plan_tasks(a1, "fly to the moon")
    with pytest.raises(gw.BadInputError, match="juggle"):
        gw.plan_tasks(nao, {"schema": 1, "tasks": [{"action": "juggle"}]})
    with pytest.raises(TypeError, match="task plan"):
        gw.plan_tasks(nao, 3)


def test_a_motion_is_like_itself(trot, playback):
    assert gw.compare(trot, trot).same and gw.compare(trot, trot).differences == []
    assert gw.compare(playback, playback).same


def test_what_a_push_changed_is_found(trot, playback):
    pushed = gw.play(trot, push=(0.0, 80.0, 0.0, 0.8, 0.1))
    comparison = gw.compare(playback, pushed)
    assert not comparison.same
    first = comparison.differences[0]
    assert first["at_s"] >= 0.8 and first["unit"]
    result = json.loads(comparison.to_json())
    assert result["compared"] == "motions" and not result["same"]
    assert "differs first" in repr(comparison) and first["quantity"] in str(comparison)
    assert "<html" in comparison.report_html() and comparison._repr_html_().startswith("<iframe")


def test_a_plan_is_held_against_what_was_measured(trot, playback):
    metrics = json.loads(gw.compare(trot, playback).to_json())["metrics"]
    assert metrics["goal_error_m"]["b"] == pytest.approx(playback.metrics["goal_error_m"].value)
    with pytest.raises(TypeError, match="a Plan or a Playback"):
        gw.compare(trot, "out/log.json")
    with pytest.raises(ValueError, match="tolerance"):
        gw.compare(trot, trot, tolerance=-1.0)


def test_what_was_measured_is_exported(playback, tmp_path):
    path = tmp_path / "measured.npz"
    playback.export(str(path), "npz")
    with np.load(path) as arrays:
        assert any(np.shape(arrays[name])[0] == len(playback.time_s) for name in arrays.files)
